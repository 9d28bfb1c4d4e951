#include "vtkShapeReader.h"

#include "vtkShapeFileContent.h"

#include <utility>

void vtkShapeReader::Make(vtkDataObject* output, const shape::Progress& progress)
{
  std::string content = vtkShapeFileContent::Read(this->FileName);
  vtkShapeFileContent::CallWithName(
    this->FileName, [&]() { this->ReadContent(std::move(content), output, progress); });
}

void vtkShapeReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n";
}
