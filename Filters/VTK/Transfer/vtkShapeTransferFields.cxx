#include "vtkShapeTransferFields.h"

#include "vtkShapeCarry.h"
#include "vtkShapeComposite.h"
#include "vtkShapeConvert.h"
#include "vtkShapePreciseMap.h"
#include "vtkShapeSeams.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include "Base/Errors.h"
#include "Mesh/SurfacePoints.h"
#include "Mesh/Topology.h"
#include "Transfer/TextureSeams.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

vtkStandardNewMacro(vtkShapeTransferFields);

vtkShapeTransferFields::vtkShapeTransferFields()
{
  this->DeclareInput("Input", PortData::Pieces, PortUse::Required, { "vtkDataSet" });
  this->DeclareInput("Source", PortData::WholeGrid, PortUse::Required, { "vtkDataSet" });
  this->DeclareOutputLikeInput();
  this->DeclareFacts();
}

namespace
{

/// An array of the giver and its name at the receiver.
struct Field
{
  vtkAbstractArray* Values;
  bool OfCells;
  std::string Name;
};

std::string NameOf(vtkAbstractArray* array)
{
  return array->GetName() ? array->GetName() : "";
}

/// The arrays to transfer: all except the point arrays named `left`. taken: names already in use.
/// Normals are omitted, because normals of the giver are wrong on the receiver.
std::vector<Field> FieldsOf(
  vtkDataSet* giver, const std::set<std::string>& left, std::set<std::string> taken)
{
  std::vector<Field> fields;
  for (const bool ofCells : { false, true })
  {
    vtkDataSetAttributes* attributes = ofCells
      ? static_cast<vtkDataSetAttributes*>(giver->GetCellData())
      : static_cast<vtkDataSetAttributes*>(giver->GetPointData());
    for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* values = attributes->GetAbstractArray(i);
      std::string name = NameOf(values);
      if (vtkShapeCarry::BelongsToMesh(values, attributes) || values == attributes->GetNormals() ||
        name == "Normals" || (!ofCells && left.count(name)))
      {
        continue;
      }
      // The array of the receiver with the same name is kept.
      while (name.empty() || taken.count(name))
      {
        name.insert(0, "Giver");
      }
      taken.insert(name);
      fields.push_back({ values, ofCells, name });
    }
  }
  return fields;
}

/// Renames an array of the receiver whose name is needed for another array.
void SetAside(vtkDataSet* receiver, const std::string& array)
{
  vtkPointData* attributes = receiver->GetPointData();
  if (vtkAbstractArray* own = attributes->GetAbstractArray(array.c_str()))
  {
    std::string name = array;
    while (attributes->HasArray(name.c_str()))
    {
      name.insert(0, "Receiver");
    }
    vtkSmartPointer<vtkAbstractArray> kept;
    kept.TakeReference(own->NewInstance());
    kept->DeepCopy(own);
    kept->SetName(name.c_str());
    attributes->RemoveArray(array.c_str());
    attributes->AddArray(kept);
  }
}

/// Adds an array that this filter computes.
void Replace(vtkDataSet* receiver, vtkDataArray* made)
{
  SetAside(receiver, made->GetName());
  receiver->GetPointData()->AddArray(made);
}

void Carry(const std::vector<Field>& fields, const shape::TransferWeights& found,
  vtkIdType giverCells, vtkDataSet* receiver, const shape::Progress& progress)
{
  const vtkShapeCarry::Weights ofPoints = found.Weights.pruned();
  const vtkShapeCarry::Weights ofCells = vtkShapeCarry::ToWeights(found.Cells, giverCells);
  std::vector<vtkSmartPointer<vtkAbstractArray>> carried;
  for (const Field& field : fields)
  {
    progress(static_cast<double>(carried.size()) / static_cast<double>(fields.size()));
    carried.push_back(vtkShapeCarry::CarryArray(field.Values, field.OfCells ? ofCells : ofPoints));
    carried.back()->SetName(field.Name.c_str());
    receiver->GetPointData()->AddArray(carried.back());
  }
}

