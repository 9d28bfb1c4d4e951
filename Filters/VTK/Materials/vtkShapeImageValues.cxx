#include "vtkShapeImageValues.h"

#include "vtkShapeComposite.h"
#include "vtkShapeConvert.h"
#include "vtkShapeExpression.h"
#include "vtkShapeGather.h"
#include "vtkShapeOwnCells.h"
#include "vtkShapeVoxelImage.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include "Base/Errors.h"
#include "Materials/BoundaryVoxels.h"
#include "Materials/MaterialBins.h"
#include "Mesh/Topology.h"

#include <algorithm>
#include <limits>

using vtkShapeGather::Reduction;

vtkStandardNewMacro(vtkShapeImageValues);

vtkShapeImageValues::vtkShapeImageValues()
{
  this->DeclareInput("Input", PortData::Pieces, PortUse::Required, { "vtkUnstructuredGrid" });
  this->DeclareInput("Image", PortData::Pieces, PortUse::Required, { "vtkImageData" });
  this->DeclareOutputLikeInput();
  this->DeclareOutput("vtkTable");
  this->DeclareFacts();
}

/// What a run reads and computes.
struct vtkShapeImageValues::Run
{
  struct Block
  {
    vtkDataSet* Output;
    shape::Cells Cells;
    Eigen::VectorXi Own;
    shape::ImageValuesResult Values;
  };
  std::vector<Block> Blocks;
  vtkShapeVoxelImage::Result Image;
  shape::MaterialLaws Laws;
  shape::BoundaryVoxels Boundary;
  shape::Materials Materials;
};

void vtkShapeImageValues::ReadInputs(Run& run)
{
  vtkShapeGather::RunOnAllOrFail(this->GetController(),
    [&]
    {
      vtkShapeComposite::ForEach(this->GetInputDataObject(0, 0), this->GetOutputDataObject(0),
        vtkShapeComposite::Points::Kept,
        [&](vtkDataSet* from, vtkDataSet* to)
        {
          auto* grid = vtkUnstructuredGrid::SafeDownCast(from);
          if (!grid)
          {
            throw shape::InvalidInput(std::string("the Input contains ") + from->GetClassName() +
              ", which has no solid cells of its own; fill a surface with Shape Tetrahedralize");
          }
          to->ShallowCopy(from);
          shape::Cells cells = vtkShapeConvert::ToCells(grid, "the Input");
          vtkShapeConvert::ReorderVoxels(cells);
          shape::RequireFinite(cells.Points, "the Input");
          run.Blocks.push_back({ to, std::move(cells), vtkShapeOwnCells::Find(from), {} });
        });
    });
  double count = 0.0;
  std::vector<const Eigen::MatrixXd*> points;
  for (const Run::Block& block : run.Blocks)
  {
    points.push_back(&block.Cells.Points);
    count += static_cast<double>(block.Own.size());
  }
  vtkShapeGather::Reduce(this->GetController(), &count, 1, Reduction::Sum);
  if (count == 0.0)
  {
    throw shape::InvalidInput("the Input has no cells; connect a mesh of solid cells");
  }
  run.Image =
    vtkShapeVoxelImage::Read(this->GetInputDataObject(1, 0), points, this->GetController());
}

namespace
{

/// The array that the density is computed from: the named one, or the active one, or the first.
const vtkShapeVoxelImage::Array& FindArray(
  const std::vector<vtkShapeVoxelImage::Array>& arrays, const std::string& name)
{
  const vtkShapeVoxelImage::Array* found = name.empty() ? &arrays.front() : nullptr;
  std::string present;
  for (const vtkShapeVoxelImage::Array& array : arrays)
  {
    found = (name.empty() ? array.AreScalars : array.Name == name) ? &array : found;
    present += (present.empty() ? "" : ", ") + array.Name;
  }
  if (!found)
  {
    throw shape::InvalidInput("the Image has no point array '" + name +
      "'; choose another Image Array (present: " + present + ")");
  }
  if (found->Components != 1)
  {
    throw shape::InvalidInput("the Image Array '" + found->Name + "' has " +
      std::to_string(found->Components) + " components, not 1; choose another one");
  }
  return *found;
}

} // namespace

