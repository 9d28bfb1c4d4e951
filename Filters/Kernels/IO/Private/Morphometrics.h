#pragma once

#include "IO/Private/LandmarkRows.h"

#include <string_view>

// Landmark files of morphometrics. See ReadLandmarks for the formats and errors.
namespace shape
{

/// Whether the content begins as a .pts file.
bool IsPTS(std::string_view content);
LandmarkRows ReadPTS(std::string_view content);

/// Whether the content begins as a .tps file.
bool IsTPS(std::string_view content);
/// specimen, target: see LandmarksReaderOptions.
LandmarkRows ReadTPS(std::string_view content, int specimen, int target);

} // namespace shape
