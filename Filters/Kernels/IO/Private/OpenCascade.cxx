#include "IO/Private/OpenCascade.h"

#include "Base/Errors.h"

#include <dlfcn.h>

namespace shape
{

#ifdef SHAPEMAP_OCCT

namespace
{

// Linking the symbols of OpenCASCADE takes longer than all else when ParaView loads
// the plugin, and few sessions read a CAD file. So it is in a library of its own, beside this one.
CascadeReader Load()
{
  void* const library = dlopen("libshape_cascade.so", RTLD_LAZY);
  void* const reader = library ? dlsym(library, "ShapeMapReadCascade") : nullptr;
  if (!reader)
  {
    throw SolveFailure(std::string("OpenCASCADE cannot be loaded (") + dlerror() +
      "); install its libraries, or ShapeMap again");
  }
  return reinterpret_cast<decltype(&ShapeMapReadCascade)>(reader);
}

} // namespace

CascadeReader LoadOpenCascade()
{
  static const CascadeReader reader = Load();
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
