#include "Mesh/Extent.h"

#include "Base/Errors.h"
#include "Mesh/Mesh.h"

#include <sstream>

namespace shape
{

void RequireExtent(const Eigen::MatrixXd& points, const std::string& name)
{
  constexpr double minimum = 1e-50, maximum = 1e50;
  const double side = points.rows() > 0 ? ComputeLongestBoxEdge(points) : 0.0;
  if (side != 0.0 && !(side >= minimum && side <= maximum))
  {
    std::ostringstream words;
    words << name << " has a longest side of " << side << ", and lengths from " << minimum << " to "
          << maximum << " can be computed with; scale it with Transform, or check its coordinates";
    throw InvalidInput(words.str());
  }
}

} // namespace shape
