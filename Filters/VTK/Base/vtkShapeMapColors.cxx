#include "vtkShapeMapColors.h"

#include "vtkShapeComposite.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include "Mesh/Extent.h"

#include <algorithm>

void vtkShapeMapColors::Add(
  vtkDataObject* output, const std::string& positions, const shape::Mesh& mesh)
{
  if (mesh.Points.rows() == 0)
  {
    return;
  }
  const Eigen::AlignedBox3d box = shape::ComputeBox(mesh);
  const Eigen::RowVector3d low = box.min();
  // Flat shapes have no extent along one axis.
  const Eigen::RowVector3d extent =
    Eigen::RowVector3d(box.sizes()).unaryExpr([](double e) { return e > 0.0 ? e : 1.0; });
  // Neither black nor white, so that shading remains visible.
  constexpr double darkest = 40.0, lightest = 245.0;
  for (vtkDataSet* leaf : vtkShapeComposite::Of(output))
  {
    vtkDataArray* array =
      positions.empty() ? nullptr : leaf->GetPointData()->GetArray(positions.c_str());
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetName("MapColors");
    colors->SetNumberOfComponents(3);
    colors->SetNumberOfTuples(leaf->GetNumberOfPoints());
    for (vtkIdType i = 0; i < leaf->GetNumberOfPoints(); ++i)
    {
      Eigen::RowVector3d position;
      if (array)
      {
        array->GetTuple(i, position.data());
      }
      else
      {
        leaf->GetPoint(i, position.data());
      }
      for (int c = 0; c < 3; ++c)
      {
        const double share = std::clamp((position(c) - low(c)) / extent(c), 0.0, 1.0);
        colors->SetTypedComponent(
          i, c, static_cast<unsigned char>(darkest + (lightest - darkest) * share));
      }
    }
    leaf->GetPointData()->AddArray(colors);
  }
}
