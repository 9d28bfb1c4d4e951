#include "Cage/CageDeform.h"

#include "Base/Errors.h"
#include "Cage/Private/CageMap.h"
#include "Cage/Private/CageTriangle.h"
#include "Cage/Private/GreenMap.h"
#include "Cage/Private/HarmonicMap.h"
#include "Cage/Private/MeanValueMap.h"
#include "Distance/SignedDistance.h"
#include "Mesh/Extent.h"
#include "Mesh/UsedPoints.h"
#include "Solids/Nesting.h"

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <Eigen/SVD>

#include <cmath>
#include <string>
#include <utility>

namespace shape
{
namespace
{

/// An affine map: y = Linear x + Offset.
struct Affine
{
  Eigen::Matrix3d Linear = Eigen::Matrix3d::Identity();
  Eigen::RowVector3d Offset = Eigen::RowVector3d::Zero();
};

/// The affine map that moves `points` closest to `moved`, in the least-squares sense.
Affine FitAffine(const Eigen::MatrixXd& points, const Eigen::MatrixXd& moved)
{
  Eigen::MatrixXd rows(points.rows(), 4);
  rows << points, Eigen::VectorXd::Ones(points.rows());
  const Eigen::MatrixXd fit = rows.colPivHouseholderQr().solve(moved);
  Affine affine{ fit.topRows<3>().transpose(), fit.row(3) };
  const Eigen::Vector3d stretches = affine.Linear.jacobiSvd().singularValues();
  if (!(stretches(2) > 1e-6 * stretches(0)))
  {
    throw InvalidInput("the MovedCage is flat: its best affine motion cannot be inverted; switch "
                       "Reproduce Affine off");
  }
  return affine;
}

void RequireOptions(const CageDeformOptions& options)
{
  RequireOption(options.Tetrahedra >= 1000 && options.Tetrahedra <= 100000000, "Tetrahedra",
    options.Tetrahedra, "from 1,000 to 100,000,000");
}

/// Returns the cage with the points that its triangles use, at a size of 1 around the origin.
Surface Normalize(
  const Surface& cage, const Eigen::RowVector3d& centre, double size, const std::vector<int>& used)
{
  Mesh mesh{ cage.Points()(used, Eigen::all),
    RenumberPoints(cage.Triangles(), used, cage.Points().rows()) };
  mesh.Points = (mesh.Points.rowwise() - centre) / size;
  return mesh;
}

/// Returns, for a position on the cage, one just inside the closest triangle: gradients are not
/// continuous on the cage.
Eigen::RowVector3d StepInside(const Mesh& cage, int triangle, const Eigen::RowVector3d& closest)
{
  constexpr double share = 1e-5;
  const Eigen::Matrix3d corners = GetCorners(cage, triangle);
  const Eigen::RowVector3d area =
    (corners.row(1) - corners.row(0)).cross(corners.row(2) - corners.row(0));
  return closest + share * (corners.colwise().mean() - closest) -
    0.1 * share * area / std::sqrt(area.norm());
}

} // namespace

struct CageDeformer::Data
{
  CageDeformOptions Options;
  Eigen::RowVector3d Centre;
  double Size = 1.0;
  Surface Cage; ///< with Centre at the origin, and Size 1; faces outwards
  Affine After; ///< applied to the map's result
  std::unique_ptr<CageMap> Map;
  std::unique_ptr<SignedDistance> Distance;
  int Tetrahedra = 0;

  /// Whether a position that is this far outside stays.
  bool IsOutside(double distance) const
  {
    constexpr double tolerance = 1e-6, farthest = 100.0;
    return distance >
      (this->Options.Coordinates == CageCoordinates::MeanValue ? farthest : tolerance);
  }

