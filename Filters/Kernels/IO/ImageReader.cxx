#include "IO/ImageReader.h"

#include "IO/Private/OpenImage.h"

namespace shape
{

ImageHeader ReadImageHeader(const std::string& path)
{
  return LoadImageLibrary().ReadHeader(path);
}

void ReadImage(const std::string& path, void* values, const Progress& progress)
{
  progress(0.0);
  LoadImageLibrary().ReadValues(path, values);
  progress(1.0);
}

} // namespace shape
