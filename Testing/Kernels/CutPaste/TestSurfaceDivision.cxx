// Facts checked: the two parts are the surface, each triangle and each place once; their Euler
// numbers add up, and they meet along the cut alone, in opposite senses; loops that have a side of
// the old border are not cut all around; a seam stays doubled, also at new points, and closes by
// ids; a point where a part hangs together by no edge is doubled if it is on the cut.

#include "CutPaste/SurfaceDivision.h"

#include "CutPaste/LoopSides.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"
#include "Support/DeformShapes.h"
#include "Support/SimpleSurfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <numeric>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace
{

using IsFeature = std::function<bool(const Eigen::RowVector3d&)>;
using Side = std::pair<int, int>;
using Loops = std::vector<std::vector<int>>;

/// A surface, and its division.
struct Divided
{
  /// The triangles whose centroids something holds for.
  Divided(shape::Mesh surface, const IsFeature& isFeature)
    : Surface(std::move(surface))
    , Joined(this->Surface)
  {
    shape::ImprintedCurves split;
    split.Surface = this->Joined.Surface;
    split.Provenance =
      shape::TraceIdentity(split.Surface.Points.rows(), split.Surface.Triangles.rows());
    std::vector<char> flags;
    const Eigen::MatrixXd centres = shape::ComputeCentroids(split.Surface);
    for (const auto& centre : centres.rowwise())
    {
      flags.push_back(isFeature(centre) ? 1 : 0);
    }
    this->Division = std::make_unique<shape::SurfaceDivision>(
      this->Surface, this->Joined, std::move(split), std::move(flags));
  }

  /// What a curve encloses.
  Divided(shape::Mesh surface, const Eigen::MatrixXd& curve)
    : Surface(std::move(surface))
    , Joined(this->Surface)
  {
    const shape::SurfaceLocator locator(this->Joined.Surface);
    shape::SurfacePaths paths(this->Joined.Surface);
    shape::ImprintedCurves split = shape::ImprintCurves(
      this->Joined.Surface, { shape::TraceLoopThrough(curve, locator, paths) }, { 0.0 });
    std::vector<char> flags =
      shape::MarkTrianglesOnSide(split.Surface, split.Loops, shape::LoopSide::Smaller);
    this->Division = std::make_unique<shape::SurfaceDivision>(
      this->Surface, this->Joined, std::move(split), std::move(flags));
  }

  shape::DividedPart Feature() const { return this->Division->PartOf(true); }
  shape::DividedPart Rest() const { return this->Division->PartOf(false); }
  Loops CutLoops(const shape::DividedPart& part) const
  {
    return this->Division->CutLoops(part.Surface, part.Ids);
  }

  shape::Mesh Surface;
  shape::WeldedSurface Joined;
  std::unique_ptr<shape::SurfaceDivision> Division;
};

/// Each triangle with points of its own.
shape::Mesh Soup(const shape::Mesh& mesh)
{
  shape::Mesh soup{ Eigen::MatrixXd(mesh.Triangles.size(), 3), mesh.Triangles };
  for (int corner = 0; corner < static_cast<int>(mesh.Triangles.size()); ++corner)
  {
    soup.Points.row(corner) = mesh.Points.row(mesh.Triangles(corner / 3, corner % 3));
    soup.Triangles(corner / 3, corner % 3) = corner;
  }
  return soup;
}

/// The same surface with points and triangles in another order.
shape::Mesh Shuffled(const shape::Mesh& mesh)
{
  std::mt19937 random(3);
  std::vector<int> points(mesh.Points.rows()), triangles(mesh.Triangles.rows());
  std::iota(points.begin(), points.end(), 0);
  std::iota(triangles.begin(), triangles.end(), 0);
  std::shuffle(points.begin(), points.end(), random);
  std::shuffle(triangles.begin(), triangles.end(), random);
  shape::Mesh shuffled{ Eigen::MatrixXd(mesh.Points.rows(), 3),
    mesh.Triangles(triangles, Eigen::all) };
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    shuffled.Points.row(points[i]) = mesh.Points.row(static_cast<Eigen::Index>(i));
  }
  shuffled.Triangles =
    shuffled.Triangles.unaryExpr([&](int point) { return points[point]; }).eval();
  return shuffled;
}

