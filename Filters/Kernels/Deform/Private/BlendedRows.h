#pragma once

#include <Eigen/Core>
#include <Eigen/StdVector>

#include <cstddef>
#include <vector>

namespace shape
{

/// The number of values in a sample's motion: its new position (3), its rotated rest position (3)
/// and its rotation (9).
constexpr int MotionSize = 15;

/// The motions of samples in blocks of eight: value c of sample j is Values[(j / 8) * 120 + c * 8 +
/// j % 8].
class SampleTransforms
{
public:
  explicit SampleTransforms(int samples);
  /// rest, position: both relative to a common centre.
  void Set(int sample, const Eigen::Vector3d& rest, const Eigen::Vector3d& position,
    const Eigen::Matrix3d& rotation);
  const double* Data() const { return this->Values.data(); }

private:
  std::vector<double> Values;
};

/// The weighted mean of the motions of samples.
struct BlendedTransform
{
  Eigen::Vector3d Position, Turned;
  Eigen::Matrix3d Rotation; ///< weighted mean of the rotations; in general no rotation

  /// Returns the new position of `point`, with scaled offsets. Old and new position are relative to
  /// the centre.
  Eigen::Vector3d Apply(const Eigen::Vector3d& point, double scale) const
  {
    return this->Position - scale * this->Turned + scale * (this->Rotation * point);
  }
};

/// The rows of a dense banded matrix of weights: row i contains the weights of samples [begin,
/// begin + count).
class BlendedRows
{
public:
  /// Appends a row; its weights are set after Allocate.
  void Add(int begin, int count);
  /// The number of weights of all rows.
  std::size_t Size() const { return this->Total; }
  /// Allocates the weights of all rows.
  void Allocate();
  /// Sets the weights of a row. All must be >= 0, and at least one positive. Several threads may
  /// set different rows.
  void Set(int row, const float* weights);
  /// Removes all rows, but keeps the memory.
  void Clear();

  /// Blends the motions with the weights of a row. If no sample moves, the result is exactly no
  /// motion. Otherwise, the last bits of the result depend on the width of the processor's vectors.
  BlendedTransform Blend(int row, const SampleTransforms& motions) const;

private:
  struct Row
  {
    std::size_t First; ///< index of the first weight
    /// The first block of eight samples, the number of blocks, the number of padding zeros before
    /// the first weight, and the number of weights.
    int Block, Blocks, Skip, Count;
    double Sum;
  };
  std::vector<Row> Rows;
  std::vector<float> Weights; ///< padded with zeros to whole blocks
  std::size_t Total = 0;
};

} // namespace shape
