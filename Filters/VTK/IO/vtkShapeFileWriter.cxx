#include "vtkShapeFileWriter.h"

#include "vtkShapeLabel.h"
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
#include <utility>

#include <unistd.h>

namespace fs = std::filesystem;

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

/// A file to be written.
struct vtkShapeFileWriter::OutputFile
{
  std::string Name; ///< as the user or a deck names it
  Content Write;
  fs::path Path; ///< the file that is replaced: the target of a symbolic link, not the link
  fs::path Part; ///< where the content is until all files are complete; empty: directly
  fs::perms Permissions = fs::perms::unknown; ///< of the older file
};

vtkShapeFileWriter::vtkShapeFileWriter() = default;

vtkShapeFileWriter::~vtkShapeFileWriter() = default;

std::string vtkShapeFileWriter::GetLabel()
{
  return vtkShapeLabel::Of(this->GetClassName());
}

void vtkShapeFileWriter::AddFile(const std::string& path, Content content)
{
  OutputFile file{ path, std::move(content), path, {} };
  std::error_code error;
  const fs::path resolved = fs::canonical(path, error);
  file.Path = error ? file.Path : resolved;
  const fs::file_status old = fs::status(file.Path, error);
  // A device or a pipe is written directly, and so is a file that is protected from writing: the
  // error says so, and renaming would replace it.
  if (!fs::exists(old) || (fs::is_regular_file(old) && access(file.Path.c_str(), W_OK) == 0))
  {
    file.Part = file.Path.parent_path() /
      (".shapemap-" + std::to_string(getpid()) + "-" + std::to_string(this->Files.size()) +
        ".part");
    file.Permissions = fs::exists(old) ? old.permissions() : fs::perms::unknown;
  }
  this->Files.push_back(std::move(file));
}

void vtkShapeFileWriter::WriteTo(
  const OutputFile& output, const std::string& path, const shape::Progress& progress) const
{
  const auto why = [] { return " (" + std::generic_category().message(errno) + "); "; };
  // Streams do not report why they failed, but the system calls that they use set errno.
  errno = 0;
  std::ofstream file(path);
  if (!file)
  {
    throw FileError("cannot open the file '" + output.Name + "'" + why() +
        "choose an existing folder with write permission",
      vtkErrorCode::CannotOpenFileError);
  }
  file.imbue(std::locale::classic()); // otherwise digits may be grouped
  output.Write(file, progress);
  file.close();
  if (!file)
  {
    throw FileError("the file '" + output.Name + "' could not be written completely" + why() +
        "free some space, or choose another disk",
      vtkErrorCode::OutOfDiskSpaceError);
  }
}

void vtkShapeFileWriter::Replace(const OutputFile& file) const
{
  std::error_code error;
  if (file.Permissions != fs::perms::unknown)
  {
    fs::permissions(file.Part, file.Permissions, error);
  }
  fs::rename(file.Part, file.Path, error);
  if (error)
  {
    throw FileError("the file '" + file.Name + "' could not be replaced (" + error.message() +
        "); choose another name",
      vtkErrorCode::CannotOpenFileError);
  }
}

void vtkShapeFileWriter::MakeFolder(const std::string& folder)
{
  std::error_code error;
  if (folder.empty() || fs::path(this->FileName).parent_path() == folder ||
    fs::is_directory(folder, error))
  {
    return;
  }
  this->MakeFolder(fs::path(folder).parent_path().string());
  if (!fs::create_directory(folder, error))
  {
    throw FileError("cannot make the folder '" + folder + "' (" + error.message() +
        "); choose an existing folder with write permission",
      vtkErrorCode::CannotOpenFileError);
  }
  this->MadeFolders.push_back(folder);
}

/// Files are written under other names in their folders, and then renamed: older files are replaced
/// only by complete ones.
void vtkShapeFileWriter::WriteFiles(const shape::Progress& progress)
{
  try
  {
    const double count = static_cast<double>(this->Files.size());
    for (std::size_t i = 0; i < this->Files.size(); ++i)
    {
      const OutputFile& file = this->Files[i];
      this->MakeFolder(fs::path(file.Name).parent_path().string());
      const double begin = static_cast<double>(i) / count;
      this->WriteTo(file, file.Part.empty() ? file.Name : file.Part.string(),
        progress.Part(begin, begin + 1.0 / count));
    }
    for (const OutputFile& file : this->Files)
    {
      file.Part.empty() ? void() : this->Replace(file);
    }
  }
  catch (...)
  {
    for (const OutputFile& file : this->Files)
    {
      std::error_code error;
      file.Part.empty() ? false : fs::remove(file.Part, error);
    }
    // A folder that has a file stays.
    for (auto folder = this->MadeFolders.rbegin(); folder != this->MadeFolders.rend(); ++folder)
    {
      std::error_code error;
      fs::remove(*folder, error);
    }
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
    this->Files.clear();
    this->MadeFolders.clear();
    Content content = this->ReadInput(progress.Part(0.0, 0.5, "reading the input"));
    this->AddFile(this->FileName, std::move(content));
    this->WriteFiles(progress.Part(0.5, 1.0, "writing the file"));
    this->Files.clear();
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
  this->Files.clear();
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
