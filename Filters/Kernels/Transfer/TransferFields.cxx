#include "Transfer/TransferFields.h"

#include "Base/Errors.h"
#include "Mesh/Mesh.h"
#include "Mesh/Topology.h"

#include <Eigen/Geometry>

#include <cmath>
#include <utility>

namespace shape
{

namespace
{

/// The longest edge of the box of the points that cells use. The locator refuses corners that are
/// no points.
double ComputeLongestEdge(const Cells& cells)
{
  Eigen::AlignedBox3d box;
  for (const int point : cells.Corners)
  {
    if (point >= 0 && point < cells.Points.rows())
    {
      box.extend(Eigen::Vector3d(cells.Points.row(point)));
    }
  }
  return box.isEmpty() ? 0.0 : box.sizes().maxCoeff();
}

/// The giver in the space in which positions are located.
Cells InPlace(Cells giver, const Eigen::MatrixXd& map, const TransferFieldsOptions& options)
{
  RequireOption(options.Tolerance >= 0.0 && std::isfinite(options.Tolerance), "Tolerance",
    options.Tolerance, "at least 0 and finite");
  RequireFinite(giver.Points, "the Source");
  if (options.Direction == TransferFieldsOptions::DirectionType::Push)
  {
    RequireFinite(map, "the map array of the Source");
    // Push: positions are located in the image of the giver.
    giver.Points = map;
  }
  return giver;
}

CellLocator LocatorOf(const Cells& giver, const Progress& progress)
{
  try
  {
    return CellLocator(giver, progress);
  }
  catch (const InvalidInput& error)
  {
    throw InvalidInput(std::string("in the Source ") + error.what());
  }
}

} // namespace

TransferFields::TransferFields(Cells giver, const Eigen::MatrixXd& map,
  const TransferFieldsOptions& options, const Progress& progress)
  : TransferFields(InPlace(std::move(giver), map, options), options, progress)
{
}

TransferFields::TransferFields(
  const Cells& giver, const TransferFieldsOptions& options, const Progress& progress)
  : Direction(options.Direction)
  , Farthest(options.Tolerance * ComputeLongestEdge(giver))
  , Locator(LocatorOf(giver, progress))
{
}

TransferWeights TransferFields::Find(
  const Eigen::MatrixXd& positions, const Progress& progress) const
{
  const bool pull = this->Direction == TransferFieldsOptions::DirectionType::Pull;
  RequireFinite(positions, pull ? "the map array of the Input" : "the Input");
  const CellPoints found = this->Locator.Find(positions, progress);
  return { found.Weights, found.Ids, (found.Distances.array() > this->Farthest).cast<int>() };
}

} // namespace shape
