#include "vtkShapeLabelImage.h"

#include "vtkShapeGather.h"

#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include "Base/Errors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

namespace
{

/// An image of this process, and its array.
struct Piece
{
  vtkImageData* Image;
  vtkDataArray* Values;
  bool IsAtCells;
};

/// Returns the array, and whether it is at cells; nullptr if there is none.
vtkDataArray* FindArray(vtkImageData* image, const std::string& name, bool& isAtCells)
{
  vtkDataSetAttributes* const kinds[] = { image->GetPointData(), image->GetCellData() };
  for (int kind = 0; kind < 2; ++kind)
  {
    vtkDataArray* values =
      name.empty() ? kinds[kind]->GetScalars() : kinds[kind]->GetArray(name.c_str());
    if (values)
    {
      isAtCells = kind == 1;
      return values;
    }
  }
  return nullptr;
}

std::string ListArrays(vtkImageData* image)
{
  std::string present;
  for (vtkDataSetAttributes* kind : { static_cast<vtkDataSetAttributes*>(image->GetPointData()),
         static_cast<vtkDataSetAttributes*>(image->GetCellData()) })
  {
    for (int i = 0; i < kind->GetNumberOfArrays(); ++i)
    {
      const char* name = kind->GetArrayName(i);
      present += (present.empty() ? "" : ", ") + std::string(name ? name : "(unnamed)");
    }
  }
  return present.empty() ? "" : " (present: " + present + ")";
}

/// Returns the blocks that are not empty, or the input itself.
std::vector<vtkDataObject*> FindBlocks(vtkDataObject* input)
{
  std::vector<vtkDataObject*> blocks;
  const auto add = [&](vtkDataObject* block)
  {
    auto* dataSet = vtkDataSet::SafeDownCast(block);
    if (!dataSet || dataSet->GetNumberOfPoints() > 0)
    {
      blocks.push_back(block);
    }
  };
  auto* composite = vtkCompositeDataSet::SafeDownCast(input);
  if (!composite)
  {
    add(input);
    return blocks;
  }
  vtkSmartPointer<vtkCompositeDataIterator> it;
  it.TakeReference(composite->NewIterator());
  for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
  {
    add(it->GetCurrentDataObject());
  }
  return blocks;
}

std::vector<Piece> FindPieces(
  vtkDataObject* input, const std::string& array, const std::string& name)
{
  std::vector<Piece> pieces;
  for (vtkDataObject* block : FindBlocks(input))
  {
    auto* image = vtkImageData::SafeDownCast(block);
    if (!image)
    {
      throw shape::InvalidInput(name + " contains " + block->GetClassName() +
        "; extract the image, or resample the data with Resample To Image");
    }
    Piece piece = { image, nullptr, false };
    piece.Values = FindArray(image, array, piece.IsAtCells);
    if (!piece.Values)
    {
      throw shape::InvalidInput(name + " has no array '" + array +
        "'; choose the array with the labels" + ListArrays(image));
    }
    if (piece.Values->GetNumberOfComponents() != 1)
    {
      throw shape::InvalidInput("the array '" + array + "' has " +
        std::to_string(piece.Values->GetNumberOfComponents()) +
        " components, not 1; choose another array");
    }
    pieces.push_back(piece);
  }
  return pieces;
}

void RequireLabel(double value, const std::string& array)
{
  const auto name = [&](int digits)
  {
    std::ostringstream words;
    words << "the array '" << array << "' has the value " << std::setprecision(digits) << value;
    return words.str();
  };
  if (value != std::round(value) || std::isinf(value))
  {
    throw shape::InvalidInput(
      name(6) + ", which is no label; choose an array of integers, or set Thresholds");
  }
  if (std::abs(value) > std::numeric_limits<int>::max())
  {
    throw shape::InvalidInput(name(20) +
      ", but labels are from -2147483647 to 2147483647; give the regions smaller numbers");
  }
}

/// The range of the samples of a piece: of its points or its cells.
std::array<int, 6> ExtentOf(const Piece& piece)
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

/// Where the samples of an image lie: origin, axes and whether they are centres of cells.
std::array<double, 13> LayoutOf(const Piece& piece)
{
  std::array<double, 13> layout;
  piece.Image->GetOrigin(layout.data());
  const double* spacing = piece.Image->GetSpacing();
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      layout[3 + 3 * row + column] =
        piece.Image->GetDirectionMatrix()->GetElement(row, column) * spacing[column];
    }
  }
  layout[12] = piece.IsAtCells;
  return layout;
}

} // namespace

