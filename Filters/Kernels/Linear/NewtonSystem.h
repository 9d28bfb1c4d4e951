#pragma once

#include "Base/Progress.h"
#include "Linear/SparseSolve.h"

#include <Eigen/SparseCore>

#include <vector>

namespace shape
{

/**
 * The linear system of Newton's method for an energy that is a sum over elements. It assembles the
 * gradient g and a positive semi-definite second derivative H from the elements, and computes the
 * step -H^-1 g.
 *
 * The unknowns are grouped in blocks, such as the coordinates of a point. All elements have the
 * same number of corners, and each corner has at most one block. The pattern of H is computed once.
 * For each step call Clear, then AddGradient and AddCurvature for all elements, then Solve.
 */
class NewtonSystem
{
public:
  /// widths: for each block, the number of its unknowns; each >= 0. elements: the blocks of the
  /// first element's corners, then of the second's, and so on; -1 for a corner without unknowns.
  /// corners: number of corners of an element. Throws Aborted.
  NewtonSystem(const std::vector<int>& widths, std::vector<int> elements, int corners,
    const Progress& progress = {});

  int Width(int block) const { return this->First[block + 1] - this->First[block]; }

  void Clear(); ///< sets H = 0 and g = 0

  /// Adds a vector to the part of g for one corner of an element. The corner must have a block, and
  /// the vector the width of this block.
  template <typename Values>
  void AddGradient(int element, int corner, const Values& values)
  {
    const int block = this->Elements[element * this->Corners + corner];
    this->Gradient.segment(this->First[block], this->Width(block)) += values;
  }

  /// Whether H has entries for the rows of corner `row` and the columns of corner `column`.
  bool HasCurvature(int element, int row, int column) const
  {
    return this->Slots[this->SlotOf(element, row, column)] >= 0;
  }

  /// Adds a matrix to the part of H for two corners of an element. Both corners must have blocks.
  /// The matrix has as many rows and columns as the blocks have unknowns.
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
    Eigen::VectorXd Values; ///< -H^-1 g; 0 if H cannot be factorised
    double Slope = 0.0;     ///< initial rate of decrease of the energy along the step: g^T H^-1 g
    /// Returns the values of a block.
    auto Of(const NewtonSystem& system, int block) const
    {
      return this->Values.segment(system.First[block], system.Width(block));
    }
  };

  /// A ridge is a share of the diagonal of H that is added to H. The first share is First, each
  /// further one Factor times the previous. Shares below 1 are added one after the other, until H
  /// is positive definite.
  struct Ridge
  {
    double First;
    double Factor;
  };

  /// Adds ridges to H until it is positive definite, factorises it in place and returns the step.
  /// Throws Aborted.
  Step Solve(const Ridge& ridge, const Progress& progress = {});

private:
  std::size_t SlotOf(int element, int row, int column) const
  {
    return (static_cast<std::size_t>(element) * this->Corners + column) * this->Corners + row;
  }
  void MakePattern(const Progress& progress);

  int Corners;
  std::vector<int> Elements;
  std::vector<int> First; ///< first unknown of each block, and the number of unknowns
  std::vector<int> Slots; ///< for each pair of corners, the first entry in each column, or -1
  Eigen::SparseMatrix<double> Matrix;
  Eigen::VectorXd Gradient;
  SparseCholesky Cholesky;
};

} // namespace shape
