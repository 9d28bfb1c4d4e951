#include "vtkShapeMeasures.h"

#include "vtkShapeComposite.h"

#include "vtkAbstractArray.h"
#include "vtkBoundingBox.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkMeshQuality.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace
{

using Setter = void (vtkMeshQuality::*)();

const std::pair<const char*, Setter> OfHexahedra[] = {
  { "ScaledJacobian", &vtkMeshQuality::SetHexQualityMeasureToScaledJacobian },
  { "Jacobian", &vtkMeshQuality::SetHexQualityMeasureToJacobian },
  { "Volume", &vtkMeshQuality::SetHexQualityMeasureToVolume },
  { "EdgeRatio", &vtkMeshQuality::SetHexQualityMeasureToEdgeRatio },
  { "MaxAspectFrobenius", &vtkMeshQuality::SetHexQualityMeasureToMaxAspectFrobenius },
  { "EquiangleSkew", &vtkMeshQuality::SetHexQualityMeasureToEquiangleSkew },
  { "Skew", &vtkMeshQuality::SetHexQualityMeasureToSkew },
  { "Taper", &vtkMeshQuality::SetHexQualityMeasureToTaper },
  { "Shape", &vtkMeshQuality::SetHexQualityMeasureToShape },
};

/// Measures with real values. Integer arrays with these names are labels, not measures.
const std::set<std::string> RealMeasures = {
  // Verdict's measures of cells, and the arrays of vtkMeshQuality, vtkCellQuality,
  // vtkCellSizeFilter
  "Area", "AspectBeta", "AspectFrobenius", "AspectGamma", "AspectRatio", "CollapseRatio",
  "Condition", "Diagonal", "Dimension", "Distortion", "EdgeRatio", "EquiangleSkew",
  "EquivolumeSkew", "Jacobian", "MaxAngle", "MaxAspectFrobenius", "MaxEdgeRatio", "MaxStretch",
  "MeanAspectFrobenius", "MeanRatio", "MedAspectFrobenius", "MinAngle", "NodalJacobianRatio",
  "NormalizedInradius", "Oddy", "RadiusRatio", "RelativeSizeSquared", "ScaledJacobian", "Shape",
  "ShapeAndSize", "Shear", "ShearAndSize", "Skew", "SquishIndex", "Stretch", "Taper", "Volume",
  "Warpage", "Quality", "CellQuality", "Length",
  // other filters of VTK
  "Distance", "Gauss_Curvature", "Mean_Curvature", "Maximum_Curvature", "Minimum_Curvature",
  "Normals", "Tangents",
  // ShapeMap: distances, distortion of maps, spectra
  "BoundaryDistance", "GeodesicDistance", "DeformationGradient", "JacobianDeterminant", "Dirichlet",
  "SymmetricDirichlet", "ConformalDistortion", "ARAP", "Hencky", "AMIPS", "AreaDistortion",
  "L2Stretch", "LinfStretch", "SmallestSingularValue", "LargestSingularValue", "AreaDifference",
  "ConformalDifference", "AreaEigenfunctions", "ConformalEigenfunctions", "OffsetAreaDifference",
  "OffsetConformalDifference", "AreaDeviation", "ConformalDeviation", "PositionDeviation",
  "AreaVariationFunctions", "ConformalVariationFunctions", "AreaModes", "ConformalModes",
  "SideLengths", "Angles", "NormalCurvatures", "Eigenfunctions", "Masses", "HeatKernelSignature",
  "WaveKernelSignature", "Embedding", "ArrivalTime", "Radius", "SplineError", "Determinant",
  "VolumeInside", "MinimumDeterminant", "NonOrthogonality", "Skewness"
};

/// Measures that are counts or Booleans.
const std::set<std::string> IntegerMeasures = { "Certified", "Degenerate", "Flipped", "Inverted",
  "Torn" };

/// Returns the name of the measure that an array contains, or an empty string if it is not a
/// measure. Active normals may have any name.
std::string MeasureOf(vtkFieldData* data, vtkAbstractArray* array)
{
  auto* attributes = vtkDataSetAttributes::SafeDownCast(data);
  if (attributes && array == attributes->GetNormals())
  {
    return "Normals";
  }
  const std::string name = array->GetName() ? array->GetName() : "";
  const int type = array->GetDataType();
  const bool isReal = type == VTK_DOUBLE || type == VTK_FLOAT;
  // Arrays with the same names and other types are the user's own.
  return (isReal && RealMeasures.count(name)) || IntegerMeasures.count(name) ? name : "";
}

/// Returns the filter that wrote a fact (HexRemesh for HexRemesh.CellSize), or an empty string if
/// it is not a filter of ShapeMap.
std::string FilterOf(const std::string& fact)
{
  static const std::set<std::string> filters = []
  {
    std::istringstream classes(SHAPEMAP_CLASSES);
    std::set<std::string> names;
    for (std::string name; classes >> name;)
    {
      names.insert(name.substr(std::string("vtkShape").size()));
    }
    return names;
  }();
  const std::string prefix = fact.substr(0, fact.find('.'));
  return prefix != fact && filters.count(prefix) ? prefix : "";
}

/// "Mesh Hexahedron Quality": the summary that vtkMeshQuality writes to the field data.
bool IsQualitySummary(const std::string& name)
{
  const std::string begin = "Mesh ", end = " Quality";
  return name.size() > begin.size() + end.size() && name.compare(0, begin.size(), begin) == 0 &&
    name.compare(name.size() - end.size(), end.size(), end) == 0;
}

/// Arrays and points of data objects.
using Parts = std::set<const vtkObject*>;

void AddParts(vtkDataObject* data, Parts& parts)
{
  for (const int kind : { vtkDataObject::POINT, vtkDataObject::CELL, vtkDataObject::FIELD })
  {
    vtkFieldData* arrays = data->GetAttributesAsFieldData(kind);
    for (int i = 0; arrays && i < arrays->GetNumberOfArrays(); ++i)
    {
      parts.insert(arrays->GetAbstractArray(i));
    }
  }
  auto* set = vtkPointSet::SafeDownCast(data);
  if (set && set->GetPoints())
  {
    parts.insert(set->GetPoints());
  }
}

Parts PartsOf(const std::vector<vtkDataObject*>& inputs)
{
  Parts parts;
  for (vtkDataObject* input : inputs)
  {
    AddParts(input, parts);
    for (vtkDataSet* leaf : vtkShapeComposite::Of(input))
    {
      AddParts(leaf, parts);
    }
  }
  return parts;
}

/// Removes the measures that the filter did not compute, and returns their names.
std::vector<std::string> Remove(
  const vtkShapeMeasures::Filter& filter, const Parts& inherited, vtkFieldData* data)
{
  std::vector<std::string> removed;
  // Backwards, because arrays are removed during the loop.
  for (int i = data->GetNumberOfArrays() - 1; i >= 0; --i)
  {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    const std::string measure = MeasureOf(data, array);
    // A measure of the new points is either computed by the filter or stale; an inherited array is
    // the input's, even if the filter computes that measure.
    if (!measure.empty() && (inherited.count(array) || !filter.Made.count(measure)))
    {
      removed.push_back(measure);
      data->RemoveArray(i);
    }
  }
  return removed;
}

/// Removes the facts of other filters, and those of an earlier run of this filter.
void RemoveFacts(const vtkShapeMeasures::Filter& filter, const Parts& inherited, vtkFieldData* data)
{
  Remove(filter, inherited, data);
  for (int i = data->GetNumberOfArrays() - 1; i >= 0; --i)
  {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    const std::string name = array->GetName() ? array->GetName() : "";
    const std::string from = FilterOf(name);
    const bool isOwn = from == filter.Name && !inherited.count(array);
    if ((!from.empty() && !isOwn) || IsQualitySummary(name))
    {
      data->RemoveArray(i);
    }
  }
}

vtkSmartPointer<vtkPoints> Scaled(vtkPoints* points, double factor)
{
  auto scaled = vtkSmartPointer<vtkPoints>::New();
  scaled->SetDataTypeToDouble();
  scaled->SetNumberOfPoints(points->GetNumberOfPoints());
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double position[3];
    points->GetPoint(i, position);
    scaled->SetPoint(i, factor * position[0], factor * position[1], factor * position[2]);
  }
  return scaled;
}

