#pragma once

#include "pqShapeInteractiveWidget.h"

class QComboBox;
class QDoubleSpinBox;
class QPushButton;

/**
 * A brush that paints strokes on a surface.
 *
 * While the button Paint is checked, a drag over the surface is a stroke, and a drag beside it
 * rotates the camera. With Shift, the stroke smooths. Backspace or the button removes the last
 * stroke, and Escape undoes the one that is being drawn. The keys - and +, or the wheel with
 * Control, change the radius. A stroke is one step to undo.
 *
 * The settings of the brush are those of the next stroke, and no properties of the filter. For a
 * filter with strokes, they begin as those of the last stroke.
 *
 * Functions of the property group (panel_widget="ShapeBrush"): Surface, Strokes (5 numbers for each
 * stroke: mode, radius, strength, value, number of its points) and Points (3 numbers for each
 * position of all strokes). The modes are 0: Set, 1: Add, 2: Smooth. The visible output of the
 * filter is coloured; the range of its colours grows with the painted values.
 */
class pqShapeBrushWidget : public pqShapeInteractiveWidget
{
  Q_OBJECT
  typedef pqShapeInteractiveWidget Superclass;

public:
  pqShapeBrushWidget(vtkSMProxy* filter, vtkSMPropertyGroup* group, QWidget* parent = nullptr);
  ~pqShapeBrushWidget() override = default;

  void deselect() override;

protected:
  int FindPart(const Eigen::Vector2d& pixel) override;
  void Grab(int part, const Eigen::Vector2d& pixel, bool shift, bool control) override;
  bool Drag(const Eigen::Vector2d& pixel) override;
  bool PressKey(const std::string& key) override;
  bool TurnWheel(int steps, bool control) override;
  bool Hover(const Eigen::Vector2d& pixel) override;
  void Draw() override;
  void ReadFacts() override;

private:
  Q_DISABLE_COPY(pqShapeBrushWidget)

  void MakeSettings();
  void TakeLastBrush(); ///< the settings of the last stroke
  bool IsPainting() const;
  void Start(); ///< the filter is applied, so that what is painted is visible
  double GetRadius() const;
  void ScaleRadius(double factor);
  void RemoveLastStroke();
  void AddPoints(const std::vector<Eigen::Vector3d>& points); ///< to the last stroke

  QPushButton* Button;
  QPushButton* Remove;
  QComboBox* Mode;
  QDoubleSpinBox *Radius, *Strength, *Value;
  vtkSmartPointer<vtkPolyData> Ring;
  vtkSmartPointer<vtkActor> RingActor;
  pqShapePlace Centre; ///< of the ring
  bool IsOver = false; ///< the mouse is over the surface
  /// The last position of the stroke, and its pixel.
  Eigen::Vector3d LastPoint = Eigen::Vector3d::Zero();
  Eigen::Vector2d LastPixel = Eigen::Vector2d::Zero();
  double Spacing = 1.0; ///< between the positions of the stroke
};
