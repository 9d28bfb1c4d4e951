#include "Harmonic/RepairMap.h"

#include "Base/Errors.h"
#include "Harmonic/Private/RepairCore.h"
#include "Harmonic/Private/WholeRepair.h"
#include "Solids/SurfaceComplex.h"

#include <algorithm>
#include <string>
#include <utility>

namespace shape
{
namespace
{

/// Fills a solid with tetrahedra. TetGen fails on some surfaces only if it adds points on the
/// triangles, and does not end on others only if it may not. Usual are half as many new points as
/// it may add, or fewer.
FiniteElements Fill(
  const Surface& domain, const Eigen::MatrixXd& images, int tetrahedra, const Progress& progress)
{
  const int maximumNewPoints = static_cast<int>(
    std::min(1e9, tetrahedra + 10.0 * static_cast<double>(domain.Points().rows())));
  try
  {
    return FillWithElements(
      domain, images, tetrahedra, false, maximumNewPoints, progress.Part(0.0, 0.5));
  }
  catch (const SolveFailure&)
  {
    return FillWithElements(
      domain, images, tetrahedra, true, maximumNewPoints, progress.Part(0.5, 1.0));
  }
}

} // namespace

RepairMapResult RepairMap(const ChargeSet& map, const Surface& domain,
  const Eigen::MatrixXd& targets, const RepairMapOptions& options, const Progress& progress)
{
  RequireOption(options.MaximumRounds >= 1, "Maximum Rounds", options.MaximumRounds, "at least 1");
  RequireOption(options.MaximumInvertedShare >= 0.0, "Maximum Inverted Share",
    options.MaximumInvertedShare, "at least 0");
  if (targets.size() != 0 && (targets.rows() != domain.Points().rows() || targets.cols() != 3))
  {
    throw InvalidInput("the boundary has " + std::to_string(domain.Points().rows()) +
      " points and " + std::to_string(targets.rows()) +
      " images; give each point one image of three coordinates");
  }
  RequireConformingComplex(
    JoinSurfaces({ domain }), { "the boundary" }, 1.0, progress.Part(0.0, 0.02));
  RepairMapResult result;
  const MapCertificate certificate =
    CertifyMap(map, domain, options.Certificate, progress.Part(0.02, 0.25));
  result.CertifiedBefore = result.CertifiedShare = certificate.CertifiedShare;
  result.InvertedBefore = result.InvertedShare = certificate.InvertedShare;
  result.UndecidedBefore = result.UndecidedShare = certificate.UndecidedShare;
  if ((certificate.States.array() == static_cast<int>(MapCertificate::BoxState::Certified)).all())
  {
    progress(1.0);
    return result;
  }
  const Eigen::MatrixXd images = targets.size() == 0 ? Evaluate(map, domain.Points()) : targets;
  FiniteElements elements;
  try
  {
    elements = Fill(domain, images, options.Tetrahedra, progress.Part(0.25, 0.4));
  }
  catch (const SolveFailure& failure)
  {
    result.Unfilled = failure.what();
    progress(1.0);
    return result;
  }
  RepairCore core(map, std::move(elements), progress.Part(0.4, 0.42));
  core.AddFolds(certificate, progress.Part(0.42, 0.45, "finding the folds"));
  core.AddLayer();
  // Rounding may leave out a box that the surface only touches.
  if (core.IsEmpty())
  {
    progress(1.0);
    return result;
  }
  // Growth that has not helped twice hardly will, and each round takes longer than the last.
  constexpr int patience = 2;
  for (int round = 0, last = 0; round < options.MaximumRounds; ++round)
  {
    const double step = 0.45 / options.MaximumRounds;
    const Progress part = progress.Part(0.45 + step * round, 0.45 + step * (round + 1));
    core.GrowUntilBounded(part.Part(0.0, 0.5, "bounding the determinant in the ring"));
    const bool untangled = core.UntangleParts(part.Part(0.5, 1.0, "untangling the core"));
    RepairShares found = core.Finish();
    ++result.Rounds;
    if (round == 0 || found.InvertedShare < result.InvertedShare)
    {
      last = round;
      result.Repair = std::move(found.Repair);
      result.InvertedShare = found.InvertedShare;
      result.UndecidedShare = 0.0; // the whole ring is certified
      result.CertifiedShare = 1.0 - found.InvertedShare;
      result.CoreShare = found.CoreShare;
      result.RingShare = found.RingShare;
    }
    if (untangled || round >= last + patience || !core.GrowInverted(1 << std::min(round, 20)))
    {
      break;
    }
  }
  if (result.InvertedShare > 0.0)
  {
    result.ImageCrossings = CountCrossings(domain.WithPoints(images));
  }
  if (result.InvertedShare > options.MaximumInvertedShare && result.ImageCrossings == 0)
  {
    MapRepair whole =
      RepairWhole(map, domain, images, progress.Part(0.9, 1.0, "untangling larger tetrahedra"));
    if (whole.Elements.Tetrahedra.rows() > 0)
    {
      result.Repair = std::move(whole);
      result.CertifiedShare = result.CoreShare = 1.0;
      result.InvertedShare = result.RingShare = 0.0;
    }
  }
  progress(1.0);
  return result;
}

} // namespace shape
