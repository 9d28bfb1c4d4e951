#include "vtkShapeFileWriter.h"

#include "vtkShapeProgress.h"

#include "vtkErrorCode.h"

#include "Base/Errors.h"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <locale>
#include <new>
#include <stdexcept>
#include <system_error>

#include <unistd.h>

namespace
{

/// The file cannot be written.
class FileError : public std::runtime_error
{
public:
  FileError(const std::string& what, unsigned long code)
    : std::runtime_error(what)
    , Code(code)
  {
  }
  unsigned long Code; ///< of vtkErrorCode
};

} // namespace

std::string vtkShapeFileWriter::GetLabel()
{
  return vtkShapeAlgorithm::LabelOf(this->GetClassName());
}

void vtkShapeFileWriter::WriteTo(
  const std::string& path, const Content& content, const shape::Progress& progress)
{
  const auto why = [] { return " (" + std::generic_category().message(errno) + "); "; };
  // Streams do not report why they failed, but the system calls that they use set errno.
  errno = 0;
  std::ofstream file(path);
  if (!file)
  {
    throw FileError("cannot open the file '" + this->FileName + "'" + why() +
        "choose an existing folder with write permission",
      vtkErrorCode::CannotOpenFileError);
  }
  file.imbue(std::locale::classic()); // otherwise digits may be grouped
  content(file, progress);
  file.close();
  if (!file)
  {
    throw FileError("the file '" + this->FileName + "' could not be written completely" + why() +
        "free some space, or choose another disk",
      vtkErrorCode::OutOfDiskSpaceError);
  }
}

/// A regular file is written under another name in its folder, and then renamed: an older file is
/// replaced only by a complete one. A device or a pipe is written directly.
void vtkShapeFileWriter::WriteWhole(const Content& content, const shape::Progress& progress)
{
  namespace fs = std::filesystem;
  std::error_code error;
  // The target of a symbolic link is replaced, and not the link.
  const fs::path resolved = fs::canonical(this->FileName, error);
  const fs::path path = error ? fs::path(this->FileName) : resolved;
  const fs::file_status old = fs::status(path, error);
  if (fs::exists(old) && !fs::is_regular_file(old))
  {
    this->WriteTo(this->FileName, content, progress);
    return;
  }
  if (fs::exists(old) && access(path.c_str(), W_OK) != 0)
  {
    // Renaming would replace a file that is protected from writing: the error says so.
    this->WriteTo(path, content, progress);
    return;
  }
  const fs::path part = path.parent_path() / (".shapemap-" + std::to_string(getpid()) + ".part");
  try
  {
    this->WriteTo(part, content, progress);
    if (fs::exists(old))
    {
      fs::permissions(part, old.permissions(), error);
    }
    fs::rename(part, path, error);
    if (error)
    {
      throw FileError("the file '" + this->FileName + "' could not be replaced (" +
          error.message() + "); choose another name",
        vtkErrorCode::CannotOpenFileError);
    }
  }
  catch (...)
  {
    fs::remove(part, error);
    throw;
  }
}

void vtkShapeFileWriter::WriteData()
{
  const shape::Progress progress = vtkShapeProgress::Make(this, this->GetLabel());
  unsigned long code = vtkErrorCode::UserError;
  std::string message;
  try
  {
    if (this->FileName.empty())
    {
      throw FileError("there is no file name; set one", vtkErrorCode::NoFileNameError);
    }
    this->WriteWhole(this->ReadInput(progress.Part(0.0, 0.5, "reading the input")),
      progress.Part(0.5, 1.0, "writing the file"));
    return;
  }
  catch (const shape::Aborted&)
  {
  }
  catch (const FileError& error)
  {
    code = error.Code;
    message = error.what();
  }
  catch (const std::bad_alloc&)
  {
    message = "out of memory; use a coarser mesh";
  }
  catch (const std::exception& error)
  {
    message = error.what();
  }
  this->SetErrorCode(code);
  if (!message.empty())
  {
    vtkErrorMacro(<< this->GetLabel() << ": " << message);
  }
}

void vtkShapeFileWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n";
}
