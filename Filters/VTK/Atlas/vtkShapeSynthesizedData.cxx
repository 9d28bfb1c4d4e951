#include "vtkShapeSynthesizedData.h"

#include "vtkShapeAlgorithm.h"
#include "vtkShapeChargeSet.h"
#include "vtkShapeComposite.h"
#include "vtkShapeConvert.h"
#include "vtkShapeFiniteElements.h"
#include "vtkShapeGather.h"
#include "vtkShapeMeasures.h"
#include "vtkShapeSolid.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include "Atlas/SampleQuality.h"
#include "Base/Errors.h"
#include "Mesh/CellFaces.h"
#include "Mesh/Extent.h"
#include "Mesh/Topology.h"
#include "Quality/ScaledJacobian.h"
#include "Search/ClosestPoint.h"
#include "Untangle/FoldFreeMap.h"

#include <algorithm>
#include <cstddef>
#include <utility>

/// A data set of the input.
struct vtkShapeSynthesizedData::Block
{
  shape::CarriedModes Positions;
  shape::CellSimplices Cells;
  std::vector<int> Boundary; ///< the points whose distance from the sample is measured
  Eigen::MatrixXi Hexahedra; ///< m x 8, if all cells are hexahedra
  Eigen::VectorXi Regions;   ///< m, if they have the array RegionId
  bool CanUntangle = false;  ///< all cells are of the kinds that shape::Untangle moves
};