bool AreHexahedra(vtkDataSet* data)
{
  if (vtkPolyData::SafeDownCast(data))
  {
    return false; // known without its types of cells, which would have to be built
  }
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    if (data->GetCellType(cell) != VTK_HEXAHEDRON)
    {
      return false;
    }
  }
  return true;
}

} // namespace

const std::vector<std::string>& vtkShapeMeasures::NamesOfHexahedra()
{
  static const std::vector<std::string> names = []
  {
    std::vector<std::string> all;
    for (const auto& [name, unused] : OfHexahedra)
    {
      all.emplace_back(name);
    }
    return all;
  }();
  return names;
}

/// Verdict's measures are at most 1e30, and it takes numbers below 1e-30 for 0. It therefore gets
/// very large and very small cells at a size of about 1.
void vtkShapeMeasures::AddToHexahedra(const std::vector<std::string>& names, vtkPointSet* hexahedra)
{
  auto cells = vtkSmartPointer<vtkPointSet>::Take(hexahedra->NewInstance());
  // Without arrays, so that vtkMeshQuality copies none.
  cells->CopyStructure(hexahedra);
  const double size = vtkBoundingBox(hexahedra->GetBounds()).GetMaxLength();
  const bool isNearLimits = size > 0.0 && std::isfinite(size) && (size < 1e-6 || size > 1e6);
  const double scale = isNearLimits ? std::exp2(std::ilogb(size)) : 1.0;
  if (isNearLimits)
  {
    cells->SetPoints(Scaled(hexahedra->GetPoints(), 1.0 / scale));
  }
  for (const auto& [name, set] : OfHexahedra)
  {
    if (std::find(names.begin(), names.end(), name) == names.end())
    {
      continue;
    }
    vtkNew<vtkMeshQuality> quality;
    quality->SetInputData(cells);
    (quality->*set)();
    quality->Update();
    vtkDataArray* values = quality->GetOutput()->GetCellData()->GetArray("Quality");
    values->SetName(name);
    const bool isVolume = std::string(name) == "Volume" || std::string(name) == "Jacobian";
    for (vtkIdType cell = 0; isVolume && cell < values->GetNumberOfTuples(); ++cell)
    {
      values->SetComponent(cell, 0, values->GetComponent(cell, 0) * scale * scale * scale);
    }
    hexahedra->GetCellData()->AddArray(values);
  }
}

/// The Verdict measures of hexahedra are computed again. Other measures are removed.
void vtkShapeMeasures::Renew(const Filter& filter, vtkDataObject* output)
{
  const Parts inherited = PartsOf(filter.Inputs);
  bool isMoved = false;
  for (vtkDataSet* leaf : vtkShapeComposite::Of(output))
  {
    auto* points = vtkPointSet::SafeDownCast(leaf);
    // The points are shared with an input, so they did not move, and all measures are still valid.
    if (!points || inherited.count(points->GetPoints()))
    {
      continue;
    }
    isMoved = true;
    Remove(filter, inherited, leaf->GetAttributesAsFieldData(vtkDataObject::POINT));
    const std::vector<std::string> ofCells =
      Remove(filter, inherited, leaf->GetAttributesAsFieldData(vtkDataObject::CELL));
    RemoveFacts(filter, inherited, leaf->GetFieldData());
    if (AreHexahedra(leaf))
    {
      AddToHexahedra(ofCells, points);
    }
  }
  if (isMoved)
  {
    RemoveFacts(filter, inherited, output->GetFieldData());
  }
}
