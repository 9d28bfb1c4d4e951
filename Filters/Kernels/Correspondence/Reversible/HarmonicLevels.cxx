#include "Correspondence/Reversible/HarmonicLevels.h"

#include "Spectrum/StressScaling.h"

#include <algorithm>
#include <cmath>

namespace shape
{
namespace
{

EmbeddedSurface Embedded(const Mesh& surface, const ScaledSamples& samples)
{
  return { surface, BiharmonicExtension(surface, samples) / std::sqrt(PointAreas(surface).sum()) };
}

} // namespace

ReversibleHarmonicResult ReversibleHarmonicOfLevels(const CoarsePair& pair,
  const SurfaceMaps& start, const Landmarks& landmarks, const ReversibleHarmonicOptions& options,
  const Progress& progress)
{
  ScaledSamples ofA = ScaleSamples(pair.A(), options.Scaling, progress.Part(0.0, 0.1)),
                ofB = ScaleSamples(pair.B(), options.Scaling, progress.Part(0.1, 0.2));
  const double share = pair.IsCoarser() ? 0.4 : 1.0;
  ReversibleHarmonicResult result = ReversibleHarmonic(Embedded(pair.A(), ofA),
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
  result.Maps = ReversibleHarmonic(fineA, fineB, pair.OnFine(result.Maps, progress.Part(0.5, 0.55)),
    pair.OnFine(landmarks), fine, progress.Part(0.55, 1.0))
                  .Maps;
  return result;
}

} // namespace shape
