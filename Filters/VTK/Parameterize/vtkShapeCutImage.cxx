#include "vtkShapeCutImage.h"

#include "vtkShapeCarry.h"
#include "vtkShapeComposite.h"
#include "vtkShapeConvert.h"
#include "vtkShapePreciseMap.h"
#include "vtkShapeSurfaces.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include "Base/Errors.h"
#include "Mesh/UsedPoints.h"

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

/// A piece keeps what marks the copies of other processes' points and cells.
void KeepGhosts(
  vtkDataSetAttributes* from, const vtkShapeCarry::Weights& weights, vtkDataSetAttributes* to)
{
  if (vtkAbstractArray* marks = from->GetAbstractArray(vtkDataSetAttributes::GhostArrayName()))
  {
    to->AddArray(vtkShapeCarry::CarryArray(marks, weights));
  }
}

} // namespace

vtkShapeCutImage::vtkShapeCutImage(const shape::Mesh& surface, const std::vector<int>& given,
  const shape::CutSurface& cut, const Eigen::MatrixXd& positions)
  : Surface(surface)
  , Given(given)
  , Cut(cut)
  , Positions(positions)
{
  for (int t = 0; t < surface.Triangles.rows(); ++t)
  {
    const Eigen::RowVector3i corners = surface.Triangles.row(t);
    this->Triangles[Turned(
      { this->ToGiven(corners(0)), this->ToGiven(corners(1)), this->ToGiven(corners(2)) })] = t;
  }
}

void vtkShapeCutImage::Fill(vtkDataSet* from, const std::vector<int>& whole, vtkDataSet* to) const
{
  const vtkSmartPointer<vtkPolyData> block = vtkShapeSurfaces::ToSurface(from, "Input");
  const shape::NumberedSurface numbered = vtkShapePreciseMap::ToSurface(block, "the surface");
  const shape::Mesh& own = numbered.Surface;
  // The same triangles with the points of the cut surface, and the block's triangle of each.
  shape::Mesh cut{ {}, Eigen::MatrixXi(own.Triangles.rows(), 3) };
  std::vector<int> imaged;
  std::map<int, int> ownOf; // the block's points by those of the cut surface
  for (Eigen::Index t = 0; t < own.Triangles.rows(); ++t)
  {
    std::array<int, 3> points{};
    for (int k = 0; k < 3; ++k)
    {
      points[k] = whole[own.Triangles(t, k)];
    }
    const auto found = this->Triangles.find(Turned(points));
    if (found == this->Triangles.end() && !this->Given.empty())
    {
      continue; // removed by the repair
    }
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
        if (this->ToGiven(this->Cut.Provenance.Points(point)) == points[k])
        {
          cut.Triangles(static_cast<Eigen::Index>(imaged.size()), k) = point;
          ownOf[point] = own.Triangles(t, k);
        }
      }
    }
    imaged.push_back(static_cast<int>(t));
  }
  cut.Triangles.conservativeResize(static_cast<Eigen::Index>(imaged.size()), 3);
  std::vector<int> used, originals;
  for (const auto& [point, original] : ownOf)
  {
    used.push_back(point);
    originals.push_back(original);
  }
  cut.Triangles = shape::RenumberPoints(cut.Triangles, used, this->Cut.Surface.Points.rows());
  cut.Points = vtkShapeConvert::Rows(this->Cut.Surface.Points, used);

  vtkNew<vtkPolyData> flat;
  vtkShapeConvert::FromMesh(cut, flat);
  const shape::Provenance provenance =
    shape::TraceCopies(originals, block->GetNumberOfPoints(), numbered.Cells(imaged));
  vtkShapeCarry::Carry({ { block, provenance } }, flat);
  KeepGhosts(block->GetPointData(), provenance.Weights, flat->GetPointData());
  KeepGhosts(block->GetCellData(),
    vtkShapeCarry::ToWeights(provenance.Cells, block->GetNumberOfCells()), flat->GetCellData());
  vtkNew<vtkUnstructuredGrid> grid;
  const bool isGrid = to->IsA("vtkUnstructuredGrid");
  if (isGrid)
  {
    grid->SetPoints(flat->GetPoints());
    grid->SetCells(VTK_TRIANGLE, flat->GetPolys());
    grid->GetPointData()->ShallowCopy(flat->GetPointData());
    grid->GetCellData()->ShallowCopy(flat->GetCellData());
    grid->GetFieldData()->ShallowCopy(flat->GetFieldData());
  }
  vtkShapeComposite::Move(isGrid ? static_cast<vtkDataSet*>(grid) : flat,
    vtkShapeConvert::Rows(this->Positions, used), to);
  to->GetPointData()->AddArray(vtkShapeConvert::ToArray(cut.Points, "SourcePosition"));
  vtkShapeCarry::AddOriginals(provenance.Points, "OriginalPointId", to->GetPointData());
}
