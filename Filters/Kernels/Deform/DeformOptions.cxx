#include "Deform/DeformOptions.h"

#include "Base/Errors.h"
#include "Mesh/Topology.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

namespace shape
{
namespace
{

constexpr double LargestPower = 32.0; // above this, only the nearest point has an influence

void RequireField(const Eigen::VectorXd& field, Eigen::Index points, const std::string& name)
{
  if (field.size() != 0 && field.size() != points)
  {
    throw InvalidInput(name + " has " + std::to_string(field.size()) +
      " values, but the shape has " + std::to_string(points) + " points; give one for each");
  }
  RequireFinite(field, name);
  if (field.size() > 0 && field.minCoeff() < 0.0)
  {
    Eigen::Index first = 0;
    while (field(first) >= 0.0)
    {
      ++first;
    }
    throw InvalidInput(name + " is " + std::to_string(field(first)) + " at point " +
      std::to_string(first) + "; it must not be negative");
  }
}

/// The curvature of each node relative to the others, in [0, 1): 1/2 if its Gaussian curvature is
/// the mean.
Eigen::VectorXd RelativeCurvatures(const PointGraph& graph)
{
  // A single angle defect is noisy: take the mean over a node and its neighbours.
  Eigen::VectorXd curvatures = graph.Curvatures;
  for (int i = 0; i < graph.Size(); ++i)
  {
    double sum = graph.Weights(i) * graph.Curvatures(i), weights = graph.Weights(i);
    for (int k = graph.First[i]; k < graph.First[i + 1]; ++k)
    {
      const int j = graph.Neighbours[k];
      sum += graph.Weights(j) * graph.Curvatures(j);
      weights += graph.Weights(j);
    }
    curvatures(i) = weights > 0.0 ? sum / weights : 0.0;
  }
  const double total = graph.Weights.sum();
  const double mean = total > 0.0 ? curvatures.dot(graph.Weights) / total : 0.0;
  return mean > 0.0 ? Eigen::VectorXd(curvatures.array() / (curvatures.array() + mean))
                    : Eigen::VectorXd(0.0 * curvatures);
}

} // namespace

bool operator==(const DeformOptions& a, const DeformOptions& b)
{
  const auto all = [](const DeformOptions& one)
  {
    return std::tie(one.Method, one.IntegrateCurves, one.Rigidity, one.RigidityBy,
      one.RigidityContrast, one.Scale, one.InnerScale, one.UpwindRadius, one.Distance,
      one.Multiresolution, one.SegmentBy, one.MinimumProtrusion, one.LaplacianSmoothing);
  };
  return all(a) == all(b);
}

bool IntegratesCurves(const DeformOptions& options)
{
  return options.IntegrateCurves && options.Method == DeformOptions::MethodType::BoundaryRelative;
}

void RequireOptions(const DeformOptions& options)
{
  // Larger factors would overflow in powers and products.
  constexpr double maximum = 1e6;
  const auto positive = [&](const char* name, double value)
  { RequireOption(value > 0.0 && value <= maximum, name, value, "positive and at most 1e+06"); };
  positive("Rigidity", options.Rigidity);
  positive("RigidityContrast", options.RigidityContrast);
  positive("Scale", options.Scale);
  positive("InnerScale", options.InnerScale);
  positive("UpwindRadius", options.UpwindRadius);
  RequireOption(options.MinimumProtrusion >= 0.0 && options.MinimumProtrusion <= 1.0,
    "MinimumProtrusion", options.MinimumProtrusion, "from 0 to 1");
  if (IntegratesCurves(options) && options.Distance != DeformOptions::DistanceType::Euclidean)
  {
    throw InvalidInput("integrals along curves have a closed form for Euclidean distances only; "
                       "set Distance to Euclidean, or turn IntegrateCurves off");
  }
}

void RequireFields(const DeformFields& fields, Eigen::Index points)
{
  RequireField(fields.Rigidity, points, "the rigidity");
  RequireField(fields.Scale, points, "the scale");
}

/// The parameters of section 2.2, which vary with the distance from the handle, the curvature or a
/// field of the user.
PointParameters FindParameters(const PointGraph& shape, const FrontSweep& sweep,
  const DeformOptions& options, const DeformFields& fields)
{
  RequireFields(fields, shape.NodeOf.size());
  const auto all = static_cast<int>(sweep.Nodes.size());
  const double last = sweep.Arrivals.back();
  const bool byCurvature = options.RigidityBy == DeformOptions::RigidityByType::Curvature;
  const Eigen::VectorXd curved = byCurvature ? RelativeCurvatures(shape) : Eigen::VectorXd();
  PointParameters parameters{ Eigen::VectorXd(all), Eigen::VectorXd(all) };
  for (int node = 0; node < all; ++node)
  {
    const double share = last > 0.0 ? sweep.Arrivals[sweep.Ranks[node]] / last : 0.0;
    const bool own = node < shape.Size(); // otherwise a node of the handle, which is not scaled
    double rigidity = options.Rigidity, scale = options.Scale;
    if (options.RigidityBy == DeformOptions::RigidityByType::Distance)
    {
      // Geometric interpolation: 1 at the handle, the contrast at the farthest point.
      rigidity *= std::pow(options.RigidityContrast, share);
    }
    else if (byCurvature && own)
    {
      // Curved regions are less rigid, so they absorb the stretch (section 2.2).
      rigidity *= std::pow(options.RigidityContrast, -curved(node));
    }
    scale *= 1.0 + (options.InnerScale - 1.0) * share;
    if (own && fields.Rigidity.size() > 0)
    {
      rigidity *= fields.Rigidity(shape.PointOf[node]);
    }
    if (own && fields.Scale.size() > 0)
    {
      scale *= fields.Scale(shape.PointOf[node]);
    }
    parameters.Powers(node) =
      // Rigidity and the power k are inversely related (section 2.2); k = 2 is the standard weight.
      rigidity > 0.0 ? std::min(2.0 / rigidity, LargestPower) : LargestPower;
    parameters.Scales(node) = scale;
  }
  return parameters;
}

} // namespace shape
