#include "Base/Errors.h"
#include "IO/Private/OpenImage.h"

#include <itkMetaImageIO.h>
#include <itkNiftiImageIO.h>
#include <itkNrrdImageIO.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace shape
{
namespace
{

/// Calls ITK, and throws its message.
template <class Function>
auto Call(const Function& function)
{
  try
  {
    return function();
  }
  catch (const itk::ExceptionObject& error)
  {
    // ITK puts its own file and the address of an object in front.
    std::string said = error.GetDescription();
    const std::size_t address = said.find("(0x"), end = said.find("): ", address);
    if (address != std::string::npos && end != std::string::npos)
    {
      said.erase(0, end + 3);
    }
    said.erase(std::unique(said.begin(), said.end(),
                 [](char a, char b) { return std::isspace(a) && std::isspace(b); }),
      said.end());
    throw InvalidInput("ITK cannot read it (" + said.substr(0, 120) + "); write it again");
  }
}

/// Returns what reads a file, after its header.
itk::ImageIOBase::Pointer Open(const std::string& path)
{
  const std::array<itk::ImageIOBase::Pointer, 3> formats{ itk::NrrdImageIO::New().GetPointer(),
    itk::MetaImageIO::New().GetPointer(), itk::NiftiImageIO::New().GetPointer() };
  for (const itk::ImageIOBase::Pointer& format : formats)
  {
    if (Call([&] { return format->CanReadFile(path.c_str()); }))
    {
      format->SetFileName(path);
      Call([&] { format->ReadImageInformation(); });
      return format;
    }
  }
  throw InvalidInput("it is no NRRD, MetaImage or NIfTI image; export one of these formats");
}

ImageNumber FindNumber(const itk::ImageIOBase& file)
{
  const auto integer = [&](bool isSigned)
  {
    // Types such as long have different sizes on different machines.
    static constexpr std::array<ImageNumber, 4> withSign{ ImageNumber::Int8, ImageNumber::Int16,
      ImageNumber::Int32, ImageNumber::Int64 };
    static constexpr std::array<ImageNumber, 4> without{ ImageNumber::UInt8, ImageNumber::UInt16,
      ImageNumber::UInt32, ImageNumber::UInt64 };
    const unsigned size = file.GetComponentSize();
    const int power = size == 1 ? 0 : size == 2 ? 1 : size == 4 ? 2 : 3;
    return isSigned ? withSign[power] : without[power];
  };
  switch (file.GetComponentType())
  {
    case itk::CommonEnums::IOComponent::CHAR:
    case itk::CommonEnums::IOComponent::SHORT:
    case itk::CommonEnums::IOComponent::INT:
    case itk::CommonEnums::IOComponent::LONG:
    case itk::CommonEnums::IOComponent::LONGLONG:
      return integer(true);
    case itk::CommonEnums::IOComponent::UCHAR:
    case itk::CommonEnums::IOComponent::USHORT:
    case itk::CommonEnums::IOComponent::UINT:
    case itk::CommonEnums::IOComponent::ULONG:
    case itk::CommonEnums::IOComponent::ULONGLONG:
      return integer(false);
    case itk::CommonEnums::IOComponent::FLOAT:
      return ImageNumber::Float;
    case itk::CommonEnums::IOComponent::DOUBLE:
      return ImageNumber::Double;
    default:
      throw InvalidInput("its numbers are of a type that is not supported; convert them to double");
  }
}

ImageHeader FindHeader(const itk::ImageIOBase& file)
{
  ImageHeader header;
  const unsigned dimensions = file.GetNumberOfDimensions();
  for (unsigned axis = 0; axis < dimensions; ++axis)
  {
    const auto size = file.GetDimensions(axis);
    if (axis >= 3 && size != 1)
    {
      throw InvalidInput("it has " + std::to_string(dimensions) + " dimensions, with " +
        std::to_string(size) + " images along the last; write one image to a file of its own");
    }
    if (axis < 3)
    {
      if (size == 0 || size > static_cast<std::size_t>(std::numeric_limits<int>::max()))
      {
        throw InvalidInput("it has " + std::to_string(size) + " voxels along an axis; crop it");
      }
      header.Size[axis] = static_cast<int>(size);
    }
  }
  const unsigned axes = std::min(dimensions, 3u);
  for (unsigned axis = axes; axis < 3; ++axis)
  {
    header.Size[axis] = 1;
  }
  for (unsigned axis = 0; axis < axes; ++axis)
  {
    header.Origin[axis] = file.GetOrigin(axis);
    header.Spacing[axis] = file.GetSpacing(axis);
    const std::vector<double> direction = file.GetDirection(axis);
    for (unsigned row = 0; row < axes; ++row)
    {
      header.Directions[3 * row + axis] = direction[row];
    }
    if (!(header.Spacing[axis] > 0.0) || !std::isfinite(header.Spacing[axis]) ||
      !std::isfinite(header.Origin[axis]))
    {
      std::ostringstream words;
      words << "along axis " << axis << ", its origin is " << header.Origin[axis]
            << " and its spacing " << header.Spacing[axis] << "; correct its header";
      throw InvalidInput(words.str());
    }
  }
  header.Number = FindNumber(file);
  header.Components = static_cast<int>(file.GetNumberOfComponents());
  return header;
}

ImageHeader ReadHeaderByITK(const std::string& path)
{
  return FindHeader(*Open(path));
}

void ReadValuesByITK(const std::string& path, void* values)
{
  const itk::ImageIOBase::Pointer file = Open(path);
  itk::ImageIORegion region(file->GetNumberOfDimensions());
  for (unsigned axis = 0; axis < file->GetNumberOfDimensions(); ++axis)
  {
    region.SetSize(axis, file->GetDimensions(axis));
  }
  file->SetIORegion(region);
  Call([&] { file->Read(values); });
}

} // namespace
} // namespace shape

void ShapeMapImageLibrary(shape::ImageLibrary& own)
{
  own = { shape::ReadHeaderByITK, shape::ReadValuesByITK };
}
