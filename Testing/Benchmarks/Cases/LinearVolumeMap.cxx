// The gradient of a function of a harmonic map by its boundary's images, beside the fit of the map.
#include "Driver/BenchmarkData.h"
#include "Driver/Case.h"

#include "Harmonic/HarmonicVolumeMap.h"
#include "Harmonic/LinearVolumeMap.h"
#include "Solids/Nesting.h"

#include <cmath>
#include <cstdlib>
#include <memory>
#include <string>

namespace
{

constexpr const char* Usage = R"(MODEL [Key=value ...]

MODEL   an OFF file: a closed surface; the images are those of the harmonic field A of volume_map
Tolerance=1e-9 of the fit, GradientTolerance=1e-7, Subdivisions=0, Repeats=3, Interior=4000 points
inside

CPU seconds of the set-up, of a fit, of the gradient of a function of the points inside, and of
Accelerated with its usual tolerance; ratio is gradient / fit. error is that of the gradient: of the
function's value, which is linear in the images, relative to the value expected of random images of this
norm. noiseerror is the same for random images, instead of those of the field. interior is the root
mean square error of the map at the points inside, divided by the longest side of the image's box;
acceleratedinterior is that of Accelerated.)";

void Run(benchmark::Arguments& arguments, benchmark::Figures& figures)
{
  const std::string model = arguments.NextWord();
  shape::LinearVolumeMapOptions options;
  options.Tolerance = arguments.Setting("Tolerance", options.Tolerance);
  options.GradientTolerance = arguments.Setting("GradientTolerance", options.GradientTolerance);
  const int repeats = arguments.Setting("Repeats", 3), steps = arguments.Setting("Subdivisions", 0),
            count = arguments.Setting("Interior", 4000);
  arguments.RequireAllRead();
  shape::Mesh mesh = benchmark::ReadOff(model, false);
  for (int i = 0; i < steps; ++i)
  {
    mesh = benchmark::Subdivide(mesh);
  }
  mesh = shape::OrientByNesting(mesh, "the model");
  const benchmark::HarmonicField field(mesh, 1);
  const Eigen::MatrixXd images = field.Evaluate(mesh.Points),
                        points = benchmark::InteriorPoints(mesh, count, 2);
  const Eigen::MatrixXd expected = field.Evaluate(points);
  const double size = shape::ComputeLongestBoxEdge(images);
  const auto errorOf = [&](const shape::ChargeSet& map)
  {
    const Eigen::MatrixXd errors = shape::Evaluate(map, points) - expected;
    return std::sqrt(errors.rowwise().squaredNorm().mean()) / size;
  };
  // The function: a sum with weights of either sign.
  const Eigen::MatrixXd weights = (7.0 * points).array().sin();

  std::unique_ptr<shape::LinearVolumeMap> solver;
  const double setUp = benchmark::MeasureMedian(
    1, [&] { solver = std::make_unique<shape::LinearVolumeMap>(mesh, options); });
  shape::ChargeSet map, accelerated;
  const double fit = benchmark::MeasureMedian(repeats, [&] { map = solver->Fit(images); });
  Eigen::MatrixXd gradient;
  const double sweep =
    benchmark::MeasureMedian(repeats, [&] { gradient = solver->Gradient(points, weights); });
  const double usual = benchmark::MeasureMedian(
    1, [&] { accelerated = shape::ComputeHarmonicVolumeMap(mesh, images).Map; });
  const auto gradientError = [&](const Eigen::MatrixXd& at)
  {
    const double value = weights.cwiseProduct(shape::Evaluate(solver->Fit(at), points)).sum();
    return std::abs(gradient.cwiseProduct(at).sum() - value) * std::sqrt(double(at.size())) /
      (gradient.norm() * at.norm());
  };
  std::srand(3);
  const Eigen::MatrixXd noise = Eigen::MatrixXd::Random(images.rows(), 3);
  figures.Print(benchmark::Row()
                  .Add("points", mesh.Points.rows())
                  .Add("setup", setUp)
                  .Add("fit", fit)
                  .Add("gradient", sweep)
                  .Add("ratio", sweep / fit)
                  .Add("accelerated", usual)
                  .Add("error", gradientError(images))
                  .Add("noiseerror", gradientError(noise))
                  .Add("interior", errorOf(map))
                  .Add("acceleratedinterior", errorOf(accelerated)));
}

const benchmark::Entry entry("linear_volume_map", { Usage, Run });

} // namespace
