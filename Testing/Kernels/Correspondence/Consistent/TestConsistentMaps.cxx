#include "Base/Errors.h"
#include "Correspondence/Consistent/ConsistentMaps.h"
#include "Correspondence/Consistent/Private/CandidateChoice.h"
#include "Correspondence/Evaluate/InvertMap.h"
#include "Support/MatchingShapes.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{

constexpr int Size = 12;

Eigen::MatrixXd Orthogonal(unsigned int seed)
{
  std::srand(seed);
  return Eigen::HouseholderQR<Eigen::MatrixXd>(Eigen::MatrixXd::Random(Size, Size)).householderQ();
}

/// The functional maps between frames.
shape::FunctionalMaps MapsOf(const Eigen::MatrixXd& ofA, const Eigen::MatrixXd& ofB)
{
  return shape::WithTranspose(ofB * ofA.transpose());
}

/// Every two of five shapes, with their true map.
struct Network
{
  std::vector<Eigen::MatrixXd> Frames;
  std::vector<shape::CandidatePair> Pairs;
};

Network TrueNetwork()
{
  Network network;
  for (unsigned int i = 0; i < 5; ++i)
  {
    network.Frames.push_back(Orthogonal(i + 1));
  }
  for (int a = 0; a < 5; ++a)
  {
    for (int b = a + 1; b < 5; ++b)
    {
      network.Pairs.push_back({ a, b, { MapsOf(network.Frames[a], network.Frames[b]) }, { 0.1 } });
    }
  }
  return network;
}

/// The map that exchanges two sides: half of the functions of A change their sign.
shape::FunctionalMaps Exchanged(const shape::FunctionalMaps& maps)
{
  Eigen::MatrixXd exchanged = maps.AToB;
  exchanged.rightCols(Size / 2) *= -1.0;
  return shape::WithTranspose(exchanged);
}

} // namespace

TEST(CandidateChoice, TakesTheMapsThatAgreeAroundCycles)
{
  // Three of ten pairs prefer the wrong map by 5 %; the others are certain.
  Network network = TrueNetwork();
  for (std::size_t p = 0; p < network.Pairs.size(); ++p)
  {
    shape::CandidatePair& pair = network.Pairs[p];
    const shape::FunctionalMaps truth = pair.Maps[0], wrong = Exchanged(truth);
    const bool isWrong = p == 0 || p == 5 || p == 9;
    pair.Maps = isWrong ? std::vector{ wrong, truth } : std::vector{ truth, wrong };
    pair.Errors = { 0.1, isWrong ? 0.105 : 0.15 };
  }
  const shape::CandidateChoice choice = shape::ChooseCandidates(5, network.Pairs, Size);
  for (std::size_t p = 0; p < network.Pairs.size(); ++p)
  {
    EXPECT_EQ(choice.Chosen[p], p == 0 || p == 5 || p == 9 ? 1 : 0) << p;
  }
  EXPECT_LT(choice.Disagreements.maxCoeff(), 1e-9);
}

TEST(CandidateChoice, TellsAPairThatContradictsAllOthers)
{
  Network network = TrueNetwork();
  network.Pairs[4].Maps[0] = Exchanged(network.Pairs[4].Maps[0]);
  const shape::CandidateChoice choice = shape::ChooseCandidates(5, network.Pairs, Size);
  for (Eigen::Index p = 0; p < choice.Disagreements.size(); ++p)
  {
    EXPECT_NEAR(choice.Disagreements(p), p == 4 ? std::sqrt(2.0) : 0.0, 1e-9) << p;
  }
  EXPECT_GT(choice.Disagreements(4), shape::LargestDisagreement);
  EXPECT_EQ(std::count(choice.Tree.begin(), choice.Tree.end(), 4), 0);
  // Without its weight, the others have frames that agree.
  std::vector<shape::FunctionalMaps> maps;
  for (const shape::CandidatePair& pair : network.Pairs)
  {
    maps.push_back(pair.Maps[0]);
  }
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(10);
  weights(4) = 0.0;
  const std::vector<Eigen::MatrixXd> frames =
    shape::AverageFrames(5, network.Pairs, maps, weights, choice.Tree);
  for (int i = 1; i < 5; ++i)
  {
    EXPECT_LT(
      (frames[i] * frames[0].transpose() - network.Frames[i] * network.Frames[0].transpose())
        .norm(),
      1e-9);
  }
}

TEST(CandidateChoice, RefusesShapesThatNoPairConnects)
{
  Network network = TrueNetwork();
  for (shape::CandidatePair& pair : network.Pairs)
  {
    if (pair.B == 4)
    {
      pair.Maps.clear();
      pair.Errors.clear();
    }
  }
  EXPECT_THROW(shape::ChooseCandidates(5, network.Pairs, Size), shape::InvalidInput);
}

