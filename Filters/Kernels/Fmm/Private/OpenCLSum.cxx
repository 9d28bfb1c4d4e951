#include "Fmm/Private/OpenCLSum.h"

#include "Base/Errors.h"

#include <algorithm>
#include <string>

#ifdef SHAPEMAP_OPENCL
#define CL_HPP_ENABLE_EXCEPTIONS
#define CL_HPP_MINIMUM_OPENCL_VERSION 120
#define CL_HPP_TARGET_OPENCL_VERSION 120
#include <CL/opencl.hpp>

#include <array>
#include <chrono>
#include <cstddef>
#include <mutex>
#endif

namespace shape
{

void OpenCLSum::AddBlocks(int begin, int end, int spanBegin, int spanEnd)
{
  for (; begin < end; begin += OpenCLBlock::Size)
  {
    this->Blocks.push_back({ begin, std::min(begin + OpenCLBlock::Size, end), spanBegin, spanEnd });
  }
}

#ifdef SHAPEMAP_OPENCL

namespace
{

/// One work-group for each block. Sources outside [sourceBegin, sourceEnd) are left out, and the
/// sums continue those in `values`, so that a long sum can be made in passes with the same bits.
constexpr const char* Source = R"CL(
#pragma OPENCL EXTENSION cl_khr_fp64 : enable
#define STRIDE (3 + COLUMNS)
#define SUMS (GRADIENTS ? 3 * COLUMNS : COLUMNS)

kernel void Sum(global const double* restrict sources, global const int2* restrict spans,
  global const int4* restrict blocks, int firstBlock, int sourceBegin, int sourceEnd,
  global const double* restrict points, int count, global double* restrict values)
{
  const int4 block = blocks[firstBlock + get_group_id(0)];
  const size_t n = count;
  const size_t i = block.x + get_local_id(0);
  if (i >= block.y)
    return;
  const double3 point = (double3)(points[i], points[i + n], points[i + 2 * n]);
  double sums[SUMS];
  for (int c = 0; c < SUMS; ++c)
    sums[c] = values[i + c * n];
  for (int s = block.z; s < block.w; ++s)
  {
    const int end = min(spans[s].y, sourceEnd);
    for (int j = max(spans[s].x, sourceBegin); j < end; ++j)
    {
      global const double* restrict source = sources + (size_t)j * STRIDE;
      const double x = point.x - source[0], y = point.y - source[1], z = point.z - source[2];
      const double inverse = rsqrt(fma(z, z, fma(y, y, x * x)));
#if GRADIENTS
      const double cube = -inverse * inverse * inverse;
      const double gx = x * cube, gy = y * cube, gz = z * cube;
      for (int c = 0; c < COLUMNS; ++c)
      {
        const double charge = source[3 + c];
        sums[3 * c] = fma(charge, gx, sums[3 * c]);
        sums[3 * c + 1] = fma(charge, gy, sums[3 * c + 1]);
        sums[3 * c + 2] = fma(charge, gz, sums[3 * c + 2]);
      }
#else
      for (int c = 0; c < SUMS; ++c)
        sums[c] = fma(source[3 + c], inverse, sums[c]);
#endif
    }
  }
  for (int c = 0; c < SUMS; ++c)
    values[i + c * n] = sums[c];
}
)CL";

/// The device of this process. Its context and programs are made when they are first needed.
class OpenDevice
{
public:
  cl::Device Id;
  bool IsGPU = false;

  cl::Context GetContext()
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    if (!this->Context())
    {
      this->Context = cl::Context(this->Id);
    }
    return this->Context;
  }

