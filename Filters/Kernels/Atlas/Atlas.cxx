#include "Atlas/Atlas.h"

#include "Atlas/Private/ShapeModes.h"
#include "Base/Errors.h"
#include "Geometry/Procrustes.h"
#include "Mesh/Extent.h"
#include "Mesh/Topology.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

namespace shape
{
namespace
{

void RequireAtlasShapes(
  const std::vector<Eigen::MatrixXd>& shapes, const Eigen::MatrixXi& triangles)
{
  if (shapes.size() < 3)
  {
    throw InvalidInput("an atlas needs at least 3 shapes, but there are " +
      std::to_string(shapes.size()) + "; put more together with Group Datasets");
  }
  for (std::size_t i = 0; i < shapes.size(); ++i)
  {
    const std::string name = "shape " + std::to_string(i);
    RequireFinite(shapes[i], name);
    if (shapes[i].rows() != shapes[0].rows())
    {
      throw InvalidInput(name + " has " + std::to_string(shapes[i].rows()) +
        " points, but shape 0 has " + std::to_string(shapes[0].rows()) +
        "; map each shape onto a template first");
    }
    RequireExtent(Mesh{ shapes[i], triangles }, name);
    if (!(ComputeArea({ shapes[i], triangles }) > 0.0))
    {
      throw InvalidInput(name + " has no area; give surfaces");
    }
  }
}

void RequireVariable(const Eigen::VectorXd& values, std::size_t shapes, const std::string& name)
{
  if (values.size() != static_cast<Eigen::Index>(shapes))
  {
    throw InvalidInput("there are " + std::to_string(values.size()) + " values of " + name +
      " for " + std::to_string(shapes) + " shapes; give one for each shape");
  }
  if (!values.allFinite())
  {
    throw InvalidInput("a value of " + name + " is not finite; leave out the shape, or give it");
  }
}

/// The shares of the area, on average over the shapes.
Eigen::VectorXd ComputeShares(
  const std::vector<Eigen::MatrixXd>& shapes, const Eigen::MatrixXi& triangles)
{
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(shapes[0].rows());
  for (const Eigen::MatrixXd& each : shapes)
  {
    const Eigen::VectorXd areas = ComputePointAreas({ each, triangles });
    weights += areas / areas.sum();
  }
  return weights / weights.sum();
}

/// Returns `values` minus their least-squares fit by the centred values `of`.
Eigen::VectorXd RemoveFit(const Eigen::VectorXd& values, const Eigen::VectorXd& of)
{
  const Eigen::VectorXd centred = values.array() - values.mean();
  const Eigen::VectorXd rest = centred - of * (of.dot(centred) / of.squaredNorm());
  if (rest.squaredNorm() < 1e-12 * centred.squaredNorm())
  {
    throw InvalidInput("the groups are a linear function of the Regression column, so one cannot "
                       "be removed from the other; clear Remove Regression");
  }
  return rest;
}

void DescribeShapes(const Eigen::MatrixXd& products, const PrincipalScores& model,
  const LeaveOneOut& leaveOneOut, AtlasResult& result)
{
  const Eigen::Index shapes = products.rows(), rank = model.Variances.size(),
                     modes = result.NumberOfModes;
  const Eigen::MatrixXd squares = model.Scores.cwiseAbs2();
  result.ReconstructionErrors =
    (squares.rightCols(rank - modes) * model.Variances.tail(rank - modes)).cwiseSqrt();
  result.MahalanobisDistances = squares.leftCols(modes).rowwise().sum().cwiseSqrt();
  result.OutlierDistances = leaveOneOut.OutlierDistances;
  std::vector<int> order(shapes);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
    [&](int a, int b) { return result.OutlierDistances(a) > result.OutlierDistances(b); });
  result.OutlierRanks.resize(shapes);
  for (Eigen::Index rankOf = 0; rankOf < shapes; ++rankOf)
  {
    result.OutlierRanks[order[rankOf]] = static_cast<int>(rankOf);
  }
}

} // namespace

