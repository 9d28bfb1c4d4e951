#pragma once

#include <Eigen/Core>

#include <functional>

namespace shape
{

/**
 * The processes that share a computation, and this process's number among them.
 *
 * All processes call a kernel with the same arguments, and all receive the same result. The kernel
 * divides its work and its large data among them. What one process computes reaches the others by
 * sums. By default there is one process.
 */
struct Processes
{
  int Count = 1;  ///< number of processes; >= 1
  int Number = 0; ///< number of this process; >= 0, < Count
  /// Replaces each value by its sum over all processes; every process then has the same bits. All
  /// processes call it equally often, with the same number of values. If one of them has failed, it
  /// throws on the others. It is not called if Count is 1.
  std::function<void(double* values, Eigen::Index count)> Add;

  /// The share [Begin, End) of one process.
  struct Share
  {
    Eigen::Index Begin = 0, End = 0;
    Eigen::Index Size() const { return this->End - this->Begin; }
  };

  /// Returns the share of [0, count) of this process. Shares are contiguous, and their sizes differ
  /// by at most one.
  Share Own(Eigen::Index count) const
  {
    return { count * this->Number / this->Count, count * (this->Number + 1) / this->Count };
  }

  /// Replaces the entries of `values` by their sums over all processes.
  template <typename Values>
  void Sum(Values& values) const
  {
    if (this->Count > 1 && values.size() > 0)
    {
      this->Add(values.data(), values.size());
    }
  }

  /// Returns the sum of one number over all processes.
  double SumOf(double value) const
  {
    if (this->Count > 1)
    {
      this->Add(&value, 1);
    }
    return value;
  }
};

} // namespace shape
