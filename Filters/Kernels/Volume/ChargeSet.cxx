#include "Volume/ChargeSet.h"

#include "Core/Parallel.h"

#include <algorithm>
#include <cmath>

namespace shape
{

namespace
{

constexpr double InverseFourPi = 0.25 / M_PI;
/// Points that one pass over the charges serves: their arrays stay in the first-level cache and
/// Eigen's fixed-size loops become vector instructions.
constexpr int Block = 32;
using Lane = Eigen::Array<double, Block, 1>;

} // namespace

Eigen::MatrixXd Evaluate(
  const ChargeSet& set, const Eigen::MatrixXd& points, const Progress& progress)
{
  const int n = static_cast<int>(points.rows());
  const Eigen::Index k = set.Points.rows();
  // One charge's six numbers side by side.
  Eigen::Matrix<double, 6, Eigen::Dynamic> charges(6, k);
  charges.topRows<3>() = set.Points.transpose();
  charges.bottomRows<3>() = InverseFourPi * set.Charges.transpose();
  Eigen::MatrixXd values(n, 3);
  ParallelFor(
    n, Block,
    [&](int begin, int end)
    {
      const int size = end - begin;
      // A last, shorter block repeats its last point.
      Eigen::Array<double, Block, 3> place;
      place.topRows(size) = points.middleRows(begin, size).array();
      place.bottomRows(Block - size).rowwise() = points.row(end - 1).array();
      Lane sumX = Lane::Zero(), sumY = Lane::Zero(), sumZ = Lane::Zero();
      for (Eigen::Index j = 0; j < k; ++j)
      {
        const double* charge = charges.data() + 6 * j;
        const Lane inverse = ((place.col(0) - charge[0]).square() +
          (place.col(1) - charge[1]).square() + (place.col(2) - charge[2]).square())
                               .rsqrt();
        sumX += charge[3] * inverse;
        sumY += charge[4] * inverse;
        sumZ += charge[5] * inverse;
      }
      values.middleRows(begin, size) =
        points.middleRows(begin, size).lazyProduct(set.Affine.leftCols<3>().transpose()).rowwise() +
        set.Affine.col(3).transpose();
      values.col(0).segment(begin, size) += sumX.head(size).matrix();
      values.col(1).segment(begin, size) += sumY.head(size).matrix();
      values.col(2).segment(begin, size) += sumZ.head(size).matrix();
    },
    progress);
  return values;
}

Eigen::MatrixXd PotentialMatrix(
  const Eigen::MatrixXd& points, const Eigen::MatrixXd& sources, const Progress& progress)
{
  Eigen::MatrixXd matrix(points.rows(), sources.rows());
  ParallelFor(
    static_cast<int>(sources.rows()), 8,
    [&](int begin, int end)
    {
      for (int j = begin; j < end; ++j)
      {
        matrix.col(j) = InverseFourPi *
          ((points.col(0).array() - sources(j, 0)).square() +
            (points.col(1).array() - sources(j, 1)).square() +
            (points.col(2).array() - sources(j, 2)).square())
            .rsqrt();
      }
    },
    progress);
  return matrix;
}

} // namespace shape
