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
using Places = Eigen::Array<double, Block, 3>;

/// One charge's six numbers side by side: its place and its weights, divided by 4 pi.
Eigen::Matrix<double, 6, Eigen::Dynamic> Packed(const ChargeSet& set)
{
  Eigen::Matrix<double, 6, Eigen::Dynamic> charges(6, set.Points.rows());
  charges.topRows<3>() = set.Points.transpose();
  charges.bottomRows<3>() = InverseFourPi * set.Charges.transpose();
  return charges;
}

/// The points [begin, end); a last, shorter block repeats its last point.
Places BlockOf(const Eigen::MatrixXd& points, int begin, int end)
{
  Places place;
  place.topRows(end - begin) = points.middleRows(begin, end - begin).array();
  place.bottomRows(Block - (end - begin)).rowwise() = points.row(end - 1).array();
  return place;
}

} // namespace

Eigen::MatrixXd Evaluate(
  const ChargeSet& set, const Eigen::MatrixXd& points, const Progress& progress)
{
  const int n = static_cast<int>(points.rows());
  const Eigen::Index k = set.Points.rows();
  const Eigen::Matrix<double, 6, Eigen::Dynamic> charges = Packed(set);
  Eigen::MatrixXd values(n, 3);
  ParallelFor(
    n, Block,
    [&](int begin, int end)
    {
      const int size = end - begin;
      const Places place = BlockOf(points, begin, end);
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

Eigen::MatrixXd Jacobians(
  const ChargeSet& set, const Eigen::MatrixXd& points, const Progress& progress)
{
  const int n = static_cast<int>(points.rows());
  const Eigen::Index k = set.Points.rows();
  const Eigen::Matrix<double, 6, Eigen::Dynamic> charges = Packed(set);
  Eigen::MatrixXd values(n, 9);
  ParallelFor(
    n, Block,
    [&](int begin, int end)
    {
      const Places place = BlockOf(points, begin, end);
      Eigen::Array<double, Block, 9> sums = Eigen::Array<double, Block, 9>::Zero();
      Places away;
      for (Eigen::Index j = 0; j < k; ++j)
      {
        const double* charge = charges.data() + 6 * j;
        for (int c = 0; c < 3; ++c)
        {
          away.col(c) = place.col(c) - charge[c];
        }
        const Lane squared = away.col(0).square() + away.col(1).square() + away.col(2).square();
        away.colwise() *= squared.rsqrt() / squared;
        for (int r = 0; r < 3; ++r)
        {
          for (int c = 0; c < 3; ++c)
          {
            sums.col(3 * r + c) -= charge[3 + r] * away.col(c);
          }
        }
      }
      for (int r = 0; r < 3; ++r)
      {
        for (int c = 0; c < 3; ++c)
        {
          values.col(3 * r + c).segment(begin, end - begin) =
            sums.col(3 * r + c).head(end - begin) + set.Affine(r, c);
        }
      }
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
