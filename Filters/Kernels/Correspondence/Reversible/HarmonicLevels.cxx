#include "Correspondence/Reversible/HarmonicLevels.h"

#include "Spectrum/Smacof.h"

#include <algorithm>
#include <cmath>

namespace shape
{
namespace
{

EmbeddedSurface Embedded(const Surface& surface, const EmbeddedSamples& samples)
{
  return { surface,
    ExtendBiharmonically(surface, samples) / std::sqrt(ComputePointAreas(surface).sum()) };
}

} // namespace

ReversibleHarmonicResult RefineReversibleHarmonicMap(const CoarsePair& pair,
  const SurfaceMaps& start, const Landmarks& landmarks, const ReversibleHarmonicOptions& options,
  const Progress& progress)
{
  EmbeddedSamples ofA = EmbedSamples(pair.A(), options.Scaling, progress.Part(0.0, 0.1)),
                  ofB = EmbedSamples(pair.B(), options.Scaling, progress.Part(0.1, 0.2));
  const double share = pair.IsCoarser() ? 0.4 : 1.0;
  ReversibleHarmonicResult result = ComputeReversibleHarmonicMap(Embedded(pair.A(), ofA),
    Embedded(pair.B(), ofB), start, landmarks, options, progress.Part(0.2, share));
  if (!pair.IsCoarser())
  {
    return result;
  }
  for (int& point : ofA.Points)
  {
    point = pair.FinePointOfA(point);
  }
  for (int& point : ofB.Points)
  {
    point = pair.FinePointOfB(point);
  }
  // The last quarter of the steps in which alpha falls: smooth first, then each other's inverse.
  ReversibleHarmonicOptions fine = options;
  const int quarter = std::max(1, options.AlphaSteps / 4);
  fine.FirstIteration = std::max(options.FirstIteration, options.AlphaSteps - quarter + 2);
  fine.MaximumIterations = std::min(quarter, options.MaximumIterations);
  const EmbeddedSurface fineA = Embedded(pair.FineA(), ofA);
  progress(0.45);
  const EmbeddedSurface fineB = Embedded(pair.FineB(), ofB);
  result.Maps =
    ComputeReversibleHarmonicMap(fineA, fineB, pair.OnFine(result.Maps, progress.Part(0.5, 0.55)),
      pair.OnFine(landmarks), fine, progress.Part(0.55, 1.0))
      .Maps;
  return result;
}

} // namespace shape
