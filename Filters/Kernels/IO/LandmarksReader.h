#pragma once

#include <Eigen/Core>

#include <string>
#include <string_view>
#include <vector>

namespace shape
{

struct LandmarksReaderOptions
{
  enum class CoordinateSystemType
  {
    AsInFile, ///< positions are not changed
    LPS,      ///< x to the left, y to the back, z up, as in DICOM
    RAS       ///< x to the right, y to the front, z up
  };
  /// the axes of a patient in the result; positions of the other system get -x and -y
  CoordinateSystemType CoordinateSystem = CoordinateSystemType::AsInFile;
  int Specimen = 1; ///< of a .tps file, from 1
  /// of a .tps file: its landmarks are the corresponding positions; 0, or more than there are: none
  int TargetSpecimen = 2;
};

/// Landmarks from a file.
struct LandmarkFile
{
  Eigen::MatrixXd Points;         ///< n x 3
  Eigen::MatrixXd Targets;        ///< n x 3, the corresponding positions; or no rows
  std::vector<std::string> Names; ///< n; without a name, the number from 1
  std::string CoordinateSystem;   ///< of the result: "LPS", "RAS", or "" if the file does not say
};

/**
 * Reads landmarks from the content of a file. The content tells the format:
 *
 * - Comma-separated values. The first line names the columns: x, y, z; tx, ty, tz for the
 *   corresponding positions; name or label. Others are ignored.
 * - 3D Slicer's .fcsv: comma-separated values after lines with #, which name the columns and the
 *   coordinate system (LPS or 1; RAS or 0, also if missing).
 * - 3D Slicer's .mrk.json: the control points of all lists; those without a position are left out.
 * - MeshLab's .pp: the active points.
 * - .pts of Landmark Editor: a line `Version`, the count, and lines `name x y z`, of which those
 *   with the number 9999 are missing and left out; and .pts with `n_points` and points in braces.
 * - .tps of tpsDig and geomorph: a block LM= (two coordinates) or LM3= for each specimen,
 * multiplied by its SCALE=. Landmarks with NA, curves and other entries are left out. A landmark of
 * a pair is left out if one of the two is missing.
 *
 * If a file has two coordinates, the third is 0.
 *
 * Throws InvalidInput, with the line or the landmark, if there are no landmarks, the format is
 * another one, a column is missing, a coordinate is no finite number, the coordinate system is
 * neither LPS nor RAS, several systems are mixed in one file, there is no such specimen, or two
 * specimens have different numbers of landmarks.
 */
LandmarkFile ReadLandmarks(std::string_view content, const LandmarksReaderOptions& options = {});

} // namespace shape
