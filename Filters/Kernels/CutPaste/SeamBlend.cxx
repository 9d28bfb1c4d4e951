#include "CutPaste/SeamBlend.h"

namespace shape
{

Eigen::MatrixXd BlendAtSeam(Eigen::MatrixXd values, const Eigen::MatrixXd& points,
  const Eigen::MatrixXd& differences, const Eigen::MatrixXd& loop, const Eigen::VectorXd& distances,
  double width)
{
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    if (!(distances(i) < width))
    {
      continue;
    }
    const Eigen::VectorXd squares = (loop.rowwise() - points.row(i)).rowwise().squaredNorm();
    Eigen::Index nearest = 0;
    Eigen::RowVectorXd difference;
    if (squares.minCoeff(&nearest) == 0.0)
    {
      difference = differences.row(nearest);
    }
    else
    {
      const Eigen::VectorXd weights = squares(nearest) * squares.cwiseInverse();
      difference = (weights.transpose() * differences) / weights.sum();
    }
    const double share = distances(i) / width, left = 1.0 - share * share;
    values.row(i) += left * left * left * difference;
  }
  return values;
}

} // namespace shape
