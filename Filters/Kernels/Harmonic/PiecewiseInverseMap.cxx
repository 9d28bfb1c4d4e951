#include "Harmonic/PiecewiseInverseMap.h"

#include "Harmonic/Private/InverseSearch.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace shape
{

PiecewiseInverseMap::PiecewiseInverseMap(std::shared_ptr<const PiecewiseHarmonicMap> map,
  const InverseMapOptions& options, const Progress& progress)
  : Map(std::move(map))
  , Iterations(options.MaximumIterations)
{
  const int count = this->Map->RegionCount();
  for (int r = 0; r < count; ++r)
  {
    this->Inverses.emplace_back(this->Map->Map(r), this->Map->BoundaryOf(r), this->Map->Farthest(),
      options, progress.Part(static_cast<double>(r) / count, static_cast<double>(r + 1) / count));
  }
  const Eigen::MatrixXd& points = this->Map->Domain().GetSurface().Points();
  this->Goal = options.Tolerance * ComputeLongestBoxEdge(this->Map->Evaluate(points));
  this->MaxStep = 0.25 * ComputeLongestBoxEdge(points);
  if (this->Map->HasRepair())
  {
    this->PrepareRepair();
  }
}

void PiecewiseInverseMap::PrepareRepair()
{
  const FiniteElements& repair = this->Map->RepairElements();
  std::vector<int> core, ring;
  for (int t = 0; t < repair.Tetrahedra.rows(); ++t)
  {
    const bool linear = (repair.Images(repair.Tetrahedra.row(t), 3).array() == 0.0).all();
    (linear ? core : ring).push_back(t);
  }
  const auto invert = [&](const std::vector<int>& tetrahedra)
  {
    return tetrahedra.empty()
      ? nullptr
      : std::make_unique<const FiniteElementMap>(FiniteElements{ repair.Images.leftCols<3>(),
          repair.Tetrahedra(tetrahedra, Eigen::all), repair.Points, {}, 0 });
  };
  this->Core = invert(core);
  this->Ring = invert(ring);
}

InverseMap::Result PiecewiseInverseMap::FindInRepaired(
  const Eigen::MatrixXd& points, const Progress& progress) const
{
  using State = InverseMap::State;
  InverseMap::Result result{ points,
    Eigen::VectorXi::Constant(points.rows(), static_cast<int>(State::Outside)) };
  const auto accept = [&](int row, const auto& position)
  {
    result.Points.row(row) = position;
    result.States(row) = static_cast<int>(State::Found);
  };
  std::vector<int> open(points.rows());
  std::iota(open.begin(), open.end(), 0);
  std::vector<int> left;
  // In the core: the inverse of linear maps.
  if (this->Core)
  {
    const FiniteElementMap::Values at =
      this->Core->Evaluate(points, progress.Part(0.0, 0.1), this->Goal);
    for (const int i : open)
    {
      at.Cells(i) >= 0 ? accept(i, at.Images.row(i)) : left.push_back(i);
    }
    open = std::exchange(left, {});
  }
  // Outside the repair: the charges.
  const InverseMap::Result charges =
    this->Inverses.front().Find(points(open, Eigen::all), progress.Part(0.1, 0.8));
  const Eigen::VectorXi cells = this->Map->LocateInRepair(charges.Points).Cells;
  for (std::size_t k = 0; k < open.size(); ++k)
  {
    if (charges.States(k) == static_cast<int>(State::Found) && cells(k) < 0)
    {
      accept(open[k], charges.Points.row(k));
      continue;
    }
    left.push_back(open[k]);
    if (charges.States(k) != static_cast<int>(State::Outside))
    {
      result.States(open[k]) = static_cast<int>(State::Missed);
    }
  }
  open = std::exchange(left, {});
  // In the ring: Newton's method.
  if (this->Ring && !open.empty())
  {
    Steps steps(progress.Part(0.8, 1.0));
    const FiniteElementMap::Values starts =
      this->Ring->Evaluate(points(open, Eigen::all), steps.Next());
    Search search = StartSearch(*this->Map, starts.Images, points(open, Eigen::all), steps.Next());
    IterateNewton(*this->Map, search, { this->Goal, this->MaxStep, this->Iterations }, steps);
    const Eigen::VectorXi outside = FindPointsOutsideDomain(
      this->Map->Domain(), search.Positions, this->Map->Farthest(), steps.Next());
    for (std::size_t k = 0; k < open.size(); ++k)
    {
      if (search.Misses(k) <= this->Goal && !outside(k))
      {
        accept(open[k], search.Positions.row(k));
      }
    }
  }
  return result;
}

InverseMap::Result PiecewiseInverseMap::Find(
  const Eigen::MatrixXd& points, const Progress& progress) const
{
  // Outline, for each region from the outermost inwards:
  // 1. The preimages of all open points under the region's harmonic map are searched.
  // 2. Newton's method with the complete map continues from them: in a skin, or beyond the border,
  //    the complete map differs.
  // 3. A solution counts if its image meets the goal and it lies in the domain. The others stay
  //    open for the next region.
  if (this->Map->HasRepair())
  {
    return this->FindInRepaired(points, progress);
  }
  if (this->Inverses.size() == 1)
  {
    return this->Inverses.front().Find(points, progress);
  }
  using State = InverseMap::State;
  InverseMap::Result result{ points,
    Eigen::VectorXi::Constant(points.rows(), static_cast<int>(State::Outside)) };
  std::vector<int> open(points.rows());
  std::iota(open.begin(), open.end(), 0);
  for (std::size_t r = 0; r < this->Inverses.size() && !open.empty(); ++r)
  {
    const double share = 1.0 / static_cast<double>(this->Inverses.size());
    const Progress part = progress.Part(share * r, share * (r + 1));
    // Step 1: the region's own map.
    const InverseMap::Result own =
      this->Inverses[r].Find(points(open, Eigen::all), part.Part(0.0, 0.8));
    std::vector<int> candidates, left;
    for (std::size_t k = 0; k < open.size(); ++k)
    {
      if (own.States(k) == static_cast<int>(State::Found))
      {
        candidates.push_back(static_cast<int>(k));
        continue;
      }
      left.push_back(open[k]);
      // A point that one region missed is Missed, even if it is Outside for the others.
      result.States(open[k]) = std::max(result.States(open[k]), own.States(k));
    }
    Steps steps(part.Part(0.8, 1.0));
    std::vector<int> ids;
    for (const int k : candidates)
    {
      ids.push_back(open[k]);
    }
    // Step 2: the complete map.
    Search search = StartSearch(
      *this->Map, own.Points(candidates, Eigen::all), points(ids, Eigen::all), steps.Next());
    IterateNewton(*this->Map, search, { this->Goal, this->MaxStep, this->Iterations }, steps);
    // Step 3: solutions in the domain.
    const Eigen::VectorXi outside = FindPointsOutsideDomain(
      this->Map->Domain(), search.Positions, this->Map->Farthest(), steps.Next());
    for (std::size_t k = 0; k < ids.size(); ++k)
    {
      if (search.Misses(k) <= this->Goal && !outside(k))
      {
        result.Points.row(ids[k]) = search.Positions.row(k);
        result.States(ids[k]) = static_cast<int>(State::Found);
      }
      else
      {
        left.push_back(ids[k]);
        result.States(ids[k]) = static_cast<int>(State::Missed);
      }
    }
    std::sort(left.begin(), left.end());
    open = std::move(left);
  }
  return result;
}

} // namespace shape
