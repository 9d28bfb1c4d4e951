#include "Correspondence/CommonBase/Private/TracedSurface.h"

namespace shape
{

SurfaceGap TracedSurface::GapOf(const BaseGraph& graph, int corner) const
{
  const int point = this->Nodes[graph.NodeOfCorner(corner)];
  if (corner < 0)
  {
    return { point, -1 };
  }
  const std::vector<int>& path = this->Paths[corner / 2];
  return { point, corner % 2 == 0 ? path[1] : path[path.size() - 2] };
}

int TracedSurface::CornerBefore(const BaseGraph& graph, int node, int next) const
{
  const int first = this->Surface.Find(this->Nodes[node], next);
  for (int side = this->Surface.TurnRight(first); side != first;
       side = this->Surface.TurnRight(side))
  {
    const int path = this->Surface.PathOf(side);
    if (path >= 0)
    {
      return graph.NodeOf(2 * path) == node ? 2 * path : 2 * path + 1;
    }
  }
  return -1 - node;
}

FormValues TracedSurface::FormsAlong(int path) const
{
  FormValues forms{};
  const std::vector<int>& points = this->Paths[path];
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    forms = AddForms(forms, this->Surface.FormsOf(this->Surface.Find(points[i - 1], points[i])));
  }
  return forms;
}

Eigen::VectorXi TracedSurface::HomologyOf(const FormValues& forms) const
{
  Eigen::VectorXi loop(this->Basis.Linking.rows());
  for (Eigen::Index i = 0; i < loop.size(); ++i)
  {
    loop(i) = forms[i];
  }
  for (const auto& [one, other] : this->Cuts)
  {
    const int sign = this->Crossings(one, other); // 1 or -1
    const int alongOne = sign * this->Crossings(loop, other),
              alongOther = -sign * this->Crossings(loop, one);
    loop -= alongOne * one + alongOther * other;
  }
  return loop;
}

bool TracedSurface::Bounds(const Eigen::VectorXi& loop, bool inside) const
{
  const Eigen::MatrixXi& linking = this->Basis.Linking;
  return inside ? (linking.transpose() * loop).isZero() : (linking * loop).isZero();
}

int TracedSurface::Crossings(const Eigen::VectorXi& one, const Eigen::VectorXi& other) const
{
  // The difference of the linking numbers on both sides is the intersection number.
  return one.dot((this->Basis.Linking - this->Basis.Linking.transpose()) * other);
}

// Each patch is filled from the half-edge at the beginning of its first side.
Eigen::VectorXi TracedSurface::FindPatches(const std::vector<std::array<int, 3>>& patches) const
{
  Eigen::VectorXi patchOf = Eigen::VectorXi::Constant(this->Surface.SideCount() / 3, -1);
  for (std::size_t patch = 0; patch < patches.size(); ++patch)
  {
    const int first = patches[patch][0];
    const std::vector<int>& path = this->Paths[first / 2];
    const auto last = path.size() - 1;
    std::vector<int> open{ (first % 2 == 0 ? this->Surface.Find(path[0], path[1])
                                           : this->Surface.Find(path[last], path[last - 1])) /
      3 };
    patchOf(open[0]) = static_cast<int>(patch);
    while (!open.empty())
    {
      const int triangle = open.back();
      open.pop_back();
      for (int edge = 3 * triangle; edge < 3 * triangle + 3; ++edge)
      {
        const int next = this->Surface.Twin(edge) / 3;
        if (this->Surface.PathOf(edge) < 0 && patchOf(next) < 0)
        {
          patchOf(next) = static_cast<int>(patch);
          open.push_back(next);
        }
      }
    }
  }
  return patchOf;
}

} // namespace shape
