#include "Linear/SparseSolve.h"

#include "Base/Errors.h"
#include "Base/Parallel.h"

#ifdef SHAPEMAP_CHOLMOD
#include <Eigen/CholmodSupport>
#else
#include <Eigen/SparseCholesky>
#endif

namespace shape
{

struct SparseCholesky::Factor
{
#ifdef SHAPEMAP_CHOLMOD
  Eigen::CholmodSupernodalLLT<Eigen::SparseMatrix<double>> Solver;
#else
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> Solver;
#endif
  bool Analysed = false;

  /// Whether the factorisation is large enough for BLAS to use several threads. In a small one they
  /// would mostly wait for each other.
  bool WorthSharing()
  {
#ifdef SHAPEMAP_CHOLMOD
    constexpr double operations = 3e9;
    return this->Solver.cholmod().fl > operations;
#else
    return false;
#endif
  }
};

SparseCholesky::SparseCholesky()
  : Impl(std::make_unique<Factor>())
{
#ifdef SHAPEMAP_CHOLMOD
  this->Impl->Solver.cholmod().print = 0;
#endif
}

SparseCholesky::~SparseCholesky() = default;
SparseCholesky::SparseCholesky(SparseCholesky&&) noexcept = default;
SparseCholesky& SparseCholesky::operator=(SparseCholesky&&) noexcept = default;

void SparseCholesky::Factorize(const Eigen::SparseMatrix<double>& a)
{
  if (!this->Impl->Analysed)
  {
    this->Impl->Solver.analyzePattern(a);
    this->Impl->Analysed = true;
  }
  const BlasThreads threads(this->Impl->WorthSharing());
  this->Impl->Solver.factorize(a);
  if (this->Impl->Solver.info() != Eigen::Success)
  {
    throw SolveFailure("a sparse matrix is not positive definite; remove triangles without area");
  }
}

Eigen::MatrixXd SparseCholesky::Solve(const Eigen::MatrixXd& b) const
{
  const BlasThreads one(false);
  return this->Impl->Solver.solve(b);
}

} // namespace shape
