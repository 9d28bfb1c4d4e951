#include "vtkShapeFunctionalMap.h"

#include "vtkShapeConvert.h"
#include "vtkShapeGather.h"

#include "Base/Errors.h"
#include "Mesh/Topology.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <cmath>
#include <limits>

namespace
{

Eigen::MatrixXd Columns(vtkTable* table)
{
  Eigen::Index components = 0;
  for (vtkIdType i = 0; i < table->GetNumberOfColumns(); ++i)
  {
    auto* column = vtkDataArray::SafeDownCast(table->GetColumn(i));
    if (!column)
    {
      throw shape::InvalidInput("the column '" + std::string(table->GetColumnName(i)) +
        "' of FunctionalMap holds no numbers; leave it out");
    }
    components += column->GetNumberOfComponents();
  }
  Eigen::MatrixXd matrix(table->GetNumberOfRows(), components);
  Eigen::Index at = 0;
  for (vtkIdType i = 0; i < table->GetNumberOfColumns(); ++i)
  {
    auto* column = vtkDataArray::SafeDownCast(table->GetColumn(i));
    for (int c = 0; c < column->GetNumberOfComponents(); ++c, ++at)
    {
      for (Eigen::Index row = 0; row < matrix.rows(); ++row)
      {
        matrix(row, at) = column->GetComponent(row, c);
      }
    }
  }
  return matrix;
}

void AppendColumns(const Eigen::MatrixXd& values, Eigen::MatrixXd& all)
{
  all.conservativeResize(Eigen::NoChange, all.cols() + values.cols());
  all.rightCols(values.cols()) = values;
}

} // namespace

Eigen::MatrixXd vtkShapeFunctionalMap::ReadMatrix(
  vtkDataObject* table, vtkMultiProcessController* controller)
{
  Eigen::MatrixXd matrix;
  vtkShapeGather::RunOnAllOrFail(controller,
    [&]
    {
      auto* own = vtkTable::SafeDownCast(table);
      if (!own)
      {
        throw shape::InvalidInput("the input FunctionalMap is no table; connect one, such as the "
                                  "output FunctionalMap of Shape Correspondence");
      }
      matrix = Columns(own);
    });
  vtkShapeGather::Share(controller, matrix);
  return matrix;
}

void vtkShapeFunctionalMap::WriteMatrix(const shape::FunctionalMatrix& map, vtkTable* table)
{
  for (Eigen::Index column = 0; column < map.Matrix.cols(); ++column)
  {
    table->AddColumn(vtkShapeConvert::ToArray(map.Matrix.col(column), std::to_string(column)));
  }
  vtkFieldData* facts = table->GetFieldData();
  facts->AddArray(vtkShapeConvert::ToArray(map.OfA.Eigenvalues, "EigenvaluesOfA"));
  facts->AddArray(vtkShapeConvert::ToArray(map.OfB.Eigenvalues, "EigenvaluesOfB"));
  vtkShapeConvert::AddFact(table, "ScaleOfA", std::sqrt(map.OfA.Masses.sum()));
  vtkShapeConvert::AddFact(table, "ScaleOfB", std::sqrt(map.OfB.Masses.sum()));
}

void vtkShapeFunctionalMap::Append(const shape::RegionIndicators& regions, Descriptors& descriptors)
{
  AppendColumns(regions.OfA, descriptors.OfA);
  AppendColumns(regions.OfB, descriptors.OfB);
}

Eigen::MatrixXd vtkShapeFunctionalMap::ReadArray(
  vtkPolyData* surface, const std::string& array, const std::string& name)
{
  vtkDataArray* given = surface->GetPointData()->GetArray(array.c_str());
  const Eigen::MatrixXd values = vtkShapeConvert::ToPointArray(surface, array,
    given ? given->GetNumberOfComponents() : 1, name, "choose an array of its points");
  shape::RequireFinite(values, "the array '" + array + "' of " + name);
  return values;
}

vtkShapeFunctionalMap::Descriptors vtkShapeFunctionalMap::ReadDescriptors(
  vtkPolyData* a, vtkPolyData* b, const std::vector<std::string>& arrays)
{
  Descriptors result{ Eigen::MatrixXd(a->GetNumberOfPoints(), 0),
    Eigen::MatrixXd(b->GetNumberOfPoints(), 0) };
  for (const std::string& array : arrays)
  {
    if (!vtkShapeConvert::IsChosen(array))
    {
      continue;
    }
    const Eigen::MatrixXd ofA = ReadArray(a, array, "SurfaceA"),
                          ofB = ReadArray(b, array, "SurfaceB");
    if (ofA.cols() != ofB.cols())
    {
      throw shape::InvalidInput("the array '" + array + "' has " + std::to_string(ofA.cols()) +
        " components on SurfaceA and " + std::to_string(ofB.cols()) +
        " on SurfaceB; give both surfaces the same functions");
    }
    AppendColumns(ofA, result.OfA);
    AppendColumns(ofB, result.OfB);
  }
  return result;
}

shape::SurfaceRegions vtkShapeFunctionalMap::ReadRegions(vtkPolyData* surface,
  const std::vector<int>& cellOf, const std::string& array, const std::string& name)
{
  const std::string remedy = "choose another Region Array, or None";
  if (surface->GetCellData()->HasArray(array.c_str()))
  {
    const Eigen::VectorXi ofCells = vtkShapeConvert::ToCellIntegers(surface, array, name, remedy);
    // Vertices and lines come before the cells that have triangles.
    const auto before = static_cast<int>(surface->GetNumberOfVerts() + surface->GetNumberOfLines());
    shape::SurfaceRegions regions{ Eigen::VectorXi(cellOf.size()), false };
    for (Eigen::Index t = 0; t < regions.Ids.size(); ++t)
    {
      regions.Ids(t) = ofCells(before + cellOf[t]);
    }
    return regions;
  }
  const Eigen::MatrixXd values = vtkShapeConvert::ToPointArray(
    surface, array, 1, name, "choose an array of the cells or of the points of both surfaces");
  for (Eigen::Index i = 0; i < values.rows(); ++i)
  {
    if (values(i) != std::floor(values(i)) ||
      std::abs(values(i)) >= std::numeric_limits<int>::max())
    {
      throw shape::InvalidInput("the point array '" + array + "' of " + name +
        " is no integer at point " + std::to_string(i) + "; " + remedy);
    }
  }
  return { values.col(0).cast<int>(), true };
}
