#include "vtkShapeCutImage.h"

#include "vtkShapeComposite.h"
#include "vtkShapeConvert.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTriangleFilter.h"

#include "Base/Errors.h"

#include <algorithm>
#include <iterator>

namespace
{

/// The lowest point comes first, because the same triangle may begin at another corner.
std::array<int, 3> Turned(std::array<int, 3> points)
{
  std::rotate(points.begin(), std::min_element(points.begin(), points.end()), points.end());
  return points;
}

} // namespace

vtkShapeCutImage::vtkShapeCutImage(
  const shape::Mesh& surface, const shape::CutSurface& cut, const Eigen::MatrixXd& positions)
  : Surface(surface)
  , Cut(cut)
  , Positions(positions)
{
  for (int t = 0; t < surface.Triangles.rows(); ++t)
  {
    const Eigen::RowVector3i corners = surface.Triangles.row(t);
    this->Triangles[Turned({ corners(0), corners(1), corners(2) })] = t;
  }
}

void vtkShapeCutImage::Fill(vtkDataSet* from, const std::vector<int>& whole, vtkDataSet* to) const
{
  auto* block = vtkPolyData::SafeDownCast(from);
  const shape::Mesh own = vtkShapeConvert::ToMesh(block, "the surface");
  // The same triangles with the points of the cut surface.
  shape::Mesh cut{ {}, Eigen::MatrixXi(own.Triangles.rows(), 3) };
  std::map<int, int> ownOf; // the block's points by those of the cut surface
  for (Eigen::Index t = 0; t < own.Triangles.rows(); ++t)
  {
    std::array<int, 3> points{};
    for (int k = 0; k < 3; ++k)
    {
      points[k] = whole[own.Triangles(t, k)];
    }
    const auto found = this->Triangles.find(Turned(points));
    if (found == this->Triangles.end())
    {
      throw shape::InvalidInput("a polygon is triangulated differently in its block than in the "
                                "gathered input; apply Triangulate to the Input first");
    }
    for (int k = 0; k < 3; ++k)
    {
      for (int l = 0; l < 3; ++l)
      {
        const int point = this->Cut.Surface.Triangles(found->second, l);
        if (this->Cut.Originals[point] == points[k])
        {
          cut.Triangles(t, k) = point;
          ownOf[point] = own.Triangles(t, k);
        }
      }
    }
  }
  std::map<int, int> position;
  std::vector<int> used;
  vtkNew<vtkIdTypeArray> originals;
  originals->SetName("OriginalPointId");
  for (const auto& [point, original] : ownOf)
  {
    position[point] = static_cast<int>(used.size());
    used.push_back(point);
    originals->InsertNextValue(original);
  }
  cut.Triangles = cut.Triangles.unaryExpr([&](int point) { return position[point]; }).eval();
  cut.Points = vtkShapeConvert::Rows(this->Cut.Surface.Points, used);

  vtkNew<vtkPolyData> flat;
  vtkShapeConvert::FromMesh(cut, flat);
  vtkNew<vtkTriangleFilter> triangulated; // passes on the data of the polygons
  triangulated->SetInputData(block);
  triangulated->PassVertsOff();
  triangulated->PassLinesOff();
  triangulated->Update();
  flat->GetCellData()->PassData(triangulated->GetOutput()->GetCellData());
  vtkPointData* fields = flat->GetPointData();
  fields->CopyAllocate(block->GetPointData(), originals->GetNumberOfTuples());
  for (vtkIdType i = 0; i < originals->GetNumberOfTuples(); ++i)
  {
    fields->CopyData(block->GetPointData(), originals->GetValue(i), i);
  }
  flat->GetFieldData()->PassData(block->GetFieldData());
  vtkShapeComposite::Move(flat, vtkShapeConvert::Rows(this->Positions, used), to);
  to->GetPointData()->AddArray(vtkShapeConvert::ToArray(cut.Points, "SourcePosition"));
  to->GetPointData()->AddArray(originals);
}
