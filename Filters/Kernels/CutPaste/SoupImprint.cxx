#include "CutPaste/SoupImprint.h"

#include "CutPaste/Private/PlacedLoop.h"
#include "Geometry/Orientation.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace shape
{
namespace
{

using Eigen::RowVector2d;
using Weights = std::vector<std::pair<int, double>>;

double TwiceAreaOf(const RowVector2d& a, const RowVector2d& b, const RowVector2d& c)
{
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// The triangles while they are cut.
class Cutting
{
public:
  Cutting(const Eigen::MatrixXd& images, const Eigen::MatrixXi& triangles,
    const Eigen::MatrixXd& loop, double snap)
    : Given(static_cast<int>(images.rows()))
    , Loop(loop)
  {
    for (const auto& image : images.rowwise())
    {
      this->Images.emplace_back(image);
    }
    this->Snap(snap);
    for (int t = 0; t < static_cast<int>(triangles.rows()); ++t)
    {
      const std::array<int, 3> corners{ triangles(t, 0), triangles(t, 1), triangles(t, 2) };
      if (this->MayMeetLoop(corners))
      {
        this->Add(corners, t);
      }
      else
      {
        this->Uncut.emplace_back(t, corners);
      }
    }
  }

  /// Splits each triangle that contains a point of the loop into three.
  void InsertPoint(int number)
  {
    const RowVector2d position = this->Loop.row(number);
    const auto count = static_cast<int>(this->Corners.size());
    for (int t = 0; t < count; ++t)
    {
      const std::array<int, 3> corners = this->Corners[t];
      if (this->IsAlive[t] == 0 || !this->IsInside(corners, position))
      {
        continue;
      }
      Weights mean;
      const RowVector2d &a = this->Images[corners[0]], &b = this->Images[corners[1]],
                        &c = this->Images[corners[2]];
      const double whole = TwiceAreaOf(a, b, c);
      this->Blend(corners[0], TwiceAreaOf(position, b, c) / whole, mean);
      this->Blend(corners[1], TwiceAreaOf(a, position, c) / whole, mean);
      this->Blend(corners[2], TwiceAreaOf(a, b, position) / whole, mean);
      const int point = this->AddPoint(position, std::move(mean), number, 0.0);
      this->Remove(t);
      for (int k = 0; k < 3; ++k)
      {
        this->Add({ corners[k], corners[(k + 1) % 3], point }, this->Original[t]);
      }
    }
  }

  /// Splits each edge that crosses the line from a point of the loop to the next one.
  void InsertLine(int number)
  {
    const RowVector2d begin = this->Loop.row(number), end = this->Loop.row(this->Next(number));
    const RowVector2d lower = begin.cwiseMin(end), upper = begin.cwiseMax(end);
    std::vector<std::pair<int, int>> crossing;
    for (const auto& [edge, triangles] : this->TrianglesAt)
    {
      const RowVector2d &a = this->Images[edge.first], &b = this->Images[edge.second];
      const bool isFar = (a.cwiseMax(b).array() < lower.array()).any() ||
        (a.cwiseMin(b).array() > upper.array()).any();
      if (!isFar && !this->IsOn(edge.first, number) && !this->IsOn(edge.second, number) &&
        EvaluateOrientation(begin, end, a) * EvaluateOrientation(begin, end, b) < 0 &&
        EvaluateOrientation(a, b, begin) * EvaluateOrientation(a, b, end) < 0)
      {
        crossing.push_back(edge);
      }
    }
    // A new edge ends on this line, so it does not cross it.
    for (const auto& edge : crossing)
    {
      this->SplitEdge(edge, number, begin, end);
    }
  }

  SoupImprint Finish()
  {
    for (int t = 0; t < static_cast<int>(this->Corners.size()); ++t)
    {
      if (this->IsAlive[t])
      {
        this->Uncut.emplace_back(this->Original[t], this->Corners[t]);
      }
    }
    // In the order of the given triangles.
    std::stable_sort(this->Uncut.begin(), this->Uncut.end(),
      [](const auto& a, const auto& b) { return a.first < b.first; });
    SoupImprint result;
    result.Triangles.resize(static_cast<Eigen::Index>(this->Uncut.size()), 3);
    for (std::size_t row = 0; row < this->Uncut.size(); ++row)
    {
      const auto& [original, corners] = this->Uncut[row];
      const auto [a, b, c] = corners;
      result.Triangles.row(static_cast<Eigen::Index>(row)) << a, b, c;
      result.Original.push_back(original);
      result.IsCovered.push_back(
        Contains(this->Loop, (this->Images[a] + this->Images[b] + this->Images[c]) / 3.0) ? 1 : 0);
    }
    result.NewPoints = std::move(this->NewPoints);
    for (const auto& [point, seam] : this->Seam)
    {
      result.Seam.push_back(seam);
    }
    return result;
  }

private:
  /// Puts given points on the loop if they are closer to it than `distance`.
  void Snap(double distance)
  {
    const RowVector2d lower = this->Loop.colwise().minCoeff().array() - distance,
                      upper = this->Loop.colwise().maxCoeff().array() + distance;
    for (int point = 0; point < this->Given; ++point)
    {
      const RowVector2d image = this->Images[point];
      if ((image.array() < lower.array()).any() || (image.array() > upper.array()).any())
      {
        continue;
      }
      double nearest = distance;
      for (int i = 0; i < static_cast<int>(this->Loop.rows()); ++i)
      {
        const RowVector2d begin = this->Loop.row(i), along = this->Loop.row(this->Next(i)) - begin;
        const double share = (image - begin).dot(along) / along.squaredNorm();
        const double fromPoint = (image - begin).norm();
        const double fromLine = (image - begin - share * along).norm();
        // A point of the loop comes first: lines on both sides of it are as close.
        if (fromPoint <= nearest)
        {
          nearest = fromPoint;
          this->Images[point] = begin;
          this->Seam[point] = { point, i, 0.0 };
        }
        else if (share > 0.0 && share < 1.0 && fromLine < nearest && !this->IsAtPoint(point))
        {
          nearest = fromLine;
          this->Images[point] = begin + share * along;
          this->Seam[point] = { point, i, share };
        }
      }
    }
  }

  /// Whether a point was put on a point of the loop.
  bool IsAtPoint(int point) const
  {
    const auto at = this->Seam.find(point);
    return at != this->Seam.end() && at->second.Along == 0.0;
  }

  /// Whether the box of a triangle meets that of a line of the loop.
  bool MayMeetLoop(const std::array<int, 3>& corners) const
  {
    const RowVector2d &a = this->Images[corners[0]], &b = this->Images[corners[1]],
                      &c = this->Images[corners[2]];
    const RowVector2d lower = a.cwiseMin(b).cwiseMin(c), upper = a.cwiseMax(b).cwiseMax(c);
    for (int i = 0; i < static_cast<int>(this->Loop.rows()); ++i)
    {
      const RowVector2d begin = this->Loop.row(i), end = this->Loop.row(this->Next(i));
      if ((begin.cwiseMin(end).array() <= upper.array()).all() &&
        (begin.cwiseMax(end).array() >= lower.array()).all())
      {
        return true;
      }
    }
    return false;
  }

  int Next(int number) const { return number + 1 == this->Loop.rows() ? 0 : number + 1; }

  bool IsInside(const std::array<int, 3>& corners, const RowVector2d& position) const
  {
    const RowVector2d &a = this->Images[corners[0]], &b = this->Images[corners[1]],
                      &c = this->Images[corners[2]];
    const int side = EvaluateOrientation(a, b, position);
    return side != 0 && side == EvaluateOrientation(b, c, position) &&
      side == EvaluateOrientation(c, a, position);
  }

  /// Whether a point was put on this line of the loop.
  bool IsOn(int point, int number) const
  {
    const auto at = this->Seam.find(point);
    if (at == this->Seam.end())
    {
      return false;
    }
    const SeamPoint& seam = at->second;
    return seam.Segment == number || (seam.Along == 0.0 && seam.Segment == this->Next(number));
  }

  /// Adds a point, times a weight, to a mean of given points.
  void Blend(int point, double weight, Weights& mean) const
  {
    const auto add = [&](int given, double share)
    {
      const auto same = std::find_if(
        mean.begin(), mean.end(), [&](const auto& entry) { return entry.first == given; });
      if (same == mean.end())
      {
        mean.emplace_back(given, share);
      }
      else
      {
        same->second += share;
      }
    };
    if (point < this->Given)
    {
      add(point, weight);
      return;
    }
    for (const auto& [given, share] : this->NewPoints[point - this->Given])
    {
      add(given, weight * share);
    }
  }

  int AddPoint(const RowVector2d& image, Weights mean, int segment, double along)
  {
    const auto point = static_cast<int>(this->Images.size());
    this->Images.push_back(image);
    this->NewPoints.push_back(std::move(mean));
    this->Seam[point] = { point, segment, along };
    return point;
  }

  void SplitEdge(
    const std::pair<int, int>& edge, int number, const RowVector2d& begin, const RowVector2d& end)
  {
    const auto [a, b] = edge;
    const double left = TwiceAreaOf(begin, end, this->Images[a]),
                 right = TwiceAreaOf(begin, end, this->Images[b]);
    const double share = left != right ? std::clamp(left / (left - right), 0.0, 1.0) : 0.5;
    const double from = TwiceAreaOf(this->Images[a], this->Images[b], begin),
                 to = TwiceAreaOf(this->Images[a], this->Images[b], end);
    // Never 0, which marks a point of the loop.
    const double along = from != to ? std::clamp(from / (from - to), 1e-300, 1.0) : 0.5;
    Weights mean;
    this->Blend(a, 1.0 - share, mean);
    this->Blend(b, share, mean);
    const int point = this->AddPoint(begin + along * (end - begin), std::move(mean), number, along);
    const std::set<int> triangles = this->TrianglesAt.at(edge);
    for (const int t : triangles)
    {
      const std::array<int, 3> corners = this->Corners[t];
      this->Remove(t);
      for (const int replaced : { a, b })
      {
        std::array<int, 3> half = corners;
        std::replace(half.begin(), half.end(), replaced, point);
        this->Add(half, this->Original[t]);
      }
    }
  }

  static std::pair<int, int> EdgeOf(const std::array<int, 3>& corners, int k)
  {
    return std::minmax({ corners[k], corners[(k + 1) % 3] });
  }

  void Add(const std::array<int, 3>& corners, int original)
  {
    for (int k = 0; k < 3; ++k)
    {
      this->TrianglesAt[EdgeOf(corners, k)].insert(static_cast<int>(this->Corners.size()));
    }
    this->Corners.push_back(corners);
    this->Original.push_back(original);
    this->IsAlive.push_back(1);
  }

  void Remove(int triangle)
  {
    this->IsAlive[triangle] = 0;
    for (int k = 0; k < 3; ++k)
    {
      const auto at = this->TrianglesAt.find(EdgeOf(this->Corners[triangle], k));
      at->second.erase(triangle);
      if (at->second.empty())
      {
        this->TrianglesAt.erase(at);
      }
    }
  }

  int Given;
  const Eigen::MatrixXd& Loop;
  std::vector<RowVector2d> Images;
  std::vector<std::array<int, 3>> Corners;
  std::vector<int> Original;
  std::vector<char> IsAlive;
  std::vector<std::pair<int, std::array<int, 3>>> Uncut;    ///< triangles away from the loop
  std::map<std::pair<int, int>, std::set<int>> TrianglesAt; ///< by edge, the lower point first
  std::vector<Weights> NewPoints;
  std::map<int, SeamPoint> Seam; ///< by point
};

} // namespace

SoupImprint ImprintLoop(const Eigen::MatrixXd& images, const Eigen::MatrixXi& triangles,
  const Eigen::MatrixXd& loop, double snap)
{
  Cutting cutting(images, triangles, loop, snap);
  for (int i = 0; i < static_cast<int>(loop.rows()); ++i)
  {
    cutting.InsertPoint(i);
  }
  for (int i = 0; i < static_cast<int>(loop.rows()); ++i)
  {
    cutting.InsertLine(i);
  }
  return cutting.Finish();
}

} // namespace shape
