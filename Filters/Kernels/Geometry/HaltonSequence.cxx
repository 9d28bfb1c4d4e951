#include "Geometry/HaltonSequence.h"

namespace shape
{

double GetHaltonNumber(int i, int base)
{
  double fraction = 1.0, value = 0.0;
  for (; i > 0; i /= base)
  {
    fraction /= base;
    value += fraction * (i % base);
  }
  return value;
}

} // namespace shape
