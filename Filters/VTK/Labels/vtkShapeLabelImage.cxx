#include "vtkShapeLabelImage.h"

#include "vtkShapeGather.h"
#include "vtkShapeImagePieces.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include "Base/Errors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

namespace
{

using vtkShapeImagePieces::Piece;

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

std::string NameOf(vtkDataArray* array)
{
  return array->GetName() ? array->GetName() : "(unnamed)";
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

/// A piece and its array.
struct LabelledPiece : Piece
{
  vtkDataArray* Values;
};

std::vector<LabelledPiece> FindPieces(
  vtkDataObject* input, const std::string& array, const std::string& name)
{
  std::vector<LabelledPiece> pieces;
  for (vtkImageData* image : vtkShapeImagePieces::Find(input, name))
  {
    LabelledPiece piece{ { image, false }, nullptr };
    piece.Values = FindArray(image, array, piece.IsAtCells);
    if (!piece.Values)
    {
      throw shape::InvalidInput(name + " has no array '" + array +
        "'; choose the array with the labels" + ListArrays(image));
    }
    if (piece.Values->GetNumberOfComponents() != 1)
    {
      throw shape::InvalidInput("the array '" + NameOf(piece.Values) + "' has " +
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
    throw shape::InvalidInput(name(6) +
      ", which is no label; choose an array of integers, or set Thresholds of Shape Label "
      "Surfaces");
  }
  if (std::abs(value) > std::numeric_limits<int>::max())
  {
    throw shape::InvalidInput(name(20) +
      ", but labels are from -2147483647 to 2147483647; give the regions smaller numbers");
  }
}

} // namespace

shape::LabelImage vtkShapeLabelImage::Read(vtkDataObject* input, const std::string& array,
  const std::vector<double>& thresholds, vtkMultiProcessController* controller,
  const std::string& name)
{
  using Reduction = vtkShapeGather::Reduction;
  constexpr double none = std::numeric_limits<double>::lowest();
  std::vector<LabelledPiece> pieces;
  vtkShapeGather::RunOnAllOrFail(controller, [&]() { pieces = FindPieces(input, array, name); });
  const vtkShapeImagePieces::Grid grid =
    vtkShapeImagePieces::FindGrid({ pieces.begin(), pieces.end() }, name, controller);
  shape::LabelImage image;
  Eigen::RowVector3d first;
  for (int axis = 0; axis < 3; ++axis)
  {
    first(axis) = grid.Extent[2 * axis];
    image.Size[axis] = grid.Extent[2 * axis + 1] - grid.Extent[2 * axis] + 1;
  }
  const double samples = static_cast<double>(image.Size[0]) * image.Size[1] * image.Size[2];
  if (samples > std::numeric_limits<int>::max())
  {
    throw shape::InvalidInput("the image has more than 2,147,483,647 voxels; extract a part of it, "
                              "or resample it to fewer");
  }
  image.Axes = grid.Axes;
  image.Origin = grid.Origin + first * grid.Axes.transpose();

  std::vector<double> values(static_cast<std::size_t>(samples), none);
  vtkShapeGather::RunOnAllOrFail(controller,
    [&]()
    {
      for (const LabelledPiece& piece : pieces)
      {
        const std::array<int, 6> own = vtkShapeImagePieces::FindExtent(piece);
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
                RequireLabel(value, NameOf(piece.Values));
              }
              double& known =
                values[image.IndexOf(i - grid.Extent[0], j - grid.Extent[2], k - grid.Extent[4])];
              if (known != none && known != value)
              {
                throw shape::InvalidInput(name +
                  " has images that overlap with different values; extract one of them with "
                  "Extract Block");
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
