#pragma once

#include "pqShapeInteractiveWidget.h"

/**
 * The handle of a filter that works at a position on a surface. It consists of a ball at this
 * position, and a ring around the ball with a knob.
 *
 * Dragging the ball moves the position over the surface. Dragging it with Shift rotates, and
 * dragging it with Control scales. Dragging the knob rotates and scales at the same time. The keys
 * [ and ] rotate, and the keys - and + scale. While the mouse is on the handle, the wheel rotates,
 * and the wheel with Control scales. Escape undoes a drag.
 *
 * Functions of the property group (panel_widget="ShapeHandle"): Surface and Seed (3 numbers, the
 * position). Optional functions: Rotation (degrees about the normal), Scale (a factor) or Radius
 * (in the units of the model), Dragging, and Feature. Feature is the input whose size determines
 * the size of the ring. The fact `Direction` or `XAxis` of the filter gives the direction of angle
 * 0. The knob is at the angle Rotation.
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
  /// The position of the handle, and the axes of its ring. The columns of Axes are the directions
  /// of angle 0 and angle 90, and the normal.
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
  Eigen::Vector3d Zero = Eigen::Vector3d::UnitX(); ///< direction of angle 0, before projection
  double Unit = 1.0;                               ///< radius of the ring for size 1
  std::vector<double> Placed;                      ///< the last Seed that Place has set
  /// The position of the mouse, the handle and the values when the drag began.
  Eigen::Vector2d FirstPixel, Offset;
  Frame FirstFrame;
  double FirstTurn = 0.0, FirstSize = 1.0, FirstAngle = 0.0, FirstDistance = 1.0;
};
