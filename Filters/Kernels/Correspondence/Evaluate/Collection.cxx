#include "Correspondence/Evaluate/Collection.h"

#include "Base/Errors.h"
#include "Correspondence/Evaluate/Private/TriangleProducts.h"
#include "Geometry/Procrustes.h"
#include "Linear/SymmetricEigen.h"
#include "Spectrum/LaplaceEigenproblem.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

namespace shape
{
namespace
{

using Measure = CollectionOptions::MeasureType;

/// The products of functions on the template, G G^T, and functions in which they are orthonormal.
class ProductBasis
{
public:
  /// functions: n x k. first: the number of functions before them that have no product.
  ProductBasis(Eigen::MatrixXd functions, const Eigen::MatrixXd& products, Eigen::Index first)
    : Functions(std::move(functions))
    , Factor(products)
    , First(first)
  {
    if (this->Factor.info() != Eigen::Success)
    {
      throw SolveFailure("the eigenfunctions of the Template are not independent on its triangles; "
                         "lower BasisSize, or remesh the surface");
    }
    this->Deltas = this->Functions * this->Factor.matrixL();
    this->Norms = this->Deltas.rowwise().squaredNorm();
  }

  /// The symmetric operator G^-1 other G^-T.
  Eigen::MatrixXd Symmetric(const Eigen::MatrixXd& other) const
  {
    const Eigen::MatrixXd half = this->Factor.matrixL().solve(other);
    const Eigen::MatrixXd result = this->Factor.matrixL().solve(half.transpose());
    return 0.5 * (result + result.transpose());
  }

  /// The operator in the eigenbasis, with 0 for the functions that have no product.
  Eigen::MatrixXd InEigenbasis(const Eigen::MatrixXd& other) const
  {
    const Eigen::Index size = other.rows() + this->First;
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
    matrix.bottomRightCorner(other.rows(), other.rows()) = this->Factor.solve(other);
    return matrix;
  }

  /// The operators, and their mean and variance, from the products on each shape.
  CollectionVariation Vary(const std::vector<Eigen::MatrixXd>& symmetric) const
  {
    const auto count = static_cast<double>(symmetric.size());
    const Eigen::Index size = symmetric[0].rows();
    Eigen::MatrixXd mean = Eigen::MatrixXd::Zero(size, size), squares = mean;
    for (const Eigen::MatrixXd& each : symmetric)
    {
      mean += each / count;
    }
    Eigen::VectorXd variance = Eigen::VectorXd::Zero(this->Functions.rows());
    for (const Eigen::MatrixXd& each : symmetric)
    {
      const Eigen::MatrixXd apart = each - mean;
      squares += apart * apart / count;
      variance += this->Field(apart).cwiseAbs2() / count;
    }
    CollectionVariation result;
    result.Deviation = variance.cwiseSqrt();
    const Eigenpairs pairs = FindLargestEigenpairs(
      squares, static_cast<int>(std::min<Eigen::Index>(size, VariationFunctions)));
    result.Variances = pairs.Values.cwiseMax(0.0);
    result.Functions = this->Functions * this->Factor.matrixU().solve(pairs.Vectors);
    return result;
  }

  /// The change of the factor for one standard deviation of each coordinate, of mean 0.
  Eigen::MatrixXd Modes(
    const std::vector<Eigen::MatrixXd>& symmetric, const Eigen::MatrixXd& coordinates) const
  {
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(this->Functions.rows(), coordinates.cols());
    // Shorter columns are rounding.
    const double shortest = 1e-6 * coordinates.colwise().norm().maxCoeff();
    for (Eigen::Index k = 0; k < coordinates.cols(); ++k)
    {
      const double length = coordinates.col(k).norm();
      Eigen::MatrixXd mode = Eigen::MatrixXd::Zero(symmetric[0].rows(), symmetric[0].cols());
      for (std::size_t i = 0; length > shortest && i < symmetric.size(); ++i)
      {
        mode += coordinates(static_cast<Eigen::Index>(i), k) / length * symmetric[i];
      }
      result.col(k) = this->Field(mode) / std::sqrt(static_cast<double>(symmetric.size()));
    }
    return result;
  }

private:
  /// At each point, <d, D d> / <d, d> of the delta d there.
  Eigen::VectorXd Field(const Eigen::MatrixXd& symmetric) const
  {
    const Eigen::VectorXd values =
      (this->Deltas * symmetric).cwiseProduct(this->Deltas).rowwise().sum();
    return (this->Norms.array() > 0.0).select(values.cwiseQuotient(this->Norms), 0.0);
  }