/// Returns the precise map of the points; none if it was computed for another surface. numbered:
/// the giver's triangles, which are computed if they are still missing.
std::optional<shape::SurfacePoints> FittingMap(vtkDataSet* from, vtkUnstructuredGrid* giver,
  double tolerance, std::optional<shape::NumberedSurface>& numbered)
{
  try
  {
    if (!numbered)
    {
      numbered = vtkShapePreciseMap::ToSurface(giver, "the Source");
    }
    return vtkShapePreciseMap::Read(from, "the Input", *numbered, "the Source", tolerance);
  }
  catch (const shape::MapOfAnotherSurface&)
  {
    return {};
  }
}

/// The texture of a giver with seams.
struct SeamedGiver
{
  shape::Surface Surface;
  Eigen::MatrixXd Texture; ///< at its points
  std::string Name;        ///< of the transferred array
};

/// Returns the texture of the giver, or nothing if it is no surface with seams. points: of the
/// giver, where the receiver's positions are located.
std::optional<SeamedGiver> FindSeams(
  vtkUnstructuredGrid* giver, const Eigen::MatrixXd& points, const std::vector<Field>& fields)
{
  vtkDataArray* texture = giver->GetPointData()->GetTCoords();
  const auto field = std::find_if(fields.begin(), fields.end(),
    [&](const Field& each) { return each.Values == texture && !each.OfCells; });
  if (!texture || texture->GetNumberOfComponents() != 2 || field == fields.end())
  {
    return {};
  }
  try
  {
    const shape::Surface surface(
      points, vtkShapePreciseMap::ToSurface(giver, "the Source").Surface.Triangles);
    shape::RequireManifold(surface, "the Source");
    if (shape::HasSeams(surface))
    {
      Eigen::MatrixXd coordinates(points.rows(), 2);
      for (Eigen::Index point = 0; point < coordinates.rows(); ++point)
      {
        coordinates.row(point) << texture->GetComponent(point, 0), texture->GetComponent(point, 1);
      }
      return SeamedGiver{ surface, coordinates, field->Name };
    }
  }
  catch (const shape::InvalidInput&)
  {
    // A solid, or a surface without two sides at each edge: it has no seams to split along.
  }
  return {};
}

/// Appends the marked points, without those that also belong to another process.
void AppendOwn(const Eigen::VectorXi& marks, vtkDataSet* data, std::vector<Eigen::RowVector3d>& own)
{
  vtkUnsignedCharArray* ghosts = data->GetPointGhostArray();
  for (Eigen::Index i = 0; i < marks.size(); ++i)
  {
    const bool isGhost =
      ghosts && (ghosts->GetValue(i) & vtkDataSetAttributes::DUPLICATEPOINT) != 0;
    if (marks(i) == 1 && !isGhost)
    {
      data->GetPoint(i, own.emplace_back().data());
    }
  }
}

/// Returns the transferred arrays, the one that the giver shows first.
std::vector<std::string> NamesToShow(vtkDataSet* giver, const std::vector<Field>& fields)
{
  std::vector<std::string> names;
  for (const Field& field : fields)
  {
    const bool isShown = field.Values == giver->GetPointData()->GetScalars() ||
      field.Values == giver->GetCellData()->GetScalars();
    names.insert(isShown ? names.begin() : names.end(), field.Name);
  }
  return names;
}

} // namespace

