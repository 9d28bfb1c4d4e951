#include "Harmonic/Certificate.h"

#include "Base/Errors.h"
#include "Geometry/SelfIntersections.h"
#include "Harmonic/Private/DomainCover.h"
#include "Solids/Nesting.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <vector>

namespace shape
{

namespace
{

using BoxState = MapCertificate::BoxState;

/// Returns the boxes of a cover, in the lengths of the domain, and their facts.
MapCertificate Collect(const DomainCover& cover, const ChargeSet& map)
{
  const double scale = cover.LengthScale();
  std::vector<const CoverBox*> boxes;
  for (const CoverBox& box : cover.GetBoxes())
  {
    if (box.ChildCount == 0)
    {
      boxes.push_back(&box);
    }
  }
  const auto count = static_cast<Eigen::Index>(boxes.size());
  MapCertificate result;
  result.ExaminedBoxes = static_cast<int>(cover.GetBoxes().size());
  result.Complete = cover.IsComplete();
  result.Centres.resize(count, 3);
  result.Edges.resize(count);
  result.States.resize(count);
  result.Volumes.resize(count);
  result.Determinants.resize(count);
  std::vector<Eigen::Index> seen;
  for (Eigen::Index i = 0; i < count; ++i)
  {
    const CoverBox& box = *boxes[i];
    result.Centres.row(i) = box.Place.Centre.transpose() / scale;
    result.Edges(i) = 2.0 * box.Place.Half / scale;
    result.States(i) = static_cast<int>(box.State);
    result.Volumes(i) = box.Volume / std::pow(scale, 3);
    result.Determinants(i) = box.State == BoxState::Undecided ? 0.0 : box.Determinant;
    if (box.HasWitness)
    {
      seen.push_back(i);
    }
  }
  result.Witnesses.resize(static_cast<Eigen::Index>(seen.size()), 3);
  for (std::size_t i = 0; i < seen.size(); ++i)
  {
    result.Witnesses.row(static_cast<Eigen::Index>(i)) =
      boxes[seen[i]]->Witness.transpose() / scale;
  }
  const Eigen::MatrixXd jacobians = EvaluateJacobians(map, result.Witnesses);
  result.WitnessDeterminants.resize(result.Witnesses.rows());
  for (std::size_t i = 0; i < seen.size(); ++i)
  {
    const double determinant =
      std::min(GetJacobian(jacobians, static_cast<Eigen::Index>(i)).determinant(), 0.0);
    result.WitnessDeterminants(static_cast<Eigen::Index>(i)) = determinant;
    result.Determinants(seen[i]) = determinant;
  }
  const double total = result.Volumes.sum();
  const auto shareOf = [&](BoxState state)
  {
    return (result.States.array() == static_cast<int>(state)).select(result.Volumes, 0.0).sum() /
      total;
  };
  result.CertifiedShare = shareOf(BoxState::Certified);
  result.InvertedShare = shareOf(BoxState::Inverted);
  result.UndecidedShare = shareOf(BoxState::Undecided);
  return result;
}

/// Checks the image of the boundary: see MapCertificate.
void CheckBoundary(
  const ChargeSet& map, const Surface& domain, const Progress& progress, MapCertificate& result)
{
  const Surface image = domain.WithPoints(Evaluate(map, domain.Points(), progress.Part(0.0, 0.3)));
  result.BoundaryCrossings = CountCrossings(image, progress.Part(0.3, 1.0));
  result.BoundaryReversed = ComputeEnclosedVolume(image) < 0.0;
  // Nested components face in and out in turn, so no position of the image is covered twice.
  result.BoundaryInjective = result.BoundaryCrossings == 0 &&
    OrientByNesting(image, "the image of the boundary").Triangles() == domain.Triangles();
}

} // namespace

MapCertificate CertifyMap(const ChargeSet& map, const Surface& domain,
  const MapCertificateOptions& options, const Progress& progress)
{
  RequireOption(options.Tolerance >= 1e-5 && options.Tolerance <= 0.5, "Tolerance",
    options.Tolerance, "from 1e-5 to 0.5");
  RequireOption(options.MaximumBoxes >= 1, "Maximum Boxes", options.MaximumBoxes, "at least 1");
  RequireClosedSurface(domain, "the domain");
  DomainCover cover(map, domain, options);
  cover.Examine(progress.Part(0.0, 0.9, "bounding the determinant"));
  cover.Merge();
  MapCertificate result = Collect(cover, map);
  CheckBoundary(map, domain, progress.Part(0.9, 1.0, "checking the boundary's image"), result);
  result.Bijective = result.BoundaryInjective &&
    (result.States.array() == static_cast<int>(BoxState::Certified)).all();
  progress(1.0);
  return result;
}

int CountCrossings(const Surface& image, const Progress& progress)
{
  const std::vector<int> degenerate = FindDegenerateTriangles(image);
  return static_cast<int>(
    degenerate.empty() ? FindSelfIntersections(image, progress).size() : degenerate.size());
}

} // namespace shape
