#include "Base/Progress.h"

#include "Base/Errors.h"

namespace shape
{

void Progress::operator()(double fraction) const
{
  if (this->Report && !this->Report(fraction))
  {
    throw Aborted();
  }
}

Progress Progress::Part(double begin, double end) const
{
  if (!this->Report)
  {
    return {};
  }
  return Progress([report = this->Report, begin, end](double fraction)
    { return report(begin + fraction * (end - begin)); });
}

} // namespace shape
