#include "Harmonic/Certificate.h"

#include "Base/Errors.h"
#include "Base/Parallel.h"
#include "Distance/SignedDistance.h"
#include "Geometry/SelfIntersections.h"
#include "Harmonic/Private/BoxInSolid.h"
#include "Harmonic/Private/DeterminantSign.h"
#include "Harmonic/Private/TaylorExpansion.h"
#include "Solids/Nesting.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

namespace shape
{

namespace
{

using BoxState = MapCertificate::BoxState;

/// Charges at this many radii of a cube or more become part of the polynomial of its children.
constexpr double FarRatio = 4.0;
/// Fewer charges are not worth a polynomial of the full degree.
constexpr int WorthExpanding = 32;
/// Degree of the polynomials of near charges, which are used for one cube only.
constexpr int NearDegree = TaylorExpansion::LowDegree;
/// A cube with a charge nearer than 1 / this many radii is divided at once.
constexpr double NearestRatio = 0.6;
/// A box with a witness is not divided if its edge is at most this share of the domain's longest
/// side: the boundary of a fold, where no box can be decided, would need most of the boxes.
constexpr double WitnessEdge = 1.0 / 256.0;
/// Subdivisions of the root whose centres are exact numbers.
constexpr int MaximumLevel = 19;

/// The far charges of a cube as a polynomial, and the others.
struct ChargeField
{
  TaylorExpansion Far;
  Eigen::Vector3d Centre;
  Eigen::Matrix3d HighTerms; ///< bounds for Far in the cube (TaylorExpansion::BoundHighTerms)
  std::vector<int> Near;
};

struct CoverBox
{
  BoxCube Place;
  int Level = 0;
  int FirstChild = 0, ChildCount = 0; ///< of a divided box: those that meet the domain
  BoxState State = BoxState::Undecided;
  double Volume = 0.0;
  double Determinant = 0.0;
  bool HasWitness = false;
  Eigen::Vector3d Witness = Eigen::Vector3d::Zero();
};

/// A box that is to be examined.
struct OpenBox
{
  int Id = 0;
  std::shared_ptr<const ChargeField> Field;
  std::vector<int> Triangles; ///< those that meet it; empty if it is inside the domain
  Eigen::AlignedBox3d Region; ///< around its part inside the domain
};

/// Divides a domain into boxes and examines them, level by level.
class DomainCover
{
public:
  DomainCover(const ChargeSet& map, const Surface& domain, const MapCertificateOptions& options)
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
    this->LargestWitness = WitnessEdge * longest * this->Scale;
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
    field->HighTerms.setZero();
    field->Far.Coefficients.middleRows<3>(1) = this->Linear.transpose();
    field->Near.resize(map.Points.rows());
    std::iota(field->Near.begin(), field->Near.end(), 0);
    std::vector<int> triangles(domain.Triangles().rows());
    std::iota(triangles.begin(), triangles.end(), 0);
    this->Open.push_back({ 0, field, std::move(triangles),
      { domain.Points().colwise().minCoeff().transpose() * this->Scale,
        domain.Points().colwise().maxCoeff().transpose() * this->Scale } });
  }

  void Examine(const Progress& progress);
  void Merge();
  MapCertificate Collect(const ChargeSet& map) const;

private:
  TaylorExpansion Expand(const ChargeField& field, const Eigen::Vector3d& centre, double radius,
    int degree, bool* tooNear = nullptr) const;
  void Decide(const OpenBox& open);
  void Test(const OpenBox& open, const Eigen::Vector3d& position);
  void Finish(const OpenBox& open);
  bool IsInside(const Eigen::Vector3d& position) const;
  std::shared_ptr<const ChargeField> Descend(const OpenBox& open) const;
  std::vector<OpenBox> Divide(const OpenBox& open) const;