namespace
{

/// Returns the points of the faces that belong to one solid cell or, without solid cells, of all
/// surface cells (ascending).
std::vector<int> FindBoundaryPoints(const shape::Cells& cells)
{
  std::vector<int> points;
  const std::vector<shape::CellFace> faces = shape::SortFaces(cells);
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    if (shape::IsBoundaryFace(faces, i))
    {
      std::copy_if(faces[i].Points.begin(), faces[i].Points.end(), std::back_inserter(points),
        [](int point) { return point >= 0; });
    }
  }
  for (Eigen::Index cell = 0; cell < cells.Kinds.size() && faces.empty(); ++cell)
  {
    if (cells.Kinds(cell) > shape::cell_kind::Line && cells.Kinds(cell) != VTK_POLY_LINE)
    {
      points.insert(points.end(), cells.Corners.data() + cells.Offsets(cell),
        cells.Corners.data() + cells.Offsets(cell + 1));
    }
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

} // namespace

vtkShapeSynthesizedData::Block vtkShapeSynthesizedData::ReadBlock(
  const shape::FiniteElementMap& map, const vtkShapeAtlasShape& atlas, vtkDataSet* data,
  const shape::Progress& progress)
{
  const Eigen::MatrixXd points = vtkShapeConvert::ToPoints(data);
  shape::RequireFinite(points, "the Data");
  Block block;
  block.Positions = shape::CarryModes(map, points, progress.Part(0.0, 0.8));
  block.Cells = vtkShapeConvert::ToSimplices(data, "the Data", progress.Part(0.8, 0.9));
  vtkSmartPointer<vtkUnstructuredGrid> grid = vtkShapeGather::GatherGrid(data, nullptr);
  shape::Cells cells = vtkShapeConvert::ToCells(grid, "the Data");
  vtkShapeConvert::ReorderVoxels(cells);
  const auto count = [&](int kind) { return (cells.Kinds.array() == kind).count(); };
  const Eigen::Index all = cells.Kinds.size();
  using namespace shape::cell_kind;
  if (all > 0 && count(Hexahedron) == all && all == data->GetNumberOfCells())
  {
    block.Hexahedra = cells.Corners.reshaped<Eigen::RowMajor>(all, 8);
    if (data->GetCellData()->HasArray("RegionId"))
    {
      block.Regions = vtkShapeConvert::ToCellIntegers(
        data, "RegionId", "the Data", "number the regions, or rename this array");
    }
  }
  block.CanUntangle = all > 0 && all == data->GetNumberOfCells() &&
    count(Hexahedron) + count(Tetrahedron) + count(Wedge) + count(Pyramid) == all;
  const std::vector<int> boundary = FindBoundaryPoints(cells);
  const Eigen::VectorXd distances = shape::SurfaceLocator(atlas.Template)
                                      .Find(points(boundary, Eigen::all), progress.Part(0.9, 1.0))
                                      .Distances;
  const double near = shape::NearTemplate * shape::ComputeLongestBoxEdge(atlas.Template);
  for (std::size_t i = 0; i < boundary.size(); ++i)
  {
    if (distances(static_cast<Eigen::Index>(i)) <= near)
    {
      block.Boundary.push_back(boundary[i]);
    }
  }
  return block;
}

void vtkShapeSynthesizedData::Prepare(vtkShapeAlgorithm& filter, vtkPointSet* whole,
  const vtkShapeAtlasShape& atlas, const shape::SynthesizeOptions& options,
  const shape::Progress& progress)
{
  vtkMultiProcessController* controller = filter.GetController();
  const bool first = !controller || controller->GetLocalProcessId() == 0;
  const bool isNewAtlas = this->SeenAtlas.IsNew(filter, 0, whole);
  const bool isNewData = this->SeenData.IsNewHere(filter, 1);
  if (isNewAtlas || !this->Map || this->Tetrahedrons != options.Tetrahedra)
  {
    this->Map.reset();
    this->Blocks.clear();
    shape::FiniteElements elements;
    vtkShapeGather::RunOnAllOrFail(controller,
      [&]
      {
        shape::RequireClosedSurface(atlas.Template, "the Atlas, at its SourcePosition,");
        if (first)
        {
          elements =
            shape::SolveModes(atlas.Template, atlas.Images, options, progress.Part(0.0, 0.7));
        }
      });
    vtkShapeFiniteElements::Share(controller, elements);
    this->Map = std::make_unique<const shape::FiniteElementMap>(
      std::move(elements), progress.Part(0.7, 0.75, "preparing the map"));
    this->Tetrahedrons = options.Tetrahedra;
  }
  vtkDataObject* data = filter.GetInputDataObject(1, 0);
  const std::vector<vtkDataSet*> leaves = vtkShapeComposite::Of(data);
  if (isNewData || this->Blocks.size() != leaves.size())
  {
    this->Blocks.clear();
    std::vector<std::shared_ptr<const Block>> blocks;
    double done = 0.0;
    const double share =
      1.0 / std::max<vtkIdType>(1, data->GetNumberOfElements(vtkDataObject::POINT));
    for (vtkDataSet* leaf : leaves)
    {
      const double next = std::min(1.0, done + share * leaf->GetNumberOfPoints());
      blocks.push_back(std::make_shared<const Block>(ReadBlock(*this->Map, atlas, leaf,
        progress.Part(0.75 + 0.25 * done, 0.75 + 0.25 * next, "moving the points by each mode"))));
      done = next;
    }
    this->Blocks = std::move(blocks);
  }
  progress(1.0);
}

double vtkShapeSynthesizedData::TemplateDistance() const
{
  double largest = 0.0;
  for (const auto& block : this->Blocks)
  {
    largest = std::max(largest, block->Positions.Distances.maxCoeff());
  }
  return largest;
}

double vtkShapeSynthesizedData::Tetrahedra() const
{
  return static_cast<double>(this->Map->Elements().Tetrahedra.rows());
}

namespace
{

void SetPositions(const Eigen::MatrixXd& positions, vtkPointSet* output)
{
  vtkNew<vtkPoints> points;
  points->SetData(vtkShapeConvert::ToArray(positions, "Points"));
  output->SetPoints(points);
}

/// Untangles a block of solid cells. Returns the marks of the cells that stay inverted.
Eigen::VectorXi UntangleBlock(const shape::Surface& surface, const shape::Surface& sample,
  vtkDataSet* given, vtkPointSet* moved, const shape::Progress& progress)
{
  const shape::Cells domain =
    vtkShapeSolid::Read(vtkShapeGather::GatherGrid(given, nullptr), "the Data");
  const shape::UntangleResult result = shape::ComputeFoldFreeMap(
    domain, vtkShapeConvert::ToPoints(moved), surface, sample.Points(), progress);
  auto* grid = vtkUnstructuredGrid::SafeDownCast(moved);
  if (grid && result.SplitCells > 0)
  {
    vtkNew<vtkUnstructuredGrid> carried;
    carried->ShallowCopy(grid);
    grid->Initialize();
    vtkShapeSolid::Write(result, carried, domain.Points, grid);
  }
  else
  {
    SetPositions(result.Solid.Points, moved);
  }
  return result.Inverted;
}

void RaiseQuality(const Eigen::MatrixXi& hexahedra, const Eigen::VectorXi& regions,
  const shape::Surface& sample, double wanted, vtkPointSet* moved, const shape::Progress& progress)
{
  const Eigen::MatrixXd before = vtkShapeConvert::ToPoints(moved);
  shape::HexMesh solid{ before, hexahedra };
  shape::RaiseSampleQuality(solid, regions, sample, wanted, progress);
  if (solid.Points != before)
  {
    SetPositions(solid.Points, moved);
  }
}

/// Adds the scaled Jacobians to hexahedra, and returns the minimum. Other quality arrays of the
/// input are removed: computing all of them takes five times as long as everything else. The kernel
/// is used, since Verdict takes as long as all other steps of a move of a slider.
double AddScaledJacobians(const Eigen::MatrixXi& hexahedra, vtkPointSet* moved)
{
  vtkCellData* data = moved->GetCellData();
  for (const std::string& name : vtkShapeMeasures::NamesOfHexahedra())
  {
    vtkDataArray* array = data->GetArray(name.c_str());
    // Integers with these names are the user's own.
    if (array && (array->GetDataType() == VTK_DOUBLE || array->GetDataType() == VTK_FLOAT))
    {
      data->RemoveArray(name.c_str());
    }
  }
  const Eigen::VectorXd values =
    shape::ComputeScaledJacobians({ vtkShapeConvert::ToPoints(moved), hexahedra });
  data->AddArray(vtkShapeConvert::ToArray(values, "ScaledJacobian"));
  return values.minCoeff();
}

} // namespace

void vtkShapeSynthesizedData::Check(const Block& block, const vtkShapeAtlasShape& atlas,
  const shape::Surface& sample, const shape::SynthesizeOptions& options, vtkDataSet* given,
  vtkPointSet* moved, Result& result, const shape::Progress& progress)
{
  int left = 0;
  if (!block.Cells.Corners.empty())
  {
    Eigen::VectorXi inverted = shape::FindInvertedCells(
      block.Cells, vtkShapeConvert::ToPoints(given), vtkShapeConvert::ToPoints(moved));
    // Cells of another process are counted there.
    vtkUnsignedCharArray* ghosts = given->GetCellGhostArray();
    for (Eigen::Index cell = 0; ghosts && cell < inverted.size(); ++cell)
    {
      inverted(cell) = ghosts->GetValue(cell) == 0 ? inverted(cell) : 0;
    }
    const int before = inverted.sum();
    if (before > 0 && options.Untangle && block.CanUntangle)
    {
      inverted = UntangleBlock(atlas.Template, sample, given, moved,
        progress.Part(0.1, 0.5, "untangling the inverted cells"));
    }
    else if (before > 0 && options.Untangle)
    {
      result.NotUntangled += before;
    }
    left = inverted.sum();
    result.InvertedBefore += before;
    result.InvertedAfter += left;
    moved->GetCellData()->AddArray(vtkShapeConvert::ToIntegers(inverted, "Inverted"));
  }
  progress(0.5);
  if (block.Hexahedra.rows() > 0)
  {
    if (left == 0)
    {
      RaiseQuality(block.Hexahedra, block.Regions, sample, options.WantedScaledJacobian, moved,
        progress.Part(0.5, 0.9, "improving the worst hexahedra"));
    }
    const double minimum = AddScaledJacobians(block.Hexahedra, moved);
    result.MinimumScaledJacobian = std::min(result.MinimumScaledJacobian, minimum);
    ++result.Hexahedra;
  }
  progress(0.9);
  if (!block.Boundary.empty())
  {
    const Eigen::MatrixXd positions = vtkShapeConvert::ToPoints(moved);
    result.BoundaryPoints += static_cast<double>(block.Boundary.size());
    result.BoundaryDistance = std::max(result.BoundaryDistance,
      shape::SurfaceLocator(sample).FindLargestDistance(positions(block.Boundary, Eigen::all)));
  }
  progress(1.0);
}

vtkShapeSynthesizedData::Result vtkShapeSynthesizedData::Move(vtkShapeAlgorithm& filter,
  const vtkShapeAtlasShape& atlas, const shape::Surface& sample, const Eigen::VectorXd& weights,
  const shape::SynthesizeOptions& options, const shape::Progress& progress)
{
  vtkDataObject* data = filter.GetInputDataObject(1, 0);
  vtkDataObject* moved = filter.GetOutputDataObject(1);
  Result result;
  std::size_t next = 0;
  const auto position = [&](const Eigen::MatrixXd&, const shape::Progress&)
  {
    const shape::CarriedModes& modes = this->Blocks[next++]->Positions;
    return shape::MovedPoints{ shape::Synthesize(modes, weights), modes.OutsideDomain };
  };
  result.Outside =
    vtkShapeChargeSet::Move(data, moved, position, progress.Part(0.0, 0.2, "moving the points"))[0];
  const std::vector<vtkDataSet*> given = vtkShapeComposite::Of(data);
  const std::vector<vtkDataSet*> outputs = vtkShapeComposite::Of(moved);
  for (std::size_t i = 0; i < outputs.size(); ++i)
  {
    const double share = 0.8 / static_cast<double>(outputs.size());
    const double begin = 0.2 + share * static_cast<double>(i);
    Check(*this->Blocks[i], atlas, sample, options, given[i], vtkPointSet::SafeDownCast(outputs[i]),
      result, progress.Part(begin, begin + share, "checking the cells"));
  }
  return result;
}
