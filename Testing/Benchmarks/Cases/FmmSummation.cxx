// The sums of 1/r: what the processor allows, pair by pair, and by the multipole method.
#include "Driver/Case.h"

#include "Fmm/DirectSummation.h"
#include "Fmm/FmmSummation.h"

#include <hwy/targets.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <random>
#include <string>

namespace
{

constexpr const char* Usage = R"(

CPU seconds on one thread, medians of five. The first row: instructions per second of FMAs alone (fma) and
of a mixture with three additions among fourteen (mixed), on vectors of so many doubles. Then, for one,
two and three charges at a source, pairs per second pair by pair, of potentials and of gradients. Then the
multipole method for points on or inside a bumpy sphere: set-up, sum, gradients, and the error at 2000 of
the points, RMS and at most, over the sum of the terms' magnitudes.)";

double Median(const std::function<void()>& body)
{
  constexpr int runs = 5;
  return benchmark::MeasureMedian(runs, body);
}

// Independent instructions on the registers of a list, in assembly: what compilers make of
// intrinsics may go by way of memory.
#define ZERO(list) ".irp n," list "\n vxorpd %%ymm\\n, %%ymm\\n, %%ymm\\n\n .endr\n"
#define FMA(width, list)                                                                           \
  ".irp n," list "\n vfmadd213pd %%" width "15, %%" width "14, %%" width "\\n\n .endr\n"
#define ADD(width, list)                                                                           \
  ".irp n," list "\n vaddpd %%" width "15, %%" width "\\n, %%" width "\\n\n .endr\n"

/// Registers that both kinds of processors have and that the sums may be in.
#define ALL "0,1,2,3,4,5,6,7,8,9,10,11,12,13"
#define MIXTURE(width)                                                                             \
  FMA(width, "0,1,2,3")                                                                            \
  ADD(width, "4") FMA(width, "5,6,7,8") ADD(width, "9") FMA(width, "10,11,12") ADD(width, "13")

constexpr int Rounds = 8000000, InRound = 14;

#define REPEATED(name, isa, block)                                                                 \
  __attribute__((target(isa), noinline)) void name()                                               \
  {                                                                                                \
    long rounds = Rounds;                                                                          \
    asm volatile(ZERO(ALL ",14,15") ".p2align 6\n1:\n" block "dec %0\n jnz 1b\n vzeroupper\n"      \
                 : "+r"(rounds)                                                                    \
                 :                                                                                 \
                 : "cc", "xmm0", "xmm1", "xmm2", "xmm3", "xmm4", "xmm5", "xmm6", "xmm7", "xmm8",   \
                 "xmm9", "xmm10", "xmm11", "xmm12", "xmm13", "xmm14", "xmm15");                    \
  }

/// FMAs alone, or three additions among fourteen instructions, for which some processors have ports
/// of their own: the innermost loop has three of sixteen.
REPEATED(WideFmas, "avx512f", FMA("zmm", ALL))
REPEATED(WideMixture, "avx512f", MIXTURE("zmm"))
REPEATED(Fmas, "avx2,fma", FMA("ymm", ALL))
REPEATED(Mixture, "avx2,fma", MIXTURE("ymm"))

std::mt19937 Generator(1);

/// Points on a bumpy sphere, times `scale`.
Eigen::MatrixXd Surface(int count, double scale)
{
  std::normal_distribution<double> normal;
  Eigen::MatrixXd points(count, 3);
  for (int i = 0; i < count; ++i)
  {
    Eigen::RowVector3d x(normal(Generator), normal(Generator), normal(Generator));
    x.normalize();
    points.row(i) = scale * x *
      (1.0 + 0.3 * std::sin(3.0 * x[0] + 1.0) * std::cos(4.0 * x[1]) + 0.15 * std::sin(7.0 * x[2]));
  }
  return points;
}

/// Evenly distributed in the inside of the same surface.
Eigen::MatrixXd Inside(int count)
{
  std::uniform_real_distribution<double> uniform;
  Eigen::MatrixXd points = Surface(count, 0.99);
  for (int i = 0; i < count; ++i)
  {
    points.row(i) *= std::cbrt(uniform(Generator));
  }
  return points;
}

/// Times of the multipole sum, and its error at 2000 of the points.
void Compare(benchmark::Figures& figures, const std::string& where, const Eigen::MatrixXd& sources,
  const Eigen::MatrixXd& points, const Eigen::MatrixXd& charges, double tolerance)
{
  shape::FmmSummationOptions options;
  options.Method = shape::FmmSummationOptions::MethodType::Multipole;
  options.Tolerance = tolerance;
  const double setUp = Median([&] { shape::FmmSummation(sources, points, options); });
  const shape::FmmSummation fast(sources, points, options);
  Eigen::MatrixXd potentials;
  const double sum = Median([&] { potentials = fast.Potentials(charges); });
  const double gradients = Median([&] { fast.Gradients(charges); });
  const Eigen::VectorXi some = Eigen::VectorXi::LinSpaced(2000, 0, points.rows() - 1);
  const Eigen::MatrixXd positions = points(some, Eigen::all);
  const Eigen::MatrixXd error =
    potentials(some, Eigen::all) - shape::SumPotentialsDirectly(sources, charges, positions);
  const Eigen::MatrixXd sizes =
    shape::SumPotentialsDirectly(sources, charges.cwiseAbs(), positions);
  figures.Print(benchmark::Row()
                  .Add("where", where)
                  .Add("sources", sources.rows())
                  .Add("points", points.rows())
                  .Add("tolerance", tolerance)
                  .Add("setup", setUp)
                  .Add("sum", sum)
                  .Add("gradient", gradients)
                  .Add("error", error.norm() / sizes.norm())
                  .Add("largest", (error.array() / sizes.array()).abs().maxCoeff()));
}

void Run(benchmark::Arguments& arguments, benchmark::Figures& figures)
{
  arguments.RequireAllRead();
  setenv("VTK_SMP_MAX_THREADS", "1", 1);
  const bool wide = (hwy::SupportedTargets() & HWY_AVX3) != 0;
  constexpr double instructions = static_cast<double>(Rounds) * InRound;
  figures.Print(benchmark::Row()
                  .Add("target", std::string(wide ? "N_AVX3" : "N_AVX2"))
                  .Add("lanes", wide ? 8 : 4)
                  .Add("fma", instructions / Median(wide ? WideFmas : Fmas))
                  .Add("mixed", instructions / Median(wide ? WideMixture : Mixture)));

  const int m = 100000;
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const Eigen::MatrixXd sources = Surface(m, 1.01);
  Eigen::MatrixXd charges = Eigen::MatrixXd::NullaryExpr(
    m, 3, [&](Eigen::Index, Eigen::Index) { return uniform(Generator); });
  charges.col(1) = charges.col(1).cwiseAbs();
  const Eigen::MatrixXd surface = Surface(m, 1.0);
  for (const int columns : { 1, 2, 3 })
  {
    const Eigen::MatrixXd few = charges.leftCols(columns);
    const Eigen::MatrixXd points = surface.topRows(20000);
    const double pairs = double(m) * points.rows();
    figures.Print(benchmark::Row()
                    .Add("columns", columns)
                    .Add("potentials",
                      pairs / Median([&] { shape::SumPotentialsDirectly(sources, few, points); }))
                    .Add("gradients",
                      pairs / Median([&] { shape::SumGradientsDirectly(sources, few, points); })));
  }
  for (const double tolerance : { 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 2e-12 })
  {
    Compare(figures, "surface", sources, surface, charges, tolerance);
  }
  const int n = 1000000;
  Compare(figures, "inside", sources, Inside(n), charges, 1e-6);
  Compare(figures, "surface", sources, Surface(n, 1.0), charges, 1e-6);
}

const benchmark::Entry FmmSummation("fmm_summation", { Usage, Run });

} // namespace
