#include "Linear/Private/SupernodalCholesky.h"

#include "Base/Parallel.h"

#include <algorithm>
#include <cblas.h>
#include <lapacke.h>
#include <vector>

namespace shape
{
namespace
{

/// A block of dense columns; `Rows` is also the distance of two columns.
struct SupernodeView
{
  int First; ///< column of L
  int Width;
  int Rows;
  const int* RowOf;
  double* Values;

  double* At(int row, int column) const
  {
    return this->Values + row + static_cast<std::ptrdiff_t>(column) * this->Rows;
  }
};

class SupernodalFactorisation
{
public:
  SupernodalFactorisation(const Eigen::SparseMatrix<double>& a, const SupernodalPattern& pattern,
    double* values, const Progress& progress)
    : A(a)
    , Pattern(pattern)
    , Values(values)
    , Report(progress)
    , RowInFactor(a.rows())
    , Owner(a.rows())
    , Position(a.rows())
    , Head(pattern.Count, -1)
    , Next(pattern.Count, -1)
    , Used(pattern.Count, 0)
  {
    for (int row = 0; row < a.rows(); ++row)
    {
      this->RowInFactor[pattern.Original[row]] = row;
    }
    for (int i = 0; i < pattern.Count; ++i)
    {
      const SupernodeView node = this->View(i);
      std::fill_n(this->Owner.begin() + node.First, node.Width, i);
      const double width = node.Width, below = node.Rows - node.Width;
      this->Total += 0.5 * width *
        ((width + std::min<double>(width, Block)) * (width / 3.0 + below) + below * below);
    }
  }

  bool Run()
  {
    // Outline (Ng and Peyton 1993, left-looking), for each supernode:
    // 1. Assemble its entries of A.
    // 2. Subtract the contributions of the earlier supernodes that have rows in its columns.
    // 3. Factorise its dense block.
    // 4. Queue it for the supernode of its next row.
    for (int i = 0; i < this->Pattern.Count; ++i)
    {
      const SupernodeView node = this->View(i);
      this->Assemble(node);
      for (int earlier = this->Head[i]; earlier >= 0;)
      {
        const int next = this->Next[earlier];
        this->Subtract(earlier, node);
        this->Queue(earlier);
        earlier = next;
      }
      if (!this->FactoriseBlock(node))
      {
        return false;
      }
      this->Used[i] = node.Width;
      this->Queue(i);
    }
    return true;
  }

private:
  /// Columns that one product computes: many for speed, but few enough that a product ends soon.
  static constexpr int Block = 128;

  SupernodeView View(int i) const
  {
    return { this->Pattern.Columns[i], this->Pattern.Columns[i + 1] - this->Pattern.Columns[i],
      this->Pattern.RowEnds[i + 1] - this->Pattern.RowEnds[i],
      this->Pattern.Rows + this->Pattern.RowEnds[i], this->Values + this->Pattern.Values[i] };
  }

  /// Step 1
  void Assemble(const SupernodeView& node)
  {
    std::fill(node.Values, node.At(0, node.Width), 0.0);
    for (int row = 0; row < node.Rows; ++row)
    {
      this->Position[node.RowOf[row]] = row;
    }
    for (int column = 0; column < node.Width; ++column)
    {
      const int original = this->Pattern.Original[node.First + column];
      for (Eigen::SparseMatrix<double>::InnerIterator entry(this->A, original); entry; ++entry)
      {
        const int row = this->RowInFactor[entry.row()];
        if (row >= node.First + column)
        {
          *node.At(this->Position[row], column) = entry.value();
        }
      }
    }
  }

  /// Step 2: the product of the earlier supernode's rows with those of its rows that are columns of
  /// the node.
  void Subtract(int earlier, const SupernodeView& node)
  {
    const SupernodeView from = this->View(earlier);
    const int begin = this->Used[earlier];
    int end = begin;
    while (end < from.Rows && from.RowOf[end] < node.First + node.Width)
    {
      ++end;
    }
    this->Used[earlier] = end;
    this->ForBlocks(begin, end, from.Rows, from.Width,
      [&](int first, int width)
      {
        const int rows = from.Rows - first;
        std::vector<double> product(static_cast<std::size_t>(rows) * width);
        cblas_dgemm(CblasColMajor, CblasNoTrans, CblasTrans, rows, width, from.Width, 1.0,
          from.At(first, 0), from.Rows, from.At(first, 0), from.Rows, 0.0, product.data(), rows);
        for (int column = 0; column < width; ++column)
        {
          double* to = node.At(0, this->Position[from.RowOf[first + column]]);
          const double* values = product.data() + static_cast<std::size_t>(column) * rows;
          for (int row = column; row < rows; ++row)
          {
            to[this->Position[from.RowOf[first + row]]] -= values[row];
          }
        }
      });
  }