/// That the parts are those of the surface, point by point and triangle by triangle.
void ExpectParts(const shape::Mesh& mesh, const std::vector<shape::DividedPart>& parts)
{
  Eigen::MatrixXd areas = shape::ComputeAreaVectors(mesh);
  for (const shape::DividedPart& part : parts)
  {
    const Eigen::MatrixXd own = shape::ComputeAreaVectors(part.Surface);
    const shape::Provenance& provenance = part.Provenance;
    ASSERT_EQ(provenance.Cells.size(), own.rows());
    for (Eigen::Index t = 0; t < own.rows(); ++t)
    {
      EXPECT_GE(own.row(t).dot(shape::ComputeAreaVectors(mesh).row(provenance.Cells(t))), 0.0);
      areas.row(provenance.Cells(t)) -= own.row(t);
    }
    // Points of the surface in their order, then the others.
    const Eigen::VectorXi& originals = provenance.Points;
    const auto added = std::find(originals.begin(), originals.end(), -1);
    EXPECT_TRUE(std::is_sorted(originals.begin(), added));
    EXPECT_EQ(std::count(added, originals.end(), -1), originals.end() - added);
    for (Eigen::Index i = 0; i < part.Surface.Points.rows(); ++i)
    {
      const Eigen::RowVector3d position = part.Surface.Points.row(i);
      if (originals[i] >= 0)
      {
        EXPECT_EQ(position, mesh.Points.row(originals[i]));
      }
      const Eigen::RowVector3d found = provenance.Weights.row(i) * mesh.Points;
      EXPECT_LT((found - position).norm(), 1e-15 * (1.0 + position.norm()));
    }
  }
  EXPECT_LT(areas.cwiseAbs().maxCoeff(), 1e-15);
}

/// The sides of loops by ids, begin first.
std::multiset<Side> SidesById(const Loops& loops, const std::vector<int>& ids, bool isTurned)
{
  std::multiset<Side> sides;
  for (const std::vector<int>& loop : loops)
  {
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const int a = ids[loop[i]], b = ids[loop[(i + 1) % loop.size()]];
      if (a != b) // points of a seam
      {
        sides.insert(isTurned ? Side(b, a) : Side(a, b));
      }
    }
  }
  return sides;
}

double LengthOf(const shape::Mesh& mesh, const Loops& loops)
{
  double length = 0.0;
  for (const std::vector<int>& loop : loops)
  {
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      length += (mesh.Points.row(loop[(i + 1) % loop.size()]) - mesh.Points.row(loop[i])).norm();
    }
  }
  return length;
}

