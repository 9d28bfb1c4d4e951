#include "Linear/NewtonSystem.h"

#include "Base/Errors.h"
#include "Base/ReportInterval.h"

#include <algorithm>
#include <utility>

namespace shape
{

NewtonSystem::NewtonSystem(
  const std::vector<int>& widths, std::vector<int> elements, int corners, const Progress& progress)
  : Corners(corners)
  , Elements(std::move(elements))
  , First(1, 0)
{
  for (const int width : widths)
  {
    this->First.push_back(this->First.back() + width);
  }
  this->MakePattern(progress);
}

void NewtonSystem::MakePattern(const Progress& progress)
{
  // First the blocks that share an element with each block are found, then the rows of each column,
  // then the slots.
  const std::size_t blocks = this->First.size() - 1, step = this->Corners;
  std::vector<std::vector<int>> neighbours(blocks);
  for (std::size_t first = 0; first < this->Elements.size(); first += step)
  {
    if (first / step % ReportInterval == 0)
    {
      progress(0.3 * first / this->Elements.size());
    }
    for (std::size_t column = first; column < first + step; ++column)
    {
      for (std::size_t row = first; row < first + step; ++row)
      {
        if (this->Elements[column] >= 0 && this->Elements[row] >= 0)
        {
          neighbours[this->Elements[column]].push_back(this->Elements[row]);
        }
      }
    }
  }
  // All columns of a block have the same rows.
  const int unknowns = this->First.back();
  this->Matrix.resize(unknowns, unknowns);
  std::vector<int> rows, inner;
  for (std::size_t block = 0; block < blocks; ++block)
  {
    if (block % ReportInterval == 0)
    {
      progress(0.3 + 0.3 * block / blocks);
    }
    std::vector<int>& all = neighbours[block];
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    rows.clear();
    for (const int other : all)
    {
      for (int row = this->First[other]; row < this->First[other + 1]; ++row)
      {
        rows.push_back(row);
      }
    }
    for (int column = this->First[block]; column < this->First[block + 1]; ++column)
    {
      inner.insert(inner.end(), rows.begin(), rows.end());
      this->Matrix.outerIndexPtr()[column + 1] = static_cast<int>(inner.size());
    }
  }
  this->Matrix.resizeNonZeros(static_cast<Eigen::Index>(inner.size()));
  std::copy(inner.begin(), inner.end(), this->Matrix.innerIndexPtr());
  // The position of each element's blocks in the columns of H, so that assembly needs no search.
  this->Slots.assign(this->Elements.size() * step, -1);
  const int count = static_cast<int>(this->Elements.size() / step);
  for (int element = 0; element < count; ++element)
  {
    if (element % ReportInterval == 0)
    {
      progress(0.6 + 0.4 * element / count);
    }
    const int* own = this->Elements.data() + element * step;
    for (int column = 0; column < this->Corners; ++column)
    {
      for (int row = 0; row < this->Corners; ++row)
      {
        if (own[column] >= 0 && own[row] >= 0 && this->Width(own[column]) > 0)
        {
          const int* outer = this->Matrix.outerIndexPtr() + this->First[own[column]];
          const int *first = inner.data() + outer[0], *last = inner.data() + outer[1];
          this->Slots[this->SlotOf(element, row, column)] =
            static_cast<int>(std::lower_bound(first, last, this->First[own[row]]) - first);
        }
      }
    }
  }
}

void NewtonSystem::Clear()
{
  this->Gradient.setZero(this->First.back());
  std::fill_n(this->Matrix.valuePtr(), this->Matrix.nonZeros(), 0.0);
}

NewtonSystem::Step NewtonSystem::Solve(const Ridge& ridge, const Progress& progress)
{
  // The unknowns are scaled to unit diagonal, so a ridge has the same effect on all of them.
  const Eigen::VectorXd diagonal = this->Matrix.diagonal();
  // The bound keeps the scale finite for unknowns without curvature.
  const Eigen::VectorXd scale =
    diagonal.array().max(1e-300 + 1e-30 * diagonal.maxCoeff()).sqrt().inverse().matrix();
  for (int column = 0; column < this->Matrix.cols(); ++column)
  {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(this->Matrix, column); entry; ++entry)
    {
      entry.valueRef() *= scale(column) * scale(entry.row());
    }
  }
  for (double share = ridge.First; share < 1.0; share *= ridge.Factor)
  {
    // The diagonal is 1, so a share of it is the share itself. Ridges that failed stay added.
    this->Matrix.diagonal().array() += share;
    try
    {
      this->Cholesky.Factorize(this->Matrix, progress);
    }
    catch (const SolveFailure&)
    {
      continue;
    }
    Step step;
    step.Values =
      -scale.cwiseProduct(this->Cholesky.Solve(scale.cwiseProduct(this->Gradient)).col(0));
    if (step.Values.allFinite())
    {
      step.Slope = -step.Values.dot(this->Gradient);
      return step;
    }
  }
  return { Eigen::VectorXd::Zero(this->First.back()), 0.0 };
}

} // namespace shape
