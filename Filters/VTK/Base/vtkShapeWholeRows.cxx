#include "vtkShapeWholeRows.h"

#include "Base/Errors.h"

#include <algorithm>
#include <numeric>
#include <string>

vtkShapeWholeRows::vtkShapeWholeRows(const Eigen::MatrixXd& whole)
  : Whole(whole)
{
}

std::vector<int> vtkShapeWholeRows::Find(const Eigen::MatrixXd& piece)
{
  if (piece.rows() == this->Whole.rows() && piece == this->Whole)
  {
    std::vector<int> rows(static_cast<std::size_t>(piece.rows()));
    std::iota(rows.begin(), rows.end(), 0);
    return rows;
  }
  if (!this->Finder)
  {
    this->Finder.emplace(this->Whole);
  }
  std::vector<int> rows = this->Finder->Find(piece);
  const auto missing = std::find(rows.begin(), rows.end(), -1);
  if (missing != rows.end())
  {
    throw shape::InvalidInput("point " + std::to_string(missing - rows.begin()) +
      " of a piece of the Input belongs only to hidden cells, or to ghost cells that no process "
      "owns; extract the visible cells with Threshold, or remove the point with Clean to Grid");
  }
  return rows;
}
