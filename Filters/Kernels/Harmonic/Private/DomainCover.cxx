#include "Harmonic/Private/DomainCover.h"

#include "Base/Parallel.h"
#include "Harmonic/Private/DeterminantSign.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

namespace shape
{

namespace
{

using BoxState = MapCertificate::BoxState;

/// A near charge at most this many radii away has a polynomial of this degree. The polynomials of
/// near charges are used for one box only.
struct NearClass
{
  double Radii;
  int Degree;
};
constexpr std::array<NearClass, 3> NearClasses = { NearClass{ 2.8, TaylorExpansion::Degree },
  NearClass{ 5.5, 6 },
  NearClass{ std::numeric_limits<double>::infinity(), TaylorExpansion::LowDegree } };
/// A box with a charge nearer than this many radii is divided at once.
constexpr double NearestRadii = 1.5;
/// A box with a witness is not divided if its edge is at most this share of the domain's longest
/// side: the boundary of a fold, where no box can be decided, would need most of the boxes.
constexpr double WitnessEdge = 1.0 / 256.0;
/// Boxes with a negative estimate wait as if they had this share of their volume.
constexpr double FoldedPriority = 1.0 / 8.0;
/// Subdivisions of the root whose centres are exact numbers.
constexpr int MaximumLevel = 19;

/// Half the edges of a box around its centre, enlarged by rounding.
Eigen::Vector3d HalfEdges(const Eigen::AlignedBox3d& box, const Eigen::Vector3d& centre)
{
  return (1.0 + 1e-12) * (box.max() - centre).cwiseMax(centre - box.min());
}

} // namespace

DomainCover::DomainCover(
  const ChargeSet& map, const Surface& domain, const MapCertificateOptions& options)
  : Options(options)
{
  // Lengths are multiplied by a power of two, and all centres are multiples of 2^-20: both are
  // exact. The root reaches one unit to each side of its centre. The centre is an odd multiple,
  // so that faces of boxes do not contain points with simple coordinates.
  const Eigen::RowVector3d low = domain.Points().colwise().minCoeff();
  const Eigen::RowVector3d high = domain.Points().colwise().maxCoeff();
  const double longest = (high - low).maxCoeff();
  this->Scale = std::exp2(-std::ceil(std::log2(0.55 * longest)));
  this->SmallestEdge = options.Tolerance * longest * this->Scale;
  this->LargestWitness = std::max(WitnessEdge, options.Tolerance) * longest * this->Scale;
  this->Charges.resize(6, map.Points.rows());
  this->Charges.topRows<3>() = this->Scale * map.Points.transpose();
  this->Charges.bottomRows<3>() =
    this->Scale * this->Scale * 0.25 * M_1_PI * map.Charges.transpose();
  this->Linear = map.Affine.leftCols<3>();
  this->Domain = domain.WithPoints(this->Scale * domain.Points());
  this->Inside = std::make_unique<SignedDistance>(this->Domain);

  constexpr double unit = 1.0 / (1 << 20);
  const Eigen::Vector3d middle = 0.5 * this->Scale * (low + high).transpose() / (2.0 * unit);
  CoverBox root;
  root.Place = {
    2.0 * unit * middle.array().round() + unit * Eigen::Array3d(12345.0, 23457.0, 34569.0), 1.0
  };
  this->Boxes.push_back(root);
  auto field = std::make_shared<ChargeField>();
  field->Centre = root.Place.Centre;
  field->Far.Coefficients.middleRows<3>(1) = this->Linear.transpose();
  field->Near.resize(map.Points.rows());
  std::iota(field->Near.begin(), field->Near.end(), 0);
  std::vector<int> triangles(domain.Triangles().rows());
  std::iota(triangles.begin(), triangles.end(), 0);
  const Eigen::AlignedBox3d region(this->Scale * low.transpose(), this->Scale * high.transpose());
  this->Open.push_back({ 0, field, std::move(triangles), region, region.volume() });
}

bool DomainCover::Expand(const ChargeField& field, const Eigen::Vector3d& centre, double radius,
  TaylorExpansion& expansion) const
{
  std::array<std::vector<int>, NearClasses.size()> classes;
  for (const int i : field.Near)
  {
    const double radii = (this->Charges.col(i).head<3>() - centre).norm() / radius;
    if (radii < NearestRadii)
    {
      return false;
    }
    std::size_t place = 0;
    while (radii > NearClasses[place].Radii)
    {
      ++place;
    }
    classes[place].push_back(i);
  }
  expansion = field.Far.GetLowTerms(centre - field.Centre);
  for (std::size_t i = 0; i < classes.size(); ++i)
  {
    expansion.Add(this->Charges, classes[i], centre, radius, NearClasses[i].Degree);
  }
  return true;
}

void DomainCover::Decide(OpenBox& open)
{
  CoverBox& box = this->Boxes[open.Id];
  const Eigen::Vector3d centre = open.Region.center();
  const Eigen::Vector3d half = HalfEdges(open.Region, centre);
  TaylorExpansion expansion;
  if (!this->Expand(*open.Field, centre, (1.0 + 1e-12) * half.norm(), expansion))
  {
    return;
  }
  const DeterminantSign verdict = BoundDeterminant(expansion, half, TaylorExpansion::Degree,
    std::pow(half.maxCoeff(), TaylorExpansion::LowDegree) * open.Field->HighTerms);
  box.State = static_cast<BoxState>(verdict.Sign);
  box.Determinant = verdict.Sign * verdict.Bound;
  if (verdict.Sign != 0 || verdict.Estimate >= 0.0)
  {
    return;
  }
  open.Priority *= FoldedPriority;
  const Eigen::Vector3d lowest = centre + verdict.Lowest;
  if (2.0 * box.Place.Half <= this->LargestWitness &&
    (open.Triangles.empty() || this->IsInside(lowest)))
  {
    this->Test(open, lowest);
  }
}

/// Makes a position of the domain the witness of a box if its determinant is proven to be negative.
void DomainCover::Test(const OpenBox& open, const Eigen::Vector3d& position)
{
  TaylorExpansion expansion = open.Field->Far.GetLowTerms(position - open.Field->Centre);
  expansion.Add(this->Charges, open.Field->Near, position, 0.0, 1);
  const DeterminantSign verdict = BoundDeterminant(expansion, Eigen::Vector3d::Zero(), 1);
  if (verdict.Sign < 0)
  {
    CoverBox& box = this->Boxes[open.Id];
    box.State = BoxState::Inverted;
    box.Determinant = -verdict.Bound;
    box.HasWitness = true;
    box.Witness = position;
  }
}

bool DomainCover::IsInside(const Eigen::Vector3d& position) const
{
  return this->Inside->Evaluate(position.transpose()).Distances(0) <= 0.0;
}

/// Computes the volume of a box that is not divided. Searches for a witness unless it is certified:
/// at the centre and, if the box is inverted or small, at the corners and the surface.
void DomainCover::Finish(const OpenBox& open)
{
  CoverBox& box = this->Boxes[open.Id];
  const BoxCube& cube = box.Place;
  const bool cut = !open.Triangles.empty();
  box.Volume = cut
    ? ComputeVolumeInCube(this->Domain, open.Triangles, cube, this->IsInside(cube.Corner()))
    : std::pow(2.0 * cube.Half, 3);
  if (box.State == BoxState::Certified || box.HasWitness)
  {
    return;
  }
  const bool thorough = 2.0 * cube.Half <= this->LargestWitness || box.State == BoxState::Inverted;
  for (int corner = -1; corner < (thorough ? 8 : 0) && !box.HasWitness; ++corner)
  {
    Eigen::Vector3d position = cube.Centre;
    for (int axis = 0; axis < 3 && corner >= 0; ++axis)
    {
      position(axis) += (corner >> axis & 1) != 0 ? cube.Half : -cube.Half;
    }
    if (!cut || this->IsInside(position))
    {
      this->Test(open, position);
    }
  }
  if (cut && thorough && !box.HasWitness)
  {
    const Eigen::Vector3d position =
      this->Inside->Locator().FindOne(cube.Centre.transpose()).Position.transpose();
    if (((position - cube.Centre).array().abs() <= cube.Half).all())
    {
      this->Test(open, position);
    }
  }
}

/// Returns the children that meet the domain; Id is their octant.
std::vector<DomainCover::OpenBox> DomainCover::Divide(const OpenBox& open) const
{
  const BoxCube& cube = this->Boxes[open.Id].Place;
  const std::shared_ptr<const ChargeField> field = Descend(open.Field, this->Charges, cube);
  std::vector<OpenBox> children;
  for (int octant = 0; octant < 8; ++octant)
  {
    const BoxCube child = cube.Child(octant);
    Eigen::AlignedBox3d region;
    std::vector<int> triangles = FindTrianglesInCube(this->Domain, open.Triangles, child, &region);
    if (!triangles.empty())
    {
      region = BoundSolidInCube(
        child, region, [&](const Eigen::Vector3d& position) { return this->IsInside(position); });
    }
    // Without a triangle, the whole child is on one side.
    else if (open.Triangles.empty() || this->IsInside(child.Centre))
    {
      region = child.Box();
    }
    if (!region.isEmpty())
    {
      children.push_back({ octant, field, std::move(triangles), region, region.volume() });
    }
  }
  return children;
}

bool DomainCover::IsDivisible(const OpenBox& open) const
{
  const CoverBox& box = this->Boxes[open.Id];
  return box.State == BoxState::Undecided && box.Place.Half >= this->SmallestEdge &&
    box.Level < MaximumLevel;
}

/// Takes the boxes to divide next: those of at least an eighth of the largest priority, the largest
/// first, as long as there may be further boxes.
std::vector<DomainCover::OpenBox> DomainCover::TakeLargest(std::vector<OpenBox>& open) const
{
  std::stable_sort(open.begin(), open.end(),
    [](const OpenBox& a, const OpenBox& b) { return a.Priority > b.Priority; });
  const std::size_t most =
    (std::max<std::size_t>(this->Options.MaximumBoxes, this->Boxes.size()) - this->Boxes.size()) /
    8;
  std::size_t count = 0;
  while (
    count < open.size() && count < most && open[count].Priority >= 0.125 * open.front().Priority)
  {
    ++count;
  }
  const auto end = open.begin() + static_cast<std::ptrdiff_t>(count);
  std::vector<OpenBox> taken(std::make_move_iterator(open.begin()), std::make_move_iterator(end));
  open.erase(open.begin(), end);
  return taken;
}

void DomainCover::Examine(const Progress& progress)
{
  // The number of boxes grows about fourfold with each level near the surface.
  const double levels =
    std::clamp(std::log2(2.0 / this->SmallestEdge), 0.0, static_cast<double>(MaximumLevel));
  const auto shareAt = [&](double priority)
  { return std::exp2(2.0 * (std::min(-std::log2(0.5 * std::cbrt(priority)), levels) - levels)); };
  // Calls a function for each box of a list.
  const auto forEach = [&](std::vector<OpenBox>& boxes, const Progress& part, const auto& body)
  {
    ParallelFor(
      static_cast<int>(boxes.size()), 4,
      [&](int begin, int end)
      {
        for (int i = begin; i < end; ++i)
        {
          body(i);
        }
      },
      part);
  };
  std::vector<OpenBox> fresh = std::move(this->Open), waiting;
  double done = 0.0;
  while (!fresh.empty() || !waiting.empty())
  {
    const double share =
      fresh.empty() ? done : std::clamp(shareAt(fresh.front().Priority), done, 1.0);
    const Progress part = progress.Part(done, share);
    done = share;
    forEach(fresh, part.Part(0.0, 0.5), [&](int i) { this->Decide(fresh[i]); });
    std::vector<OpenBox> finished;
    for (OpenBox& box : fresh)
    {
      (this->IsDivisible(box) ? waiting : finished).push_back(std::move(box));
    }
    std::vector<OpenBox> divided = this->TakeLargest(waiting);
    if (divided.empty())
    {
      this->Complete = waiting.empty();
      std::move(waiting.begin(), waiting.end(), std::back_inserter(finished));
      waiting.clear();
    }
    forEach(finished, part.Part(0.5, 0.6), [&](int i) { this->Finish(finished[i]); });
    std::vector<std::vector<OpenBox>> children(divided.size());
    forEach(divided, part.Part(0.6, 1.0), [&](int i) { children[i] = this->Divide(divided[i]); });
    fresh.clear();
    for (std::size_t i = 0; i < divided.size(); ++i)
    {
      const CoverBox parent = this->Boxes[divided[i].Id];
      this->Boxes[divided[i].Id].FirstChild = static_cast<int>(this->Boxes.size());
      this->Boxes[divided[i].Id].ChildCount = static_cast<int>(children[i].size());
      for (OpenBox& child : children[i])
      {
        CoverBox box;
        box.Place = parent.Place.Child(child.Id);
        box.Level = parent.Level + 1;
        child.Id = static_cast<int>(this->Boxes.size());
        this->Boxes.push_back(box);
        fresh.push_back(std::move(child));
      }
    }
  }
  progress(1.0);
}

void DomainCover::Merge()
{
  for (auto box = this->Boxes.rbegin(); box != this->Boxes.rend(); ++box)
  {
    const auto first = this->Boxes.begin() + box->FirstChild;
    const auto last = first + box->ChildCount;
    if (first == last ||
      !std::all_of(first, last,
        [&](const CoverBox& child)
        { return child.ChildCount == 0 && child.State == first->State; }))
    {
      continue;
    }
    box->State = first->State;
    box->Determinant = std::numeric_limits<double>::infinity();
    for (auto child = first; child != last; ++child)
    {
      box->Volume += child->Volume;
      if (child->Determinant < box->Determinant)
      {
        box->Determinant = child->Determinant;
      }
      if (child->HasWitness)
      {
        box->HasWitness = true;
        box->Witness = child->Witness;
      }
      child->ChildCount = -1; // part of its parent
    }
    box->ChildCount = 0;
  }
}

} // namespace shape
