#include "vtkShapeImagePieces.h"

#include "vtkShapeGather.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkSmartPointer.h"

#include "Base/Errors.h"

#include <algorithm>
#include <limits>

namespace
{

/// Where the samples of a piece lie: origin, axes and whether they are centres of cells.
std::array<double, 13> LayoutOf(const vtkShapeImagePieces::Piece& piece)
{
  std::array<double, 13> layout;
  piece.Image->GetOrigin(layout.data());
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      layout[3 + 3 * row + column] = piece.Image->GetDirectionMatrix()->GetElement(row, column) *
        piece.Image->GetSpacing()[column];
    }
  }
  layout[12] = piece.IsAtCells;
  return layout;
}

} // namespace

std::vector<vtkImageData*> vtkShapeImagePieces::Find(vtkDataObject* input, const std::string& name)
{
  std::vector<vtkImageData*> images;
  const auto add = [&](vtkDataObject* block)
  {
    auto* image = vtkImageData::SafeDownCast(block);
    auto* dataSet = vtkDataSet::SafeDownCast(block);
    const bool isEmpty = dataSet && dataSet->GetNumberOfPoints() == 0;
    if (!image && !isEmpty)
    {
      throw shape::InvalidInput(name + " contains " + block->GetClassName() +
        "; extract the image, or resample the data with Resample To Image");
    }
    if (!isEmpty)
    {
      images.push_back(image);
    }
  };
  auto* composite = vtkCompositeDataSet::SafeDownCast(input);
  if (!composite)
  {
    add(input);
    return images;
  }
  vtkSmartPointer<vtkCompositeDataIterator> it;
  it.TakeReference(composite->NewIterator());
  for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
  {
    add(it->GetCurrentDataObject());
  }
  return images;
}

std::array<int, 6> vtkShapeImagePieces::FindExtent(const Piece& piece)
{
  std::array<int, 6> extent;
  piece.Image->GetExtent(extent.data());
  for (int axis = 0; piece.IsAtCells && axis < 3; ++axis)
  {
    if (extent[2 * axis + 1] == extent[2 * axis])
    {
      throw shape::InvalidInput(
        "the image is flat and its array is at cells; choose an array at points");
    }
    --extent[2 * axis + 1];
  }
  return extent;
}

vtkShapeImagePieces::Grid vtkShapeImagePieces::FindGrid(
  const std::vector<Piece>& pieces, const std::string& name, vtkMultiProcessController* controller)
{
  using Reduction = vtkShapeGather::Reduction;
  // The maxima of the layouts and of their negatives; the minima of the extents, the last indices
  // of which are negative.
  std::array<double, 26> layouts;
  layouts.fill(std::numeric_limits<double>::lowest());
  std::array<double, 6> extent;
  extent.fill(std::numeric_limits<double>::max());
  vtkShapeGather::RunOnAllOrFail(controller,
    [&]()
    {
      for (const Piece& piece : pieces)
      {
        const std::array<double, 13> layout = LayoutOf(piece);
        for (int i = 0; i < 13; ++i)
        {
          layouts[i] = std::max(layouts[i], layout[i]);
          layouts[13 + i] = std::max(layouts[13 + i], -layout[i]);
        }
        const std::array<int, 6> own = FindExtent(piece);
        for (int i = 0; i < 6; ++i)
        {
          extent[i] = std::min(extent[i], static_cast<double>(i % 2 == 0 ? own[i] : -own[i]));
        }
      }
    });
  vtkShapeGather::Reduce(controller, layouts.data(), 26, Reduction::Maximum);
  vtkShapeGather::Reduce(controller, extent.data(), 6, Reduction::Minimum);
  if (extent[0] == std::numeric_limits<double>::max())
  {
    throw shape::InvalidInput(name + " has no voxels; choose an image with points");
  }
  for (int i = 0; i < 13; ++i)
  {
    if (layouts[i] != -layouts[13 + i])
    {
      throw shape::InvalidInput(name +
        " has images with different origins, spacings or directions; extract one of them with "
        "Extract Block");
    }
  }
  Grid grid;
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      grid.Axes(row, column) = layouts[3 + 3 * row + column];
    }
  }
  grid.Origin = Eigen::RowVector3d(layouts[0], layouts[1], layouts[2]) +
    0.5 * layouts[12] * Eigen::RowVector3d::Ones() * grid.Axes.transpose();
  for (int i = 0; i < 6; ++i)
  {
    grid.Extent[i] = static_cast<int>(i % 2 == 0 ? extent[i] : -extent[i]);
  }
  return grid;
}
