#include "Deform/ShapeDeformation.h"

#include "Base/Errors.h"
#include "Deform/DeformOptions.h"
#include "Deform/Private/BoundaryIntegral.h"
#include "Deform/Private/BoundaryRelative.h"
#include "Deform/Private/FrontDeformation.h"
#include "Deform/Private/HandleAttachment.h"
#include "Deform/Private/LaplacianSmoothing.h"
#include "Deform/Private/MultiresolutionDeformation.h"
#include "Deform/Private/Protrusions.h"
#include "Deform/Private/SegmentHierarchy.h"
#include "Geometry/GraphComponents.h"
#include "Mesh/Topology.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>

namespace shape
{
namespace
{

/// Throws InvalidInput unless a pose has a position and a rotation for each sample.
void RequirePose(const BoundaryHandle& handle, const HandlePose& pose)
{
  const Eigen::Index samples = handle.Positions.rows();
  if (pose.Positions.rows() != samples || pose.Positions.cols() != 3 ||
    static_cast<Eigen::Index>(pose.Rotations.size()) != samples)
  {
    throw InvalidInput("the pose has " + std::to_string(pose.Positions.rows()) + " positions and " +
      std::to_string(pose.Rotations.size()) + " rotations, but the handle has " +
      std::to_string(samples) + " points; give a position and a rotation for each point");
  }
  RequireFinite(pose.Positions, "the pose");
}

std::unique_ptr<NodeDeformation> SolveInFull(
  NodeProblem problem, const DeformOptions& options, const Progress& progress)
{
  if (IntegratesCurves(options))
  {
    return std::make_unique<BoundaryIntegral>(std::move(problem), progress);
  }
  if (options.Method == DeformOptions::MethodType::BoundaryRelative)
  {
    return std::make_unique<BoundaryRelative>(std::move(problem), progress);
  }
  return std::make_unique<FrontDeformation>(std::move(problem), progress);
}

std::unique_ptr<NodeDeformation> Solve(
  NodeProblem problem, const DeformOptions& options, const Progress& progress)
{
  // As in the paper: above 2000 points, a base of 1000; larger shapes have larger bases.
  constexpr int few = 2000, minimum = 1000, share = 20;
  using Type = DeformOptions::MultiresolutionType;
  const int inner = problem.Graph.Size() - static_cast<int>(problem.Sources.size());
  const int base = std::max(minimum, inner / share);
  // A base that is not smaller than the shape saves nothing.
  const bool coarse = options.Multiresolution == Type::On ||
    (options.Multiresolution == Type::Automatic && inner > few);
  if (!coarse || inner <= base)
  {
    return SolveInFull(std::move(problem), options, progress);
  }
  return std::make_unique<MultiresolutionDeformation>(
    std::move(problem), base,
    [&](NodeProblem one, const Progress& part)
    { return SolveInFull(std::move(one), options, part); },
    progress);
}

/// The labels of all nodes of a graph whose first nodes are the shape's.
Eigen::VectorXi LabelsOfNodes(
  const PointGraph& shape, const Eigen::VectorXi& labels, const PointGraph& all)
{
  if (labels.size() != shape.NodeOf.size())
  {
    throw InvalidInput("the segments have " + std::to_string(labels.size()) +
      " labels, but the shape has " + std::to_string(shape.NodeOf.size()) +
      " points; give one for each");
  }
  Eigen::VectorXi ofNodes = Eigen::VectorXi::Zero(all.Size());
  for (int node = 0; node < shape.Size(); ++node)
  {
    ofNodes(node) = labels(shape.PointOf[node]);
  }
  return ofNodes;
}

/// Relative to a much larger or distant handle, the shape would be a single point.
void RequireNear(const BoundaryHandle& handle, const PointGraph& graph)
{
  // With less, differences of coordinates would keep fewer than seven digits.
  constexpr double minimum = 1e-9;
  Eigen::MatrixXd all(handle.Positions.rows() + graph.Positions.rows(), 3);
  all << handle.Positions, graph.Positions;
  const double shape = ComputeLongestBoxEdge(graph.Positions), both = ComputeLongestBoxEdge(all);
  // AttachHandle reports values that are not finite.
  if (std::isfinite(both) && shape < minimum * both && (shape > 0.0 || both > 1e50))
  {
    std::ostringstream words;
    words << "the longest edge of the shape's bounding box is only " << shape
          << ", and that of shape and handle together is " << both
          << "; move the undeformed handle to the shape";
    throw InvalidInput(words.str());
  }
}

} // namespace

struct ShapeDeformation::Prepared
{
  PointGraph Shape;
  BoundaryHandle Handle;
  HandleSources Sources;
  Eigen::VectorXd Scales;
  Eigen::VectorXd Arrivals;
  Eigen::VectorXi Protrusions;
  DeformFacts Facts;
  std::unique_ptr<NodeDeformation> Nodes;
  std::unique_ptr<LaplacianSmoothing> Smoothing;
};

/// 1. Attach the handle: its samples become sources of the graph (AttachHandle).
/// 2. Link the components that it does not reach (ConnectComponents).
/// 3. Sweep the front: arrival times (section 2.1).
/// 4. Evaluate the parameters at each node (section 2.2).
/// 5. Prepare the weights in full resolution, on a coarse base, or part by part (section 2.3).
ShapeDeformation::ShapeDeformation(const PointGraph& graph, const BoundaryHandle& handle,
  const DeformOptions& options, const DeformFields& fields, const Progress& progress)
  : Impl(std::make_unique<Prepared>())
{
  RequireOptions(options);
  RequireNear(handle, graph);
  Prepared& own = *this->Impl;
  own.Shape = graph;
  own.Handle = handle;
  own.Sources =
    AttachHandle(graph, handle, progress.Part(0.0, 0.1, "attaching the shape to the boundary"));
  own.Facts.Islands = ConnectComponents(
    own.Sources.Graph, own.Sources.Nodes, progress.Part(0.1, 0.2, "connecting the components"));
  own.Facts.WeldedPoints = static_cast<int>(graph.NodeOf.size()) - graph.Size();
  const FrontSweep sweep = SweepFront(
    own.Sources.Graph, own.Sources.Nodes, progress.Part(0.2, 0.3, "ordering the points"));
  own.Arrivals.resize(graph.NodeOf.size());
  for (Eigen::Index i = 0; i < own.Arrivals.size(); ++i)
  {
    own.Arrivals(i) = sweep.Arrivals[sweep.Ranks[graph.NodeOf(i)]];
  }
  const PointParameters parameters = FindParameters(graph, sweep, options, fields);
  own.Scales = parameters.Scales;
  NodeProblem problem{ own.Sources.Graph, own.Sources.Nodes, parameters.Powers, parameters.Scales,
    { options.UpwindRadius, options.Distance } };
  problem.Curves = own.Sources.Curves;
  if (options.LaplacianSmoothing)
  {
    own.Smoothing = std::make_unique<LaplacianSmoothing>(problem, progress.Part(0.3, 0.3));
  }
  Eigen::VectorXi labels; // of the nodes
  if (options.SegmentBy == DeformOptions::SegmentByType::Protrusions)
  {
    labels =
      FindProtrusions(own.Sources.Graph, sweep, options.MinimumProtrusion * sweep.Arrivals.back());
    own.Protrusions = labels(graph.NodeOf);
  }
  else if (fields.Segments.size() > 0)
  {
    labels = LabelsOfNodes(graph, fields.Segments, own.Sources.Graph);
  }
  if (labels.size() > 0)
  {
    if (IntegratesCurves(options))
    {
      throw InvalidInput(
        "parts that are deformed one after another follow points, not curves; turn "
        "IntegrateCurves off, or give no segments");
    }
    auto parts = std::make_unique<SegmentHierarchy>(
      std::move(problem), labels,
      [&](NodeProblem one, const Progress& part) { return Solve(std::move(one), options, part); },
      progress.Part(0.3, 1.0, "preparing the weights"));
    own.Facts.Segments = parts->Segments();
    own.Nodes = std::move(parts);
  }
  else
  {
    own.Nodes =
      Solve(std::move(problem), options, progress.Part(0.3, 1.0, "preparing the weights"));
  }
  own.Facts.EmptyBands = own.Nodes->EmptyBands();
  own.Facts.ZeroWeights = own.Nodes->ZeroWeights();
  own.Facts.BasePoints = own.Nodes->BaseNodes();
  own.Facts.Streamed = own.Nodes->IsStreamed();
}

ShapeDeformation::~ShapeDeformation() = default;

const Eigen::VectorXd& ShapeDeformation::Arrivals() const
{
  return this->Impl->Arrivals;
}

const Eigen::VectorXi& ShapeDeformation::Protrusions() const
{
  return this->Impl->Protrusions;
}

const DeformFacts& ShapeDeformation::Facts() const
{
  return this->Impl->Facts;
}

// 1. The sources follow the samples of the handle (MoveSources).
// 2. The front moves the other nodes by the stored weights.
// 3. Laplacian smoothing, if it is wanted.
// 4. Points follow their nodes, also those that were welded.
DeformedShape ShapeDeformation::Deform(
  const HandlePose& pose, double reach, const Progress& progress) const
{
  const Prepared& own = *this->Impl;
  RequirePose(own.Handle, pose);
  const NodeTransforms sources = MoveSources(own.Sources, own.Handle, pose, own.Scales);
  constexpr double everywhere = std::numeric_limits<double>::infinity();
  // Smoothing solves for all nodes at once, so it needs all of them.
  NodeTransforms motions = own.Nodes->Move(sources, own.Smoothing ? everywhere : reach, progress);
  if (own.Smoothing)
  {
    own.Smoothing->Apply(motions);
  }
  const Eigen::Index points = own.Shape.Points.rows();
  DeformedShape result{ Eigen::MatrixXd(points, 3), std::vector<Eigen::Matrix3d>(points) };
  for (Eigen::Index i = 0; i < points; ++i)
  {
    const int node = own.Shape.NodeOf(i);
    result.Rotations[i] = motions.Rotations[node];
    result.Points.row(i) = own.Shape.Points.row(i) + motions.Shifts.col(node).transpose();
    if (own.Shape.PointOf[node] != i) // welded to another node, which it follows
    {
      const Eigen::Matrix3d turn =
        own.Scales(node) * motions.Rotations[node] - Eigen::Matrix3d::Identity();
      const Eigen::RowVector3d offset = own.Shape.Points.row(i) - own.Shape.Positions.row(node);
      result.Points.row(i) += offset * turn.transpose();
    }
  }
  return result;
}

std::unique_ptr<ShapeDeformation> PrepareDeformation(const PointGraph& graph,
  const BoundaryHandle& handle, const DeformOptions& options, const DeformFields& fields,
  const Progress& progress)
{
  return std::make_unique<ShapeDeformation>(graph, handle, options, fields, progress);
}

} // namespace shape
