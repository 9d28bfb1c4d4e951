#include "IO/Private/OpenImage.h"

#include "Base/Errors.h"
#include "Base/LoadedLibrary.h"

namespace shape
{

#ifdef SHAPEMAP_ITK

ImageLibrary LoadImageLibrary()
{
  static const ImageLibrary library = []
  {
    ImageLibrary loaded{};
    reinterpret_cast<decltype(&ShapeMapImageLibrary)>(
      LoadFunction("libshape_image.so", "ShapeMapImageLibrary", "ITK"))(loaded);
    return loaded;
  }();
  return library;
}

#else

ImageLibrary LoadImageLibrary()
{
  throw InvalidInput(
    "ShapeMap was built without ITK (SHAPEMAP_ITK=OFF); build it with SHAPEMAP_ITK=ON");
}

#endif

} // namespace shape
