#include "Harmonic/Private/ChargeShells.h"

#include "Harmonic/Private/OffsetSurface.h"
#include "Mesh/Topology.h"
#include "Mesh/UsedPoints.h"

#include <algorithm>
#include <vector>

namespace shape
{

namespace
{

/// Returns the maximum distance from the wall inside a void, over a lattice of points in its box.
double Depth(const Mesh& component, const SignedDistance& field, const Progress& progress)
{
  // A coarse lattice suffices, because the offset is at most half the depth.
  constexpr int side = 16;
  const Eigen::MatrixXd corners = component.Points(component.Triangles.reshaped(), Eigen::all);
  const Eigen::RowVector3d low = corners.colwise().minCoeff();
  const Eigen::RowVector3d step = (corners.colwise().maxCoeff() - low) / side;
  Eigen::MatrixXd lattice(side * side * side, 3);
  for (int i = 0; i < lattice.rows(); ++i)
  {
    const Eigen::RowVector3d cell(i % side, i / side % side, i / (side * side));
    lattice.row(i) = low + step.cwiseProduct((cell.array() + 0.5).matrix());
  }
  return field.Evaluate(lattice, progress).Distances.maxCoeff();
}

/// Returns the components. A connected surface is returned as it is, with its search tree.
std::vector<Surface> Components(const Surface& boundary)
{
  if (boundary.Topology().Components == 1)
  {
    return { boundary };
  }
  const std::vector<Mesh> split = SplitComponents(boundary);
  return { split.begin(), split.end() };
}

} // namespace

ChargeShells::ChargeShells(const Surface& boundary, double offset, const Progress& progress)
  : Offset(offset)
{
  const std::vector<Surface> components = Components(boundary);
  const double share = 1.0 / static_cast<double>(components.size());
  for (std::size_t c = 0; c < components.size(); ++c)
  {
    const SignedDistance field(components[c]);
    const Progress part = progress.Part(share * c, share * (c + 1));
    // Li et al. 2010, section 3.2: sources lie on an offset surface. The shell of a void must fit
    // into the void.
    double distance = offset;
    if (ComputeEnclosedVolume(components[c]) < 0.0) // a void
    {
      distance = std::min(offset, 0.5 * Depth(components[c], field, part.Part(0.0, 0.2)));
      this->Offset = std::min(this->Offset, distance);
    }
    this->Shells.push_back(
      BuildOffsetSurface(field, distance, OffsetSurfaceOptions(), part.Part(0.2, 1.0)));
  }
}

double ChargeShells::Area() const
{
  double area = 0.0;
  for (const Mesh& shell : this->Shells)
  {
    area += ComputeArea(shell);
  }
  return area;
}

std::vector<Eigen::MatrixXd> ChargeShells::Sample(
  int count, SamplingMode mode, unsigned int seed, const Progress& progress) const
{
  // Li et al. 2010, section 4.1.2: geometry-adaptive or uniform samples.
  return SampleSurfaces(this->Shells, count, Fewest, mode, seed, progress);
}

Mesh ChargeShells::Joined() const
{
  return JoinMeshes(this->Shells);
}

} // namespace shape
