#pragma once

namespace shape
{

/**
 * Where sums over pairs of points and sources are computed.
 *
 * An OpenCL device is used through the ICD loader, and only if it has double precision
 * (cl_khr_fp64). Its sums differ from the processor's by rounding only: by less than 1e-12 of the
 * sum of the terms' absolute values. They have the same bits in every run on the same device.
 */
enum class SumDevice
{
  /// a GPU, if there is one and the sum has at least MinimumDevicePairs pairs; else the processor
  Automatic,
  Processor, ///< never OpenCL
  OpenCL     ///< the largest GPU or, if there is none, another OpenCL device
};

/// The minimum number of pairs for which Automatic chooses a GPU. They take a core about a second.
/// To start the device and to compile for it takes about as long, once in a process. The true
/// break-even depends on the GPU and has not been measured.
constexpr double MinimumDevicePairs = 1e9;

/// Returns the device for a sum of so many pairs: Processor or OpenCL. Throws InvalidInput if
/// `asked` is OpenCL and there is no such device, or ShapeMap was built without OpenCL.
SumDevice ChooseSumDevice(SumDevice asked, double pairs);

} // namespace shape
