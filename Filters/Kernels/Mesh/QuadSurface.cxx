#include "Mesh/QuadSurface.h"

#include <algorithm>

namespace shape
{

QuadSurface::QuadSurface(Eigen::MatrixXi quads)
  : Corners(std::move(quads))
{
  for (int q = 0; q < static_cast<int>(this->Corners.rows()); ++q)
  {
    for (int k = 0; k < 4; ++k)
    {
      this->QuadOf[{ this->Corners(q, k), this->Corners(q, (k + 1) % 4) }] = q;
    }
  }
}

int QuadSurface::Across(int quad, int k) const
{
  return this->QuadAt({ this->Corners(quad, (k + 1) % 4), this->Corners(quad, k) });
}

int QuadSurface::NextAround(int point, int quad) const
{
  const auto corners = this->Corners.row(quad);
  const auto k = std::find(corners.begin(), corners.end(), point) - corners.begin();
  // Here the edge runs from the previous corner to the point; the quad beyond has it reversed.
  return this->QuadAt({ point, corners((k + 3) % 4) });
}

std::vector<int> QuadSurface::QuadsAround(int point, int quad) const
{
  std::vector<int> around = { quad };
  for (int next = this->NextAround(point, quad); next != quad; next = this->NextAround(point, next))
  {
    around.push_back(next);
  }
  return around;
}

Topology ComputeBoundaryTopology(const HexMesh& mesh)
{
  return ComputeTopology({ mesh.Points, SplitQuads(FindBoundaryQuads(mesh)) });
}

bool HasBoundaryTopology(const HexMesh& mesh, const Topology& wanted)
{
  const Topology found = ComputeBoundaryTopology(mesh);
  return found.EulerNumber == wanted.EulerNumber && found.Components == wanted.Components &&
    found.NonManifoldEdges == 0 && found.NonManifoldPoints == 0;
}

} // namespace shape
