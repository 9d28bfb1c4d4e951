#pragma once

#include <QString>

#include <string>
#include <vector>

/// Landmarks on a surface, or pairs of landmarks on two surfaces.
struct pqShapeLandmarkTable
{
  std::vector<double> Points;       ///< 3 numbers for each landmark
  std::vector<double> TargetPoints; ///< empty, or of the same size: the corresponding positions
  std::vector<std::string> Names;   ///< as many as landmarks, or fewer
};

/// Files of landmarks on the computer of the window.
namespace pqShapeLandmarkFiles
{

/// Reads a file of any format that Shape Landmarks Reader knows. Returns false if it cannot be
/// read; the reader has then shown an error.
bool Read(const QString& path, pqShapeLandmarkTable& table);

/// Writes comma-separated values: a row for each landmark, under the names of the columns. A path
/// that ends in .pts or .tps gives a file of Landmark Editor, or of tpsDig with a specimen for each
/// surface. Returns what is wrong, or nothing.
QString Write(const QString& path, const pqShapeLandmarkTable& table);

} // namespace pqShapeLandmarkFiles