  CagePositions Locate(const Eigen::MatrixXd& points, const SignedDistance::Result& at,
    Eigen::VectorXi& outside) const;
};

CageDeformer::CageDeformer(const Surface& cage, const Eigen::MatrixXd& moved,
  const CageDeformOptions& options, const Progress& progress)
  : Impl(std::make_unique<Data>())
{
  Data& data = *this->Impl;
  data.Options = options;
  RequireOptions(options);
  RequireExtent(cage, "the Cage");
  if (moved.rows() != cage.Points().rows() || moved.cols() != 3)
  {
    throw InvalidInput("the MovedCage has " + std::to_string(moved.rows()) +
      " points and the Cage " + std::to_string(cage.Points().rows()) +
      "; connect the same surface with its points moved");
  }
  const std::vector<int> used = FindUsedPoints(cage.Triangles(), cage.Points().rows());
  Eigen::MatrixXd target = moved(used, Eigen::all);
  RequireFinite(target, "the MovedCage");
  RequireExtent(target, "the MovedCage");
  const Eigen::AlignedBox3d box = ComputeBox(cage);
  data.Centre = box.center();
  data.Size = box.sizes().maxCoeff();
  data.Cage = OrientByNesting(
    Normalize(cage, data.Centre, data.Size, used), "the Cage", progress.Part(0.0, 0.05));
  target = (target.rowwise() - data.Centre) / data.Size;
  if (options.Coordinates == CageCoordinates::Green && options.ReproduceAffine)
  {
    data.After = FitAffine(data.Cage.Points(), target);
    target = (target.rowwise() - data.After.Offset) * data.After.Linear.inverse().transpose();
  }
  const Eigen::MatrixXd steps = target - data.Cage.Points();
  switch (options.Coordinates)
  {
    case CageCoordinates::MeanValue:
      data.Map = std::make_unique<MeanValueMap>(data.Cage, steps);
      break;
    case CageCoordinates::Green:
      data.Map = std::make_unique<GreenMap>(data.Cage, target);
      break;
    case CageCoordinates::Harmonic:
    {
      auto map = std::make_unique<HarmonicMap>(
        data.Cage, steps, options.Tetrahedra, progress.Part(0.05, 0.95));
      data.Tetrahedra = map->GetTetrahedra();
      data.Map = std::move(map);
      break;
    }
  }
  data.Distance = std::make_unique<SignedDistance>(data.Cage);
  progress(1.0);
}

CageDeformer::~CageDeformer() = default;
CageDeformer::CageDeformer(CageDeformer&&) noexcept = default;
CageDeformer& CageDeformer::operator=(CageDeformer&&) noexcept = default;

int CageDeformer::GetTetrahedra() const
{
  return this->Impl->Tetrahedra;
}

/// points: relative to the size of the cage. outside: becomes 1 at positions that stay.
CagePositions CageDeformer::Data::Locate(
  const Eigen::MatrixXd& points, const SignedDistance::Result& at, Eigen::VectorXi& outside) const
{
  constexpr double rounding = 1e-13, nearCage = 1e-6;
  const Eigen::Index count = points.rows();
  outside.setZero(count);
  CagePositions positions{ points, Eigen::VectorXi::Zero(count), at.Closest, {} };
  if (this->Options.DeformationGradient)
  {
    positions.GradientAt = points;
  }
  for (Eigen::Index i = 0; i < count; ++i)
  {
    const double distance = at.Distances(i);
    const Eigen::RowVector3d closest = at.Closest.Positions.row(i);
    outside(i) = this->IsOutside(distance);
    // Outside, a map that is defined inside is evaluated on the cage. What stays is ignored later.
    const bool isOutside =
      distance > 0.0 && this->Options.Coordinates != CageCoordinates::MeanValue;
    positions.IsOnCage(i) = isOutside || std::abs(distance) <= rounding;
    if (positions.IsOnCage(i))
    {
      positions.Points.row(i) = closest;
    }
    if (this->Options.DeformationGradient && (isOutside || std::abs(distance) < nearCage))
    {
      positions.GradientAt.row(i) = StepInside(this->Cage, at.Closest.Triangles(i), closest);
    }
  }
  return positions;
}

CageMovedPoints CageDeformer::Evaluate(
  const Eigen::MatrixXd& points, const Progress& progress) const
{
  const Data& data = *this->Impl;
  RequireFinite(points, "the Input");
  const Eigen::MatrixXd scaled = (points.rowwise() - data.Centre) / data.Size;
  const SignedDistance::Result at =
    data.Distance->Evaluate(scaled, progress.Part(0.0, 0.1, "finding points outside the cage"));
  CageMovedPoints result;
  const CagePositions positions = data.Locate(scaled, at, result.OutsideDomain);
  const CageMotion motion =
    data.Map->Evaluate(positions, progress.Part(0.1, 1.0, "moving the points"));
  const Eigen::Matrix3d linear = data.After.Linear;
  result.Points = points;
  result.Gradients.resize(motion.Gradients.rows(), 9);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    const bool moves = result.OutsideDomain(i) == 0;
    if (moves)
    {
      const Eigen::RowVector3d place = scaled.row(i) + motion.Steps.row(i);
      result.Points.row(i) =
        data.Centre + data.Size * (place * linear.transpose() + data.After.Offset);
    }
    if (motion.Gradients.rows() > 0)
    {
      Eigen::Matrix<double, 3, 3, Eigen::RowMajor> gradient = Eigen::Matrix3d::Identity();
      if (moves)
      {
        gradient += Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(
          Eigen::RowVectorXd(motion.Gradients.row(i)).data());
        gradient = (linear * gradient).eval();
      }
      result.Gradients.row(i) = Eigen::Map<const Eigen::Matrix<double, 1, 9>>(gradient.data());
    }
  }
  return result;
}

} // namespace shape