  /// Step 3: right-looking, block by block.
  bool FactoriseBlock(const SupernodeView& node)
  {
    for (int first = 0; first < node.Width; first += Block)
    {
      const int width = std::min(Block, node.Width - first), rest = first + width;
      if (LAPACKE_dpotrf_work(LAPACK_COL_MAJOR, 'L', width, node.At(first, first), node.Rows) != 0)
      {
        return false;
      }
      cblas_dtrsm(CblasColMajor, CblasRight, CblasLower, CblasTrans, CblasNonUnit, node.Rows - rest,
        width, 1.0, node.At(first, first), node.Rows, node.At(rest, first), node.Rows);
      this->Completed(width * (width / 3.0 + node.Rows - rest) * width);
      this->ForBlocks(rest, node.Width, node.Rows, width,
        [&](int column, int columns)
        {
          cblas_dgemm(CblasColMajor, CblasNoTrans, CblasTrans, node.Rows - column, columns, width,
            -1.0, node.At(column, first), node.Rows, node.At(column, first), node.Rows, 1.0,
            node.At(column, column), node.Rows);
        });
    }
    return true;
  }

  /// Step 4: lists the supernode for the owner of its first row that is not yet used.
  void Queue(int i)
  {
    const SupernodeView node = this->View(i);
    if (this->Used[i] < node.Rows)
    {
      const int owner = this->Owner[node.RowOf[this->Used[i]]];
      this->Next[i] = this->Head[owner];
      this->Head[owner] = i;
    }
  }

  /// Calls body(first, width) for blocks of [begin, end). The work for each is a product of
  /// (rows - first) x depth with depth x width values.
  template <typename Body>
  void ForBlocks(int begin, int end, int rows, int depth, const Body& body)
  {
    constexpr double worthSharing = 1e7, longest = 1e9; // multiplications
    const double column = static_cast<double>(rows - begin) * depth;
    const int count = end - begin;
    if (column * count < worthSharing)
    {
      if (count > 0)
      {
        body(begin, count);
      }
    }
    else
    {
      const int grain = std::clamp(static_cast<int>(longest / column), 8, Block);
      ParallelFor(
        count, grain, [&](int first, int last) { body(begin + first, last - first); },
        this->Report.Part(this->Share(), this->Share()));
    }
    this->Completed(count * (rows - begin - 0.5 * count) * depth);
  }

  double Share() const { return std::min(1.0, this->Done / this->Total); }

  /// Counts multiplications; reports seldom enough that reports cost nothing.
  void Completed(double operations)
  {
    constexpr double interval = 5e6;
    this->Done += operations;
    if (this->Done - this->Reported > interval)
    {
      this->Reported = this->Done;
      this->Report(this->Share());
    }
  }

  const Eigen::SparseMatrix<double>& A;
  const SupernodalPattern& Pattern;
  double* Values;
  const Progress& Report;
  std::vector<int> RowInFactor; ///< for each row of A
  std::vector<int> Owner;       ///< the supernode of each column
  std::vector<int> Position;    ///< in the current supernode, of each of its rows
  std::vector<int> Head, Next;  ///< lists of the supernodes that contribute to each supernode
  std::vector<int> Used;        ///< for each supernode, the number of rows already used
  double Total = 0.0, Done = 0.0, Reported = 0.0; ///< multiplications
};

} // namespace

bool FactorizeSupernodes(const Eigen::SparseMatrix<double>& a, const SupernodalPattern& pattern,
  double* values, const Progress& progress)
{
  // The loops share out the work themselves: threads of BLAS wait for each other in every product.
  const BlasThreads one(false);
  return SupernodalFactorisation(a, pattern, values, progress).Run();
}

} // namespace shape
