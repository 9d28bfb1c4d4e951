// The curve skeleton of a model beside that of CGAL.
#include "Cases/CgalMesh.h"
#include "Cases/ModelFile.h"
#include "Driver/Case.h"
#include "Driver/Cost.h"

#include "Distance/SignedDistance.h"
#include "Mesh/Extent.h"
#include "Mesh/Surface.h"
#include "Remesh/IsotropicRemesh.h"
#include "Skeleton/Skeleton.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/extract_mean_curvature_flow_skeleton.h>

#include <boost/graph/connected_components.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace
{

constexpr const char* Usage = R"(MODEL

Extracts the curve skeleton of a closed surface by the kernel and by CGAL's
extract_mean_curvature_flow_skeleton, with their defaults. Both get the same even mesh, with edges
of a hundredth of the diagonal, because CGAL's skeletons of coarse meshes are poor.

Figures: method, points, branches, cycles (links - points + components), genus of the surface,
components, outside (points not inside the surface), distance (the mean distance of the
other skeleton's points from the nearest point of this one, divided by the diagonal of the box),
inradii (the same, divided by this skeleton's radius at the nearest point; ours), cost.)";

using Kernel = CGAL::Simple_cartesian<double>;
using CgalSurface = CGAL::Surface_mesh<Kernel::Point_3>;
using CgalSkeleton = CGAL::Mean_curvature_flow_skeletonization<CgalSurface>::Skeleton;

/// The mean distance of points from the nearest of others.
double MeanDistance(const Eigen::MatrixXd& points, const Eigen::MatrixXd& others)
{
  double sum = 0.0;
  for (const auto& point : points.rowwise())
  {
    sum += (others.rowwise() - point).rowwise().norm().minCoeff();
  }
  return sum / static_cast<double>(points.rows());
}

/// The mean distance of points from the nearest of a skeleton, in parts of its radius there.
double MeanDistanceInRadii(const Eigen::MatrixXd& points, const shape::CurveSkeleton& skeleton)
{
  double sum = 0.0;
  for (const auto& point : points.rowwise())
  {
    Eigen::Index nearest = 0;
    const double distance = (skeleton.Points.rowwise() - point).rowwise().norm().minCoeff(&nearest);
    sum += distance / skeleton.Radii(nearest);
  }
  return sum / static_cast<double>(points.rows());
}

int CountOutside(const shape::Surface& surface, const Eigen::MatrixXd& points)
{
  const Eigen::VectorXd distances = shape::SignedDistance(surface).Evaluate(points).Distances;
  return static_cast<int>((distances.array() > 0.0).count());
}

int CountCgalBranches(const CgalSkeleton& skeleton)
{
  // Each branch has two ends at points with other than two links; cycles alone have none.
  int ends = 0;
  for (const auto vertex : CGAL::make_range(vertices(skeleton)))
  {
    const int degree = static_cast<int>(out_degree(vertex, skeleton));
    ends += degree == 2 ? 0 : degree;
  }
  return ends / 2;
}

void Run(benchmark::Arguments& arguments, benchmark::Figures& figures)
{
  const shape::Surface model = benchmark::ReadModel(arguments.NextWord());
  arguments.RequireAllRead();
  const shape::Topology topology = shape::RequireClosedSurface(model, "the model");
  const int genus = topology.Components - topology.EulerNumber / 2;
  const double diagonal = shape::ComputeBoxDiagonal(model.AsMesh());
  shape::IsotropicRemeshOptions fine;
  fine.EdgeLength = 0.01 * diagonal;
  const shape::Surface surface = shape::RemeshIsotropically(model, fine);

  shape::CurveSkeleton own;
  const benchmark::Cost ownCost =
    benchmark::Measure([&]() { own = shape::ExtractCurveSkeleton(surface); });

  CgalSkeleton peer;
  benchmark::Cost peerCost;
  const CgalSurface converted = benchmark::ToCgal<Kernel::Point_3>(surface);
  // CGAL takes one component.
  const bool hasPeer = topology.Components == 1;
  Eigen::MatrixXd peerPoints(0, 3);
  if (hasPeer)
  {
    peerCost =
      benchmark::Measure([&]() { CGAL::extract_mean_curvature_flow_skeleton(converted, peer); });
    peerPoints.resize(static_cast<Eigen::Index>(num_vertices(peer)), 3);
    Eigen::Index row = 0;
    for (const auto vertex : CGAL::make_range(vertices(peer)))
    {
      const Kernel::Point_3& point = peer[vertex].point;
      peerPoints.row(row++) << point.x(), point.y(), point.z();
    }
  }
  benchmark::Row first;
  first.Add("method", std::string("own"))
    .Add("points", own.Points.rows())
    .Add("branches", own.Branches.size())
    .Add("cycles", own.Cycles)
    .Add("genus", genus)
    .Add("components", own.Components)
    .Add("outside", own.OutsidePoints)
    .Add("distance", hasPeer ? MeanDistance(peerPoints, own.Points) / diagonal : 0.0)
    .Add("inradii", hasPeer ? MeanDistanceInRadii(peerPoints, own) : 0.0)
    .Add(ownCost);
  figures.Print(first);
  if (hasPeer)
  {
    std::vector<int> component(num_vertices(peer));
    const int components = boost::connected_components(peer, component.data());
    const int cycles =
      static_cast<int>(num_edges(peer)) - static_cast<int>(num_vertices(peer)) + components;
    figures.Print(benchmark::Row()
                    .Add("method", std::string("CGAL"))
                    .Add("points", peerPoints.rows())
                    .Add("branches", CountCgalBranches(peer))
                    .Add("cycles", cycles)
                    .Add("genus", genus)
                    .Add("components", components)
                    .Add("outside", CountOutside(surface, peerPoints))
                    .Add("distance", MeanDistance(own.Points, peerPoints) / diagonal)
                    .Add(peerCost));
  }
}

const benchmark::Entry Skeleton("skeleton", { Usage, Run });

} // namespace