TEST(SurfaceDivision, AlongEdges)
{
  const shape::Mesh sphere = shapetest::Icosphere(3);
  const IsFeature isCap = [](const Eigen::RowVector3d& position) { return position(2) > 0.35; };
  const Divided plain(sphere, isCap);
  const double length = plain.Division->CutLength(), area = plain.Division->MeanArea();
  const shape::DividedPart cap = plain.Feature(), other = plain.Rest();
  std::vector<int> shared;
  std::set_intersection(
    cap.Ids.begin(), cap.Ids.end(), other.Ids.begin(), other.Ids.end(), std::back_inserter(shared));
  EXPECT_EQ(shared.size(), plain.CutLoops(cap).at(0).size());
  double sum = 0.0;
  int beside = 0;
  for (const shape::DividedPart& part : { cap, other })
  {
    const std::multiset<Side> sides = SidesById(plain.CutLoops(part), part.Ids, false);
    const Eigen::VectorXd areas = 0.5 * shape::ComputeAreaVectors(part.Surface).rowwise().norm();
    for (int t = 0; t < static_cast<int>(areas.size()); ++t)
    {
      bool isNextTo = false;
      for (int k = 0; k < 3; ++k)
      {
        const int begin = part.Surface.Triangles(t, k);
        const int end = part.Surface.Triangles(t, (k + 1) % 3);
        isNextTo = isNextTo || sides.count({ part.Ids[begin], part.Ids[end] }) > 0;
      }
      beside += isNextTo ? 1 : 0;
      sum += isNextTo ? areas(t) : 0.0;
    }
  }
  EXPECT_NEAR(area, sum / beside, 1e-15);

  for (const shape::Mesh& mesh : { sphere, Soup(sphere), Shuffled(sphere) })
  {
    const Divided divided(mesh, isCap);
    const shape::DividedPart feature = divided.Feature(), rest = divided.Rest();
    ExpectParts(mesh, { feature, rest });
    for (const shape::DividedPart& part : { feature, rest })
    {
      const shape::Topology topology = shape::RequireManifold(shape::MergeSeam(part), "the part");
      EXPECT_EQ(topology.EulerNumber, 1);
      EXPECT_EQ(topology.BoundaryLoops, 1);
      EXPECT_NEAR(LengthOf(part.Surface, divided.CutLoops(part)), length, 1e-13);
    }
    EXPECT_EQ(SidesById(divided.CutLoops(feature), feature.Ids, false),
      SidesById(divided.CutLoops(rest), rest.Ids, true));
    EXPECT_NEAR(divided.Division->CutLength(), length, 1e-13);
    EXPECT_NEAR(divided.Division->MeanArea(), area, 1e-15);
  }

  const Eigen::Matrix3d turn = shapetest::SomeRotation();
  const Eigen::RowVector3d shift(300, -200, 50);
  const Divided moved({ shapetest::Moved(sphere.Points, turn, 1e3, shift), sphere.Triangles },
    [&](const Eigen::RowVector3d& position) { return isCap(1e-3 * (position - shift) * turn); });
  EXPECT_NEAR(moved.Division->CutLength(), 1e3 * length, 1e-10 * length);
  EXPECT_NEAR(moved.Division->MeanArea(), 1e6 * area, 1e-7 * area);
  EXPECT_EQ(moved.Feature().Surface.Triangles, cap.Surface.Triangles);

  const Divided whole(sphere, [](const Eigen::RowVector3d&) { return false; });
  EXPECT_EQ(whole.Division->CutLength(), 0.0);
  EXPECT_EQ(whole.Division->MeanArea(), 0.0);
  EXPECT_EQ(whole.Feature().Surface.Triangles.rows(), 0);
  EXPECT_EQ(whole.Rest().Surface.Triangles, sphere.Triangles);

  // Four pages of a book, in turn of the feature and not: the back, 2 long, is cut once.
  shape::Mesh book{ Eigen::MatrixXd(6, 3), Eigen::MatrixXi(4, 3) };
  book.Points << 0, 0, 0, 0, 0, 2, 1, 1, 0, -1, -1, 0, 1, -1, 0, -1, 1, 0;
  book.Triangles << 0, 1, 2, 0, 1, 4, 0, 1, 3, 0, 1, 5;
  const Divided pages(
    book, [](const Eigen::RowVector3d& position) { return position(0) * position(1) > 0; });
  EXPECT_EQ(pages.Division->CutLength(), 2.0);
}

/// A tube whose points at angle 0 are doubled.
shape::Mesh TubeWithSeam(int around, int along)
{
  const int given = around * (along + 1);
  shape::Mesh tube = shapetest::Tube(around, along, 2.0);
  tube.Points.conservativeResize(given + along + 1, 3);
  for (int i = 0; i <= along; ++i)
  {
    tube.Points.row(given + i) = tube.Points.row(around * i);
  }
  for (Eigen::Index t = 0; t < tube.Triangles.rows(); ++t)
  {
    const bool isLast = t % (2 * around) >= 2 * around - 2;
    for (int& point : tube.Triangles.row(t))
    {
      point = isLast && point % around == 0 ? given + point / around : point;
    }
  }
  return tube;
}

