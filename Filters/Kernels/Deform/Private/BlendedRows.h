#pragma once

#include <Eigen/Core>
#include <Eigen/StdVector>

#include <cstddef>
#include <vector>

namespace shape
{

/// A rigid motion's 15 numbers: where a sample goes, its turned rest place, its rotation.
constexpr int MotionSize = 15;

/// Samples' motions in blocks of eight: number c of sample j is Values[(j / 8) * 120 + c * 8 + j %
/// 8].
class SampleTransforms
{
public:
  explicit SampleTransforms(int samples);
  /// rest, place: relative to a centre of each.
  void Set(int sample, const Eigen::Vector3d& rest, const Eigen::Vector3d& position,
    const Eigen::Matrix3d& rotation);
  const double* Data() const { return this->Values.data(); }

private:
  std::vector<double> Values;
};

/// What a row of weights makes of the motions: sums over the samples, divided by that of weights.
struct BlendedTransform
{
  Eigen::Vector3d Position, Turned;
  Eigen::Matrix3d Rotation; ///< the mean of rotations, not one itself

  /// Where `point` (relative to the centre) goes when offsets are scaled.
  Eigen::Vector3d Apply(const Eigen::Vector3d& point, double scale) const
  {
    return this->Position - scale * this->Turned + scale * (this->Rotation * point);
  }
};

/// The rows of a dense banded matrix of weights: row i has those of samples [begin, begin + count).
class BlendedRows
{
public:
  /// Appends a row; its weights are set when there is room for them.
  void Add(int begin, int count);
  /// How many weights the rows take.
  std::size_t Size() const { return this->Total; }
  /// Makes room for the weights of all rows.
  void Allocate();
  /// The weights of a row, >= 0, one of them positive. Different rows may be set at the same time.
  void Set(int row, const float* weights);
  /// Forgets all rows, but not their room.
  void Clear();

  /// What a row makes of the motions. Samples that do not move blend to exactly that; else the last
  /// bits depend on how wide the vectors of the processor are.
  BlendedTransform Blend(int row, const SampleTransforms& motions) const;

private:
  struct Row
  {
    std::size_t First;              ///< weight
    int Block, Blocks, Skip, Count; ///< blocks of eight samples; weights before the first one's
    double Sum;
  };
  std::vector<Row> Rows;
  std::vector<float> Weights; ///< filled up with zeros to whole blocks
  std::size_t Total = 0;
};

} // namespace shape
