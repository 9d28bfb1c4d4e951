#include "Linear/SparseSolve.h"

#include "Base/Errors.h"
#include "Base/Parallel.h"

#include <algorithm>

#ifdef SHAPEMAP_CHOLMOD
#include "Base/LibraryCall.h"
#include "Linear/Private/SupernodalCholesky.h"

#include <Eigen/CholmodSupport>

#include <new>
#include <vector>
#else
#include <Eigen/SparseCholesky>
#endif

namespace shape
{

#ifdef SHAPEMAP_CHOLMOD

/// CHOLMOD orders the matrix, finds the pattern of the factor and solves. The values are computed
/// by FactorizeSupernodes, because CHOLMOD's own factorisation cannot be interrupted.
struct SparseCholesky::Factor
{
  Factor()
  {
    cholmod_start(&this->Common);
    this->Common.print = 0;
    this->Common.supernodal = CHOLMOD_SUPERNODAL;
  }
  ~Factor()
  {
    cholmod_free_factor(&this->L, &this->Common);
    cholmod_finish(&this->Common);
  }
  Factor(const Factor&) = delete;
  Factor& operator=(const Factor&) = delete;

  bool Factorize(const Eigen::SparseMatrix<double>& a, const Progress& progress)
  {
    // Share of the time for the order and the pattern: 0.55 for surfaces, 0.15 for solids.
    const double analysis = this->L ? 0.0 : 0.4;
    if (!this->L)
    {
      this->Analyse(a, progress.Part(0.0, analysis));
    }
    if (this->L->xtype == CHOLMOD_PATTERN)
    {
      cholmod_change_factor(CHOLMOD_REAL, true, true, true, true, this->L, &this->Common);
      this->RequireSuccess();
    }
    const cholmod_factor* supernodes = this->L;
    const SupernodalPattern pattern{ static_cast<int>(supernodes->nsuper),
      static_cast<const int*>(supernodes->super), static_cast<const int*>(supernodes->pi),
      static_cast<const int*>(supernodes->s), static_cast<const int*>(supernodes->px),
      static_cast<const int*>(supernodes->Perm) };
    return FactorizeSupernodes(
      a, pattern, static_cast<double*>(supernodes->x), progress.Part(analysis, 1.0));
  }

  Eigen::MatrixXd Solve(Eigen::MatrixXd b)
  {
    cholmod_dense right = Eigen::viewAsCholmod(b);
    cholmod_dense* x = cholmod_solve(CHOLMOD_A, this->L, &right, &this->Common);
    this->RequireSuccess();
    b = Eigen::Map<Eigen::MatrixXd>(static_cast<double*>(x->x), b.rows(), b.cols());
    cholmod_free_dense(&x, &this->Common);
    return b;
  }

  /// number of values of the factor
  double Size() const { return static_cast<double>(this->L->xsize); }

private:
  /// Finds the elimination order and the pattern of the factor.
  void Analyse(const Eigen::SparseMatrix<double>& a, const Progress& progress)
  {
    const auto lower = a.selfadjointView<Eigen::Lower>();
    cholmod_sparse matrix = Eigen::viewAsCholmod(lower);
    constexpr int large = 30000;
    if (a.rows() < large)
    {
      this->L = cholmod_analyze(&matrix, &this->Common);
    }
    else
    {
      // Only the order takes long. It is found by a child process; the rest follows from it.
      std::vector<int> order(a.rows(), -1);
      constexpr double operationsOfARow = 3e5;
      RunInterruptibly(
        [&]
        {
          cholmod_factor* found = cholmod_analyze(&matrix, &this->Common);
          if (found)
          {
            std::copy_n(static_cast<const int*>(found->Perm), order.size(), order.begin());
            cholmod_free_factor(&found, &this->Common);
          }
        },
        operationsOfARow * static_cast<double>(a.rows()),
        { { order.data(), order.size() * sizeof(int) } }, progress);
      if (order.front() < 0)
      {
        throw std::bad_alloc();
      }
      this->Common.nmethods = 1;
      this->Common.method[0].ordering = CHOLMOD_GIVEN;
      this->L = cholmod_analyze_p(&matrix, order.data(), nullptr, 0, &this->Common);
    }
    this->RequireSuccess();
  }

  void RequireSuccess() const
  {
    if (this->Common.status == CHOLMOD_TOO_LARGE)
    {
      throw SolveFailure(
        "the factor of a sparse matrix has 2^31 values or more; coarsen the input");
    }
    if (this->Common.status < CHOLMOD_OK)
    {
      throw std::bad_alloc();
    }
  }

  cholmod_common Common{};
  cholmod_factor* L = nullptr;
};

#else

struct SparseCholesky::Factor
{
  bool Factorize(const Eigen::SparseMatrix<double>& a, const Progress&)
  {
    if (!this->Analysed)
    {
      this->Solver.analyzePattern(a);
      this->Analysed = true;
    }
    this->Solver.factorize(a);
    return this->Solver.info() == Eigen::Success;
  }

  Eigen::MatrixXd Solve(const Eigen::MatrixXd& b) { return this->Solver.solve(b); }

  double Size() const
  {
    return static_cast<double>(this->Solver.matrixL().nestedExpression().nonZeros());
  }

private:
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> Solver;
  bool Analysed = false;
};

#endif

SparseCholesky::SparseCholesky()
  : Impl(std::make_unique<Factor>())
{
}

SparseCholesky::~SparseCholesky() = default;
SparseCholesky::SparseCholesky(SparseCholesky&&) noexcept = default;
SparseCholesky& SparseCholesky::operator=(SparseCholesky&&) noexcept = default;

void SparseCholesky::Factorize(const Eigen::SparseMatrix<double>& a, const Progress& progress)
{
  progress(0.0);
  if (!this->Impl->Factorize(a, progress))
  {
    throw SolveFailure("a sparse matrix is not positive definite; remove triangles without area");
  }
  progress(1.0);
}

Eigen::MatrixXd SparseCholesky::Solve(const Eigen::MatrixXd& b, const Progress& progress) const
{
  const BlasThreads one(false);
  // Several columns share a pass over the factor. A group takes about a tenth of a second at most.
  constexpr double valuesOfGroup = 1e8;
  const Eigen::Index group =
    std::clamp<Eigen::Index>(static_cast<Eigen::Index>(valuesOfGroup / this->Impl->Size()), 1, 32);
  Eigen::MatrixXd x(b.rows(), b.cols());
  for (Eigen::Index first = 0; first < b.cols(); first += group)
  {
    progress(static_cast<double>(first) / static_cast<double>(b.cols()));
    const Eigen::Index count = std::min(group, b.cols() - first);
    x.middleCols(first, count) = this->Impl->Solve(b.middleCols(first, count));
  }
  return x;
}

} // namespace shape
