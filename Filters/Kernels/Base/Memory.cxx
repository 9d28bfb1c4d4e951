#include "Base/Memory.h"

#include "Base/Parallel.h"

#include <cstddef>
#include <new>

#include <sys/mman.h>

namespace shape
{

void RequireThreadMemory()
{
  // A buffer of OpenBLAS and a stack.
  constexpr std::size_t ofThread = (128UL + 8UL) << 20U;
  const std::size_t size = ofThread * static_cast<std::size_t>(GetThreadCount());
  // Addresses only: no page is ever used.
  void* addresses =
    mmap(nullptr, size, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (addresses == MAP_FAILED)
  {
    throw std::bad_alloc();
  }
  munmap(addresses, size);
}

} // namespace shape
