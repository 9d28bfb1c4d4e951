#pragma once

#include <array>
#include <cstddef>

namespace shape
{

/// The type of a number of an image, with its number of bits.
enum class ImageNumber
{
  Int8,
  UInt8,
  Int16,
  UInt16,
  Int32,
  UInt32,
  Int64,
  UInt64,
  Float,
  Double
};

/**
 * What a file says about its image, apart from the numbers.
 *
 * Voxel (i, j, k) lies at Origin + Directions diag(Spacing) (i, j, k)^T, in the unit of the file,
 * usually millimetres, and in the axes of DICOM: x to the patient's left, y to the back, z to the
 * head. NIfTI and some NRRD files have other axes, and are converted.
 */
struct ImageHeader
{
  std::array<int, 3> Size = { 0, 0, 0 }; ///< 1 along k for an image of two dimensions
  std::array<double, 3> Origin = { 0.0, 0.0, 0.0 };
  std::array<double, 3> Spacing = { 1.0, 1.0, 1.0 }; ///< positive
  /// Orthonormal, by rows; the columns belong to i, j and k, and may be left-handed.
  std::array<double, 9> Directions = { 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0 };
  ImageNumber Number = ImageNumber::UInt8;
  int Components = 1; ///< numbers of a voxel

  std::size_t GetNumberOfVoxels() const
  {
    return static_cast<std::size_t>(this->Size[0]) * static_cast<std::size_t>(this->Size[1]) *
      static_cast<std::size_t>(this->Size[2]);
  }
};

} // namespace shape
