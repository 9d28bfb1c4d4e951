#pragma once

#include <functional>
#include <string>

namespace shape
{

/**
 * Where sums over pairs of points and sources are computed, and who is warned if that fails.
 *
 * An OpenCL device is used through the ICD loader, and only if it has double precision
 * (cl_khr_fp64). Its sums differ from the processor's by rounding only: by less than 1e-12 of the
 * sum of the terms' absolute values. They have the same bits in every run on the same device. If
 * the device fails, Warn is called, and the processor computes the sum.
 */
struct SumDevice
{
  enum class KindType
  {
    /// a GPU, if there is one and the sum has at least MinimumPairs pairs; else the processor
    Automatic,
    Processor, ///< never OpenCL
    OpenCL     ///< the largest GPU or, if there is none, another OpenCL device
  };
  KindType Kind = KindType::Processor;
  /// Receives the fact and the remedy in one line, in the thread that called the kernel. If it is
  /// empty, a device that fails is a SolveFailure.
  std::function<void(const std::string& warning)> Warn = {};

  /// The minimum number of pairs for which Automatic chooses a GPU. They take a core about a
  /// second. To start the device and to compile for it takes about as long, once in a process. The
  /// true break-even depends on the GPU and has not been measured (`benchmark opencl_sums`).
  static constexpr double MinimumPairs = 1e9;
};

/// Returns whether OpenCL computes a sum of this number of pairs. Throws InvalidInput if the kind
/// is OpenCL and there is no such device, or ShapeMap was built without OpenCL.
bool ChooseOpenCL(const SumDevice& device, double pairs);

} // namespace shape
