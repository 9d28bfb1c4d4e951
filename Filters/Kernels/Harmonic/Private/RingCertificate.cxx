#include "Harmonic/Private/RingCertificate.h"

#include "Base/Parallel.h"
#include "Harmonic/Private/BoxInSolid.h"
#include "Harmonic/Private/ChargeField.h"
#include "Harmonic/Private/DeterminantSign.h"
#include "Harmonic/Private/TaylorExpansion.h"
#include "Harmonic/Private/TetrahedronBox.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <utility>

namespace shape
{
namespace
{

/// A cube with a charge nearer than 1 / this many radii is divided at once.
constexpr double RingNearestRatio = 0.6;
/// The smallest cubes / the longest edge of a tetrahedron's box.
constexpr double RingSmallest = 1.0 / 16.0;

/// A cube, and the tetrahedra that it has not decided.
struct RingCube
{
  BoxCube Place;
  std::shared_ptr<const ChargeField> Field;
  std::vector<int> Tetrahedra; ///< indices into the ring
};

/// One tetrahedron, in scaled coordinates: h(x) = Constant + Linear x, phi(x) = Share + Slope . x.
struct RingElement
{
  Eigen::Matrix<double, 4, 3> Corners;
  Eigen::AlignedBox3d Box;
  double Size = 0.0; ///< longest edge of the box
  Eigen::Matrix3d Linear;
  Eigen::Vector3d Constant;
  Eigen::RowVector3d Slope;
  double Share = 0.0;
  double Rounding = 0.0; ///< bound of the rounding errors of the entries of Linear
};

/// Returns the position of a monomial in TaylorExpansion::GetMonomials.
int IndexOf(int x, int y, int z)
{
  const int degree = x + y + z, others = y + z;
  return TaylorExpansion::SizeOf(degree - 1) + others * (others + 1) / 2 + z;
}

class RingCover
{
public:
  RingCover(const ChargeSet& map, const MapRepair& repair, const std::vector<int>& tetrahedra);
  std::vector<char> FindUndecided(const Progress& progress);

private:
  bool Decide(const RingElement& element, const RingCube& cube, const TaylorExpansion& expansion,
    const Eigen::Vector3d& valueError) const;
  std::vector<RingCube> Examine(const RingCube& cube, std::vector<int>& failed) const;