// 1. Build the search structure of the giver: at its positions, or at their images for Push.
// 2. Locate the receiver's positions, or their images for Pull: by the precise map if it has one.
// 3. Interpolate the giver's arrays there.
// 4. Replace the map array of the receiver by the composed map.
void vtkShapeTransferFields::Execute(const shape::Progress& progress)
{
  const bool push = this->Options.Direction == shape::TransferFieldsOptions::DirectionType::Push;
  vtkUnstructuredGrid* giver = this->GetGatheredInput(1).Grid;
  const Eigen::MatrixXd giverPoints = vtkShapeConvert::ToPoints(giver);
  // The receiver's new map array is interpolated from this one.
  Eigen::MatrixXd newMap;
  Eigen::MatrixXd giverMap;
  vtkDataArray* second = giver->GetPointData()->GetArray(this->MapArray.c_str());
  if (push)
  {
    giverMap = vtkShapeConvert::ToPointArray(giver, this->MapArray, 3, "the Source");
    newMap = giverPoints;
  }
  else if (second && second->GetNumberOfComponents() == 3)
  {
    newMap = vtkShapeConvert::ToPointArray(giver, this->MapArray, 3, "the Source");
    shape::RequireFinite(newMap, "the map array of the Source");
  }
  progress(0.05);
  const shape::TransferFields transfer(vtkShapeConvert::ToCells(giver, "the Source"), giverMap,
    this->Options, progress.Part(0.05, 0.2, "building the search tree"));

  vtkDataObject* input = this->GetInputDataObject(0, 0);
  // The new map array replaces that of the receiver, and with it the precise map.
  std::set<std::string> replaced;
  if (newMap.size() > 0)
  {
    replaced.insert(this->MapArray);
    if (this->MapArray == vtkShapePreciseMap::Position)
    {
      replaced.insert({ vtkShapePreciseMap::Cell, vtkShapePreciseMap::Barycentric });
    }
  }
  std::set<std::string> taken = replaced;
  taken.insert({ "OutsideDomain", this->MapArray });
  for (vtkDataSet* leaf : vtkShapeComposite::Of(input))
  {
    for (int i = 0; i < leaf->GetPointData()->GetNumberOfArrays(); ++i)
    {
      taken.insert(NameOf(leaf->GetPointData()->GetAbstractArray(i)));
    }
  }
  const std::vector<Field> fields = FieldsOf(giver, replaced, std::move(taken));

  const std::optional<SeamedGiver> seamed = this->SplitSeams
    ? FindSeams(giver, push ? giverMap : giverPoints, fields)
    : std::optional<SeamedGiver>();
  std::optional<shape::NumberedSurface> numbered; // if a block has a precise map
  std::vector<Eigen::RowVector3d> outsidePoints, precisePoints, seamPoints;
  double done = 0.2;
  const double share =
    0.8 / std::max<vtkIdType>(1, input->GetNumberOfElements(vtkDataObject::POINT));
  vtkDataObject* output = this->GetOutputDataObject(0);
  vtkShapeComposite::ForEach(input, output, vtkShapeComposite::Points::Kept,
    [&](vtkDataSet* from, vtkDataSet* to)
    {
      const double next = done + share * from->GetNumberOfPoints();
      const double middle = (done + next) / 2.0;
      Eigen::MatrixXd positions = vtkShapeConvert::ToPoints(from);
      shape::RequireFinite(positions, "the Input");
      if (!push)
      {
        positions = vtkShapeConvert::ToPointArray(from, this->MapArray, 3, "the Input");
      }
      std::optional<shape::SurfacePoints> precise;
      if (!push && vtkShapePreciseMap::Has(from, this->MapArray))
      {
        // The triangles of a precise map need no search. They are also correct where the giver
        // touches itself.
        precise = FittingMap(from, giver, this->Options.Tolerance, numbered);
      }
      const shape::TransferWeights found = precise
        ? shape::LocateOnTriangles(*precise, *numbered)
        : transfer.Find(positions, progress.Part(done, middle, "finding the positions"));
      to->ShallowCopy(from);
      Carry(fields, found, giver->GetNumberOfCells(), to,
        progress.Part(middle, next, "transferring the arrays"));
      for (const std::string& name : replaced)
      {
        SetAside(to, name);
      }
      if (newMap.size() > 0)
      {
        Replace(to, vtkShapeConvert::ToArray(found.Weights * newMap, this->MapArray));
      }
      Replace(to, vtkShapeConvert::ToIntegers(found.Outside, "OutsideDomain"));
      AppendOwn(found.Outside, from, outsidePoints);
      if (precise)
      {
        AppendOwn(Eigen::VectorXi::Ones(from->GetNumberOfPoints()), from, precisePoints);
      }
      if (seamed && vtkPolyData::SafeDownCast(to))
      {
        Eigen::VectorXi marks = Eigen::VectorXi::Zero(from->GetNumberOfPoints());
        for (const int point : vtkShapeSeams::Split(vtkPolyData::SafeDownCast(to), seamed->Name,
               seamed->Surface, seamed->Texture, push ? positions : found.Weights * giverPoints))
        {
          marks(point) = 1;
        }
        AppendOwn(marks, from, seamPoints);
      }
      done = next;
    });
  this->DeclareShown(0, NamesToShow(giver, fields));
  this->AddCount(0, "TransferFields.OutsidePoints", std::move(outsidePoints));
  this->AddCount(0, "TransferFields.PrecisePoints", std::move(precisePoints));
  this->AddCount(0, "TransferFields.SeamPoints", std::move(seamPoints));
}
