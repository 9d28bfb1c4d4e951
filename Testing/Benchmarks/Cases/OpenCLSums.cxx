// Sums of 1/r by the processor and by an OpenCL device, from few pairs to many.
#include "Driver/Case.h"

#include "Fmm/DirectSummation.h"
#include "Fmm/FmmSummation.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <random>
#include <string>
#include <vector>

namespace
{

constexpr const char* Usage = R"([Key=value ...]

Pairs=1e9 of the largest direct sum, at most 1e10, which is for a GPU: where pocl is the device, two cores
take a minute by default, and ten times as long with 1e10.

Wall seconds, medians of three after a first run that starts the device, for three charges at a source. By
the processor with all its threads (VTK_SMP_MAX_THREADS limits them), and by the OpenCL device. direct: as
many points as sources, potentials and gradients. multipole: a sum of tolerance 1e-6 on a sphere.)";

double MedianSeconds(const std::function<void()>& body)
{
  body();
  std::vector<double> seconds;
  for (int run = 0; run < 3; ++run)
  {
    const auto start = std::chrono::steady_clock::now();
    body();
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    seconds.push_back(taken.count());
  }
  std::sort(seconds.begin(), seconds.end());
  return seconds[1];
}

Eigen::MatrixXd Random(int rows, int columns, unsigned seed)
{
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  return Eigen::MatrixXd::NullaryExpr(
    rows, columns, [&](Eigen::Index, Eigen::Index) { return uniform(generator); });
}

void Run(benchmark::Arguments& arguments, benchmark::Figures& figures)
{
  const double pairs = arguments.Setting("Pairs", 1e9);
  arguments.RequireAllRead();
  const shape::SumDevice processor, device{ shape::SumDevice::KindType::OpenCL };
  for (const int count : { 1000, 3162, 10000, 31622, 100000 })
  {
    if (double(count) * count > pairs)
    {
      break;
    }
    const Eigen::MatrixXd sources = Random(count, 3, 1), points = Random(count, 3, 2);
    const Eigen::MatrixXd charges = Random(count, 3, 3);
    const auto potentials = [&](const shape::SumDevice& by)
    {
      return MedianSeconds(
        [&] {
          shape::SumPotentialsDirectly(
            sources, charges, points, shape::RootError::Rounding, {}, by);
        });
    };
    const auto gradients = [&](const shape::SumDevice& by) {
      return MedianSeconds([&] { shape::SumGradientsDirectly(sources, charges, points, {}, by); });
    };
    figures.Print(benchmark::Row()
                    .Add("method", std::string("direct"))
                    .Add("pairs", double(count) * count)
                    .Add("processor", potentials(processor))
                    .Add("opencl", potentials(device))
                    .Add("processor_gradients", gradients(processor))
                    .Add("opencl_gradients", gradients(device)));
  }
  for (const int count : { 10000, 100000, 1000000 })
  {
    const Eigen::MatrixXd sources = 1.01 * Random(count, 3, 4).rowwise().normalized();
    const Eigen::MatrixXd points = Random(count, 3, 5).rowwise().normalized();
    const Eigen::MatrixXd charges = Random(count, 3, 6);
    const auto seconds = [&](const shape::SumDevice& by)
    {
      shape::FmmSummationOptions options;
      options.Method = shape::FmmSummationOptions::MethodType::Multipole;
      options.Device = by;
      const shape::FmmSummation sum(sources, points, options);
      return MedianSeconds([&] { sum.Potentials(charges); });
    };
    figures.Print(benchmark::Row()
                    .Add("method", std::string("multipole"))
                    .Add("points", count)
                    .Add("processor", seconds(processor))
                    .Add("opencl", seconds(device)));
  }
}

const benchmark::Entry OpenCLSums("opencl_sums", { Usage, Run });

} // namespace
