#include "Harmonic/Private/RepairCore.h"

#include "Base/Parallel.h"
#include "Geometry/Orientation.h"
#include "Geometry/SelfIntersections.h"
#include "Harmonic/Private/RingCertificate.h"
#include "Harmonic/Private/TetrahedronBox.h"
#include "Mesh/Surface.h"
#include "Search/TriangleBoxes.h"
#include "Untangle/Untangle.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace shape
{
namespace
{

/// Boxes are enlarged by this share of their edge, more than rounding.
constexpr double BoxMargin = 1e-9;

using Corners = Eigen::Matrix<double, 4, 3>;

Corners GetTetrahedron(const Eigen::MatrixXd& points, const Eigen::RowVector4i& ids)
{
  return points(ids, Eigen::all);
}

bool IsPositive(const Eigen::MatrixXd& points, const Eigen::RowVector4i& ids)
{
  return EvaluateOrientation(
           points.row(ids(0)), points.row(ids(1)), points.row(ids(2)), points.row(ids(3))) > 0;
}

/// Returns the tetrahedra whose images are inverted or have no volume.
std::vector<int> FindInverted(const FiniteElements& elements)
{
  std::vector<int> found;
  for (int t = 0; t < static_cast<int>(elements.Tetrahedra.rows()); ++t)
  {
    if (!IsPositive(elements.Images, elements.Tetrahedra.row(t)))
    {
      found.push_back(t);
    }
  }
  return found;
}

/// Returns the points at the boundary or more than some layers away from some tetrahedra.
std::vector<int> FindFixed(const FiniteElements& elements, const std::vector<int>& tetrahedra)
{
  constexpr int layers = 3;
  std::vector<char> near(elements.Points.rows(), 0);
  for (const int point : elements.Tetrahedra(tetrahedra, Eigen::all).reshaped())
  {
    near[point] = 1;
  }
  for (int layer = 0; layer < layers; ++layer)
  {
    const std::vector<char> inner = near;
    for (Eigen::Index t = 0; t < elements.Tetrahedra.rows(); ++t)
    {
      const Eigen::RowVector4i ids = elements.Tetrahedra.row(t);
      const bool touches =
        std::any_of(ids.begin(), ids.end(), [&](int i) { return inner[i] != 0; });
      for (const int point : ids)
      {
        near[point] |= static_cast<char>(touches);
      }
    }
  }
  const Eigen::MatrixXi faces = FindBoundaryTriangles(elements);
  for (const int point : faces.reshaped())
  {
    near[point] = 0;
  }
  std::vector<int> fixed;
  for (std::size_t i = 0; i < near.size(); ++i)
  {
    if (near[i] == 0)
    {
      fixed.push_back(static_cast<int>(i));
    }
  }
  return fixed;
}

/// The visitor with which Eigen's tree search finds whether a tetrahedron meets a box.
struct MeetsABox
{
  const std::vector<Eigen::AlignedBox3d>& Boxes;
  Corners Tetrahedron;
  Eigen::AlignedBox3d Around = {};
  bool Found = false;

  // Eigen's search calls these two by their names. NOLINTBEGIN(readability-identifier-naming)
  bool intersectVolume(const Eigen::AlignedBox3d& box) const
  {
    return this->Around.intersects(box);
  }
  bool intersectObject(int box)
  {
    this->Found = MayMeet(this->Tetrahedron, this->Boxes[box]);
    return this->Found;
  }
  // NOLINTEND(readability-identifier-naming)
};

} // namespace

RepairCore::RepairCore(const ChargeSet& map, FiniteElements elements, const Progress& progress)
  : Map(map)
  , Elements(std::move(elements))
  , Values(Evaluate(map, this->Elements.Points, progress))
  , InCore(this->Elements.Tetrahedra.rows(), 0)
  , AtSurface(this->Elements.Points.rows(), 0)
  , Certified(this->Elements.Tetrahedra.rows(), 0)
{
  for (const int point : this->Elements.Boundary.reshaped())
  {
    this->AtSurface[point] = 1;
  }
}

void RepairCore::AddFolds(const MapCertificate& certificate, const Progress& progress)
{
  std::vector<Eigen::AlignedBox3d> boxes;
  std::vector<int> ids;
  for (Eigen::Index i = 0; i < certificate.States.size(); ++i)
  {
    if (certificate.States(i) != static_cast<int>(MapCertificate::BoxState::Certified))
    {
      const Eigen::Vector3d centre = certificate.Centres.row(i).transpose();
      const Eigen::Vector3d half =
        Eigen::Vector3d::Constant((0.5 + BoxMargin) * certificate.Edges(i));
      ids.push_back(static_cast<int>(boxes.size()));
      boxes.emplace_back(centre - half, centre + half);
    }
  }
  BoxTree tree;
  tree.init(ids.begin(), ids.end(), boxes.begin(), boxes.end());
  ParallelFor(
    static_cast<int>(this->InCore.size()), 1000,
    [&](int begin, int end)
    {
      for (int t = begin; t < end; ++t)
      {
        MeetsABox meets{ boxes,
          GetTetrahedron(this->Elements.Points, this->Elements.Tetrahedra.row(t)) };
        for (int k = 0; k < 4; ++k)
        {
          meets.Around.extend(meets.Tetrahedron.row(k).transpose());
        }
        Eigen::BVIntersect(tree, meets);
        this->InCore[t] = static_cast<char>(meets.Found);
      }
    },
    progress);
  this->Close();
}

void RepairCore::Grow(int layers)
{
  for (int layer = 0; layer < layers && !this->IsWhole(); ++layer)
  {
    for (const int t : this->RingTetrahedra)
    {
      this->InCore[t] = 1;
    }
    this->Close();
  }
}

/// Finds the points of the core, adds the tetrahedra that have no other points, and finds the ring.
void RepairCore::Close()
{
  this->AtCore.assign(this->Elements.Points.rows(), 0);
  const auto count = static_cast<int>(this->InCore.size());
  for (int t = 0; t < count; ++t)
  {
    for (int k = 0; k < 4 && this->InCore[t] != 0; ++k)
    {
      this->AtCore[this->Elements.Tetrahedra(t, k)] = 1;
    }
  }
  this->CoreTetrahedra.clear();
  this->RingTetrahedra.clear();
  for (int t = 0; t < count; ++t)
  {
    int touching = 0;
    for (const int point : this->Elements.Tetrahedra.row(t))
    {
      touching += this->AtCore[point];
    }
    this->InCore[t] = static_cast<char>(touching == 4);
    if (touching > 0)
    {
      (touching == 4 ? this->CoreTetrahedra : this->RingTetrahedra).push_back(t);
    }
  }
}

/// Returns for each point whether it has its prescribed image. The points of the ring have their
/// images by f, also on the boundary.
std::vector<char> RepairCore::FindPrescribed() const
{
  std::vector<char> prescribed(this->AtSurface);
  for (const int point : this->Elements.Tetrahedra(this->RingTetrahedra, Eigen::all).reshaped())
  {
    prescribed[point] = 0;
  }
  return prescribed;
}

/// Returns the repair before untangling, with the tetrahedra and points of the whole solid.
MapRepair RepairCore::WholeRepair() const
{
  MapRepair repair{ this->Elements, Eigen::VectorXd::Ones(this->Elements.Points.rows()) };
  const std::vector<char> prescribed = this->FindPrescribed();
  for (Eigen::Index i = 0; i < repair.Shares.size(); ++i)
  {
    if (this->AtCore[i] != 0)
    {
      repair.Shares(i) = 0.0;
    }
    if (prescribed[i] == 0)
    {
      repair.Elements.Images.row(i) = this->Values.row(i);
    }
  }
  return repair;
}

/// Returns the tetrahedra of the ring that are not certified.
std::vector<int> RepairCore::TestRing(const Progress& progress)
{
  std::vector<int> tested;
  for (const int t : this->RingTetrahedra)
  {
    char corners = 0;
    for (int k = 0; k < 4; ++k)
    {
      corners |= static_cast<char>(this->AtCore[this->Elements.Tetrahedra(t, k)] << k);
    }
    if (this->Certified[t] != corners)
    {
      this->Certified[t] = corners;
      tested.push_back(t);
    }
  }
  std::vector<int> failed = FindUncertified(this->Map, this->WholeRepair(), tested, progress);
  for (const int t : failed)
  {
    this->Certified[t] = 0;
  }
  return failed;
}

/// Returns the points of boundary triangles of the core whose images cross or have no area, unless
/// the images of their points are all prescribed.
std::vector<int> RepairCore::FindCrossings()
{
  const MapRepair repair = this->WholeRepair();
  const std::vector<char> prescribed = this->FindPrescribed();
  const FiniteElements core{ {}, this->Elements.Tetrahedra(this->CoreTetrahedra, Eigen::all) };
  const Surface image(repair.Elements.Images, FindBoundaryTriangles(core));
  std::vector<int> triangles = FindDegenerateTriangles(image);
  if (triangles.empty())
  {
    for (const Crossing& crossing : FindSelfIntersections(image))
    {
      triangles.insert(triangles.end(), { crossing.First, crossing.Second });
    }
  }
  this->HasCrossing = !triangles.empty();
  std::vector<int> points;
  for (const int triangle : triangles)
  {
    const Eigen::RowVector3i corners = image.Triangles().row(triangle);
    if (std::any_of(corners.begin(), corners.end(), [&](int i) { return prescribed[i] == 0; }))
    {
      points.insert(points.end(), corners.begin(), corners.end());
    }
  }
  return points;
}

void RepairCore::GrowUntilBounded(const Progress& progress)
{
  for (double done = 0.0; true;)
  {
    const double next = done + 0.3 * (1.0 - done);
    const std::vector<int> failed = this->TestRing(progress.Part(done, next));
    done = next;
    const Eigen::MatrixXi corners = this->Elements.Tetrahedra(failed, Eigen::all);
    std::vector<int> points(corners.data(), corners.data() + corners.size());
    if (points.empty())
    {
      points = this->FindCrossings();
    }
    if (points.empty())
    {
      break;
    }
    std::vector<char> touched(this->AtCore.size(), 0);
    for (const int point : points)
    {
      touched[point] = 1;
    }
    for (std::size_t t = 0; t < this->InCore.size(); ++t)
    {
      for (const int point : this->Elements.Tetrahedra.row(static_cast<Eigen::Index>(t)))
      {
        this->InCore[t] |= touched[point];
      }
    }
    this->Close();
  }
  progress(1.0);
}

bool RepairCore::UntangleCore(const Progress& progress)
{
  const MapRepair repair = this->WholeRepair();
  std::vector<int> positions(this->AtCore.size(), -1);
  this->CorePoints.clear();
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    if (this->AtCore[i] != 0)
    {
      positions[i] = static_cast<int>(this->CorePoints.size());
      this->CorePoints.push_back(static_cast<int>(i));
    }
  }
  const auto count = static_cast<int>(this->CoreTetrahedra.size());
  const Eigen::MatrixXi tetrahedra = this->Elements.Tetrahedra(this->CoreTetrahedra, Eigen::all)
                                       .unaryExpr([&](int point) { return positions[point]; });
  this->Core = { this->Elements.Points(this->CorePoints, Eigen::all), tetrahedra,
    repair.Elements.Images(this->CorePoints, Eigen::all), {}, 0 };
  double volume = 0.0;
  for (int t = 0; t < count; ++t)
  {
    const Corners image = GetTetrahedron(this->Core.Images, tetrahedra.row(t));
    volume += (image.bottomRows<3>().rowwise() - image.row(0)).determinant();
  }
  const std::vector<int> inverted = FindInverted(this->Core);
  // A core whose image has no positive volume cannot be untangled.
  if (inverted.empty() || !(volume > 0.0))
  {
    return inverted.empty();
  }
  // Where the image is thinner than the error of f, a harmonic map between the points around may
  // be much nearer to a map without folds. If many tetrahedra stay inverted, they hold each other.
  constexpr std::size_t few = 30;
  FiniteElements harmonic = this->Core;
  SolveLaplace(harmonic, FindFixed(harmonic, inverted), progress.Part(0.0, 0.2));
  if (FindInverted(harmonic).size() < std::min(few, inverted.size()))
  {
    this->Core.Images = harmonic.Images;
  }
  const Eigen::MatrixXi byCell = tetrahedra.transpose();
  UntangleOptions options;
  options.SplitCells = !this->HasCrossing; // splitting takes long, and cannot help
  UntangleResult result =
    Untangle({ this->Core.Images, Eigen::VectorXi::Constant(count, cell_kind::Tetrahedron),
               Eigen::VectorXi::LinSpaced(count + 1, 0, 4 * count), byCell.reshaped() },
      this->Core.Points, options, progress.Part(0.2, 1.0));
  // New points divide tetrahedra in the solid as in the image.
  this->Core.Points = result.Provenance.Weights * this->Core.Points;
  this->Core.Images = result.Solid.Points;
  this->Core.Tetrahedra = result.Solid.Corners.reshaped(4, result.Inverted.size()).transpose();
  return result.InvertedAfter == 0;
}

