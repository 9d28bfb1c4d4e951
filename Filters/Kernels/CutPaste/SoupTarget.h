#pragma once

#include "Base/Progress.h"
#include "CutPaste/FeatureFootprint.h"
#include "CutPaste/PasteTarget.h"
#include "CutPaste/SoupImprint.h"
#include "ExponentialMap/ExponentialMap.h"
#include "Mesh/Provenance.h"
#include "Mesh/Surface.h"
#include "Search/ClosestPoint.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// A feature's loop on a soup, and the soup without the triangles inside it.
struct LoopOnSoup
{
  TangentFrame Seed;         ///< see LoopOnTarget
  Eigen::MatrixXd Positions; ///< n x 3: positions of the loop's points on the soup or across a gap
  Eigen::MatrixXd Normals;   ///< n x 3: unit normals of the soup at these positions
  /// The soup without the covered triangles, cut along the loop. Triangles near the loop are split.
  /// Points: all given ones, then new ones.
  Mesh Rest;
  Provenance Origin;           ///< of Rest from the soup
  std::vector<SeamPoint> Seam; ///< points of Rest on the loop
  int Covered = 0;             ///< number of triangles of the soup with a covered part
};

/**
 * A polygon soup on which features are pasted: triangles that need not be connected, oriented or a
 * manifold. "We utilize only point samples, so all our results apply to arbitrary polygon soups"
 * (Schmidt and Singh, "Drag-and-drop surface composition", section 1; figure 17 shows cars).
 *
 * Edges near the seed are split until they are no longer than the mean edge of the loop, but at
 * least a fiftieth and at most an eighth of the patch's radius. The points there sample the surface
 * (ConnectSamples), and its exponential map carries the loop across gaps that are not much wider
 * than these edges. The soup's triangles are cut along the loop in the plane of this map
 * (ImprintLoop). Sheets closer than the samples count as one surface, and are all cut. Other sheets
 * stay.
 */
class SoupTarget
{
public:
  /// soup: any triangles with finite points. Throws InvalidInput if there is no triangle; Aborted.
  explicit SoupTarget(const shape::Surface& soup, const ExponentialMapOptions& options = {},
    const Progress& progress = {});

  const shape::Surface& Surface() const { return this->Locator.GetSurface(); }
  const SurfaceLocator& Closest() const { return this->Locator; }

  /// Maps the base's loop to the soup, as PasteTarget::Land does to a manifold. The plane's outer
  /// side is that of most triangles around the seed, by area. Throws InvalidInput if a point of the
  /// loop is beyond the patch; Aborted.
  LoopOnSoup Land(
    const FeatureFootprint& base, const PastePlacement& placement, const Progress& progress = {});

private:
  ExponentialMapOptions Options;
  SurfaceLocator Locator;
};

} // namespace shape
