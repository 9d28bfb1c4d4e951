#pragma once

#include "vtkSmartPointer.h"

#include <Eigen/Core>

#include <functional>
#include <string>
#include <vector>

class vtkActor;
class vtkPolyData;
class vtkProp;
class vtkRenderer;
class vtkTextActor;

/// A landmark in a view.
struct pqShapeLandmarkMark
{
  Eigen::Vector3d Position; ///< in the view
  std::string Text;
  int Side = 0;         ///< 0 on Surface A, 1 on Surface B; determines the colour
  bool Visible = true;  ///< false on the far side of the surface; then the mark is faint
  bool Hovered = false; ///< the mouse is on it, or on its partner
};

/// Balls with texts beside them, and lines between partners, in one view.
class pqShapeLandmarkMarks
{
public:
  /// add: adds an actor to the view.
  explicit pqShapeLandmarkMarks(const std::function<void(vtkProp*)>& add);

  /// lines: pairs of end points.
  void Draw(vtkRenderer* renderer, const std::vector<pqShapeLandmarkMark>& marks,
    const std::vector<Eigen::Vector3d>& lines);

private:
  std::function<void(vtkProp*)> Add;
  std::vector<vtkSmartPointer<vtkActor>> Balls;
  std::vector<vtkSmartPointer<vtkTextActor>> Texts;
  vtkSmartPointer<vtkPolyData> Lines;
  vtkSmartPointer<vtkActor> LinesActor;
};