double RepairCore::VolumeOf(const std::vector<int>& tetrahedra) const
{
  double volume = 0.0;
  for (const int t : tetrahedra)
  {
    const Corners corners = GetTetrahedron(this->Elements.Points, this->Elements.Tetrahedra.row(t));
    volume += (corners.bottomRows<3>().rowwise() - corners.row(0)).determinant() / 6.0;
  }
  return volume;
}

RepairShares RepairCore::Finish() const
{
  RepairShares result;
  // The points of the core, then those of the ring alone.
  MapRepair& repair = result.Repair;
  std::vector<int> positions(this->AtCore.size(), -1), outer;
  for (std::size_t i = 0; i < this->CorePoints.size(); ++i)
  {
    positions[this->CorePoints[i]] = static_cast<int>(i);
  }
  const Eigen::Index points = this->Core.Points.rows(), cells = this->Core.Tetrahedra.rows();
  const auto ring = static_cast<Eigen::Index>(this->RingTetrahedra.size());
  repair.Elements.Tetrahedra.resize(cells + ring, 4);
  repair.Elements.Tetrahedra.topRows(cells) = this->Core.Tetrahedra;
  for (Eigen::Index t = 0; t < ring; ++t)
  {
    for (int k = 0; k < 4; ++k)
    {
      const int point = this->Elements.Tetrahedra(this->RingTetrahedra[t], k);
      if (positions[point] < 0)
      {
        positions[point] = static_cast<int>(points) + static_cast<int>(outer.size());
        outer.push_back(point);
      }
      repair.Elements.Tetrahedra(cells + t, k) = positions[point];
    }
  }
  const auto added = static_cast<Eigen::Index>(outer.size());
  repair.Elements.Points.resize(points + added, 3);
  repair.Elements.Points << this->Core.Points, this->Elements.Points(outer, Eigen::all);
  repair.Elements.Images.resize(points + added, 3);
  repair.Elements.Images << this->Core.Images, this->Values(outer, Eigen::all);
  repair.Shares = Eigen::VectorXd::Ones(points + added);
  repair.Shares.head(points).setZero();

  double inverted = 0.0, core = 0.0;
  for (Eigen::Index t = 0; t < cells; ++t)
  {
    const Eigen::RowVector4i ids = this->Core.Tetrahedra.row(t);
    const Corners corners = GetTetrahedron(this->Core.Points, ids);
    const double volume =
      std::abs((corners.bottomRows<3>().rowwise() - corners.row(0)).determinant()) / 6.0;
    core += volume;
    if (!IsPositive(this->Core.Points, ids) || !IsPositive(this->Core.Images, ids))
    {
      inverted += volume;
    }
  }
  std::vector<int> all(this->InCore.size());
  std::iota(all.begin(), all.end(), 0);
  const double total = this->VolumeOf(all);
  result.CoreShare = core / total;
  result.RingShare = this->VolumeOf(this->RingTetrahedra) / total;
  result.InvertedShare = inverted / total;
  return result;
}

} // namespace shape