shape::LabelImage vtkShapeLabelImage::Read(vtkDataObject* input, const std::string& array,
  const std::vector<double>& thresholds, vtkMultiProcessController* controller,
  const std::string& name)
{
  using Reduction = vtkShapeGather::Reduction;
  constexpr double none = std::numeric_limits<double>::lowest();
  std::vector<Piece> pieces;
  // The minimum and, negated, the maximum of the extents; the maximum and minimum of the layouts.
  std::array<double, 6> extent;
  extent.fill(std::numeric_limits<double>::max());
  std::array<double, 26> layouts;
  layouts.fill(none);
  vtkShapeGather::RunOnAllOrFail(controller,
    [&]()
    {
      pieces = FindPieces(input, array, name);
      for (const Piece& piece : pieces)
      {
        const std::array<int, 6> own = ExtentOf(piece);
        const std::array<double, 13> layout = LayoutOf(piece);
        for (int i = 0; i < 6; ++i)
        {
          extent[i] = std::min(extent[i], static_cast<double>(i % 2 == 0 ? own[i] : -own[i]));
        }
        for (int i = 0; i < 13; ++i)
        {
          layouts[i] = std::max(layouts[i], layout[i]);
          layouts[13 + i] = std::max(layouts[13 + i], -layout[i]);
        }
      }
    });
  vtkShapeGather::Reduce(controller, extent.data(), 6, Reduction::Minimum);
  vtkShapeGather::Reduce(controller, layouts.data(), 26, Reduction::Maximum);
  if (extent[0] == std::numeric_limits<double>::max())
  {
    throw shape::InvalidInput(name + " has no voxels; choose an image with points");
  }
  for (int i = 0; i < 13; ++i)
  {
    if (layouts[i] != -layouts[13 + i])
    {
      throw shape::InvalidInput(name +
        " has images with different origins, spacings or "
        "directions; extract one of them");
    }
  }

  shape::LabelImage image;
  std::array<int, 3> first;
  for (int axis = 0; axis < 3; ++axis)
  {
    first[axis] = static_cast<int>(extent[2 * axis]);
    image.Size[axis] = static_cast<int>(-extent[2 * axis + 1]) - first[axis] + 1;
  }
  const double samples = static_cast<double>(image.Size[0]) * image.Size[1] * image.Size[2];
  if (samples > std::numeric_limits<int>::max())
  {
    throw shape::InvalidInput("the image has more than 2,147,483,647 voxels; extract a part of it, "
                              "or resample it to fewer");
  }
  Eigen::RowVector3d start;
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      image.Axes(row, column) = layouts[3 + 3 * row + column];
    }
    start(row) = first[row] + 0.5 * layouts[12];
  }
  image.Origin =
    Eigen::RowVector3d(layouts[0], layouts[1], layouts[2]) + start * image.Axes.transpose();

  std::vector<double> values(static_cast<std::size_t>(samples), none);
  vtkShapeGather::RunOnAllOrFail(controller,
    [&]()
    {
      for (const Piece& piece : pieces)
      {
        const std::array<int, 6> own = ExtentOf(piece);
        vtkIdType next = 0;
        for (int k = own[4]; k <= own[5]; ++k)
        {
          for (int j = own[2]; j <= own[3]; ++j)
          {
            for (int i = own[0]; i <= own[1]; ++i)
            {
              const double value = piece.Values->GetComponent(next++, 0);
              if (thresholds.empty())
              {
                RequireLabel(value, array);
              }
              double& known = values[image.IndexOf(i - first[0], j - first[1], k - first[2])];
              if (known != none && known != value)
              {
                throw shape::InvalidInput(name +
                  " has images that overlap with different "
                  "values; extract one of them with Extract Block");
              }
              known = value;
            }
          }
        }
      }
    });
  vtkShapeGather::Reduce(
    controller, values.data(), static_cast<int>(values.size()), Reduction::Maximum);
  if (!thresholds.empty())
  {
    image.Values.assign(values.begin(), values.end());
    shape::MakeLabels(image, thresholds);
    return image;
  }
  image.Labels.resize(values.size());
  std::transform(values.begin(), values.end(), image.Labels.begin(),
    [&](double value) { return value == none ? 0 : static_cast<int>(value); });
  return image;
}