  cl::Kernel MakeKernel(int columns, bool gradients)
  {
    const cl::Context context = this->GetContext();
    const std::lock_guard<std::mutex> lock(this->Mutex);
    cl::Program& program = this->Programs[2 * (columns - 1) + (gradients ? 1 : 0)];
    if (!program())
    {
      const std::string definitions =
        "-D COLUMNS=" + std::to_string(columns) + " -D GRADIENTS=" + (gradients ? "1" : "0");
      cl::Program built(context, Source);
      built.build({ this->Id }, definitions.c_str());
      program = built;
    }
    return cl::Kernel(program, "Sum");
  }

private:
  std::mutex Mutex;
  cl::Context Context;
  std::array<cl::Program, 6> Programs; ///< for 1 to 3 charges, of potentials and of gradients
};

/// Adds the devices of a platform that can compute the sums.
void AddDevices(const cl::Platform& platform, std::vector<cl::Device>& able)
{
  std::vector<cl::Device> devices;
  platform.getDevices(CL_DEVICE_TYPE_ALL, &devices);
  for (const cl::Device& device : devices)
  {
    if (device.getInfo<CL_DEVICE_DOUBLE_FP_CONFIG>() != 0 &&
      device.getInfo<CL_DEVICE_AVAILABLE>() && device.getInfo<CL_DEVICE_COMPILER_AVAILABLE>() &&
      device.getInfo<CL_DEVICE_MAX_WORK_GROUP_SIZE>() >= OpenCLBlock::Size)
    {
      able.push_back(device);
    }
  }
}

/// Finds the GPU with the most compute units or, if there is none, such a device of another kind.
/// Returns null if there is no device.
std::unique_ptr<OpenDevice> FindDevice()
{
  std::vector<cl::Platform> platforms;
  std::vector<cl::Device> able;
  try
  {
    cl::Platform::get(&platforms);
  }
  catch (const cl::Error&)
  {
    return nullptr; // no driver is installed
  }
  for (const cl::Platform& platform : platforms)
  {
    try
    {
      AddDevices(platform, able);
    }
    catch (const cl::Error&)
    {
      // a driver without devices
    }
  }
  auto device = std::make_unique<OpenDevice>();
  unsigned int most = 0;
  for (const cl::Device& one : able)
  {
    const bool isGPU = (one.getInfo<CL_DEVICE_TYPE>() & CL_DEVICE_TYPE_GPU) != 0;
    const unsigned int units = one.getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>();
    if (isGPU == device->IsGPU ? units > most : isGPU)
    {
      most = units;
      device->IsGPU = isGPU;
      device->Id = one;
    }
  }
  return most > 0 ? std::move(device) : nullptr;
}

/// Returns the device of this process, or null if there is none.
OpenDevice* GetOpenDevice()
{
  // It is never closed: when a process ends, its driver may be gone before its static objects.
  static OpenDevice* const device = FindDevice().release();
  return device;
}

/// Makes a buffer with a copy of the data; without data, a small one, because none may be empty.
template <typename Value>
cl::Buffer Upload(
  const cl::Context& context, cl_mem_flags access, const Value* data, std::size_t count)
{
  return count == 0 ? cl::Buffer(context, access, sizeof(Value))
                    : cl::Buffer(context, access | CL_MEM_COPY_HOST_PTR, count * sizeof(Value),
                        const_cast<Value*>(data));
}

