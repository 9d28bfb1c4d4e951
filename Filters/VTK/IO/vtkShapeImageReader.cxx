#include "vtkShapeImageReader.h"

#include "vtkShapeFileContent.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include "IO/ImageReader.h"

#include <array>

vtkStandardNewMacro(vtkShapeImageReader);

namespace
{

int ToVTK(shape::ImageNumber number)
{
  switch (number)
  {
    case shape::ImageNumber::Int8:
      return VTK_SIGNED_CHAR;
    case shape::ImageNumber::UInt8:
      return VTK_UNSIGNED_CHAR;
    case shape::ImageNumber::Int16:
      return VTK_SHORT;
    case shape::ImageNumber::UInt16:
      return VTK_UNSIGNED_SHORT;
    case shape::ImageNumber::Int32:
      return VTK_INT;
    case shape::ImageNumber::UInt32:
      return VTK_UNSIGNED_INT;
    case shape::ImageNumber::Int64:
      return VTK_LONG_LONG;
    case shape::ImageNumber::UInt64:
      return VTK_UNSIGNED_LONG_LONG;
    case shape::ImageNumber::Float:
      return VTK_FLOAT;
    default:
      return VTK_DOUBLE;
  }
}

std::array<int, 6> FindExtent(const shape::ImageHeader& header)
{
  return { 0, header.Size[0] - 1, 0, header.Size[1] - 1, 0, header.Size[2] - 1 };
}

} // namespace

std::string vtkShapeImageReader::GetOutputType()
{
  return "vtkImageData";
}

void vtkShapeImageReader::Announce(vtkInformation* output)
{
  shape::ImageHeader header;
  vtkShapeFileContent::CallWithName(
    this->FileName, [&]() { header = shape::ReadImageHeader(this->FileName); });
  const std::array<int, 6> extent = FindExtent(header);
  output->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent.data(), 6);
  output->Set(vtkDataObject::ORIGIN(), header.Origin.data(), 3);
  output->Set(vtkDataObject::SPACING(), header.Spacing.data(), 3);
  output->Set(vtkDataObject::DIRECTION(), header.Directions.data(), 9);
  vtkDataObject::SetPointDataActiveScalarInfo(output, ToVTK(header.Number), header.Components);
  output->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
}

void vtkShapeImageReader::Make(vtkDataObject* output, const shape::Progress& progress)
{
  vtkShapeFileContent::CallWithName(this->FileName,
    [&]()
    {
      const shape::ImageHeader header = shape::ReadImageHeader(this->FileName);
      auto* const image = vtkImageData::SafeDownCast(output);
      image->SetExtent(FindExtent(header).data());
      image->SetOrigin(header.Origin.data());
      image->SetSpacing(header.Spacing.data());
      image->SetDirectionMatrix(header.Directions.data());
      const auto values =
        vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(ToVTK(header.Number)));
      values->SetName("ImageScalars");
      values->SetNumberOfComponents(header.Components);
      values->SetNumberOfTuples(static_cast<vtkIdType>(header.GetNumberOfVoxels()));
      shape::ReadImage(this->FileName, values->GetVoidPointer(0), progress);
      image->GetPointData()->SetScalars(values);
    });
}

void vtkShapeImageReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n";
}