void vtkShapeImageValues::MakeLaws(Run& run, const shape::Progress& progress)
{
  if (this->Density.find_first_not_of(" \t\n") == std::string::npos)
  {
    return;
  }
  const vtkShapeVoxelImage::Array& array = FindArray(run.Image.Arrays, this->ImageArray);
  const shape::VoxelImage& image = run.Image.Image;
  run.Laws.Values = image.Channels[array.FirstChannel];
  run.Laws.Density = vtkShapeExpression::Parse(this->Density, { "Value", array.Name }, "Density");
  run.Laws.Modulus = vtkShapeExpression::Parse(this->ModulusLaw, { "Density" }, "Modulus Law");
  std::vector<double> shares(image.Count(), 0.0);
  vtkShapeGather::RunOnAllOrFail(this->GetController(),
    [&]
    {
      shape::RequireVoxelImage(image);
      for (std::size_t i = 0; i < run.Blocks.size() && this->Options.BoundaryLayers > 0; ++i)
      {
        const Run::Block& block = run.Blocks[i];
        const double begin = 0.8 * i / run.Blocks.size(), end = 0.8 * (i + 1) / run.Blocks.size();
        shape::AddVoxelShares(block.Cells, block.Own, image, shares, progress.Part(begin, end));
      }
    });
  vtkShapeGather::Reduce(
    this->GetController(), shares.data(), static_cast<int>(shares.size()), Reduction::Sum);
  run.Boundary = shape::ExtrapolateToBoundary(
    image, shares, this->Options.BoundaryLayers, run.Laws.Values, progress.Part(0.8, 1.0));
}

namespace
{

void AddColumns(vtkDataSet* output, const vtkShapeVoxelImage::Result& image,
  const shape::ImageValuesResult& values)
{
  vtkCellData* cells = output->GetCellData();
  for (const vtkShapeVoxelImage::Array& array : image.Arrays)
  {
    cells->AddArray(vtkShapeConvert::ToArray(
      values.Means.middleCols(array.FirstChannel, array.Components), array.Name));
  }
  cells->AddArray(vtkShapeConvert::ToArray(values.Coverage, "Coverage"));
  if (!cells->HasArray("RegionId"))
  {
    // Otherwise, the window would offer the active array as the regions of a file.
    const Eigen::VectorXi regions = Eigen::VectorXi::Zero(values.Coverage.size());
    cells->AddArray(vtkShapeConvert::ToIntegers(regions, "RegionId"));
  }
  if (values.Modulus.size() > 0)
  {
    cells->AddArray(vtkShapeConvert::ToArray(values.Density, "Density"));
    cells->AddArray(vtkShapeConvert::ToArray(values.Modulus, "Modulus"));
  }
}

} // namespace

void vtkShapeImageValues::MakeMaterials(Run& run)
{
  // The minimum of the modulus, and of its negative.
  double range[2] = { std::numeric_limits<double>::max(), std::numeric_limits<double>::max() };
  for (const Run::Block& block : run.Blocks)
  {
    if (block.Values.Modulus.size() > 0)
    {
      range[0] = std::min(range[0], block.Values.Modulus.minCoeff());
      range[1] = std::min(range[1], -block.Values.Modulus.maxCoeff());
    }
  }
  vtkShapeGather::Reduce(this->GetController(), range, 2, Reduction::Minimum);
  shape::MaterialBins bins(range[0], -range[1], this->Options.Materials);
  for (const Run::Block& block : run.Blocks)
  {
    const shape::ImageValuesResult& values = block.Values;
    bins.Add(values.Modulus, values.Density, values.Volumes, block.Own);
  }
  vtkShapeGather::Reduce(
    this->GetController(), bins.Sums.data(), static_cast<int>(bins.Sums.size()), Reduction::Sum);
  run.Materials = shape::FindMaterials(bins);
  for (const Run::Block& block : run.Blocks)
  {
    Eigen::VectorXi ids(block.Values.Modulus.size());
    for (Eigen::Index cell = 0; cell < ids.size(); ++cell)
    {
      // A hidden cell may be alone in its bin.
      ids(cell) = std::max(0, run.Materials.OfBin(bins.FindBin(block.Values.Modulus(cell))));
    }
    vtkCellData* cells = block.Output->GetCellData();
    cells->AddArray(vtkShapeConvert::ToIntegers(ids, "MaterialId"));
    cells->AddArray(
      vtkShapeConvert::ToArray(run.Materials.Density(ids, Eigen::all), "MaterialDensity"));
    cells->AddArray(
      vtkShapeConvert::ToArray(run.Materials.Modulus(ids, Eigen::all), "MaterialModulus"));
  }
}

