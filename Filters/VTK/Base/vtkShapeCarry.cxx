#include "vtkShapeCarry.h"

#include "vtkAbstractArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

namespace
{

using vtkShapeCarry::Weights;

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// An array of one of the meshes that data come from, nullptr if it lacks it, and its weights.
using Part = std::pair<vtkAbstractArray*, const Weights*>;

/// Writes the weighted means of the parts' values. areNormals: whether those that are not copies
/// become unit vectors.
void Interpolate(const std::vector<Part>& parts, bool areNormals, vtkDataArray* to)
{
  Eigen::MatrixXd means =
    Eigen::MatrixXd::Zero(parts.front().second->rows(), to->GetNumberOfComponents());
  Eigen::VectorXi counts = Eigen::VectorXi::Zero(means.rows());
  for (const auto& [array, weights] : parts)
  {
    if (array)
    {
      auto* values = vtkDataArray::SafeDownCast(array);
      means += *weights * vtkShapeCarry::GetTuples(values);
      for (Eigen::Index row = 0; areNormals && row < counts.size(); ++row)
      {
        counts(row) += weights->outerIndexPtr()[row + 1] - weights->outerIndexPtr()[row];
      }
    }
  }
  for (Eigen::Index row = 0; row < counts.size(); ++row)
  {
    if (counts(row) > 1)
    {
      means.row(row).stableNormalize();
    }
  }
  vtkShapeCarry::SetTuples(means, 0, to);
}

/// Of each tuple, the source with the largest weight: as the tuples that each part gives.
class LargestWeights
{
public:
  explicit LargestWeights(const std::vector<Part>& parts)
    : Given(parts.size())
  {
    for (vtkIdType tuple = 0; tuple < parts.front().second->rows(); ++tuple)
    {
      double largest = 0.0;
      std::size_t part = parts.size();
      vtkIdType source = -1;
      for (std::size_t i = 0; i < parts.size(); ++i)
      {
        for (Weights::InnerIterator entry(*parts[i].second, tuple); entry; ++entry)
        {
          if (entry.value() > largest)
          {
            largest = entry.value();
            part = i;
            source = entry.col();
          }
        }
      }
      if (part < parts.size())
      {
        this->Given[part].From->InsertNextId(source);
        this->Given[part].To->InsertNextId(tuple);
      }
    }
  }

  void Copy(const std::vector<Part>& parts, vtkAbstractArray* to) const
  {
    if (auto* numbers = vtkDataArray::SafeDownCast(to))
    {
      numbers->Fill(0.0); // bits are not, nor are tuples without a source
    }
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      if (parts[i].first)
      {
        to->InsertTuples(this->Given[i].To, this->Given[i].From, parts[i].first);
      }
    }
  }

private:
  struct Tuples
  {
    vtkNew<vtkIdList> From, To;
  };

  std::vector<Tuples> Given; ///< by each part
};

/// An array without tuples of the same kind.
vtkSmartPointer<vtkAbstractArray> MakeAlike(vtkAbstractArray* array)
{
  auto alike =
    vtkSmartPointer<vtkAbstractArray>::Take(vtkAbstractArray::CreateArray(array->GetDataType()));
  alike->SetName(array->GetName());
  alike->SetNumberOfComponents(array->GetNumberOfComponents());
  alike->CopyComponentNames(array);
  if (array->HasInformation())
  {
    alike->CopyInformation(array->GetInformation(), 1);
  }
  auto* numbers = vtkDataArray::SafeDownCast(array);
  if (numbers && numbers->GetLookupTable())
  {
    vtkDataArray::SafeDownCast(alike)->SetLookupTable(numbers->GetLookupTable());
  }
  return alike;
}

/// largest: found for the first array that needs it.
vtkSmartPointer<vtkAbstractArray> CarryParts(
  const std::vector<Part>& parts, bool areNormals, std::optional<LargestWeights>& largest)
{
  const auto isThere = [](const Part& part) { return part.first != nullptr; };
  vtkAbstractArray* like = std::find_if(parts.begin(), parts.end(), isThere)->first;
  vtkSmartPointer<vtkAbstractArray> carried = MakeAlike(like);
  carried->SetNumberOfTuples(parts.front().second->rows());
  if (vtkShapeCarry::AreValues(like))
  {
    Interpolate(parts, areNormals, vtkDataArray::SafeDownCast(carried));
    return carried;
  }
  if (!largest)
  {
    largest.emplace(parts);
  }
  largest->Copy(parts, carried);
  return carried;
}

/// Carries point data or cell data.
void CarryAttributes(const std::vector<vtkDataSetAttributes*>& from,
  const std::vector<const Weights*>& weights, vtkDataSetAttributes* to)
{
  std::optional<LargestWeights> largest;
  for (std::size_t first = 0; first < from.size(); ++first)
  {
    for (int i = 0; i < from[first]->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* array = from[first]->GetAbstractArray(i);
      const char* name = array->GetName();
      const bool isMerged = first > 0 && name && to->HasArray(name);
      if (isMerged || vtkShapeCarry::BelongsToMesh(array, from[first]))
      {
        continue;
      }
      std::vector<Part> parts;
      for (std::size_t part = 0; part < from.size(); ++part)
      {
        vtkAbstractArray* own = part == first ? array
          : name                              ? from[part]->GetAbstractArray(name)
                                              : nullptr;
        parts.emplace_back(vtkShapeCarry::AreAlike(own, array) ? own : nullptr, weights[part]);
      }
      const int added =
        to->AddArray(CarryParts(parts, array == vtkShapeCarry::GetNormals(from[first]), largest));
      for (int role = 0; role < vtkDataSetAttributes::NUM_ATTRIBUTES; ++role)
      {
        if (array == from[first]->GetAbstractAttribute(role) && !to->GetAbstractAttribute(role))
        {
          to->SetActiveAttribute(added, role);
        }
      }
    }
  }
}

} // namespace

