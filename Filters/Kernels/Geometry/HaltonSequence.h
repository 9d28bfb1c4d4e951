#pragma once

namespace shape
{

/// Returns the i-th element of the sequence of van der Corput for a base, in [0, 1): the digits of
/// i, mirrored at the point. Sequences with different primes as bases are the coordinates of evenly
/// distributed points (Halton 1960). i: >= 0; element 0 is 0.
double GetHaltonNumber(int i, int base);

} // namespace shape