/// Adds the sums to the values.
void Run(
  OpenDevice& device, const OpenCLSum& sum, Eigen::MatrixXd& values, const Progress& progress)
{
  static_assert(sizeof(OpenCLBlock) == sizeof(cl_int4) && sizeof(SourceSpan) == sizeof(cl_int2));
  const cl::Context context = device.GetContext();
  const auto upload = [&](const auto* data, std::size_t count)
  { return Upload(context, CL_MEM_READ_ONLY, data, count); };
  const cl::CommandQueue queue(context, device.Id);
  const cl::Buffer sourceData = upload(sum.Sources.data(), sum.Sources.size());
  const cl::Buffer spans = upload(sum.Spans.data(), sum.Spans.size());
  const cl::Buffer blockData = upload(sum.Blocks.data(), sum.Blocks.size());
  const cl::Buffer points = upload(sum.Points.data(), sum.Points.size());
  const cl::Buffer sums = Upload(context, CL_MEM_READ_WRITE, values.data(), values.size());
  cl::Kernel kernel = device.MakeKernel(static_cast<int>(sum.Sources.rows()) - 3, sum.Gradients);
  kernel.setArg(0, sourceData);
  kernel.setArg(1, spans);
  kernel.setArg(2, blockData);
  kernel.setArg(6, points);
  kernel.setArg(7, static_cast<cl_int>(sum.Points.rows()));
  kernel.setArg(8, sums);

  const int blocks = static_cast<int>(sum.Blocks.size());
  const int sources = static_cast<int>(sum.Sources.cols());
  // Launches grow until one takes about a tenth of a second, which is often enough for abort.
  int batch = 16;
  for (int begin = 0; begin < sources;)
  {
    const int end = sources - begin > sum.Pass ? begin + sum.Pass : sources;
    kernel.setArg(4, begin);
    kernel.setArg(5, end);
    for (int first = 0; first < blocks;)
    {
      const int last = blocks - first > batch ? first + batch : blocks;
      const auto start = std::chrono::steady_clock::now();
      kernel.setArg(3, first);
      queue.enqueueNDRangeKernel(kernel, cl::NullRange,
        cl::NDRange(std::size_t(last - first) * OpenCLBlock::Size), cl::NDRange(OpenCLBlock::Size));
      queue.finish();
      const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
      if (seconds.count() < 0.05 && batch < blocks)
      {
        batch *= 2;
      }
      first = last;
      progress((begin + (end - begin) * (static_cast<double>(first) / blocks)) / sources);
    }
    begin = end;
  }
  if (values.size() > 0)
  {
    queue.enqueueReadBuffer(sums, CL_TRUE, 0, values.size() * sizeof(double), values.data());
  }
}

} // namespace

bool ChooseOpenCL(const SumDevice& device, double pairs)
{
  switch (device.Kind)
  {
    case SumDevice::KindType::Processor:
      return false;
    case SumDevice::KindType::OpenCL:
      if (!GetOpenDevice())
      {
        throw InvalidInput("there is no OpenCL device with double precision; install the driver of "
                           "a GPU, or set Device to Automatic or Processor");
      }
      return true;
    default:
      // Drivers are loaded only for a sum that is large enough.
      return pairs >= SumDevice::MinimumPairs && GetOpenDevice() && GetOpenDevice()->IsGPU;
  }
}

std::optional<Eigen::MatrixXd> SumByOpenCL(
  const OpenCLSum& sum, const SumDevice& device, const Progress& progress)
{
  Eigen::MatrixXd values =
    Eigen::MatrixXd::Zero(sum.Points.rows(), (sum.Sources.rows() - 3) * (sum.Gradients ? 3 : 1));
  try
  {
    Run(*GetOpenDevice(), sum, values, progress);
    return values;
  }
  catch (const cl::Error& error)
  {
    const std::string fact = "the OpenCL device failed (" + std::string(error.what()) + ", error " +
      std::to_string(error.err()) + ")";
    if (!device.Warn)
    {
      throw SolveFailure(fact + "; compute on the processor");
    }
    device.Warn(fact +
      ", and the processor computed the sums; set Device to Processor, or use a "
      "device with more memory or another driver");
    return std::nullopt;
  }
}

#else

bool ChooseOpenCL(const SumDevice& device, double)
{
  if (device.Kind == SumDevice::KindType::OpenCL)
  {
    throw InvalidInput("ShapeMap was built without OpenCL (SHAPEMAP_OPENCL=OFF); build it with "
                       "SHAPEMAP_OPENCL=ON, or set Device to Processor");
  }
  return false;
}

std::optional<Eigen::MatrixXd> SumByOpenCL(const OpenCLSum&, const SumDevice&, const Progress&)
{
  return std::nullopt; // never called: ChooseOpenCL returns false
}

#endif

} // namespace shape
