#pragma once

#include "pqShapeInteractiveWidget.h"

class QPushButton;

/**
 * Draws a closed loop on a surface, place by place, and moves its places.
 *
 * While the button Draw Loop is pressed, a click on the surface appends a place, and a drag still
 * turns the camera. A double click or Enter closes the loop, Backspace takes the last place back,
 * Escape gives up: the filter keeps the loop that it had. The places of a closed loop are balls
 * that are dragged over the surface; Delete removes the one under the mouse.
 *
 * Functions of the property group (panel_widget="ShapeLoop"): Surface, Points (3 numbers for each
 * place; the last joins the first); optional: Dragging.
 */
class pqShapeLoopWidget : public pqShapeInteractiveWidget
{
  Q_OBJECT
  typedef pqShapeInteractiveWidget Superclass;

public:
  pqShapeLoopWidget(vtkSMProxy* filter, vtkSMPropertyGroup* group, QWidget* parent = nullptr);
  ~pqShapeLoopWidget() override = default;

  void deselect() override;

protected:
  int FindPart(const Eigen::Vector2d& pixel) override;
  void Grab(int part, const Eigen::Vector2d& pixel, bool shift, bool control) override;
  bool Drag(const Eigen::Vector2d& pixel) override;
  bool PressKey(const std::string& key) override;
  bool TurnWheel(int steps, bool control) override;
  void Draw() override;
  bool Click(const Eigen::Vector2d& pixel) override;
  bool DoubleClick() override;

private:
  Q_DISABLE_COPY(pqShapeLoopWidget)

  using Positions = std::vector<Eigen::Vector3d>;
  bool IsDrawing() const;
  /// What is being drawn, or else the filter's loop.
  Positions GetPlaces() const;
  void SetPlaces(const Positions& positions);
  void Close();
  void DrawCurve(const Positions& positions);

  QPushButton* Button;
  Positions Drawn;
  Positions Shown; ///< the places that the curve goes through, on that version of the surface
  bool ShownClosed = false;
  int ShownVersion = 0;
  int Grabbed = 0;
  Eigen::Vector2d Offset = Eigen::Vector2d::Zero();
  vtkSmartPointer<vtkPolyData> Curve, Marks;
  vtkSmartPointer<vtkActor> CurveActor, MarksActor, HoveredActor;
};
