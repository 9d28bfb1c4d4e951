#pragma once

#include "pqShapeInteractiveWidget.h"

/**
 * The handle of a filter that does something at a place of a surface: a ball at the place, and a
 * ring around it with a knob.
 *
 * Dragging the ball moves the place over the surface under the mouse; with Shift it turns, with
 * Control it scales. Dragging the knob turns and scales at once. [ and ] turn, - and + scale, so do
 * the wheel and Control with the wheel while the mouse is on the handle; Escape takes a drag back.
 *
 * Functions of the property group (panel_widget="ShapeHandle"): Surface, Seed (3 numbers, a place);
 * optional: Rotation (degrees about the normal), Scale (a factor) or Radius (in model units),
 * Dragging, and Feature, the input by whose size the ring is drawn. The knob is where the filter
 * says in its fact `Direction` (or `XAxis`) that angle 0 is, turned by the Rotation.
 */
class pqShapeHandleWidget : public pqShapeInteractiveWidget
{
  Q_OBJECT
  typedef pqShapeInteractiveWidget Superclass;

public:
  pqShapeHandleWidget(vtkSMProxy* filter, vtkSMPropertyGroup* group, QWidget* parent = nullptr);
  ~pqShapeHandleWidget() override = default;

protected:
  int FindPart(const Eigen::Vector2d& pixel) override;
  void Grab(int part, const Eigen::Vector2d& pixel, bool shift, bool control) override;
  bool Drag(const Eigen::Vector2d& pixel) override;
  bool PressKey(const std::string& key) override;
  bool TurnWheel(int steps, bool control) override;
  void Draw() override;
  void ReadFacts() override;
  void Place() override;

private:
  Q_DISABLE_COPY(pqShapeHandleWidget)

  enum Part
  {
    None,
    Ball,
    Knob
  };
  enum class Motion
  {
    Move,
    Turn,
    Scale,
    TurnAndScale
  };
  /// Where the handle is, and the axes of its ring: columns from the centre to angle 0, to angle
  /// 90, and the normal.
  struct Frame
  {
    Eigen::Vector3d Centre;
    Eigen::Matrix3d Axes;
    double Radius;
    Eigen::Vector3d Knob;
  };
  Frame MakeFrame();

  double GetValue(const std::string& function, double otherwise) const;
  double GetSize() const; ///< Scale or Radius, whichever the filter has
  bool SetTurn(double degrees);
  bool SetSize(double size);
  bool DragKnob(const Eigen::Vector2d& pixel);
  bool Polar(const Eigen::Vector2d& pixel, double& angle, double& distance);

  vtkSmartPointer<vtkActor> BallActor, KnobActor, RingActor;
  vtkSmartPointer<vtkPolyData> Ring;
  Motion Moving = Motion::Move;
  Eigen::Vector3d Zero = Eigen::Vector3d::UnitX(); ///< where angle 0 points, but for the tilt
  double Unit = 1.0;                               ///< the ring's radius where the size is 1
  /// When the drag began: the mouse, the handle, and the values.
  Eigen::Vector2d FirstPixel, Offset;
  Frame FirstFrame;
  double FirstTurn = 0.0, FirstSize = 1.0, FirstAngle = 0.0, FirstDistance = 1.0;
};