/// That points of a part with one id are two, at one place of the seam of a tube and in a triangle
/// on either side of it. Returns how many pairs of new points there are.
int AddedOnSeam(const shape::Mesh& tube, const shape::DividedPart& part)
{
  std::map<int, std::vector<int>> pointsOf;
  for (int i = 0; i < static_cast<int>(part.Ids.size()); ++i)
  {
    pointsOf[part.Ids[i]].push_back(i);
  }
  int added = 0;
  for (const auto& [id, points] : pointsOf)
  {
    const Eigen::RowVector3d position = part.Surface.Points.row(points[0]);
    const bool isOnSeam = position(0) > 0.0 && position(1) == 0.0;
    EXPECT_EQ(points.size(), isOnSeam ? 2U : 1U);
    if (points.size() == 2)
    {
      EXPECT_EQ(position, part.Surface.Points.row(points[1]));
      const auto side = [&](int point)
      {
        int triangle = 0;
        while ((part.Surface.Triangles.row(triangle).array() != point).all())
        {
          ++triangle;
        }
        return shape::GetCorners(tube, part.Provenance.Cells(triangle)).col(1).sum();
      };
      EXPECT_LT(side(points[0]) * side(points[1]), 0.0);
      added += part.Provenance.Points(points[0]) < 0 ? 1 : 0;
    }
  }
  return added;
}

TEST(SurfaceDivision, AcrossASeam)
{
  const shape::Mesh tube = TubeWithSeam(20, 8);
  Eigen::MatrixXd curve(30, 3);
  for (int i = 0; i < 30; ++i)
  {
    const double turn = 2.0 * M_PI * (i + 0.5) / 30, angle = 0.02 + 0.55 * std::cos(turn);
    curve.row(i) << std::cos(angle), std::sin(angle), 1.03 + 0.6 * std::sin(turn);
  }
  const Divided divided(tube, curve);
  const shape::DividedPart feature = divided.Feature(), rest = divided.Rest();
  ExpectParts(tube, { feature, rest });
  // The curve crosses the seam twice. Closed, one is a disk, the other a tube with a hole.
  EXPECT_EQ(AddedOnSeam(tube, feature), 2);
  EXPECT_EQ(AddedOnSeam(tube, rest), 2);
  EXPECT_EQ(shape::ComputeTopology(feature.Surface).Components, 2);
  EXPECT_EQ(shape::RequireManifold(shape::MergeSeam(feature), "the feature").EulerNumber, 1);
  EXPECT_EQ(shape::ComputeTopology(shape::MergeSeam(feature)).Components, 1);
  EXPECT_EQ(shape::RequireManifold(shape::MergeSeam(rest), "the rest").EulerNumber, -1);
  const double length = divided.Division->CutLength();
  EXPECT_NEAR(LengthOf(feature.Surface, divided.CutLoops(feature)), length, 1e-13);
  EXPECT_NEAR(LengthOf(rest.Surface, divided.CutLoops(rest)), length, 1e-13);
  EXPECT_EQ(SidesById(divided.CutLoops(feature), feature.Ids, false),
    SidesById(divided.CutLoops(rest), rest.Ids, true));
  const shape::Mesh whole = shape::MergeSeam(rest);
  for (Eigen::Index i = 0; i < whole.Triangles.size(); ++i)
  {
    const int id = rest.Ids[rest.Surface.Triangles.reshaped()(i)];
    const auto first = std::find(rest.Ids.begin(), rest.Ids.end(), id);
    EXPECT_EQ(whole.Triangles.reshaped()(i), first - rest.Ids.begin());
  }
  // What is not on the surface has no id, and stays.
  shape::DividedPart loose = feature;
  std::fill(loose.Ids.begin(), loose.Ids.end(), -1);
  EXPECT_EQ(shape::MergeSeam(loose).Triangles, feature.Surface.Triangles);
}

