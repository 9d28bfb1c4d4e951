#include "IO/Private/OpenCascade.h"

#include "Base/Errors.h"
#include "Base/LoadedLibrary.h"

namespace shape
{

#ifdef SHAPEMAP_OCCT

CascadeReader LoadOpenCascade()
{
  static const auto reader = reinterpret_cast<decltype(&ShapeMapReadCascade)>(
    LoadFunction("libshape_cascade.so", "ShapeMapReadCascade", "OpenCASCADE"));
  return reader;
}

#else

CascadeReader LoadOpenCascade()
{
  throw InvalidInput("ShapeMap was built without OpenCASCADE (SHAPEMAP_OCCT=OFF); build it with "
                     "SHAPEMAP_OCCT=ON");
}

#endif

} // namespace shape
