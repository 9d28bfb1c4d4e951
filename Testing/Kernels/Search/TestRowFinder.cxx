#include "Search/RowFinder.h"

#include <gtest/gtest.h>

#include <vector>

TEST(RowFinder, FindsTheFirstRowWithTheSameValues)
{
  const Eigen::MatrixXd rows =
    (Eigen::MatrixXd(6, 3) << 1, 2, 3, 1, 2, 4, 0, 9, 9, 1, 2, 3, -0.0, 9, 9, 5, 0, 0).finished();
  const shape::RowFinder finder(rows);
  EXPECT_EQ(finder.Find(rows), (std::vector<int>{ 0, 1, 2, 0, 2, 5 }));
  const Eigen::MatrixXd others =
    (Eigen::MatrixXd(3, 3) << 5, 0, 1e-300, 6, 0, 0, 1, 2, 4).finished();
  EXPECT_EQ(finder.Find(others), (std::vector<int>{ -1, -1, 1 }));
  EXPECT_TRUE(finder.Find(Eigen::MatrixXd(0, 3)).empty());
  const Eigen::MatrixXd nothing(0, 3);
  EXPECT_EQ(shape::RowFinder(nothing).Find(others), std::vector<int>(3, -1));
}