TEST(SurfaceDivision, LoopsWithASideOfTheOldBorderAreNotCut)
{
  const shape::Mesh square = shapetest::FlatSquare(16, 0.0);
  const auto loopsOf = [&](const IsFeature& isFeature)
  {
    const Divided divided(square, isFeature);
    std::array<std::vector<double>, 2> lengths;
    for (const bool isRest : { false, true })
    {
      const shape::DividedPart part = isRest ? divided.Rest() : divided.Feature();
      for (const std::vector<int>& loop : divided.CutLoops(part))
      {
        lengths[isRest ? 1 : 0].push_back(LengthOf(part.Surface, { loop }));
      }
    }
    return lengths;
  };
  const auto within = [](const Eigen::RowVector3d& position, double size)
  { return position.cwiseAbs().maxCoeff() < size; };
  using Lengths = std::array<std::vector<double>, 2>;
  EXPECT_EQ(loopsOf([&](const auto& position) { return position(0) < 0.0; }), Lengths());
  EXPECT_EQ(loopsOf([&](const auto& position) { return within(position, 0.5); }),
    (Lengths{ { { 4.0 }, { 4.0 } } }));
  EXPECT_EQ(loopsOf([&](const auto& position)
              { return within(position, 0.75) && !within(position, 0.25); }),
    (Lengths{ { { 6.0, 2.0 }, { 6.0, 2.0 } } }));
  EXPECT_EQ(loopsOf([&](const auto& position) { return !within(position, 0.75); }),
    (Lengths{ { { 6.0 }, { 6.0 } } }));
}

TEST(SurfaceDivision, PinchesOfTheCutArePartedAndNoOthers)
{
  // Two disks that share their middle; of one, two triangles that meet there alone are cut out.
  const shape::Mesh disk = shapetest::FlatDisk(4);
  const auto points = static_cast<int>(disk.Points.rows());
  shape::Mesh both = shapetest::Twice(disk, { 3, 0, 0 });
  const int last = both.Triangles.bottomRows(disk.Triangles.rows()).maxCoeff();
  const auto isBowTie = [](const Eigen::RowVector3d& position)
  { return position.norm() < 0.2 && position(0) * position(1) > 1e-3; };
  for (const bool isPinched : { false, true })
  {
    if (isPinched) // where nothing is cut
    {
      both.Triangles = (both.Triangles.array() == last).select(points - 1, both.Triangles).eval();
    }
    const Divided divided(both, isBowTie);
    for (shape::DividedPart part : { divided.Feature(), divided.Rest() })
    {
      const bool isRest = part.Surface.Triangles.rows() > 2;
      const int left = isRest && isPinched ? 1 : 0;
      EXPECT_EQ(shape::ComputeTopology(part.Surface).NonManifoldPoints, 1 + left);
      const shape::DividedPart before = part;
      divided.Division->PartPinches(part);
      EXPECT_EQ(shape::ComputeTopology(part.Surface).NonManifoldPoints, left);
      const Eigen::Index copy = before.Surface.Points.rows();
      ASSERT_EQ(part.Surface.Points.rows(), copy + 1);
      EXPECT_EQ(part.Surface.Points.topRows(copy), before.Surface.Points);
      EXPECT_TRUE(part.Surface.Points.row(copy).isZero(0.0));
      EXPECT_EQ(part.Ids.at(copy), 0);
      EXPECT_EQ(part.Provenance.Points(copy), 0);
      EXPECT_EQ(part.Provenance.Weights.row(copy).sum(), 1.0);
      EXPECT_EQ(part.Provenance.Weights.coeff(copy, 0), 1.0);
      EXPECT_EQ(shape::ComputeAreaVectors(part.Surface), shape::ComputeAreaVectors(before.Surface));
    }
  }
  // Triangles with points of their own hang together where their seams are closed.
  const Divided soup(Soup(disk), isBowTie);
  shape::DividedPart own = soup.Rest();
  soup.Division->PartPinches(own);
  EXPECT_EQ(own.Surface.Points.rows(), own.Surface.Triangles.size());
  // So do two beside a seam that ends at the middle.
  shape::Mesh slit = disk;
  slit.Points.conservativeResize(points + 1, 3);
  slit.Points.row(points) = disk.Points.row(1);
  for (Eigen::Index t = 0; t < slit.Triangles.rows(); ++t)
  {
    for (int& point : slit.Triangles.row(t))
    {
      point = point == 1 && shape::GetCorners(disk, t).col(1).sum() < 0.0 ? points : point;
    }
  }
  const Divided beside(slit,
    [](const Eigen::RowVector3d& position) { return position.norm() < 0.2 && position(0) > 0.05; });
  shape::DividedPart pair = beside.Feature();
  EXPECT_EQ(pair.Surface.Points.rows(), 5);
  beside.Division->PartPinches(pair);
  EXPECT_EQ(pair.Surface.Points.rows(), 5);
}

} // namespace