  ChargeColumns Charges;
  double Reach = 0.0; ///< the largest distance of a charge from a position of the ring
  std::vector<RingElement> Elements;
  RingCube Root;
};

RingCover::RingCover(
  const ChargeSet& map, const MapRepair& repair, const std::vector<int>& tetrahedra)
{
  // Lengths are multiplied by a power of two, after the origin is moved to the middle. Images are
  // scaled in the same way, so derivatives stay.
  const Eigen::MatrixXd& points = repair.Elements.Points;
  const Eigen::RowVector3d low = points.colwise().minCoeff(), high = points.colwise().maxCoeff();
  const Eigen::RowVector3d origin = 0.5 * (low + high);
  const double scale = std::exp2(-std::ceil(std::log2(0.5 * (high - low).maxCoeff())));
  const Eigen::RowVector3d imageOrigin = repair.Elements.Images.colwise().mean();
  this->Charges.resize(6, map.Points.rows());
  this->Charges.topRows<3>() = scale * (map.Points.rowwise() - origin).transpose();
  this->Charges.bottomRows<3>() = scale * scale * 0.25 * M_1_PI * map.Charges.transpose();
  this->Reach = 2.0 * std::sqrt(3.0);
  if (map.Points.rows() > 0)
  {
    this->Reach += this->Charges.topRows<3>().colwise().norm().maxCoeff();
  }
  auto field = std::make_shared<ChargeField>();
  field->Far.Coefficients.row(0) =
    scale * (map.Affine * origin.transpose().homogeneous() - imageOrigin.transpose()).transpose();
  field->Far.Coefficients.middleRows<3>(1) = map.Affine.leftCols<3>().transpose();
  field->Near.resize(map.Points.rows());
  std::iota(field->Near.begin(), field->Near.end(), 0);
  this->Root.Place = { Eigen::Vector3d::Zero(), 1.0 };
  this->Root.Field = field;
  for (const int t : tetrahedra)
  {
    RingElement element;
    Eigen::Matrix<double, 4, 3> images;
    Eigen::Vector4d shares;
    for (int k = 0; k < 4; ++k)
    {
      const int point = repair.Elements.Tetrahedra(t, k);
      element.Corners.row(k) = scale * (points.row(point) - origin);
      images.row(k) = scale * (repair.Elements.Images.row(point) - imageOrigin);
      shares(k) = repair.Shares(point);
      element.Box.extend(element.Corners.row(k).transpose());
    }
    element.Size = element.Box.sizes().maxCoeff();
    const Eigen::Matrix3d edges =
      element.Corners.bottomRows<3>().rowwise() - element.Corners.row(0);
    const Eigen::Matrix3d inverse = edges.inverse();
    const Eigen::Vector3d first = element.Corners.row(0).transpose();
    element.Linear = (inverse * (images.bottomRows<3>().rowwise() - images.row(0))).transpose();
    element.Constant = images.row(0).transpose() - element.Linear * first;
    element.Slope = (inverse * (shares.tail<3>().array() - shares(0)).matrix()).transpose();
    element.Share = shares(0) - element.Slope * first;
    element.Rounding = 1e-14 * inverse.norm() *
      (edges.norm() * inverse.norm() * element.Size * element.Linear.norm() + images.norm());
    this->Root.Tetrahedra.push_back(static_cast<int>(this->Elements.size()));
    this->Elements.push_back(element);
  }
}

/// Whether det J_g > 0 is proven in the cube. g extends beyond its tetrahedron. valueError: bounds
/// of the error of the expansion of f.
bool RingCover::Decide(const RingElement& element, const RingCube& cube,
  const TaylorExpansion& expansion, const Eigen::Vector3d& valueError) const
{
  constexpr int degree = TaylorExpansion::LowDegree;
  const Eigen::Vector3d& centre = cube.Place.Centre;
  const double half = cube.Place.Half;
  // f - h, multiplied by phi, plus h, around the centre.
  Eigen::Matrix<double, TaylorExpansion::Size, 3> difference = expansion.Coefficients;
  difference.row(0) -= (element.Constant + element.Linear * centre).transpose();
  difference.middleRows<3>(1) -= element.Linear.transpose();
  const double share = element.Share + element.Slope * centre;
  TaylorExpansion blend;
  for (int i = 0; i < TaylorExpansion::SizeOf(degree); ++i)
  {
    const auto& powers = TaylorExpansion::GetMonomials()[i].Powers;
    blend.Coefficients.row(i) += share * difference.row(i);
    for (int axis = 0; axis < 3; ++axis)
    {
      const int next =
        IndexOf(powers[0] + (axis == 0), powers[1] + (axis == 1), powers[2] + (axis == 2));
      blend.Coefficients.row(next) += element.Slope(axis) * difference.row(i);
    }
  }
  blend.Coefficients.middleRows<3>(1) += element.Linear.transpose();
  // What is left out.
  const double largest = std::abs(share) + half * element.Slope.lpNorm<1>();
  const double steepest = element.Slope.norm();
  const Eigen::Matrix3d leftOut = std::pow(half, degree) * cube.Field->HighTerms;
  blend.Magnitude = largest * expansion.Magnitude;
  blend.Remainder = largest * expansion.Remainder +
    steepest *
      (valueError + cube.Place.Radius() * leftOut.rowwise().norm() +
        TaylorExpansion::Rounding * this->Reach * expansion.Magnitude) +
    Eigen::Vector3d::Constant((1.0 + largest) * element.Rounding + 1e-12 * steepest);
  return BoundDeterminant(blend, Eigen::Vector3d::Constant(half), degree + 1, largest * leftOut)
           .Sign > 0;
}

/// Decides the tetrahedra of a cube, appends those that fail, and returns its children with those
/// that are left.
std::vector<RingCube> RingCover::Examine(const RingCube& cube, std::vector<int>& failed) const
{
  std::vector<int> left, tested;
  for (const int id : cube.Tetrahedra)
  {
    // A larger cube would hardly decide it.
    (cube.Place.Half <= this->Elements[id].Size ? tested : left).push_back(id);
  }
  const double radius = cube.Place.Radius();
  const double nearest = radius / RingNearestRatio;
  const bool tooNear = std::any_of(cube.Field->Near.begin(), cube.Field->Near.end(),
    [&](int i) {
      return (this->Charges.col(i).head<3>() - cube.Place.Centre).squaredNorm() < nearest * nearest;
    });
  if (!tested.empty() && !tooNear)
  {
    TaylorExpansion expansion = cube.Field->Far.GetLowTerms(cube.Place.Centre - cube.Field->Centre);
    expansion.Add(
      this->Charges, cube.Field->Near, cube.Place.Centre, radius, TaylorExpansion::LowDegree);
    const Eigen::Vector3d valueError =
      cube.Field->ValueError + radius * (expansion.Remainder - cube.Field->Far.Remainder);
    tested.erase(
      std::remove_if(tested.begin(), tested.end(),
        [&](int id) { return this->Decide(this->Elements[id], cube, expansion, valueError); }),
      tested.end());
  }
  for (const int id : tested)
  {
    (2.0 * cube.Place.Half > RingSmallest * this->Elements[id].Size ? left : failed).push_back(id);
  }
  std::vector<RingCube> children;
  if (left.empty())
  {
    return children;
  }
  const std::shared_ptr<const ChargeField> field = Descend(cube.Field, this->Charges, cube.Place);
  for (int octant = 0; octant < 8; ++octant)
  {
    RingCube child{ cube.Place.Child(octant), field, {} };
    const Eigen::Vector3d half = Eigen::Vector3d::Constant((1.0 + 1e-9) * child.Place.Half);
    const Eigen::AlignedBox3d box(child.Place.Centre - half, child.Place.Centre + half);
    for (const int id : left)
    {
      if (MayMeet(this->Elements[id].Corners, box))
      {
        child.Tetrahedra.push_back(id);
      }
    }
    if (!child.Tetrahedra.empty())
    {
      children.push_back(std::move(child));
    }
  }
  return children;
}

/// Returns for each element whether a cube left it undecided.
std::vector<char> RingCover::FindUndecided(const Progress& progress)
{
  std::vector<char> undecided(this->Elements.size(), 0);
  std::vector<RingCube> open{ this->Root };
  double done = 0.0;
  while (!open.empty())
  {
    const auto count = static_cast<int>(open.size());
    std::vector<std::vector<RingCube>> children(count);
    std::vector<std::vector<int>> failed(count);
    const double next = done + 0.2 * (1.0 - done);
    ParallelFor(
      count, 4,
      [&](int begin, int end)
      {
        for (int i = begin; i < end; ++i)
        {
          children[i] = this->Examine(open[i], failed[i]);
        }
      },
      progress.Part(done, next));
    done = next;
    for (const std::vector<int>& some : failed)
    {
      for (const int id : some)
      {
        undecided[id] = 1;
      }
    }
    open.clear();
    for (std::vector<RingCube>& some : children)
    {
      for (RingCube& child : some)
      {
        std::vector<int>& ids = child.Tetrahedra;
        ids.erase(
          std::remove_if(ids.begin(), ids.end(), [&](int id) { return undecided[id] != 0; }),
          ids.end());
        if (!ids.empty())
        {
          open.push_back(std::move(child));
        }
      }
    }
  }
  return undecided;
}

} // namespace

std::vector<int> FindUncertified(const ChargeSet& map, const MapRepair& repair,
  const std::vector<int>& tetrahedra, const Progress& progress)
{
  std::vector<int> found;
  if (tetrahedra.empty())
  {
    return found;
  }
  RingCover cover(map, repair, tetrahedra);
  const std::vector<char> undecided = cover.FindUndecided(progress);
  for (std::size_t i = 0; i < tetrahedra.size(); ++i)
  {
    if (undecided[i] != 0)
    {
      found.push_back(tetrahedra[i]);
    }
  }
  progress(1.0);
  return found;
}

} // namespace shape