  MapCertificateOptions Options;
  double Scale = 1.0, SmallestEdge = 0.0, LargestWitness = 0.0;
  ChargeColumns Charges;
  Eigen::Matrix3d Linear;
  Surface Domain;
  std::unique_ptr<SignedDistance> Inside;
  std::vector<CoverBox> Boxes;
  std::vector<OpenBox> Open;
  bool Complete = true;
};

/// Returns the expansion of all charges around a position, without the higher terms of the far
/// ones. tooNear: set if a charge is too near.
TaylorExpansion DomainCover::Expand(const ChargeField& field, const Eigen::Vector3d& centre,
  double radius, int degree, bool* tooNear) const
{
  if (tooNear)
  {
    const double nearest = radius / NearestRatio;
    *tooNear = std::any_of(field.Near.begin(), field.Near.end(),
      [&](int i)
      { return (this->Charges.col(i).head<3>() - centre).squaredNorm() < nearest * nearest; });
    if (*tooNear)
    {
      return {};
    }
  }
  TaylorExpansion expansion = field.Far.GetLowTerms(centre - field.Centre);
  expansion.Add(this->Charges, field.Near, centre, radius, degree);
  return expansion;
}

void DomainCover::Decide(const OpenBox& open)
{
  CoverBox& box = this->Boxes[open.Id];
  bool tooNear = false;
  const Eigen::Vector3d centre = open.Region.center();
  const Eigen::Vector3d half = (1.0 + 1e-12) *
    (open.Region.max() - centre).cwiseMax(centre - open.Region.min());
  const TaylorExpansion expansion =
    this->Expand(*open.Field, centre, (1.0 + 1e-12) * half.norm(), NearDegree, &tooNear);
  if (tooNear)
  {
    return;
  }
  const DeterminantSign verdict = BoundDeterminant(
    expansion, half, NearDegree, std::pow(half.maxCoeff(), TaylorExpansion::LowDegree) * open.Field->HighTerms);
  box.State = static_cast<BoxState>(verdict.Sign);
  box.Determinant = verdict.Sign * verdict.Bound;
  const Eigen::Vector3d lowest = centre + verdict.Lowest;
  if (verdict.Sign == 0 && verdict.Estimate < 0.0 && 2.0 * box.Place.Half <= this->LargestWitness &&
    (open.Triangles.empty() || this->IsInside(lowest)))
  {
    this->Test(open, lowest);
  }
}

/// Makes a position of the domain the witness of a box if its determinant is proven to be negative.
void DomainCover::Test(const OpenBox& open, const Eigen::Vector3d& position)
{
  const DeterminantSign verdict =
    BoundDeterminant(this->Expand(*open.Field, position, 0.0, 1), Eigen::Vector3d::Zero(), 1);
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

/// Computes the volume of a box that is not divided, and searches for a witness unless it is
/// certified: at the centre, the corners and, if the surface cuts the box, at the surface.
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
  for (int corner = -1; corner < 8 && !box.HasWitness; ++corner)
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
  if (cut && !box.HasWitness)
  {
    const Eigen::Vector3d position =
      this->Inside->Locator().FindOne(cube.Centre.transpose()).Position.transpose();
    if (((position - cube.Centre).array().abs() <= cube.Half).all())
    {
      this->Test(open, position);
    }
  }
}

/// Returns the field for the children of a box.
std::shared_ptr<const ChargeField> DomainCover::Descend(const OpenBox& open) const
{
  const BoxCube& cube = this->Boxes[open.Id].Place;
  const double radius = cube.Radius();
  std::vector<int> far, near;
  for (const int i : open.Field->Near)
  {
    const double distance = (this->Charges.col(i).head<3>() - cube.Centre).norm();
    (distance > FarRatio * radius ? far : near).push_back(i);
  }
  if (static_cast<int>(far.size()) < WorthExpanding)
  {
    return open.Field;
  }
  auto field =
    std::make_shared<ChargeField>(ChargeField{ open.Field->Far, cube.Centre, {}, std::move(near) });
  field->Far.Shift(cube.Centre - open.Field->Centre);
  field->Far.Add(this->Charges, far, cube.Centre, radius, TaylorExpansion::Degree);
  field->HighTerms = (1.0 + 1e-12) * field->Far.BoundHighTerms(cube.Half);
  return field;
}

/// Returns the children that meet the domain; Id is their octant.
std::vector<OpenBox> DomainCover::Divide(const OpenBox& open) const
{
  const BoxCube& cube = this->Boxes[open.Id].Place;
  const std::shared_ptr<const ChargeField> field = this->Descend(open);
  std::vector<OpenBox> children;
  for (int octant = 0; octant < 8; ++octant)
  {
    BoxCube child{ cube.Centre, 0.5 * cube.Half };
    for (int axis = 0; axis < 3; ++axis)
    {
      child.Centre(axis) += (octant >> axis & 1) != 0 ? child.Half : -child.Half;
    }
    Eigen::AlignedBox3d region;
    std::vector<int> triangles = FindTrianglesInCube(this->Domain, open.Triangles, child, &region);
    if (!triangles.empty())
    {
      region = BoundSolidInCube(child, region,
        [&](const Eigen::Vector3d& position) { return this->IsInside(position); });
    }
    // Without a triangle, the whole child is on one side.
    else if (open.Triangles.empty() || this->IsInside(child.Centre))
    {
      region = { child.Centre.array() - child.Half, child.Centre.array() + child.Half };
    }
    if (!region.isEmpty())
    {
      children.push_back({ octant, field, std::move(triangles), region });
    }
  }
  return children;
}

void DomainCover::Examine(const Progress& progress)
{
  // The number of boxes grows about fourfold with each level near the surface.
  const int levels =
    std::clamp(static_cast<int>(std::log2(2.0 / this->SmallestEdge)), 0, MaximumLevel);
  const auto share = [&](int level) { return std::exp2(std::min(level, levels + 1) - levels - 1); };
  for (int level = 0; !this->Open.empty(); ++level)
  {
    const Progress part = progress.Part(level == 0 ? 0.0 : share(level), share(level + 1));
    ParallelFor(
      static_cast<int>(this->Open.size()), 4,
      [&](int begin, int end)
      {
        for (int i = begin; i < end; ++i)
        {
          this->Decide(this->Open[i]);
        }
      },
      part.Part(0.0, 0.5));
    // The first undecided boxes are divided, as long as there may be further boxes.
    std::vector<char> divided(this->Open.size(), 0);
    std::size_t count = this->Boxes.size();
    for (std::size_t i = 0; i < this->Open.size(); ++i)
    {
      const CoverBox& box = this->Boxes[this->Open[i].Id];
      const bool wanted = box.State == BoxState::Undecided &&
        box.Place.Half >= this->SmallestEdge && box.Level < MaximumLevel;
      const bool fits = count + 8 <= static_cast<std::size_t>(this->Options.MaximumBoxes);
      this->Complete = this->Complete && (fits || !wanted);
      divided[i] = static_cast<char>(wanted && fits);
      count += divided[i] ? 8 : 0;
    }
    std::vector<std::vector<OpenBox>> children(this->Open.size());
    ParallelFor(
      static_cast<int>(this->Open.size()), 4,
      [&](int begin, int end)
      {
        for (int i = begin; i < end; ++i)
        {
          if (divided[i])
          {
            children[i] = this->Divide(this->Open[i]);
          }
          else
          {
            this->Finish(this->Open[i]);
          }
        }
      },
      part.Part(0.5, 1.0));
    std::vector<OpenBox> next;
    for (std::size_t i = 0; i < this->Open.size(); ++i)
    {
      const int parent = this->Open[i].Id;
      this->Boxes[parent].FirstChild = static_cast<int>(this->Boxes.size());
      this->Boxes[parent].ChildCount = static_cast<int>(children[i].size());
      for (OpenBox& child : children[i])
      {
        CoverBox box;
        box.Place = { this->Boxes[parent].Place.Centre, 0.5 * this->Boxes[parent].Place.Half };
        box.Level = level + 1;
        for (int axis = 0; axis < 3; ++axis)
        {
          box.Place.Centre(axis) += (child.Id >> axis & 1) != 0 ? box.Place.Half : -box.Place.Half;
        }
        child.Id = static_cast<int>(this->Boxes.size());
        this->Boxes.push_back(box);
        next.push_back(std::move(child));
      }
    }
    this->Open = std::move(next);
  }
  progress(1.0);
}

/// Joins children with the same state. Children follow their parents in the list.
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

MapCertificate DomainCover::Collect(const ChargeSet& map) const
{
  std::vector<const CoverBox*> boxes;
  for (const CoverBox& box : this->Boxes)
  {
    if (box.ChildCount == 0)
    {
      boxes.push_back(&box);
    }
  }
  const auto count = static_cast<Eigen::Index>(boxes.size());
  MapCertificate result;
  result.ExaminedBoxes = static_cast<int>(this->Boxes.size());
  result.Complete = this->Complete;
  result.Centres.resize(count, 3);
  result.Edges.resize(count);
  result.States.resize(count);
  result.Volumes.resize(count);
  result.Determinants.resize(count);
  std::vector<Eigen::Index> seen;
  for (Eigen::Index i = 0; i < count; ++i)
  {
    const CoverBox& box = *boxes[i];
    result.Centres.row(i) = box.Place.Centre.transpose() / this->Scale;
    result.Edges(i) = 2.0 * box.Place.Half / this->Scale;
    result.States(i) = static_cast<int>(box.State);
    result.Volumes(i) = box.Volume / std::pow(this->Scale, 3);
    result.Determinants(i) = box.State == BoxState::Undecided ? 0.0 : box.Determinant;
    if (box.HasWitness)
    {
      seen.push_back(i);
    }
  }
  result.Witnesses.resize(static_cast<Eigen::Index>(seen.size()), 3);
  for (std::size_t i = 0; i < seen.size(); ++i)
  {
    result.Witnesses.row(static_cast<Eigen::Index>(i)) =
      boxes[seen[i]]->Witness.transpose() / this->Scale;
  }
  const Eigen::MatrixXd jacobians = EvaluateJacobians(map, result.Witnesses);
  result.WitnessDeterminants.resize(result.Witnesses.rows());
  for (std::size_t i = 0; i < seen.size(); ++i)
  {
    const Eigen::Matrix3d jacobian =
      jacobians.row(static_cast<Eigen::Index>(i)).reshaped<Eigen::RowMajor>(3, 3);
    const double determinant = std::min(jacobian.determinant(), 0.0);
    result.WitnessDeterminants(static_cast<Eigen::Index>(i)) = determinant;
    result.Determinants(seen[i]) = determinant;
  }
  const double total = result.Volumes.sum();
  const auto shareOf = [&](BoxState state)
  {
    return (result.States.array() == static_cast<int>(state)).select(result.Volumes, 0.0).sum() /
      total;
  };
  result.CertifiedShare = shareOf(BoxState::Certified);
  result.InvertedShare = shareOf(BoxState::Inverted);
  result.UndecidedShare = shareOf(BoxState::Undecided);
  return result;
}

/// Checks the image of the boundary: see MapCertificate.
void CheckBoundary(
  const ChargeSet& map, const Surface& domain, const Progress& progress, MapCertificate& result)
{
  const Surface image = domain.WithPoints(Evaluate(map, domain.Points(), progress.Part(0.0, 0.3)));
  const std::vector<int> degenerate = FindDegenerateTriangles(image);
  result.BoundaryCrossings = static_cast<int>(degenerate.size());
  if (degenerate.empty())
  {
    result.BoundaryCrossings =
      static_cast<int>(FindSelfIntersections(image, progress.Part(0.3, 1.0)).size());
  }
  // Nested components face in and out in turn, so no position of the image is covered twice.
  result.BoundaryInjective = result.BoundaryCrossings == 0 &&
    OrientByNesting(image, "the image of the boundary").Triangles() == domain.Triangles();
}

} // namespace

MapCertificate CertifyMap(const ChargeSet& map, const Surface& domain,
  const MapCertificateOptions& options, const Progress& progress)
{
  RequireOption(options.Tolerance >= 1e-5 && options.Tolerance <= 0.5, "Tolerance",
    options.Tolerance, "from 1e-5 to 0.5");
  RequireOption(options.MaximumBoxes >= 1, "Maximum Boxes", options.MaximumBoxes, "at least 1");
  RequireClosedSurface(domain, "the domain");
  DomainCover cover(map, domain, options);
  cover.Examine(progress.Part(0.0, 0.9, "bounding the determinant"));
  cover.Merge();
  MapCertificate result = cover.Collect(map);
  CheckBoundary(map, domain, progress.Part(0.9, 1.0, "checking the boundary's image"), result);
  result.Bijective = result.BoundaryInjective &&
    (result.States.array() == static_cast<int>(BoxState::Certified)).all();
  progress(1.0);
  return result;
}

} // namespace shape
