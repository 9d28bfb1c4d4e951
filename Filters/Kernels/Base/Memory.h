#pragma once

namespace shape
{

/**
 * Throws std::bad_alloc if the address space cannot grow by what GetThreadCount() threads need.
 * BLAS takes a buffer for each thread at its first call. Without memory, OpenBLAS asks again for
 * ever, and OpenMP ends the process. Only a limit on the address space (ulimit -v) is found out.
 */
void RequireThreadMemory();

} // namespace shape
