#include "Correspondence/Transport/Private/Sinkhorn.h"

#include <algorithm>
#include <cmath>

namespace shape
{

Sinkhorn::Sinkhorn(const Eigen::VectorXd& rows, const Eigen::VectorXd& columns)
  : Rows(rows)
  , Columns(columns)
  , OfRows(Eigen::VectorXd::Zero(rows.size()))
  , OfColumns(Eigen::VectorXd::Zero(columns.size()))
{
}

void Sinkhorn::Scale(double factor)
{
  this->OfRows *= factor;
  this->OfColumns *= factor;
}

/// In logarithms: exp would overflow for small entropies, so the largest entry of each row is
/// subtracted before, and returned in f.
Eigen::MatrixXd Sinkhorn::Begin(const Eigen::MatrixXd& likeness)
{
  Eigen::MatrixXd masses = likeness;
  masses.rowwise() += this->OfColumns.transpose();
  const Eigen::VectorXd largest = masses.rowwise().maxCoeff();
  masses.colwise() -= largest;
  masses = masses.array().exp();
  const Eigen::VectorXd factors = this->Rows.cwiseQuotient(masses.rowwise().sum());
  masses = factors.asDiagonal() * masses;
  this->OfRows = factors.array().log().matrix() - largest;
  // A column whose entries all underflow would need an infinite factor; it is then scaled by its
  // own largest entry.
  constexpr double lost = 1e-60;
  if (masses.colwise().sum().minCoeff() > lost)
  {
    return masses;
  }
  masses = likeness;
  masses.colwise() += this->OfRows;
  const Eigen::RowVectorXd highest = masses.colwise().maxCoeff();
  masses.rowwise() -= highest;
  masses = masses.array().exp();
  const Eigen::RowVectorXd others = this->Columns.transpose().cwiseQuotient(masses.colwise().sum());
  this->OfColumns = (others.array().log().matrix() - highest).transpose();
  return masses * others.asDiagonal();
}

Eigen::MatrixXd Sinkhorn::Masses(
  const Eigen::MatrixXd& likeness, int iterations, double tolerance, const Progress& progress)
{
  // Most steps update factors; some absorb these in the logarithms to stay within range.
  constexpr int span = 25;
  // The over-relaxation of Thibault et al. converges near the solution only: it starts once the row
  // error is below `near`. The exponent is between 1 (Sinkhorn) and 2 (divergence).
  constexpr double tiny = 1e-100, near = 0.03, relaxation = 1.6;
  for (int done = 0;;)
  {
    Eigen::MatrixXd masses = this->Begin(likeness);
    Eigen::ArrayXd rows = Eigen::ArrayXd::Ones(masses.rows()), columns;
    const auto fitColumns = [&] {
      return (this->Columns.array() / (masses.transpose() * rows.matrix()).array().max(tiny))
        .eval();
    };
    columns = fitColumns();
    for (int k = 0; k <= span; ++k, ++done)
    {
      progress(std::min(1.0, static_cast<double>(done) / iterations));
      const Eigen::ArrayXd sums = (masses * columns.matrix()).array().max(tiny);
      this->RowError = (sums * rows - this->Rows.array()).abs().sum();
      if (this->RowError < tolerance || done >= iterations || k == span)
      {
        break;
      }
      const double power = this->RowError < near ? relaxation : 1.0;
      // One step of Sinkhorn's iteration: scale the rows to their sums, then the columns to theirs.
      rows *= (this->Rows.array() / (sums * rows)).pow(power);
      columns *= (fitColumns() / columns).pow(power);
    }
    columns = fitColumns();
    this->OfRows += rows.log().matrix();
    this->OfColumns += columns.log().matrix();
    if (this->RowError < tolerance || done >= iterations)
    {
      masses = rows.matrix().asDiagonal() * masses * columns.matrix().asDiagonal();
      this->RowError = (masses.rowwise().sum() - this->Rows).cwiseAbs().sum();
      return masses;
    }
  }
}

} // namespace shape
