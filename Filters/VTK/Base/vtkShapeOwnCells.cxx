#include "vtkShapeOwnCells.h"

#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkUnsignedCharArray.h"

Eigen::VectorXi vtkShapeOwnCells::Find(vtkDataSet* data)
{
  Eigen::VectorXi own = Eigen::VectorXi::Ones(data->GetNumberOfCells());
  if (vtkUnsignedCharArray* ghosts = data->GetCellGhostArray())
  {
    const int left = vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL;
    for (Eigen::Index cell = 0; cell < own.size(); ++cell)
    {
      own(cell) = (ghosts->GetValue(cell) & left) == 0;
    }
  }
  return own;
}