void vtkShapeCarry::Carry(const std::vector<Source>& sources, vtkDataSet* derived)
{
  std::vector<vtkDataSetAttributes*> points, cells;
  std::vector<const Weights*> pointWeights, cellWeights;
  bool haveCellsData = false, haveCellsSources = false;
  for (const Source& source : sources)
  {
    points.push_back(source.Mesh->GetPointData());
    pointWeights.push_back(&source.From.Weights);
    cells.push_back(source.Mesh->GetCellData());
    haveCellsData = haveCellsData || cells.back()->GetNumberOfArrays() > 0;
    haveCellsSources = haveCellsSources || (source.From.Cells.array() >= 0).any();
  }
  CarryAttributes(points, pointWeights, derived->GetPointData());
  if (haveCellsData && haveCellsSources)
  {
    std::vector<Weights> ofCells;
    for (const Source& source : sources)
    {
      ofCells.push_back(ToWeights(source.From.Cells, source.Mesh->GetNumberOfCells()));
    }
    std::transform(ofCells.begin(), ofCells.end(), std::back_inserter(cellWeights),
      [](const Weights& weights) { return &weights; });
    CarryAttributes(cells, cellWeights, derived->GetCellData());
  }
  if (sources.size() == 1)
  {
    derived->GetFieldData()->PassData(sources.front().Mesh->GetFieldData());
  }
}

vtkSmartPointer<vtkAbstractArray> vtkShapeCarry::CarryArray(
  vtkAbstractArray* array, const Weights& weights)
{
  std::optional<LargestWeights> largest;
  return CarryParts({ { array, &weights } }, false, largest);
}

vtkShapeCarry::Weights vtkShapeCarry::ToWeights(const Eigen::VectorXi& tuples, vtkIdType oldTuples)
{
  shape::ProvenanceWriter writer(oldTuples);
  for (const int tuple : tuples)
  {
    if (tuple < 0)
    {
      writer.AddNone(1);
    }
    else
    {
      writer.AddCopy(tuple);
    }
  }
  return writer.Finish({}).Weights;
}

void vtkShapeCarry::AddOriginals(
  const Eigen::VectorXi& originals, const std::string& name, vtkDataSetAttributes* data)
{
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName(name.c_str());
  ids->SetNumberOfTuples(originals.size());
  std::copy(originals.begin(), originals.end(), ids->GetPointer(0));
  data->AddArray(ids);
}

void vtkShapeCarry::RenumberOriginals(const std::vector<int>& list, vtkDataSetAttributes* data)
{
  auto* ids = vtkIdTypeArray::SafeDownCast(data->GetAbstractArray("OriginalPointId"));
  for (vtkIdType i = 0; ids && !list.empty() && i < ids->GetNumberOfTuples(); ++i)
  {
    ids->SetValue(i, ids->GetValue(i) < 0 ? -1 : list[ids->GetValue(i)]);
  }
}

vtkDataArray* vtkShapeCarry::GetNormals(vtkDataSetAttributes* data)
{
  vtkDataArray* normals = data->GetNormals() ? data->GetNormals() : data->GetArray("Normals");
  const bool areDirections = normals && normals->GetNumberOfComponents() == 3 &&
    (normals->GetDataType() == VTK_FLOAT || normals->GetDataType() == VTK_DOUBLE);
  return areDirections ? normals : nullptr;
}

bool vtkShapeCarry::BelongsToMesh(vtkAbstractArray* array, vtkDataSetAttributes* data)
{
  const std::string name = array->GetName() ? array->GetName() : "";
  return array == data->GetGlobalIds() || name == vtkDataSetAttributes::GhostArrayName();
}

bool vtkShapeCarry::AreAlike(vtkAbstractArray* one, vtkAbstractArray* other)
{
  return one && other && one->GetDataType() == other->GetDataType() &&
    one->GetNumberOfComponents() == other->GetNumberOfComponents();
}

bool vtkShapeCarry::AreValues(vtkAbstractArray* array)
{
  return array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE ||
    array->GetDataType() == VTK_UNSIGNED_CHAR;
}

Eigen::MatrixXd vtkShapeCarry::GetTuples(vtkDataArray* array)
{
  RowMajor values(array->GetNumberOfTuples(), array->GetNumberOfComponents());
  for (vtkIdType tuple = 0; tuple < values.rows(); ++tuple)
  {
    array->GetTuple(tuple, values.row(tuple).data());
  }
  return values;
}

void vtkShapeCarry::SetTuples(const Eigen::MatrixXd& values, vtkIdType first, vtkDataArray* array)
{
  RowMajor stored = values;
  if (array->GetDataType() == VTK_UNSIGNED_CHAR)
  {
    stored = stored.array().round().max(0.0).min(255.0);
  }
  for (vtkIdType row = 0; row < stored.rows(); ++row)
  {
    array->SetTuple(first + row, stored.row(row).data());
  }
}
