#pragma once

#include "Base/Progress.h"
#include "Distance/SignedDistance.h"
#include "Harmonic/CertificateTypes.h"
#include "Harmonic/ChargeSet.h"
#include "Harmonic/Private/BoxInSolid.h"
#include "Harmonic/Private/ChargeField.h"
#include "Harmonic/Private/TaylorExpansion.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <memory>
#include <vector>

namespace shape
{

/// A cube of a DomainCover.
struct CoverBox
{
  BoxCube Place;
  int Level = 0;
  /// Of a divided box: those that meet the domain. ChildCount is -1 in a box that was merged.
  int FirstChild = 0, ChildCount = 0;
  MapCertificate::BoxState State = MapCertificate::BoxState::Undecided;
  double Volume = 0.0; ///< of the part inside the domain
  double Determinant = 0.0;
  bool HasWitness = false;
  Eigen::Vector3d Witness = Eigen::Vector3d::Zero();
};

/// Divides a domain into cubes and proves the sign of the determinant in each: CertifyMap.
class DomainCover
{
public:
  DomainCover(const ChargeSet& map, const Surface& domain, const MapCertificateOptions& options);

  /// Examines boxes and divides those that are not decided, until there are none or MaximumBoxes is
  /// reached. Throws Aborted.
  void Examine(const Progress& progress);
  /// Joins children with the same state. Boxes with ChildCount 0 then cover the domain.
  void Merge();

  /// All boxes; children follow their parents. Lengths are multiplied by LengthScale.
  const std::vector<CoverBox>& GetBoxes() const { return this->Boxes; }
  double LengthScale() const { return this->Scale; }
  /// Whether MaximumBoxes has left no box undivided.
  bool IsComplete() const { return this->Complete; }

private:
  /// A box without a state.
  struct OpenBox
  {
    int Id = 0;
    std::shared_ptr<const ChargeField> Field;
    std::vector<int> Triangles; ///< those that meet it; empty if it is inside the domain
    Eigen::AlignedBox3d Region; ///< around its part inside the domain
    /// The volume of the region; less where the determinant seems to be negative.
    double Priority = 0.0;
  };

  /// Computes the expansion of all charges around a position, without the higher terms of the far
  /// ones. Returns false if a charge is too near.
  bool Expand(const ChargeField& field, const Eigen::Vector3d& centre, double radius,
    TaylorExpansion& expansion) const;
  void Decide(OpenBox& open);
  void Test(const OpenBox& open, const Eigen::Vector3d& position);
  void Finish(const OpenBox& open);
  bool IsInside(const Eigen::Vector3d& position) const;
  bool IsDivisible(const OpenBox& open) const;
  std::vector<OpenBox> Divide(const OpenBox& open) const;
  std::vector<OpenBox> TakeLargest(std::vector<OpenBox>& open) const;

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

} // namespace shape
