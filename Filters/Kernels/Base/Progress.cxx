#include "Base/Progress.h"

#include "Base/Errors.h"

#include <utility>

namespace shape
{

Progress::Progress(Callback report)
{
  if (report)
  {
    this->Report = std::make_shared<const Callback>(std::move(report));
  }
}

Progress::Progress(std::function<bool(double)> report)
{
  if (report)
  {
    this->Report = std::make_shared<const Callback>(
      [report = std::move(report)](double fraction, const char*) { return report(fraction); });
  }
}

void Progress::operator()(double fraction) const
{
  if (this->Report &&
    !(*this->Report)(this->Begin + fraction * (this->End - this->Begin), this->Stage))
  {
    throw Aborted();
  }
}

Progress Progress::Part(double begin, double end, const char* stage) const
{
  Progress part = *this;
  const double length = this->End - this->Begin;
  part.Begin = this->Begin + begin * length;
  part.End = this->Begin + end * length;
  part.Stage = stage ? stage : this->Stage;
  return part;
}

} // namespace shape
