// Facts checked: a row blends as the sums over its samples say, wherever in the blocks of eight it
// begins and whatever other rows hold; samples that do not move blend to exactly that, those that
// all move rigidly to that motion, by any weights.

#include "Deform/Private/BlendedRows.h"
#include "Support/DeformShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace
{

using Eigen::Matrix3d;
using Eigen::Vector3d;

std::vector<float> RandomWeights(int count, std::mt19937& random)
{
  std::uniform_real_distribution<float> uniform(0.0F, 1.0F);
  std::vector<float> weights(count);
  for (float& weight : weights)
  {
    weight = uniform(random);
  }
  return weights;
}

Matrix3d RandomRotation()
{
  return Eigen::Quaterniond::UnitRandom().toRotationMatrix();
}

struct Sample
{
  Vector3d Rest = Vector3d::Random(), Position = Vector3d::Random();
  Matrix3d Rotation = RandomRotation();
};

shape::SampleTransforms MotionsOf(const std::vector<Sample>& samples, int first = 0)
{
  shape::SampleTransforms motions(first + static_cast<int>(samples.size()));
  int number = first;
  for (const Sample& sample : samples)
  {
    motions.Set(number++, sample.Rest, sample.Position, sample.Rotation);
  }
  return motions;
}

shape::BlendedTransform BlendOf(
  int begin, const std::vector<float>& weights, const shape::SampleTransforms& motions)
{
  shape::BlendedRows rows;
  rows.Add(begin, static_cast<int>(weights.size()));
  rows.Allocate();
  rows.Set(0, weights.data());
  return rows.Blend(0, motions);
}

double Difference(const shape::BlendedTransform& a, const shape::BlendedTransform& b)
{
  return (a.Position - b.Position).norm() + (a.Turned - b.Turned).norm() +
    (a.Rotation - b.Rotation).norm();
}

TEST(BlendedRows, ARowIsTheWeightedMeanOfItsSamples)
{
  std::mt19937 random(5);
  const std::vector<Sample> samples(60);
  const shape::SampleTransforms motions = MotionsOf(samples);
  // Within a block, across some, whole ones, up to the last sample.
  const std::vector<std::array<int, 2>> ranges = { { 2, 3 }, { 7, 2 }, { 13, 40 }, { 16, 16 },
    { 0, 60 }, { 59, 1 } };
  shape::BlendedRows rows;
  rows.Add(1, 50); // forgotten
  rows.Allocate();
  rows.Set(0, RandomWeights(50, random).data());
  rows.Clear();
  EXPECT_EQ(rows.Size(), 0U);
  std::vector<std::vector<float>> weights;
  for (const auto& [begin, count] : ranges)
  {
    rows.Add(begin, count);
    weights.push_back(RandomWeights(count, random));
  }
  rows.Allocate();
  for (std::size_t i = ranges.size(); i-- > 0;)
  {
    rows.Set(static_cast<int>(i), weights[i].data());
  }
  const Vector3d point(0.4, -1.2, 0.7);
  for (std::size_t i = 0; i < ranges.size(); ++i)
  {
    Vector3d position = Vector3d::Zero();
    double sum = 0.0;
    for (int j = 0; j < ranges[i][1]; ++j)
    {
      const Sample& sample = samples[ranges[i][0] + j];
      const double weight = weights[i][j];
      position += weight * (sample.Position + 1.7 * (sample.Rotation * (point - sample.Rest)));
      sum += weight;
    }
    const shape::BlendedTransform blend = rows.Blend(static_cast<int>(i), motions);
    EXPECT_LT((blend.Apply(point, 1.7) - position / sum).norm(), 1e-14);
  }
}

TEST(BlendedRows, WhatAllSamplesDoIsTheBlend)
{
  std::mt19937 random(6);
  std::vector<Sample> resting(37), moving(37);
  const Matrix3d turn = shapetest::SomeRotation();
  const Vector3d shift(3, -7, 2), point(0.3, 0.1, -0.9);
  for (std::size_t i = 0; i < resting.size(); ++i)
  {
    resting[i].Position = resting[i].Rest;
    resting[i].Rotation.setIdentity();
    moving[i].Position = turn * moving[i].Rest + shift;
    moving[i].Rotation = turn;
  }
  const shape::SampleTransforms rest = MotionsOf(resting), rigid = MotionsOf(moving);
  for (int begin = 0; begin < 12; ++begin)
  {
    const std::vector<float> weights = RandomWeights(25, random);
    const shape::BlendedTransform still = BlendOf(begin, weights, rest);
    EXPECT_EQ(still.Position, still.Turned);
    EXPECT_EQ(still.Rotation, Matrix3d(Matrix3d::Identity()));
    EXPECT_EQ(still.Apply(point, 1.0), point);
    const shape::BlendedTransform moved = BlendOf(begin, weights, rigid);
    EXPECT_LT((moved.Apply(point, 1.0) - turn * point - shift).norm(), 1e-14);
    EXPECT_LT((moved.Rotation - turn).norm(), 1e-14);
  }
}

TEST(BlendedRows, NumbersAndTheSizeOfWeightsDoNotCount)
{
  std::mt19937 random(7);
  const std::vector<Sample> samples(30);
  const std::vector<float> weights = RandomWeights(30, random);
  const shape::BlendedTransform blend = BlendOf(0, weights, MotionsOf(samples));
  for (const int first : { 1, 5, 8, 19 })
  {
    EXPECT_LT(Difference(BlendOf(first, weights, MotionsOf(samples, first)), blend), 1e-14);
  }
  std::vector<float> larger = weights;
  for (float& weight : larger)
  {
    weight *= 1024.0F;
  }
  EXPECT_EQ(Difference(BlendOf(0, larger, MotionsOf(samples)), blend), 0.0);
  std::vector<float> wider(30, 0.0F); // weights of 0 are as good as none
  std::copy_n(weights.begin(), 11, wider.begin() + 9);
  EXPECT_EQ(Difference(BlendOf(0, wider, MotionsOf(samples)),
              BlendOf(9, { weights.begin(), weights.begin() + 11 }, MotionsOf(samples))),
    0.0);
}

} // namespace
