#include "vtkShapeReader.h"

#include "vtkShapeFileContent.h"

#include "Base/Errors.h"

#include <utility>

void vtkShapeReader::Make(vtkDataObject* output, const shape::Progress& progress)
{
  if (this->FileName.empty())
  {
    throw shape::InvalidInput("there is no file name; set one");
  }
  std::string content = vtkShapeFileContent::Read(this->FileName);
  try
  {
    this->ReadContent(std::move(content), output, progress);
  }
  catch (const shape::InvalidInput& error)
  {
    throw shape::InvalidInput(
      this->FileName.substr(this->FileName.find_last_of('/') + 1) + ": " + error.what());
  }
}

void vtkShapeReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n";
}
