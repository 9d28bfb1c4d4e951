#include "Cases/FiniteElements.h"

#include "Driver/Cost.h"

#include "Tetrahedra/Private/TetGen.h"

#include <Eigen/CholmodSupport>
#include <Eigen/Geometry>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace benchmark
{

namespace
{

using Sparse = Eigen::SparseMatrix<double>;

/// 10 numbers a tetrahedron would do; with all 16 the loops need no table.
using Stiffness = std::vector<Eigen::Matrix4d>;

Stiffness LocalMatrices(const Eigen::MatrixXd& points, const Eigen::MatrixXi& tetrahedra)
{
  Stiffness local(tetrahedra.rows());
  for (Eigen::Index t = 0; t < tetrahedra.rows(); ++t)
  {
    const Eigen::RowVector3d a = points.row(tetrahedra(t, 0));
    const Eigen::RowVector3d u = points.row(tetrahedra(t, 1)) - a;
    const Eigen::RowVector3d v = points.row(tetrahedra(t, 2)) - a;
    const Eigen::RowVector3d w = points.row(tetrahedra(t, 3)) - a;
    Eigen::Matrix<double, 4, 3> gradients; // times six volumes
    gradients.row(1) = v.cross(w);
    gradients.row(2) = w.cross(u);
    gradients.row(3) = u.cross(v);
    gradients.row(0) = -gradients.bottomRows<3>().colwise().sum();
    const double sixVolumes = std::abs(u.dot(gradients.row(1)));
    local[t] = gradients * gradients.transpose() / (6.0 * sixVolumes);
  }
  return local;
}

/// The lower triangle of the free points' matrix, columns sorted, and the right-hand sides.
struct System
{
  Sparse Matrix;
  Eigen::MatrixXd Right;
};

System Assemble(
  const Eigen::MatrixXd& points, const Eigen::MatrixXi& tetrahedra, const Eigen::MatrixXd& fixed)
{
  const int first = static_cast<int>(fixed.rows()); // the free points follow the fixed ones
  const int count = static_cast<int>(points.rows()) - first;
  const Stiffness local = LocalMatrices(points, tetrahedra);
  std::vector<int> starts(count + 1, 0);
  const auto eachCorner = [&](const auto& visit)
  {
    for (int t = 0; t < tetrahedra.rows(); ++t)
    {
      for (int k = 0; k < 4; ++k)
      {
        if (tetrahedra(t, k) >= first)
        {
          visit(tetrahedra(t, k) - first, 4 * t + k);
        }
      }
    }
  };
  eachCorner([&](int point, int) { ++starts[point + 1]; });
  for (int i = 0; i < count; ++i)
  {
    starts[i + 1] += starts[i];
  }
  std::vector<int> corners(starts[count]), next(starts.begin(), starts.end() - 1);
  eachCorner([&](int point, int corner) { corners[next[point]++] = corner; });

  System system{ Sparse(count, count), Eigen::MatrixXd::Zero(count, fixed.cols()) };
  std::vector<int> rows, sorted;
  std::vector<double> values, sums(count, 0.0);
  std::vector<int> offsets(count + 1, 0);
  rows.reserve(9 * count);
  values.reserve(9 * count);
  for (int j = 0; j < count; ++j)
  {
    sorted.clear();
    for (int c = starts[j]; c < starts[j + 1]; ++c)
    {
      const int t = corners[c] / 4, k = corners[c] % 4;
      for (int l = 0; l < 4; ++l)
      {
        const int i = tetrahedra(t, l) - first;
        const double value = local[t](l, k);
        if (i < 0)
        {
          system.Right.row(j) -= value * fixed.row(i + first);
        }
        else if (i >= j)
        {
          if (sums[i] == 0.0)
          {
            sorted.push_back(i);
          }
          sums[i] += value;
        }
      }
    }
    std::sort(sorted.begin(), sorted.end());
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    for (const int i : sorted)
    {
      rows.push_back(i);
      values.push_back(sums[i]);
      sums[i] = 0.0;
    }
    offsets[j + 1] = static_cast<int>(rows.size());
  }
  system.Matrix = Eigen::Map<const Sparse>(count, count, static_cast<Eigen::Index>(rows.size()),
    offsets.data(), rows.data(), values.data());
  return system;
}

template <class Solver>
Eigen::MatrixXd Solved(Solver& solver, const System& system)
{
  if (system.Matrix.rows() == 0)
  {
    return system.Right;
  }
  solver.compute(system.Matrix);
  Eigen::MatrixXd solution = solver.solve(system.Right);
  if (solver.info() != Eigen::Success)
  {
    throw std::runtime_error("the sparse solver failed");
  }
  return solution;
}

Eigen::MatrixXd Solve(const System& system, const FiniteElementOptions& options)
{
  if (options.Solver == "LLT")
  {
    Eigen::SimplicialLLT<Sparse, Eigen::Lower> solver;
    return Solved(solver, system);
  }
  if (options.Solver == "LDLT")
  {
    Eigen::SimplicialLDLT<Sparse, Eigen::Lower> solver;
    return Solved(solver, system);
  }
  if (options.Solver == "CG")
  {
    Eigen::ConjugateGradient<Sparse, Eigen::Lower, Eigen::IncompleteCholesky<double>> solver;
    solver.setTolerance(1e-8);
    return Solved(solver, system);
  }
  Eigen::CholmodSupernodalLLT<Sparse, Eigen::Lower> solver;
  if (options.Ordering != "Best")
  {
    solver.cholmod().nmethods = 1;
    solver.cholmod().method[0].ordering = options.Ordering == "METIS" ? CHOLMOD_METIS : CHOLMOD_AMD;
  }
  return Solved(solver, system);
}

} // namespace

FiniteElementResult SolveByFiniteElements(
  const shape::Mesh& surface, const Eigen::MatrixXd& values, const FiniteElementOptions& options)
{
  const double start = CpuSeconds();
  const double cell =
    shape::ComputeEnclosedVolume(surface) / (6.0 * static_cast<double>(surface.Points.rows()));
  // The mean tetrahedron has about half the volume of the bound.
  const double bound = options.Refine > 0.0 ? 2.0 * cell / options.Refine : 0.0;
  const Eigen::MatrixXd noHoles(0, 3);
  const shape::TetGenOutput mesh =
    shape::RunTetGen({ surface, noHoles, options.RadiusEdgeRatio, bound, true, -1 });
  FiniteElementResult result;
  result.SecondsOfMesh = CpuSeconds() - start;
  const System system = Assemble(mesh.Points, mesh.Tetrahedra, values);
  const double assembled = CpuSeconds();
  result.Values.resize(mesh.Points.rows(), values.cols());
  result.Values.topRows(values.rows()) = values;
  result.Values.bottomRows(mesh.Points.rows() - values.rows()) = Solve(system, options);
  result.SecondsOfFactor = CpuSeconds() - assembled;
  const Eigen::Index count = mesh.Tetrahedra.rows();
  result.Solid.Points = mesh.Points;
  result.Solid.Kinds = Eigen::VectorXi::Constant(count, 10);
  result.Solid.Offsets = Eigen::VectorXi::LinSpaced(count + 1, 0, static_cast<int>(4 * count));
  result.Solid.Corners.resize(4 * count);
  for (Eigen::Index t = 0; t < count; ++t)
  {
    result.Solid.Corners.segment<4>(4 * t) = mesh.Tetrahedra.row(t).transpose();
  }
  return result;
}

} // namespace benchmark
