#pragma once

#include "pqShapeInteractiveWidget.h"

#include <QPointer>

class QPushButton;
class pqOutputPort;

/**
 * Draws a closed loop on a surface, position by position, and moves its positions.
 *
 * While the button Draw Loop is checked, a click on the surface appends a position, and a drag
 * rotates the camera as usual. A double click or Enter closes the loop, and Backspace removes the
 * last position. Escape cancels: the filter keeps its previous loop. The positions of a closed loop
 * are balls that can be dragged over the surface. Delete removes the position under the mouse.
 *
 * While the loop is drawn, its positions are joined by straight lines that are projected onto the
 * surface. Once the filter has cut along it, its curve is the boundary of the feature, the first
 * output. It runs as the properties of the filter require, such as along creases.
 *
 * Functions of the property group (panel_widget="ShapeLoop"): Surface and Points (3 numbers for
 * each position; the last position is joined to the first). Dragging is optional.
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
  void ReadFacts() override;
  bool UpdateSurface() override;

private:
  Q_DISABLE_COPY(pqShapeLoopWidget)

  using Positions = std::vector<Eigen::Vector3d>;
  bool IsDrawing() const;
  /// Returns the positions of the loop that is being drawn. If none is being drawn, returns the
  /// positions of the filter's loop.
  Positions GetPlaces() const;
  void SetPlaces(const Positions& positions);
  void ShowSurface(); ///< while a loop is drawn, the surface under the mouse is visible
  void Close();
  bool FacesViewer(const Eigen::Vector3d& position) const;
  void FetchCut();
  void DrawCurve(const Positions& positions);
  void DrawMarks(
    const Positions& positions); ///< dimmed on the far side, where they cannot be grabbed

  QPushButton* Button;
  Positions Drawn;
  QPointer<pqOutputPort> ShownSurface; ///< that was hidden before the loop was drawn
  Positions Shown; ///< positions of the drawn curve, for ShownVersion of the surface
  bool ShownClosed = false;
  int ShownVersion = 0;
  bool IsCutOutdated = true;
  vtkSmartPointer<vtkPolyData> Cut; ///< the curve along which the filter has cut, or null
  Positions CutPositions;           ///< the positions of the loop that was cut
  int Grabbed = 0;
  Eigen::Vector2d Offset = Eigen::Vector2d::Zero();
  vtkSmartPointer<vtkPolyData> Curve, Marks, HiddenMarks;
  vtkSmartPointer<vtkActor> CurveActor, MarksActor, HiddenMarksActor, HoveredActor;
};
