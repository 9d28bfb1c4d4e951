#include "Network/Private/OpenNetwork.h"

#include "Base/Errors.h"
#include "Base/LoadedLibrary.h"

namespace shape
{

#ifdef SHAPEMAP_OPENCV

NetworkLibrary LoadNetworkLibrary()
{
  static const NetworkLibrary library = []
  {
    NetworkLibrary loaded{};
    reinterpret_cast<decltype(&ShapeMapNetworkLibrary)>(
      LoadFunction("libshape_network.so", "ShapeMapNetworkLibrary", "OpenCV"))(loaded);
    return loaded;
  }();
  return library;
}

#else

NetworkLibrary LoadNetworkLibrary()
{
  throw InvalidInput(
    "ShapeMap was built without OpenCV (SHAPEMAP_OPENCV=OFF); build it with SHAPEMAP_OPENCV=ON");
}

#endif

} // namespace shape
