#pragma once

#include "Base/Progress.h"
#include "IO/ImageHeader.h"

#include <string>

namespace shape
{

/**
 * Reads the header of an NRRD (.nrrd, .nhdr), MetaImage (.mha, .mhd) or NIfTI (.nii, .nii.gz) file
 * by ITK. The content tells the format.
 *
 * Throws InvalidInput if the file is none of these, is damaged, has more than three dimensions or
 * has numbers of another type, or ShapeMap was built without ITK. Throws SolveFailure if ITK cannot
 * be loaded.
 */
ImageHeader ReadImageHeader(const std::string& path);

/// Reads the numbers of such a file: Components for each voxel, the first index fastest. values:
/// has room for the numbers that the header announces. Throws as ReadImageHeader does, and Aborted.
void ReadImage(const std::string& path, void* values, const Progress& progress = {});

} // namespace shape
