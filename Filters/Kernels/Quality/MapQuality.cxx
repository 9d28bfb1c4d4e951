#include "Quality/MapQuality.h"

#include "Base/Parallel.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>

namespace shape
{
namespace
{

using Measures = Eigen::Array<double, MapMeasureCount, 1>;

/// Sizes up to this share of the longest edge squared or cubed are rounding error.
constexpr double Flat = 1e-14;
/// Tolerances of the plane and the unit sphere; points in single precision meet only the second
/// one.
constexpr double PlaneTolerance = 1e-9;
constexpr double SphereTolerance = 1e-6;
constexpr int CellsPerChunk = 256;

bool IsTriangle(const std::array<int, 4>& simplex)
{
  return simplex[3] < 0;
}

/// Returns the edges of a simplex from its first corner, as columns; a triangle's third column is
/// 0.
Eigen::Matrix3d Edges(const Eigen::MatrixXd& points, const std::array<int, 4>& simplex)
{
  Eigen::Matrix3d edges = Eigen::Matrix3d::Zero();
  for (int k = 1; k < 4 && simplex[k] >= 0; ++k)
  {
    edges.col(k - 1) = points.row(simplex[k]) - points.row(simplex[0]);
  }
  return edges;
}

Eigen::RowVector3d AreaVector(const Eigen::MatrixXd& points, const std::array<int, 4>& triangle)
{
  const Eigen::Matrix3d edges = Edges(points, triangle);
  return edges.col(0).cross(edges.col(1)).transpose();
}

double LongestEdge(const Eigen::Matrix3d& edges, bool triangle)
{
  double square = edges.colwise().squaredNorm().maxCoeff();
  for (int k = 0; k < (triangle ? 1 : 3); ++k)
  {
    square = std::max(square, (edges.col((k + 1) % 3) - edges.col(k)).squaredNorm());
  }
  return std::sqrt(square);
}

/// The side to which triangles face, relative to the surface around them.
class Sides
{
public:
  /// height, offSphere: those of the complete data.
  Sides(const Eigen::MatrixXd& points, const CellSimplices& cells, double height, double offSphere)
    : Points(points)
    , InPlane(height <= PlaneTolerance)
    , OnSphere(offSphere <= SphereTolerance)
    , Around(Eigen::MatrixXd::Zero(points.rows(), 3))
  {
    for (const std::array<int, 4>& simplex : cells.Corners)
    {
      if (IsTriangle(simplex) && !this->InPlane && !this->OnSphere)
      {
        const Eigen::RowVector3d area = AreaVector(points, simplex);
        for (int k = 0; k < 3; ++k)
        {
          this->Around.row(simplex[k]) += area;
        }
      }
    }
  }

  /// Whether sides are defined in the same way for both.
  bool IsLike(const Sides& other) const
  {
    return this->InPlane == other.InPlane && this->OnSphere == other.OnSphere;
  }

