#include "Base/LoadedLibrary.h"

#include "Base/Errors.h"

#include <dlfcn.h>

namespace shape
{

void* LoadFunction(
  const std::string& library, const std::string& function, const std::string& product)
{
  void* const loaded = dlopen(library.c_str(), RTLD_LAZY);
  void* const found = loaded ? dlsym(loaded, function.c_str()) : nullptr;
  if (!found)
  {
    throw SolveFailure(
      product + " cannot be loaded (" + dlerror() + "); install its libraries, or ShapeMap again");
  }
  return found;
}

} // namespace shape
