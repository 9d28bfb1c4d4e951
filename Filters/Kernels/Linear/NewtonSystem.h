#pragma once

#include "Linear/SparseSolve.h"

#include <Eigen/SparseCore>

#include <vector>

namespace shape
{

/**
 * The linear system of Newton's method for an energy that is a sum over elements: its gradient g
 * and a positive semi-definite second derivative H, assembled element by element, and the step
 * -H^-1 g.
 *
 * The unknowns come in blocks, as the coordinates of a point; an element has a fixed number of
 * blocks. The pattern of H is found once; for each step call Clear, AddGradient and AddCurvature
 * for all elements, and Solve.
 */
class NewtonSystem
{
public:
  /// widths: how many unknowns each block has, >= 0. elements: the blocks of the elements,
  /// `corners` for each, one element after the other; -1 where nothing is unknown.
  NewtonSystem(const std::vector<int>& widths, std::vector<int> elements, int corners);

  int Width(int block) const { return this->First[block + 1] - this->First[block]; }

  void Clear(); ///< H = 0 and g = 0

  /// Adds to the part of g that belongs to a corner of an element, which must be a block: a vector
  /// of its width.
  template <typename Values>
  void AddGradient(int element, int corner, const Values& values)
  {
    const int block = this->Elements[element * this->Corners + corner];
    this->Gradient.segment(this->First[block], this->Width(block)) += values;
  }

  /// Whether rows of corner `row` and columns of corner `column` are in H.
  bool HasCurvature(int element, int row, int column) const
  {
    return this->Slots[this->SlotOf(element, row, column)] >= 0;
  }

  /// Adds to the part of H that belongs to two corners of an element, both blocks: a matrix of
  /// their widths.
  template <typename Values>
  void AddCurvature(int element, int row, int column, const Values& values)
  {
    const int first = this->First[this->Elements[element * this->Corners + column]],
              slot = this->Slots[this->SlotOf(element, row, column)];
    for (Eigen::Index k = 0; k < values.cols(); ++k)
    {
      double* entries = this->Matrix.valuePtr() + this->Matrix.outerIndexPtr()[first + k] + slot;
      for (Eigen::Index j = 0; j < values.rows(); ++j)
      {
        entries[j] += values(j, k);
      }
    }
  }

  struct Step
  {
    Eigen::VectorXd Values; ///< of all unknowns; 0 if H cannot be factorised
    double Slope = 0.0;     ///< by how much the energy falls along it at first: g^T H^-1 g
    /// The values of a block.
    auto Of(const NewtonSystem& system, int block) const
    {
      return this->Values.segment(system.First[block], system.Width(block));
    }
  };

  /// What is added to the diagonal of H, as a share of it, until H is positive definite: First, and
  /// each time Factor as much again, below 1.
  struct Ridge
  {
    double First;
    double Factor;
  };

  /// Factorises H, which is lost, with the smallest ridge that makes it positive definite. One
  /// library call for each ridge that is tried.
  Step Solve(const Ridge& ridge);

private:
  std::size_t SlotOf(int element, int row, int column) const
  {
    return (static_cast<std::size_t>(element) * this->Corners + column) * this->Corners + row;
  }
  void MakePattern();

  int Corners;
  std::vector<int> Elements;
  std::vector<int> First; ///< unknown of each block, and how many unknowns there are
  std::vector<int> Slots; ///< of two corners: the row where they begin in each column; -1: nowhere
  Eigen::SparseMatrix<double> Matrix;
  Eigen::VectorXd Gradient;
  SparseCholesky Cholesky;
};

} // namespace shape