  double Of(const std::array<int, 4>& triangle) const
  {
    const Eigen::RowVector3d area = AreaVector(this->Points, triangle);
    Eigen::RowVector3d reference = Eigen::RowVector3d::UnitZ();
    if (!this->InPlane)
    {
      const Eigen::MatrixXd& from = this->OnSphere ? this->Points : this->Around;
      reference = from.row(triangle[0]) + from.row(triangle[1]) + from.row(triangle[2]);
      // The triangle itself has contributed at its three corners.
      reference -= this->OnSphere ? Eigen::RowVector3d::Zero().eval() : (3.0 * area).eval();
    }
    return area.dot(reference) < 0.0 ? -1.0 : 1.0;
  }

private:
  const Eigen::MatrixXd& Points;
  bool InPlane;
  bool OnSphere;
  Eigen::MatrixXd Around; ///< n x 3: sums of area vectors
};

/// Computes the measures from |J|^2, |adj J|^2, det J and the d singular values, the largest first.
Measures FromInvariants(
  int d, double square, double adjugate, double determinant, const Eigen::Vector3d& singular)
{
  // |J^-1|^2 = |adj J|^2 / det^2, and the sum of (s_i - 1)^2 is |J|^2 - 2 sum s_i + d. The smallest
  // s_i carries the sign of the determinant.
  const double size = std::abs(determinant);
  const double inverse = adjugate / (size * size);
  const double smallest = singular(d - 1);
  const double trace = singular.head(d - 1).sum() + (determinant < 0.0 ? -smallest : smallest);
  const double area = 0.5 * (size + 1.0 / size);
  const double angles = d == 2 ? 0.5 * square / size : 0.125 * (square * inverse - 1.0);
  Measures measures;
  measures << determinant, 0.5 * square, square + inverse,
    std::max(1.0, square / (d * std::pow(size, 2.0 / d))), std::max(0.0, square - 2.0 * trace + d),
    singular.head(d).array().log().square().sum(),
    std::exp(std::max(1.0, angles) + 0.5 * std::max(1.0, area)), std::max(1.0, area),
    std::sqrt(inverse / d), 1.0 / smallest, smallest, singular(0);
  return measures.isNaN()
    .select(Measures::Constant(LargestMeasure), measures)
    .cwiseMin(LargestMeasure)
    .cwiseMax(-LargestMeasure);
}

Measures OfTriangle(const Eigen::Matrix3d& source, const Eigen::Matrix3d& image, double sign)
{
  // Images of two orthonormal vectors of the source's plane.
  const Eigen::Vector3d u = source.col(0), v = source.col(1);
  const double square = u.squaredNorm();
  const Eigen::Vector3d first = image.col(0) / std::sqrt(square);
  const Eigen::Vector3d second =
    (image.col(1) - u.dot(v) / square * image.col(0)) * (std::sqrt(square) / u.cross(v).norm());
  const double norm = first.squaredNorm() + second.squaredNorm();
  const double determinant = sign * first.cross(second).norm();
  // In two dimensions |adj J| = |J|, and (s_1 +- s_2)^2 = |J|^2 +- 2 |det J|. The difference is
  // written so that nothing cancels near a similarity.
  const double size = std::abs(determinant);
  const double lengths = first.norm() * second.norm(), cosine = first.dot(second);
  const double apart = first.norm() - second.norm();
  const double sheared = lengths > 0.0 ? cosine * cosine / (lengths + size) : 0.0;
  const double largest =
    0.5 * (std::sqrt(norm + 2.0 * size) + std::sqrt(apart * apart + 2.0 * sheared));
  const double smallest = largest > 0.0 ? std::min(size / largest, largest) : 0.0;
  return FromInvariants(2, norm, norm, determinant, { largest, smallest, 0.0 });
}

Measures OfTetrahedron(const Eigen::Matrix3d& source, const Eigen::Matrix3d& image)
{
  const Eigen::Matrix3d jacobian = image * source.inverse();
  const double determinant = image.determinant() / source.determinant();
  double adjugate = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    adjugate += jacobian.col(k).cross(jacobian.col((k + 1) % 3)).squaredNorm();
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(jacobian);
  Eigen::Vector3d values = Eigen::Vector3d::Zero(); // if the Jacobian has overflowed
  if (svd.info() == Eigen::Success)
  {
    values = svd.singularValues();
  }
  return FromInvariants(3, jacobian.squaredNorm(), adjugate, determinant, values);
}

Measures OfIsometry(int d)
{
  Measures measures;
  measures << 1.0, 0.5 * d, 2.0 * d, 1.0, 0.0, 0.0, std::exp(1.5), 1.0, 1.0, 1.0, 1.0, 1.0;
  return measures;
}

/// Returns twice the area or six times the volume, or 0 if that is rounding error.
double SizeOf(const Eigen::Matrix3d& edges, bool triangle)
{
  const double size =
    triangle ? edges.col(0).cross(edges.col(1)).norm() : std::abs(edges.determinant());
  const double longest = LongestEdge(edges, triangle);
  const double minimum = Flat * longest * longest * (triangle ? 1.0 : longest);
  return size > minimum ? size : 0.0;
}

/// The measures of a cell whose image has no size, given those by its rounded singular values.
void SetWithoutSize(Measures& measures)
{
  for (const MapMeasure zero :
    { MapMeasure::JacobianDeterminant, MapMeasure::SmallestSingularValue })
  {
    measures(static_cast<int>(zero)) = 0.0;
  }
  for (const MapMeasure infinite : { MapMeasure::SymmetricDirichlet,
         MapMeasure::ConformalDistortion, MapMeasure::Hencky, MapMeasure::AMIPS,
         MapMeasure::AreaDistortion, MapMeasure::L2Stretch, MapMeasure::LinfStretch })
  {
    measures(static_cast<int>(infinite)) = LargestMeasure;
  }
}

bool AnyAtLargest(Measures measures)
{
  measures(static_cast<int>(MapMeasure::AMIPS)) = 0.0; // large, but finite
  return (measures.abs() >= LargestMeasure).any();
}

} // namespace

MapExtent ComputeMapExtent(
  const Eigen::MatrixXd& points, const Eigen::MatrixXd& images, const CellSimplices& cells)
{
  MapExtent extent;
  for (const std::array<int, 4>& simplex : cells.Corners)
  {
    extent.Dimension = std::max(extent.Dimension, IsTriangle(simplex) ? 2 : 3);
    for (int k = 0; k < 3 && IsTriangle(simplex); ++k)
    {
      const auto widen = [&](const Eigen::MatrixXd& positions, double& height, double& offSphere)
      {
        const Eigen::RowVector3d position = positions.row(simplex[k]);
        height = std::max(height, std::abs(position(2)));
        offSphere = std::max(offSphere, std::abs(position.norm() - 1.0));
      };
      widen(points, extent.SourceHeight, extent.SourceOffSphere);
      widen(images, extent.ImageHeight, extent.ImageOffSphere);
    }
  }
  return extent;
}

MapQualityResult EvaluateMapQuality(const Eigen::MatrixXd& points, const Eigen::MatrixXd& images,
  const CellSimplices& cells, const MapExtent& extent, const Progress& progress)
{
  progress(0.0);
  const Sides source(points, cells, extent.SourceHeight, extent.SourceOffSphere);
  const Sides image(images, cells, extent.ImageHeight, extent.ImageOffSphere);
  const bool sameKind = source.IsLike(image);
  progress(0.1);
  const int count = cells.Count();
  const Measures isometry = OfIsometry(std::max(2, extent.Dimension));
  MapQualityResult result{ isometry.matrix().transpose().replicate(count, 1),
    Eigen::VectorXd::Zero(count), Eigen::VectorXi::Zero(count), Eigen::VectorXi::Zero(count),
    Eigen::VectorXi::Zero(count) };
  const auto measureCell = [&](int cell)
  {
    Measures sums = Measures::Zero();
    double size = 0.0, minimum = LargestMeasure;
    for (int s = cells.Offsets[cell]; s < cells.Offsets[cell + 1]; ++s)
    {
      const std::array<int, 4>& simplex = cells.Corners[s];
      const bool triangle = IsTriangle(simplex);
      result.Counted(cell) = extent.Dimension == (triangle ? 2 : 3);
      const Eigen::Matrix3d from = Edges(points, simplex), to = Edges(images, simplex);
      const double part = cells.Shares[s] * SizeOf(from, triangle);
      if (!result.Counted(cell) || part == 0.0)
      {
        continue;
      }
      Measures measures = triangle
        ? OfTriangle(from, to, image.Of(simplex) * (sameKind ? source.Of(simplex) : 1.0))
        : OfTetrahedron(from, to);
      if (SizeOf(to, triangle) == 0.0)
      {
        SetWithoutSize(measures);
      }
      result.Degenerate(cell) = result.Degenerate(cell) || AnyAtLargest(measures);
      // A measure that is infinite in one simplex is infinite in the mean.
      sums = (measures >= LargestMeasure || sums >= LargestMeasure)
               .select(Measures::Constant(LargestMeasure), sums + part * measures);
      size += part;
      minimum = std::min(minimum, measures(0));
    }
    if (size > 0.0)
    {
      Measures means = (sums >= LargestMeasure).select(sums, sums / size);
      means(0) = minimum;
      result.Measures.row(cell) = means.matrix().transpose();
      result.Flipped(cell) = minimum < 0.0;
    }
    else
    {
      // A surface or solid cell without simplices has no size either.
      result.Degenerate(cell) = result.Counted(cell);
    }
    result.Sizes(cell) = size;
  };
  ParallelFor(
    count, CellsPerChunk,
    [&](int begin, int end)
    {
      for (int cell = begin; cell < end; ++cell)
      {
        measureCell(cell);
      }
    },
    progress.Part(0.1, 1.0));
  progress(1.0);
  return result;
}

MapQualitySums::MapQualitySums()
  : Minima(Measures::Constant(LargestMeasure))
  , Maxima(Measures::Constant(-LargestMeasure))
  , Sums(Measures::Zero())
  , Weights(Measures::Zero())
  , Undefined(Measures::Zero())
{
}

void MapQualitySums::Add(const MapQualityResult& result, const Eigen::VectorXi& use)
{
  for (Eigen::Index cell = 0; cell < result.Sizes.size(); ++cell)
  {
    if (!use(cell) || !result.Counted(cell))
    {
      continue;
    }
    this->Cells += 1.0;
    this->Flipped += result.Flipped(cell);
    this->Degenerate += result.Degenerate(cell);
    const double size = result.Sizes(cell);
    if (size == 0.0)
    {
      this->Undefined += 1.0;
      continue;
    }
    const Measures values = result.Measures.row(cell).transpose();
    this->Minima = this->Minima.min(values);
    this->Maxima = this->Maxima.max(values);
    const auto defined = (values.abs() < LargestMeasure).eval();
    this->Sums += defined.select(size * values, 0.0);
    this->Weights += defined.select(Measures::Constant(size), 0.0);
    this->Undefined += defined.select(Measures::Zero(), Measures::Ones());
  }
}

double MapQualitySums::Mean(MapMeasure measure) const
{
  const int row = static_cast<int>(measure);
  return this->Weights(row) > 0.0 ? this->Sums(row) / this->Weights(row) : LargestMeasure;
}

} // namespace shape