// 1. The shapes, superimposed, and their deviations from the mean.
// 2. What the covariate and the groups explain.
// 3. Modes and scores, and the choice of their number.
// 4. The statistics of the model.
AtlasResult BuildAtlas(const std::vector<Eigen::MatrixXd>& shapes, const Eigen::MatrixXi& triangles,
  const AtlasVariables& variables, const AtlasOptions& options, const Progress& progress)
{
  RequireOption(
    options.NumberOfModes >= 0, "NumberOfModes", options.NumberOfModes, "0 or positive");
  RequireOption(options.SpecificitySamples >= 1, "SpecificitySamples", options.SpecificitySamples,
    "at least 1");
  RequireOption(options.Permutations >= 1, "Permutations", options.Permutations, "at least 1");
  RequireOption(options.Seed >= 0, "Seed", options.Seed, "0 or positive");
  RequireAtlasShapes(shapes, triangles);
  const Eigen::VectorXd weights = ComputeShares(shapes, triangles);
  Superimposed aligned =
    Superimpose(shapes, weights, options.Scale, progress.Part(0.0, 0.2, "aligning the shapes"));
  const auto count = static_cast<Eigen::Index>(shapes.size()), points = shapes[0].rows();
  const double degrees = static_cast<double>(count - 1);
  AtlasResult result;
  Eigen::MatrixXd deviations(3 * points, count);
  result.Distances.resize(count);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    const Eigen::MatrixXd own = aligned.Shapes[i] - aligned.Mean;
    result.Distances(i) = RootMeanSquare(own, weights);
    deviations.col(i) = own.reshaped();
  }
  if (result.Distances.maxCoeff() <= 1e-12 * aligned.Sizes.mean())
  {
    deviations.setZero(); // the shapes differ by rounding alone
  }
  const PermutationTestOptions testing{ options.Permutations, options.Seed };
  const bool regressed = variables.Covariate.size() > 0;
  if (regressed)
  {
    RequireVariable(variables.Covariate, shapes.size(), "the Regression column");
    result.OfCovariate = TestByPermutation(deviations, weights, variables.Covariate, testing,
      progress.Part(0.2, 0.35, "testing the regression"));
  }
  const bool removed = regressed && options.RemoveRegression;
  const Eigen::VectorXd covariate = removed
    ? Eigen::VectorXd(variables.Covariate.array() - variables.Covariate.mean())
    : Eigen::VectorXd();
  if (removed)
  {
    deviations -= result.OfCovariate.Slope.reshaped() * covariate.transpose();
  }
  if (variables.Groups.size() > 0)
  {
    RequireVariable(variables.Groups, shapes.size(), "the Groups column");
    result.OfGroups = TestByPermutation(deviations, weights,
      removed ? RemoveFit(variables.Groups, covariate) : variables.Groups, testing,
      progress.Part(0.35, 0.5, "testing the groups"));
  }
  result.Deviations =
    (deviations.rowwise().squaredNorm().reshaped(points, 3).rowwise().sum() / degrees).cwiseSqrt();

  const Progress last = progress.Part(0.5, 1.0, "computing the modes");
  const DeviationProducts products =
    ComputeDeviationProducts(deviations, weights, options.Seed, last.Part(0.0, 0.2));
  PrincipalScores model = ComputePrincipalScores(products.All, last.Part(0.2, 0.3));
  const Eigen::Index rank = model.Variances.size();
  int modes = options.NumberOfModes;
  if (modes == 0 && rank > 0)
  {
    modes =
      ChooseNumberOfModes(ComputePredictionErrors(products, options.Seed, last.Part(0.3, 0.4)));
  }
  result.NumberOfModes = std::min(modes, static_cast<int>(rank));
  result.Modes.resize(points, Eigen::Index(3) * result.NumberOfModes);
  for (Eigen::Index k = 0; k < result.NumberOfModes; ++k)
  {
    result.Modes.middleCols(3 * k, 3) =
      (deviations * (model.Scores.col(k) / degrees)).reshaped(points, 3);
  }
  // Shapes that are alike have no modes.
  const LeaveOneOut leaveOneOut = rank > 0
    ? ComputeLeaveOneOut(
        products.All, static_cast<int>(rank), result.NumberOfModes, last.Part(0.4, 0.9))
    : LeaveOneOut{ Eigen::VectorXd(), Eigen::VectorXd::Zero(count) };
  DescribeShapes(products.All, model, leaveOneOut, result);
  result.Generalisation = leaveOneOut.Generalisation;
  result.Specificity =
    ComputeSpecificity(model, options.SpecificitySamples, options.Seed, last.Part(0.9, 1.0));
  result.Explained.resize(rank);
  std::partial_sum(model.Variances.begin(), model.Variances.end(), result.Explained.begin());
  if (rank > 0)
  {
    result.Explained /= model.Variances.sum();
  }
  result.Aligned = std::move(aligned.Shapes);
  result.Mean = std::move(aligned.Mean);
  result.Sizes = std::move(aligned.Sizes);
  result.Scales = std::move(aligned.Scales);
  result.Variances = std::move(model.Variances);
  result.Scores = std::move(model.Scores);
  progress(1.0);
  return result;
}

AtlasField BuildAtlasField(const AtlasResult& atlas, const Eigen::MatrixXd& values)
{
  const auto count = static_cast<Eigen::Index>(atlas.Aligned.size());
  if (values.cols() != count)
  {
    throw InvalidInput("there are values of " + std::to_string(values.cols()) + " shapes for " +
      std::to_string(count) + " shapes; give one column for each shape");
  }
  RequireFinite(values, "a quantity of the shapes");
  AtlasField field;
  field.Mean = values.rowwise().mean();
  const Eigen::MatrixXd deviations = values.colwise() - field.Mean;
  field.Deviations =
    (deviations.rowwise().squaredNorm() / static_cast<double>(count - 1)).cwiseSqrt();
  // Scores have the mean 0 and are not correlated, so each mode is a regression of its own.
  const Eigen::MatrixXd scores = atlas.Scores.leftCols(atlas.NumberOfModes);
  field.Modes = deviations * scores * scores.colwise().squaredNorm().cwiseInverse().asDiagonal();
  return field;
}

} // namespace shape
