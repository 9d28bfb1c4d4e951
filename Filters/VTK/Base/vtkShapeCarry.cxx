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

#include "Base/Parallel.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <type_traits>
#include <utility>

namespace
{

using vtkShapeCarry::Weights;

/// An array of one of the meshes that data come from, nullptr if it lacks it, and its weights.
using Part = std::pair<vtkAbstractArray*, const Weights*>;

/// A value as an array of T stores it.
template <typename T>
T Stored(double value)
{
  return std::is_same_v<T, unsigned char>
    ? static_cast<T>(std::clamp(std::round(value), 0.0, 255.0))
    : static_cast<T>(value);
}

/// Calls a function with the values of an array of values, which are in one block.
template <typename Function>
void WithValues(vtkDataArray* array, const Function& function)
{
  switch (array->GetDataType())
  {
    case VTK_FLOAT:
      function(static_cast<float*>(array->GetVoidPointer(0)));
      break;
    case VTK_DOUBLE:
      function(static_cast<double*>(array->GetVoidPointer(0)));
      break;
    default:
      function(static_cast<unsigned char*>(array->GetVoidPointer(0)));
      break;
  }
}

/// An array with the same values in one block.
vtkSmartPointer<vtkDataArray> InOneBlock(vtkAbstractArray* array)
{
  vtkSmartPointer<vtkDataArray> values = vtkDataArray::SafeDownCast(array);
  if (!values->HasStandardMemoryLayout())
  {
    values.TakeReference(vtkDataArray::CreateDataArray(array->GetDataType()));
    values->DeepCopy(array);
  }
  return values;
}

/// Writes the weighted means of the parts' values. A tuple with one source of weight 1 is copied to
/// the bit. areNormals: whether the others become unit vectors.
template <typename T>
void Interpolate(const std::vector<Part>& parts, bool areNormals, int components, T* to)
{
  std::vector<vtkSmartPointer<vtkDataArray>> blocks;
  std::vector<std::pair<const T*, const Weights*>> sources;
  for (const auto& [array, weights] : parts)
  {
    if (array)
    {
      blocks.push_back(InOneBlock(array));
      sources.emplace_back(static_cast<const T*>(blocks.back()->GetVoidPointer(0)), weights);
    }
  }
  constexpr int grain = 4096;
  const auto interpolate = [&](int begin, int end)
  {
    Eigen::VectorXd sums(components);
    for (int tuple = begin; tuple < end; ++tuple)
    {
      sums.setZero();
      const T* copied = nullptr;
      int count = 0;
      for (const auto& [values, weights] : sources)
      {
        for (Weights::InnerIterator entry(*weights, tuple); entry; ++entry)
        {
          if (entry.value() == 0.0)
          {
            continue;
          }
          const T* from = values + components * static_cast<vtkIdType>(entry.col());
          copied = ++count == 1 && entry.value() == 1.0 ? from : nullptr;
          for (int k = 0; k < components; ++k)
          {
            sums(k) += entry.value() * static_cast<double>(from[k]);
          }
        }
      }
      T* out = to + components * static_cast<vtkIdType>(tuple);
      if (copied)
      {
        std::copy_n(copied, components, out);
        continue;
      }
      if (areNormals)
      {
        sums.stableNormalize();
      }
      std::transform(sums.begin(), sums.end(), out, Stored<T>);
    }
  };
  shape::ParallelFor(static_cast<int>(parts.front().second->rows()), grain, interpolate);
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
    WithValues(vtkDataArray::SafeDownCast(carried),
      [&](auto* to) { Interpolate(parts, areNormals, like->GetNumberOfComponents(), to); });
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
  derived->GetFieldData()->PassData(sources.front().Mesh->GetFieldData());
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

Eigen::MatrixXd vtkShapeCarry::GetTuples(vtkDataArray* array, const std::vector<int>& tuples)
{
  Eigen::MatrixXd values(tuples.size(), array->GetNumberOfComponents());
  for (Eigen::Index row = 0; row < values.rows(); ++row)
  {
    for (Eigen::Index k = 0; k < values.cols(); ++k)
    {
      values(row, k) = array->GetComponent(tuples[row], static_cast<int>(k));
    }
  }
  return values;
}

void vtkShapeCarry::SetTuples(
  const Eigen::MatrixXd& values, const std::vector<int>& tuples, vtkDataArray* array)
{
  WithValues(array,
    [&](auto* to)
    {
      for (Eigen::Index row = 0; row < values.rows(); ++row)
      {
        std::transform(values.row(row).begin(), values.row(row).end(),
          to + values.cols() * static_cast<vtkIdType>(tuples[row]),
          Stored<std::remove_pointer_t<decltype(to)>>);
      }
    });
}
