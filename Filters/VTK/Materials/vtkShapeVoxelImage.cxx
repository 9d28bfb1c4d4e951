#include "vtkShapeVoxelImage.h"

#include "vtkShapeGather.h"
#include "vtkShapeImagePieces.h"

#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include "Base/Errors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace
{

using vtkShapeGather::Reduction;

constexpr double None = std::numeric_limits<double>::lowest();

/// The numeric point arrays that all pieces of all processes have.
std::vector<vtkShapeVoxelImage::Array> FindArrays(
  const std::vector<vtkImageData*>& images, vtkMultiProcessController* controller)
{
  // A point for each process with the arrays of its image, which are gathered.
  vtkNew<vtkUnstructuredGrid> names;
  if (!images.empty())
  {
    vtkNew<vtkPoints> points;
    points->InsertNextPoint(0.0, 0.0, 0.0);
    names->SetPoints(points);
    const vtkIdType point = 0;
    names->InsertNextCell(VTK_VERTEX, 1, &point);
    vtkPointData* of = images.front()->GetPointData();
    for (int i = 0; i < of->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = of->GetArray(i);
      if (array && array->GetName() && array != images.front()->GetPointGhostArray())
      {
        vtkSmartPointer<vtkDataArray> one;
        one.TakeReference(array->NewInstance());
        one->SetName(array->GetName());
        one->SetNumberOfComponents(array->GetNumberOfComponents());
        one->SetNumberOfTuples(1);
        one->Fill(array == of->GetScalars() ? 1.0 : 0.0);
        names->GetPointData()->AddArray(one);
      }
    }
  }
  const vtkSmartPointer<vtkUnstructuredGrid> all = vtkShapeGather::GatherGrid(names, controller);
  std::vector<vtkShapeVoxelImage::Array> arrays;
  int channel = 0;
  for (int i = 0; i < all->GetPointData()->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = all->GetPointData()->GetArray(i);
    const int components = array->GetNumberOfComponents();
    arrays.push_back({ array->GetName(), channel, components, array->GetComponent(0, 0) != 0.0 });
    channel += components;
  }
  return arrays;
}

/// Returns the part of the image that surrounds the points, without channels, and its first index.
shape::VoxelImage Crop(const vtkShapeImagePieces::Grid& grid,
  const std::vector<const Eigen::MatrixXd*>& points, vtkMultiProcessController* controller,
  std::array<int, 3>& first)
{
  shape::VoxelImage image;
  image.Origin = grid.Origin;
  image.Axes = grid.Axes;
  for (int axis = 0; axis < 3; ++axis)
  {
    image.Size[axis] = grid.Extent[2 * axis + 1] - grid.Extent[2 * axis] + 1;
  }
  shape::RequireVoxelImage(image);
  // The minima of the indices of the points, and of their negatives.
  Eigen::Array<double, 6, 1> range =
    Eigen::Array<double, 6, 1>::Constant(std::numeric_limits<double>::max());
  for (const Eigen::MatrixXd* matrix : points)
  {
    if (matrix->rows() > 0)
    {
      const Eigen::MatrixXd indices = shape::ToIndices(image, *matrix);
      range.head(3) = range.head(3).min(indices.colwise().minCoeff().transpose().array());
      range.tail(3) = range.tail(3).min(-indices.colwise().maxCoeff().transpose().array());
    }
  }
  vtkShapeGather::Reduce(controller, range.data(), 6, Reduction::Minimum);
  Eigen::RowVector3d start;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double low = grid.Extent[2 * axis], high = grid.Extent[2 * axis + 1];
    start(axis) = std::clamp(std::floor(range(axis)), low, high - 1.0);
    const double end = std::clamp(std::ceil(-range(3 + axis)), start(axis) + 1.0, high);
    first[axis] = static_cast<int>(start(axis));
    image.Size[axis] = static_cast<int>(end - start(axis)) + 1;
  }
  image.Origin += start * image.Axes.transpose();
  return image;
}

/// Copies a component of the arrays of the images to a channel.
void CopyChannel(const std::vector<vtkImageData*>& images, const std::string& name, int component,
  const shape::VoxelImage& image, const std::array<int, 3>& first, std::vector<double>& values)
{
  for (vtkImageData* piece : images)
  {
    vtkDataArray* array = piece->GetPointData()->GetArray(name.c_str());
    if (!array)
    {
      throw shape::InvalidInput(
        "a part of the Image has no array '" + name + "'; extract one image with Extract Block");
    }
    const int* extent = piece->GetExtent();
    std::array<int, 3> low, high;
    for (int axis = 0; axis < 3; ++axis)
    {
      low[axis] = std::max(extent[2 * axis], first[axis]);
      high[axis] = std::min(extent[2 * axis + 1], first[axis] + image.Size[axis] - 1);
    }
    for (int k = low[2]; k <= high[2]; ++k)
    {
      for (int j = low[1]; j <= high[1]; ++j)
      {
        int at[3] = { low[0], j, k };
        vtkIdType point = piece->ComputePointId(at);
        std::size_t sample = image.IndexOf(low[0] - first[0], j - first[1], k - first[2]);
        for (int i = low[0]; i <= high[0]; ++i)
        {
          values[sample++] = array->GetComponent(point++, component);
        }
      }
    }
  }
}

} // namespace

vtkShapeVoxelImage::Result vtkShapeVoxelImage::Read(vtkDataObject* input,
  const std::vector<const Eigen::MatrixXd*>& points, vtkMultiProcessController* controller)
{
  std::vector<vtkImageData*> images;
  vtkShapeGather::RunOnAllOrFail(
    controller, [&] { images = vtkShapeImagePieces::Find(input, "the Image"); });
  std::vector<vtkShapeImagePieces::Piece> pieces;
  for (vtkImageData* image : images)
  {
    pieces.push_back({ image, false });
  }
  const vtkShapeImagePieces::Grid grid =
    vtkShapeImagePieces::FindGrid(pieces, "the Image", controller);
  Result result;
  result.Arrays = FindArrays(images, controller);
  if (result.Arrays.empty())
  {
    throw shape::InvalidInput("the Image has no numbers at its points; convert arrays at its cells "
                              "with Cell Data To Point Data");
  }
  std::array<int, 3> first;
  result.Image = Crop(grid, points, controller, first);
  const double samples = 1.0 * result.Image.Size[0] * result.Image.Size[1] * result.Image.Size[2];
  if (samples > std::numeric_limits<int>::max())
  {
    throw shape::InvalidInput("the Image has more than 2,147,483,647 voxels around the Input; "
                              "resample it to fewer");
  }
  for (const Array& array : result.Arrays)
  {
    for (int component = 0; component < array.Components; ++component)
    {
      std::vector<double>& values =
        result.Image.Channels.emplace_back(static_cast<std::size_t>(samples), None);
      vtkShapeGather::RunOnAllOrFail(controller,
        [&] { CopyChannel(images, array.Name, component, result.Image, first, values); });
      vtkShapeGather::Reduce(
        controller, values.data(), static_cast<int>(values.size()), Reduction::Maximum);
      if (std::find(values.begin(), values.end(), None) != values.end())
      {
        throw shape::InvalidInput("the Image has parts that do not fill a box around the Input; "
                                  "resample it with Resample To Image");
      }
    }
  }
  return result;
}
