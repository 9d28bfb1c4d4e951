#pragma once

#include "Base/Progress.h"
#include "Labels/LabelImage.h"

namespace shape
{

struct DissolvedIslands
{
  int Count = 0;
  double Voxels = 0.0;
};

/// Gives each connected part with fewer than `smallest` voxels the label with which it shares most
/// faces, until there are no such parts. Voxels are connected by faces. The part of label 0 at the
/// border of the image belongs to the outside and stays. Throws Aborted.
DissolvedIslands DissolveIslands(LabelImage& image, int smallest, const Progress& progress = {});

} // namespace shape