TEST(InvertMap, IsExactForRenumberedPoints)
{
  const shape::Mesh mesh = shapetest::BumpySphere(2, Eigen::Matrix3d::Identity());
  const shapetest::Renumbered other = shapetest::Renumber(mesh, 5);
  const shape::SurfacePoints onto = shape::MakeSurfacePointsAtVertices(other.NewOf, other.Mesh);
  const shape::SurfacePoints back = shape::InvertMap(mesh, onto, other.Mesh);
  const Eigen::MatrixXd positions = shape::PullBack(back, mesh.Triangles, mesh.Points);
  EXPECT_LT((positions(other.NewOf, Eigen::all) - mesh.Points).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(InvertMap, IsExactInsideTriangles)
{
  // Images of corners are corners of the same triangle, so those between are, too.
  const shape::Mesh mesh = shapetest::Icosphere(1);
  const shape::Surface target(mesh);
  const shape::Mesh turned{ mesh.Points * shapetest::Rotation(0.4, { 1, 2, 3 }).transpose(),
    mesh.Triangles };
  const shape::SurfacePoints same = shape::MakeSurfacePointsAtVertices(
    Eigen::VectorXi::LinSpaced(mesh.Points.rows(), 0, static_cast<int>(mesh.Points.rows()) - 1),
    mesh);
  const shape::MapInverse inverse(turned, same, target);
  shape::SurfacePoints inside{ Eigen::VectorXi::LinSpaced(
                                 mesh.Triangles.rows(), 0, mesh.Triangles.rows() - 1),
    Eigen::RowVector3d(0.5, 0.3, 0.2).replicate(mesh.Triangles.rows(), 1) };
  const shape::SurfacePoints found = inverse.Find(inside);
  EXPECT_EQ(found.Triangles, inside.Triangles);
  EXPECT_LT((found.Barycentrics - inside.Barycentrics).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(InvertMap, StaysOnTheSheetWhereTwoAreClose)
{
  // Two spheres with a gap of 0.02, the inner one turned over. The chords of the coarse outer one
  // are up to 0.06 below the sphere, beyond the inner one.
  const auto shells = [](int level)
  {
    const shape::Mesh outer = shapetest::Icosphere(level), inner = shapetest::Icosphere(4);
    shape::Mesh both{ Eigen::MatrixXd(outer.Points.rows() + inner.Points.rows(), 3),
      Eigen::MatrixXi(outer.Triangles.rows() + inner.Triangles.rows(), 3) };
    both.Points << outer.Points, 0.98 * inner.Points;
    both.Triangles << outer.Triangles,
      inner.Triangles.rowwise().reverse().array() + static_cast<int>(outer.Points.rows());
    return both;
  };
  const shape::Surface coarse(shells(1)), fine(shells(4));
  const Eigen::Index few = shapetest::Icosphere(1).Points.rows(),
                     many = shapetest::Icosphere(4).Points.rows();
  Eigen::VectorXi images(coarse.Points().rows());
  for (Eigen::Index i = 0; i < images.size(); ++i)
  {
    Eigen::Index nearest = 0;
    (fine.Points().rowwise() - coarse.Points().row(i)).rowwise().squaredNorm().minCoeff(&nearest);
    images(i) = static_cast<int>(nearest);
  }
  const shape::SurfacePoints back =
    shape::InvertMap(coarse, shape::MakeSurfacePointsAtVertices(images, fine), fine);
  int wrong = 0;
  for (Eigen::Index i = 0; i < fine.Points().rows(); ++i)
  {
    const bool isOuter = coarse.Triangles()(back.Triangles(i), 0) < few;
    wrong += isOuter == (i < many) ? 0 : 1;
  }
  EXPECT_EQ(wrong, 0);
}

TEST(ConsistentMaps, RecoverTheTruthOfStretchedRenumberedCopies)
{
  const shape::Mesh mesh = shapetest::BumpySphere(3, Eigen::Matrix3d::Identity());
  std::vector<shape::Surface> shapes;
  std::vector<Eigen::VectorXi> numbers;
  for (int i = 0; i < 4; ++i)
  {
    // Nearly isometric copies: stretched by up to 6 %, turned and renumbered.
    const Eigen::Matrix3d turn = shapetest::Rotation(0.7 * i, { 1, 2, 3 });
    const Eigen::MatrixXd points =
      mesh.Points * Eigen::Vector3d(1.0 + 0.02 * i, 1.0, 1.0).asDiagonal() * turn.transpose();
    const shapetest::Renumbered copy =
      shapetest::Renumber({ points, mesh.Triangles }, 10 + static_cast<unsigned int>(i));
    shapes.emplace_back(copy.Mesh);
    numbers.push_back(copy.NewOf);
  }
  const shape::ConsistentMaps maps = shape::ComputeConsistentMaps(shapes, nullptr);
  ASSERT_GE(maps.Template, 0);
  EXPECT_EQ(maps.Pairs.size(), 6U);
  EXPECT_EQ(maps.Triples, 4);
  EXPECT_LE(maps.CycleError, maps.PairwiseCycleError / 3.0);
  const shape::Surface& base = shapes[maps.Template];
  const double length = std::sqrt(shape::ComputePointAreas(base).sum());
  for (int i = 0; i < 4; ++i)
  {
    const Eigen::MatrixXd images =
      shape::PullBack(maps.Maps[i].AToB, base.Triangles(), base.Points())(numbers[i], Eigen::all);
    const Eigen::MatrixXd truth = base.Points()(numbers[maps.Template], Eigen::all);
    EXPECT_LT((images - truth).rowwise().norm().mean(), 0.03 * length) << i;
  }
}

TEST(ConsistentMaps, FollowLandmarks)
{
  // An ellipsoid has four maps onto itself that keep orientation. The landmarks of the second shape
  // are turned by half a turn, and so is its map.
  shape::Mesh mesh = shapetest::Icosphere(3);
  mesh.Points = mesh.Points * Eigen::Vector3d(3.0, 2.0, 1.0).asDiagonal();
  const Eigen::Vector3d turn(-1.0, -1.0, 1.0);
  const auto nearestTo = [&](const Eigen::RowVector3d& position)
  {
    Eigen::Index nearest = 0;
    (mesh.Points.rowwise() - position).rowwise().squaredNorm().minCoeff(&nearest);
    return static_cast<int>(nearest);
  };
  std::vector<shape::Surface> shapes;
  std::vector<Eigen::VectorXi> numbers;
  shape::ConsistentMapsOptions options;
  for (unsigned int i = 0; i < 3; ++i)
  {
    const shapetest::Renumbered copy = shapetest::Renumber(mesh, 20 + i);
    shapes.emplace_back(copy.Mesh);
    numbers.push_back(copy.NewOf);
    options.Numbered.emplace_back();
    for (int axis = 0; axis < 3; ++axis)
    {
      for (const double sign : { -1.0, 1.0 })
      {
        const double end = (i == 1 ? turn(axis) : 1.0) * sign * (3.0 - axis);
        options.Numbered[i][2 * axis + (sign > 0.0 ? 1 : 0)] =
          copy.NewOf(nearestTo(end * Eigen::RowVector3d::Unit(axis)));
      }
    }
  }
  using Type = shape::ConsistentMapsOptions;
  const double length = std::sqrt(shape::ComputeArea(shapes[0]));
  for (const auto consistency : { Type::ConsistencyType::LimitShape, Type::ConsistencyType::None })
  {
    for (const auto method :
      { Type::MethodType::FunctionalMap, Type::MethodType::ReversibleHarmonic })
    {
      options.Consistency = consistency;
      options.Method = method;
      const shape::ConsistentMaps maps = shape::ComputeConsistentMaps(shapes, nullptr, options);
      const shape::Surface& base = shapes[maps.Template];
      for (int i = 0; i < 3; ++i)
      {
        const Eigen::MatrixXd images =
          shape::PullBack(maps.Maps[i].AToB, base.Triangles(), base.Points());
        const bool isTurned = (i == 1) != (maps.Template == 1);
        const Eigen::MatrixXd truth =
          isTurned ? Eigen::MatrixXd(mesh.Points * turn.asDiagonal()) : mesh.Points;
        EXPECT_LT((images(numbers[i], Eigen::all) - truth).rowwise().norm().mean(), 0.03 * length)
          << i;
        if (consistency == Type::ConsistencyType::LimitShape)
        {
          for (const auto& [number, point] : options.Numbered[i])
          {
            const int partner = options.Numbered[maps.Template].at(number);
            EXPECT_LT((images.row(point) - base.Points().row(partner)).norm(), 1e-9 * length);
          }
        }
      }
    }
  }
  options.Numbered.pop_back();
  EXPECT_THROW(shape::ComputeConsistentMaps(shapes, nullptr, options), shape::InvalidInput);
  options.Numbered.push_back({ { 1, 100000 } });
  EXPECT_THROW(shape::ComputeConsistentMaps(shapes, nullptr, options), shape::InvalidInput);
}

TEST(ConsistentMaps, RefuseASingleSurfaceAndOptionsOutOfRange)
{
  const shape::Surface one(shapetest::Icosphere(2));
  EXPECT_THROW(shape::ComputeConsistentMaps({ one }, nullptr), shape::InvalidInput);
  shape::ConsistentMapsOptions options;
  options.Neighbours = 1;
  EXPECT_THROW(shape::ComputeConsistentMaps({ one, one }, nullptr, options), shape::InvalidInput);
}