namespace
{

void WriteTable(const shape::Materials& materials, vtkTable* table)
{
  const auto count = static_cast<int>(materials.Modulus.size());
  table->AddColumn(
    vtkShapeConvert::ToIntegers(Eigen::VectorXi::LinSpaced(count, 0, count - 1), "Id"));
  table->AddColumn(vtkShapeConvert::ToArray(materials.Modulus, "Modulus"));
  table->AddColumn(vtkShapeConvert::ToArray(materials.Density, "Density"));
  table->AddColumn(vtkShapeConvert::ToArray(materials.Volume, "Volume"));
  table->AddColumn(vtkShapeConvert::ToArray(materials.Cells, "Cells"));
}

} // namespace

void vtkShapeImageValues::WriteFacts(const Run& run)
{
  Eigen::Vector4d sums = Eigen::Vector4d::Zero(); // cells, volume, cells outside and partly outside
  for (const Run::Block& block : run.Blocks)
  {
    for (Eigen::Index cell = 0; cell < block.Own.size(); ++cell)
    {
      const double coverage = block.Values.Coverage(cell);
      sums += block.Own(cell) *
        Eigen::Vector4d(1.0, block.Values.Volumes(cell), coverage == 0.0,
          coverage > 0.0 && coverage < 1.0 - 1e-9);
    }
  }
  vtkShapeGather::Reduce(this->GetController(), sums.data(), 4, Reduction::Sum);
  std::vector<std::pair<const char*, double>> facts = { { "Cells", sums(0) }, { "Volume", sums(1) },
    { "CellsOutside", sums(2) }, { "CellsPartlyOutside", sums(3) } };
  const shape::Materials& materials = run.Materials;
  if (materials.Modulus.size() > 0)
  {
    facts.insert(facts.end(),
      { { "Mass", materials.Density.dot(materials.Volume) },
        { "Stiffness", materials.Modulus.dot(materials.Volume) },
        { "Materials", static_cast<double>(materials.Modulus.size()) },
        { "BoundaryVoxels", run.Boundary.Boundary }, { "RaisedVoxels", run.Boundary.Raised },
        { "UnresolvedVoxels", run.Boundary.Unresolved } });
  }
  for (const auto& [fact, value] : facts)
  {
    vtkShapeConvert::AddFact(
      this->GetOutputDataObject(0), std::string("ImageValues.") + fact, value);
  }
  if (sums(2) > 0.0)
  {
    this->Warn(std::to_string(static_cast<long long>(sums(2))) +
      " cells lie outside of the Image, and their means are 0; see Coverage");
  }
}

// 1. Read the cells of this process, and the image around the cells of all processes.
// 2. Extrapolate the values that the density is computed from to the boundary of the mesh.
// 3. Average the image and the laws over each cell.
// 4. Divide the cells of all processes into materials.
void vtkShapeImageValues::Execute(const shape::Progress& progress)
{
  Run run;
  shape::RequireInRange(this->Options); // before the layers are extrapolated
  this->ReadInputs(run);
  progress(0.1);
  this->MakeLaws(run, progress.Part(0.1, 0.4, "finding the voxels at the boundary"));
  vtkShapeGather::RunOnAllOrFail(this->GetController(),
    [&]
    {
      const double share = 0.55 / std::max<std::size_t>(1, run.Blocks.size());
      double begin = 0.4;
      for (Run::Block& block : run.Blocks)
      {
        block.Values = shape::ComputeImageValues(block.Cells, run.Image.Image, run.Laws,
          this->Options, progress.Part(begin, begin + share, "averaging within the cells"));
        begin += share;
      }
    });
  const bool hasMaterials = !run.Laws.Values.empty();
  for (const Run::Block& block : run.Blocks)
  {
    AddColumns(block.Output, run.Image, block.Values);
  }
  if (hasMaterials)
  {
    this->MakeMaterials(run);
    if (!this->GetController() || this->GetController()->GetLocalProcessId() == 0)
    {
      WriteTable(run.Materials, vtkTable::SafeDownCast(this->GetOutputDataObject(1)));
    }
  }
  const std::string& shown = run.Image.Arrays.front().Name;
  this->DeclareShown(0, { hasMaterials ? "Modulus" : shown });
  this->WriteFacts(run);
  progress(1.0);
}
