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

void vtkShapeFileWriter::WriteWhole(const Content& content, const shape::Progress& progress)
{
  const auto why = [] { return " (" + std::generic_category().message(errno) + "); "; };
  // Streams do not report why they failed, but the system calls that they use set errno.
  errno = 0;
  std::ofstream file(this->FileName);
  if (!file)
  {
    throw FileError("cannot open the file '" + this->FileName + "'" + why() +
        "choose an existing folder with write permission",
      vtkErrorCode::CannotOpenFileError);
  }
  try
  {
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
  catch (...)
  {
    file.close();
    std::error_code ignored;
    // A partial file is removed, but never a device or a pipe.
    if (std::filesystem::is_regular_file(this->FileName, ignored))
    {
      std::filesystem::remove(this->FileName, ignored);
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
