#include "Remesh/EditableSurface.h"

#include <algorithm>

namespace shape
{

EditableSurface::EditableSurface(const Mesh& mesh)
  : Triangles(mesh.Triangles.rows())
  , Fans(mesh.Points.rows())
{
  this->Points.reserve(mesh.Points.rows());
  for (const auto& point : mesh.Points.rowwise())
  {
    this->Points.emplace_back(point.transpose());
  }
  for (int t = 0; t < this->TriangleCount(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      this->Triangles[t][k] = mesh.Triangles(t, k);
      this->Fans[mesh.Triangles(t, k)].push_back(t);
    }
  }
}

void EditableSurface::FindNeighbours(int point, std::vector<int>& found) const
{
  found.clear();
  for (const int t : this->Fans[point])
  {
    for (const int other : this->Triangles[t])
    {
      if (other != point)
      {
        found.push_back(other);
      }
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
}

std::vector<int> EditableSurface::TrianglesOf(int a, int b) const
{
  std::vector<int> both;
  std::copy_if(this->Fans[a].begin(), this->Fans[a].end(), std::back_inserter(both),
    [&](int t) { return Has(this->Triangles[t], b); });
  return both;
}

std::vector<int> EditableSurface::Collapse(int point, int into)
{
  std::vector<int> left;
  for (const int t : this->Fans[point])
  {
    Triangle& corners = this->Triangles[t];
    // The triangles of the edge are removed; the others get the new corner.
    if (!Has(corners, into))
    {
      corners[CornerOf(corners, point)] = into;
      left.push_back(t);
      continue;
    }
    for (const int corner : corners)
    {
      if (corner != point)
      {
        this->Remove(corner, t);
      }
    }
    corners[0] = -1;
  }
  this->Fans[into].insert(this->Fans[into].end(), left.begin(), left.end());
  this->Fans[point].clear();
  return left;
}

int EditableSurface::Split(int a, int b)
{
  const int middle = this->PointCount();
  this->Points.emplace_back(0.5 * (this->Points[a] + this->Points[b]));
  this->Fans.emplace_back();
  for (const int t : this->TrianglesOf(a, b))
  {
    const int other = this->TriangleCount();
    const int c = this->Opposite(t, a, b);
    // The triangle keeps the half at a; a new one gets the half at b.
    Triangle second = this->Triangles[t];
    second[CornerOf(second, a)] = middle;
    this->Triangles[t][CornerOf(this->Triangles[t], b)] = middle;
    this->Triangles.push_back(second);
    this->Remove(b, t);
    this->Fans[b].push_back(other);
    this->Fans[c].push_back(other);
    this->Fans[middle].push_back(t);
    this->Fans[middle].push_back(other);
  }
  return middle;
}

void EditableSurface::Flip(int t, int s, int a, int b)
{
  const int c = this->Opposite(t, a, b), d = this->Opposite(s, a, b);
  this->Triangles[t] = { a, d, c };
  this->Triangles[s] = { d, b, c };
  this->Remove(b, t);
  this->Remove(a, s);
  this->Fans[d].push_back(t);
  this->Fans[c].push_back(s);
}

EditableSurface::Compacted EditableSurface::Compact() const
{
  Compacted result;
  std::vector<int> number(this->Points.size(), -1);
  for (int point = 0; point < this->PointCount(); ++point)
  {
    if (this->Contains(point))
    {
      number[point] = static_cast<int>(result.Points.size());
      result.Points.push_back(point);
    }
  }
  result.Surface.Points.resize(static_cast<Eigen::Index>(result.Points.size()), 3);
  for (std::size_t i = 0; i < result.Points.size(); ++i)
  {
    result.Surface.Points.row(static_cast<Eigen::Index>(i)) =
      this->Points[result.Points[i]].transpose();
  }
  result.Rows.assign(this->Triangles.size(), -1);
  result.Surface.Triangles.resize(static_cast<Eigen::Index>(this->Triangles.size()), 3);
  int count = 0;
  for (int t = 0; t < this->TriangleCount(); ++t)
  {
    const Triangle& corners = this->Triangles[t];
    if (corners[0] >= 0)
    {
      result.Rows[t] = count;
      result.Surface.Triangles.row(count++) << number[corners[0]], number[corners[1]],
        number[corners[2]];
    }
  }
  result.Surface.Triangles.conservativeResize(count, 3);
  return result;
}

/// Takes a triangle out of a point's fan.
void EditableSurface::Remove(int point, int triangle)
{
  std::vector<int>& fan = this->Fans[point];
  fan.erase(std::find(fan.begin(), fan.end(), triangle));
}

} // namespace shape