  Eigen::MatrixXd Functions;
  Eigen::LLT<Eigen::MatrixXd> Factor;
  Eigen::Index First;
  Eigen::MatrixXd Deltas; ///< the delta at each point as a combination of the functions
  Eigen::VectorXd Norms;  ///< n: <d, d>
};

void RequireShapes(const Surface& base, const std::vector<CollectionShape>& shapes, Measure measure)
{
  if (shapes.empty())
  {
    throw InvalidInput("there is no shape to compare");
  }
  for (std::size_t i = 0; i < shapes.size(); ++i)
  {
    const std::string name = "shape " + std::to_string(i);
    const Surface& surface = shapes[i].Shape;
    RequireFinite(surface.Points(), name);
    if (shapes[i].Images.Triangles.size() > 0)
    {
      if (measure == Measure::Procrustes && shapes[i].OnShape.rows() != base.Points().rows())
      {
        throw InvalidInput("Procrustes compares positions of the Template's points, but " + name +
          " has " + std::to_string(shapes[i].OnShape.rows()) + " of them; invert its map");
      }
      continue;
    }
    if (surface.Points().rows() != base.Points().rows())
    {
      throw InvalidInput(name + " has " + std::to_string(surface.Points().rows()) +
        " points, but the Template has " + std::to_string(base.Points().rows()) +
        "; map the Template onto each shape first, or set Correspondence to Maps");
    }
    if (surface.Triangles().rows() != base.Triangles().rows() ||
      surface.Triangles() != base.Triangles())
    {
      throw InvalidInput(name + " has other triangles than the Template, so its points are in " +
        "another order; map the Template onto each shape first, or set Correspondence to Maps");
    }
  }
}

/// The distances after the best rigid motion, and the deviation from the mean shape (Superimpose).
void CompareSuperimposed(const std::vector<CollectionShape>& shapes, const Eigen::VectorXd& weights,
  const Progress& progress, CollectionResult& result)
{
  std::vector<Eigen::MatrixXd> points;
  for (const CollectionShape& shape : shapes)
  {
    points.push_back(
      MoveToCentre(shape.OnShape.rows() > 0 ? shape.OnShape : shape.Shape.Points(), weights));
  }
  const auto count = static_cast<Eigen::Index>(points.size());
  for (Eigen::Index i = 0; i < count; ++i)
  {
    progress(0.9 * static_cast<double>(i) / static_cast<double>(count));
    for (Eigen::Index j = 0; j < i; ++j)
    {
      const Eigen::Matrix3d rotation = FitRotation(points[i], points[j], weights);
      result.Distances(i, j) = result.Distances(j, i) =
        RootMeanSquare(points[i] * rotation.transpose() - points[j], weights);
    }
  }
  const Superimposed all = Superimpose(std::move(points), weights, false, progress.Part(0.9, 1.0));
  Eigen::VectorXd variance = Eigen::VectorXd::Zero(all.Mean.rows());
  for (const Eigen::MatrixXd& each : all.Shapes)
  {
    variance += (each - all.Mean).rowwise().squaredNorm() / static_cast<double>(count);
  }
  result.PositionDeviation = variance.cwiseSqrt();
}

/// Classical MDS (Torgerson 1952): the eigenvectors of the squared distances, centred twice.
void Embed(int dimension, CollectionResult& result)
{
  const Eigen::Index count = result.Distances.rows();
  Eigen::MatrixXd squares = result.Distances.cwiseAbs2();
  squares.rowwise() -= squares.colwise().mean().eval();
  squares.colwise() -= squares.rowwise().mean().eval();
  const Eigenpairs pairs = FindLargestEigenpairs(
    -0.5 * squares, static_cast<int>(std::min<Eigen::Index>(dimension, count)));
  const Eigen::VectorXd values = pairs.Values.cwiseMax(0.0);
  result.Embedding = pairs.Vectors * values.cwiseSqrt().asDiagonal();
  FixSigns(result.Embedding);
  const double total = -0.5 * squares.trace();
  result.Shares =
    total > 0.0 ? Eigen::VectorXd(values / total) : Eigen::VectorXd::Zero(values.size());
}

void OrderByDissimilarity(CollectionResult& result)
{
  const Eigen::Index count = result.Distances.rows();
  result.Dissimilarities =
    result.Distances.rowwise().sum() / static_cast<double>(std::max<Eigen::Index>(count - 1, 1));
  result.Order.resize(count);
  std::iota(result.Order.begin(), result.Order.end(), 0);
  std::stable_sort(result.Order.begin(), result.Order.end(),
    [&](int a, int b) { return result.Dissimilarities(a) > result.Dissimilarities(b); });
}

/// Average linkage: the two nearest clusters become one, whose distance from another one is the
/// mean over its shapes. The cluster with the first shape comes first.
std::vector<int> OrderLeaves(const Eigen::MatrixXd& distances)
{
  std::vector<std::vector<int>> clusters(distances.rows());
  for (int i = 0; i < static_cast<int>(clusters.size()); ++i)
  {
    clusters[i] = { i };
  }
  Eigen::MatrixXd between = distances;
  while (clusters.size() > 1)
  {
    const auto count = static_cast<Eigen::Index>(clusters.size());
    Eigen::Index a = 0, b = 1;
    for (Eigen::Index i = 0; i < count; ++i)
    {
      for (Eigen::Index j = i + 1; j < count; ++j)
      {
        if (between(i, j) < between(a, b))
        {
          a = i;
          b = j;
        }
      }
    }
    const auto sizeA = static_cast<double>(clusters[a].size()),
               sizeB = static_cast<double>(clusters[b].size());
    const Eigen::VectorXd mean =
      (sizeA * between.col(a) + sizeB * between.col(b)) / (sizeA + sizeB);
    between.col(a) = mean;
    between.row(a) = mean.transpose();
    clusters[a].insert(clusters[a].end(), clusters[b].begin(), clusters[b].end());
    clusters.erase(clusters.begin() + b);
    // Without row and column b.
    std::vector<int> kept;
    for (int i = 0; i < static_cast<int>(count); ++i)
    {
      if (i != b)
      {
        kept.push_back(i);
      }
    }
    between = between(kept, kept).eval();
  }
  return clusters.front();
}

/// Adds the squared Frobenius distances of symmetric operators, divided by their size.
void AddSquaredDistances(const std::vector<Eigen::MatrixXd>& operators, Eigen::MatrixXd& squares)
{
  for (Eigen::Index i = 0; i < squares.rows(); ++i)
  {
    for (Eigen::Index j = 0; j < squares.cols(); ++j)
    {
      squares(i, j) +=
        (operators[i] - operators[j]).squaredNorm() / static_cast<double>(operators[i].rows());
    }
  }
}

/// The shapes, each scaled to this area. One without area stays as it is.
std::vector<CollectionShape> ScaledToArea(std::vector<CollectionShape> shapes, double area)
{
  for (CollectionShape& shape : shapes)
  {
    const double own = ComputeArea(shape.Shape), factor = own > 0.0 ? std::sqrt(area / own) : 1.0;
    shape.Shape = shape.Shape.WithPoints(factor * shape.Shape.Points());
    shape.OnShape *= factor;
  }
  return shapes;
}

} // namespace

// 1. The eigenfunctions of the template, and their products there.
// 2. Their products on each shape, and from these the operators.
// 3. Distances of operators or positions; embedding and order from these.
CollectionResult CompareCollection(const Surface& base, const std::vector<CollectionShape>& shapes,
  const CollectionOptions& options, const Progress& progress)
{
  const Topology topology = RequireManifold(base, "the Template");
  RequireShapes(base, shapes, options.Measure);
  if (options.Scale)
  {
    CollectionOptions unscaled = options;
    unscaled.Scale = false;
    return CompareCollection(base, ScaledToArea(shapes, ComputeArea(base)), unscaled, progress);
  }
  RequireOption(options.EmbeddingDimension >= 1, "EmbeddingDimension", options.EmbeddingDimension,
    "at least 1");
  const Eigen::Index points = (topology.ComponentId.array() >= 0).count();
  const int size = options.BasisSize;
  RequireOption(size > topology.Components && size <= points, "BasisSize", size,
    "more than the number of the Template's components, " + std::to_string(topology.Components) +
      ", and at most the number of its points, " + std::to_string(points));
  const Eigen::Index constants = topology.Components, varying = size - constants;
  const LaplaceEigenpairs eigenpairs =
    SolveLaplaceEigenproblem(base, size, progress.Part(0.0, 0.4, "computing the eigenfunctions"));
  // The first eigenfunction of each component is constant; solved for each component, they are the
  // first ones in all.
  const Eigen::MatrixXd& functions = eigenpairs.Eigenfunctions;
  const TriangleProducts here = ComputeTriangleProducts(base, functions);
  const ProductBasis areas(functions, here.Mass, 0),
    gradients(
      functions.rightCols(varying), here.Dirichlet.bottomRightCorner(varying, varying), constants);

  const Progress each = progress.Part(0.4, 0.8, "computing the operators");
  std::vector<Eigen::MatrixXd> ofAreas, ofGradients;
  CollectionVariation area, conformal;
  for (std::size_t i = 0; i < shapes.size(); ++i)
  {
    each(static_cast<double>(i) / static_cast<double>(shapes.size()));
    const SurfacePoints& images = shapes[i].Images;
    const TriangleProducts there = ComputeTriangleProducts(shapes[i].Shape,
      images.Triangles.size() > 0 ? PullBack(images, base.Triangles(), functions) : functions);
    const Eigen::MatrixXd dirichlet = there.Dirichlet.bottomRightCorner(varying, varying);
    ofAreas.push_back(areas.Symmetric(there.Mass));
    ofGradients.push_back(gradients.Symmetric(dirichlet));
    area.Operators.push_back(areas.InEigenbasis(there.Mass));
    conformal.Operators.push_back(gradients.InEigenbasis(dirichlet));
    if (!area.Operators.back().allFinite() || !conformal.Operators.back().allFinite())
    {
      throw InvalidInput("shape " + std::to_string(i) +
        " has triangles without area, whose angles are unknown; remesh or clean it");
    }
  }
  const Progress last = progress.Part(0.8, 1.0, "comparing the shapes");
  last(0.0);
  CollectionResult result;
  result.Area = areas.Vary(ofAreas);
  result.Area.Operators = std::move(area.Operators);
  last(0.3);
  result.Conformal = gradients.Vary(ofGradients);
  result.Conformal.Operators = std::move(conformal.Operators);
  FixSigns(result.Area.Functions);
  FixSigns(result.Conformal.Functions);
  const auto count = static_cast<Eigen::Index>(shapes.size());
  result.Distances = Eigen::MatrixXd::Zero(count, count);
  if (options.Measure == Measure::Procrustes)
  {
    CompareSuperimposed(shapes, eigenpairs.Masses, last.Part(0.6, 0.95), result);
  }
  else
  {
    if (options.Measure != Measure::Conformal)
    {
      AddSquaredDistances(ofAreas, result.Distances);
    }
    if (options.Measure != Measure::Area)
    {
      AddSquaredDistances(ofGradients, result.Distances);
    }
    result.Distances = result.Distances.cwiseSqrt().eval();
  }
  last(0.95);
  Embed(options.EmbeddingDimension, result);
  result.Area.Modes = areas.Modes(ofAreas, result.Embedding);
  result.Conformal.Modes = gradients.Modes(ofGradients, result.Embedding);
  OrderByDissimilarity(result);
  result.Leaves = OrderLeaves(result.Distances);
  progress(1.0);
  return result;
}

int FindNearestToAll(const std::vector<CollectionShape>& shapes, const CollectionOptions& options,
  const Progress& progress)
{
  return CompareCollection(shapes.at(0).Shape, shapes, options, progress).Order.back();
}

} // namespace shape
