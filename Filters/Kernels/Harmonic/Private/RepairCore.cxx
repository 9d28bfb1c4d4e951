#include "Harmonic/Private/RepairCore.h"

#include "Base/DisjointSets.h"
#include "Base/Parallel.h"
#include "Geometry/PositiveTetrahedron.h"
#include "Geometry/SelfIntersections.h"
#include "Harmonic/Private/RingCertificate.h"
#include "Harmonic/Private/TetrahedronBox.h"
#include "Mesh/Surface.h"
#include "Search/TriangleBoxes.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <unordered_map>
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

void RepairCore::AddLayer()
{
  this->GrowAround(this->AtCore, 1);
}

bool RepairCore::GrowInverted(int layers)
{
  std::vector<char> marked(this->AtCore.size(), 0);
  bool grows = false;
  for (const CorePart& part : this->Parts)
  {
    if (!part.IsUntangled && !part.Crosses && part.Tetrahedra.size() < this->InCore.size())
    {
      grows = true;
      for (const int point : part.Points)
      {
        marked[point] = 1;
      }
    }
  }
  if (!grows || this->WorkLeft <= LeastWork)
  {
    return false;
  }
  this->GrowAround(std::move(marked), layers);
  return true;
}

/// Adds layers of the tetrahedra that share a point with the marked ones.
void RepairCore::GrowAround(std::vector<char> marked, int layers)
{
  for (int layer = 0; layer < layers; ++layer)
  {
    const std::vector<char> inner = marked;
    for (std::size_t t = 0; t < this->InCore.size(); ++t)
    {
      const Eigen::RowVector4i ids = this->Elements.Tetrahedra.row(static_cast<Eigen::Index>(t));
      if (std::any_of(ids.begin(), ids.end(), [&](int point) { return inner[point] != 0; }))
      {
        this->InCore[t] = 1;
        for (const int point : ids)
        {
          marked[point] = 1;
        }
      }
    }
    if (marked == inner)
    {
      break;
    }
  }
  this->Close();
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

/// Divides the core in parts, in the order of their first tetrahedra. A part with the same
/// tetrahedra as before stays as it is: the images of its boundary are the same, too.
void RepairCore::FindParts()
{
  DisjointSets sets(static_cast<int>(this->AtCore.size()));
  for (const int t : this->CoreTetrahedra)
  {
    for (int k = 1; k < 4; ++k)
    {
      sets.Merge(this->Elements.Tetrahedra(t, 0), this->Elements.Tetrahedra(t, k));
    }
  }
  std::vector<CorePart> parts;
  this->PartOf.assign(this->AtCore.size(), -1);
  for (const int t : this->CoreTetrahedra)
  {
    int& part = this->PartOf[sets.Find(this->Elements.Tetrahedra(t, 0))];
    if (part < 0)
    {
      part = static_cast<int>(parts.size());
      parts.emplace_back();
    }
    parts[part].Tetrahedra.push_back(t);
  }
  for (int point = 0; point < static_cast<int>(this->AtCore.size()); ++point)
  {
    if (this->AtCore[point] != 0)
    {
      this->PartOf[point] = this->PartOf[sets.Find(point)];
      parts[this->PartOf[point]].Points.push_back(point);
    }
  }
  std::unordered_map<int, CorePart*> before; // by the first tetrahedron
  for (CorePart& part : this->Parts)
  {
    before.emplace(part.Tetrahedra.front(), &part);
  }
  for (CorePart& part : parts)
  {
    const auto found = before.find(part.Tetrahedra.front());
    if (found != before.end() && found->second->Tetrahedra == part.Tetrahedra)
    {
      part = std::move(*found->second);
    }
  }
  this->Parts = std::move(parts);
}

/// Returns the points of boundary triangles of the core whose images cross or have no area, unless
/// the images of their points are all prescribed, and the points where the boundary touches itself.
/// Finds the parts, and marks those that cross themselves.
std::vector<int> RepairCore::FindCrossings(const Progress& progress)
{
  const MapRepair repair = this->WholeRepair();
  const std::vector<char> prescribed = this->FindPrescribed();
  const FiniteElements core{ {}, this->Elements.Tetrahedra(this->CoreTetrahedra, Eigen::all) };
  progress(0.0);
  const Surface image(repair.Elements.Images, FindBoundaryTriangles(core));
  progress(0.0);
  std::vector<std::array<int, 2>> pairs;
  for (const int triangle : FindDegenerateTriangles(image))
  {
    pairs.push_back({ triangle, triangle });
  }
  progress(0.0);
  if (pairs.empty())
  {
    for (const Crossing& crossing : FindSelfIntersections(image, progress))
    {
      pairs.push_back({ crossing.First, crossing.Second });
    }
  }
  progress(1.0);
  this->FindParts();
  progress(1.0);
  // Growth removes them, since the solid itself does not touch itself.
  std::vector<int> points = FindPinches(image);
  for (const std::array<int, 2>& pair : pairs)
  {
    const int part = this->PartOf[image.Triangles()(pair[0], 0)];
    if (part == this->PartOf[image.Triangles()(pair[1], 0)])
    {
      this->Parts[part].Crosses = true;
    }
    for (const int triangle : pair)
    {
      const Eigen::RowVector3i corners = image.Triangles().row(triangle);
      if (std::any_of(corners.begin(), corners.end(), [&](int i) { return prescribed[i] == 0; }))
      {
        points.insert(points.end(), corners.begin(), corners.end());
      }
    }
  }
  return points;
}

void RepairCore::GrowUntilBounded(const Progress& progress)
{
  for (double done = 0.0; true;)
  {
    const double next = done + 0.3 * (1.0 - done), middle = 0.5 * (done + next);
    const std::vector<int> failed = this->TestRing(progress.Part(done, middle));
    const Eigen::MatrixXi corners = this->Elements.Tetrahedra(failed, Eigen::all);
    std::vector<int> points(corners.data(), corners.data() + corners.size());
    if (points.empty())
    {
      points = this->FindCrossings(progress.Part(middle, next));
    }
    if (points.empty())
    {
      break;
    }
    done = next;
    std::vector<char> marked(this->AtCore.size(), 0);
    for (const int point : points)
    {
      marked[point] = 1;
    }
    this->GrowAround(std::move(marked), 1);
  }
  progress(1.0);
}

bool RepairCore::UntangleParts(const Progress& progress)
{
  std::vector<CorePart*> tangled;
  double all = 0.0;
  for (CorePart& part : this->Parts)
  {
    if (part.Elements.Tetrahedra.rows() == 0)
    {
      tangled.push_back(&part);
      all += static_cast<double>(part.Points.size());
    }
  }
  // Small ones first, as they need little of the work.
  std::stable_sort(tangled.begin(), tangled.end(),
    [](const CorePart* a, const CorePart* b) { return a->Points.size() < b->Points.size(); });
  const MapRepair repair = this->WholeRepair();
  std::vector<int> positions(this->AtCore.size(), -1);
  double done = 0.0;
  for (CorePart* part : tangled)
  {
    for (std::size_t i = 0; i < part->Points.size(); ++i)
    {
      positions[part->Points[i]] = static_cast<int>(i);
    }
    part->Elements = { this->Elements.Points(part->Points, Eigen::all),
      this->Elements.Tetrahedra(part->Tetrahedra, Eigen::all)
        .unaryExpr([&](int point) { return positions[point]; }),
      repair.Elements.Images(part->Points, Eigen::all), {}, 0 };
    const double next = done + static_cast<double>(part->Points.size()) / all;
    this->WorkLeft -= UntanglePart(*part, 0.5 * this->WorkLeft, progress.Part(done, next));
    done = next;
  }
  progress(1.0);
  return std::all_of(
    this->Parts.begin(), this->Parts.end(), [](const CorePart& part) { return part.IsUntangled; });
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
  // The points of the core, part by part, then those of the ring alone.
  MapRepair& repair = result.Repair;
  std::vector<int> positions(this->AtCore.size(), -1), outer;
  Eigen::Index points = 0, cells = 0;
  for (const CorePart& part : this->Parts)
  {
    for (std::size_t i = 0; i < part.Points.size(); ++i)
    {
      positions[part.Points[i]] = static_cast<int>(points) + static_cast<int>(i);
    }
    points += part.Elements.Points.rows();
    cells += part.Elements.Tetrahedra.rows();
  }
  const auto ring = static_cast<Eigen::Index>(this->RingTetrahedra.size());
  repair.Elements.Tetrahedra.resize(cells + ring, 4);
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
  repair.Elements.Images.resize(points + added, 3);
  Eigen::Index firstPoint = 0, firstCell = 0;
  for (const CorePart& part : this->Parts)
  {
    const FiniteElements& elements = part.Elements;
    const Eigen::Index count = elements.Points.rows(), tetrahedra = elements.Tetrahedra.rows();
    repair.Elements.Points.middleRows(firstPoint, count) = elements.Points;
    repair.Elements.Images.middleRows(firstPoint, count) = elements.Images;
    repair.Elements.Tetrahedra.middleRows(firstCell, tetrahedra) =
      elements.Tetrahedra.array() + static_cast<int>(firstPoint);
    firstPoint += count;
    firstCell += tetrahedra;
  }
  repair.Elements.Points.bottomRows(added) = this->Elements.Points(outer, Eigen::all);
  repair.Elements.Images.bottomRows(added) = this->Values(outer, Eigen::all);
  repair.Shares = Eigen::VectorXd::Ones(points + added);
  repair.Shares.head(points).setZero();

  double inverted = 0.0, core = 0.0;
  for (Eigen::Index t = 0; t < cells; ++t)
  {
    const Eigen::RowVector4i ids = repair.Elements.Tetrahedra.row(t);
    const Corners corners = GetTetrahedron(repair.Elements.Points, ids);
    const double volume =
      std::abs((corners.bottomRows<3>().rowwise() - corners.row(0)).determinant()) / 6.0;
    core += volume;
    if (!IsPositive(repair.Elements.Points, ids) || !IsPositive(repair.Elements.Images, ids))
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
