#pragma once

#include "pqShapeHandleCurves.h"
#include "pqShapeInteractiveWidget.h"

#include <Eigen/Geometry>

/**
 * Moves the handle by which a shape is deformed, and rotates frames at points of it.
 *
 * Each part of the handle has a ball at its centre. Dragging the ball translates the part in the
 * plane of the view and, with Shift, along its axis. The part that was used last has a ring with a
 * knob, and an axis. Dragging the knob rotates and scales, with Shift it only rotates, and with
 * Control it only scales. Dragging the tip of the axis tilts the part. The keys [ and ] rotate, and
 * the keys - and + scale.
 *
 * A click on the handle adds a frame, which at first changes nothing. It is drawn as the normal of
 * the shape. Dragging its tip rotates the frame. Between the frames of a part, the filter
 * interpolates. Delete removes the frame under the mouse. Escape undoes a drag.
 *
 * Functions of the property group (panel_widget="ShapeMotion"): Motions (8 numbers for each part
 * that moves: part, translation, rotation vector in degrees, scale) and Frames (6 numbers for each
 * frame: position at rest, rotation vector in degrees). The output Handle of the filter is where
 * the handle is: a vtkPolyData with the point arrays SourcePosition, TargetNormal, FrameTurn and
 * Part.
 */
class pqShapeMotionWidget : public pqShapeInteractiveWidget
{
  Q_OBJECT
  typedef pqShapeInteractiveWidget Superclass;

public:
  pqShapeMotionWidget(vtkSMProxy* filter, vtkSMPropertyGroup* group, QWidget* parent = nullptr);
  ~pqShapeMotionWidget() override = default;

protected:
  int FindPart(const Eigen::Vector2d& pixel) override;
  void Grab(int part, const Eigen::Vector2d& pixel, bool shift, bool control) override;
  bool Drag(const Eigen::Vector2d& pixel) override;
  bool Click(const Eigen::Vector2d& pixel) override;
  bool PressKey(const std::string& key) override;
  bool TurnWheel(int, bool) override { return false; }
  void Draw() override;
  void ReadFacts() override;
  bool UpdateSurface() override;
  bool IsReady() const override { return this->Curves.IsThere(); }

private:
  Q_DISABLE_COPY(pqShapeMotionWidget)

  /// What can be grabbed. Balls and frames are numbered from the last two.
  enum Grip
  {
    None,
    Knob,
    Axis,
    FirstBall,
    FirstFrame = FirstBall + 1000
  };
  /// The handle of the active part as drawn.
  struct Gizmo
  {
    pqShapeHandleCurves::Part Part;
    double Radius;
    Eigen::Vector3d Knob, Tip;
  };
  struct Motion
  {
    Eigen::Vector3d Translation = Eigen::Vector3d::Zero();
    Eigen::Vector3d Rotation = Eigen::Vector3d::Zero(); ///< degrees
    double Scale = 1.0;
  };
  Gizmo MakeGizmo();
  Motion GetMotion(int part) const;
  void SetMotion(int part, const Motion& motion);
  std::size_t CountFrames() const;
  int FindSample(std::size_t frame) const; ///< at which a frame is
  Eigen::Vector3d FindFrameTip(std::size_t frame) const;
  bool DragBall(const Eigen::Vector2d& pixel);
  bool DragKnob(const Eigen::Vector2d& pixel);
  bool DragAxis(const Eigen::Vector2d& pixel);
  bool DragFrame(const Eigen::Vector2d& pixel);
  bool FindInPlane(const Eigen::Vector2d& pixel, const Eigen::Vector3d& origin,
    const Eigen::Vector3d& normal, Eigen::Vector3d& position) const;
  /// Finds where the mouse has pulled what was at `from` when it was grabbed, in the plane of the
  /// view.
  bool Pull(const Eigen::Vector2d& pixel, const Eigen::Vector3d& from, Eigen::Vector3d& to) const;
  void DrawFrames();

  pqShapeHandleCurves Curves;
  int Active = 0; ///< the part with the ring
  vtkSmartPointer<vtkPolyData> CurveLines, RingLines, AxisLines, FrameLines, BallMarks, FrameMarks;
  vtkSmartPointer<vtkActor> CurveActor, RingActor, AxisActor, FrameActor, MarkActor, FrameMarkActor;
  vtkSmartPointer<vtkActor> BallActor, KnobActor, TipActor;
  /// When the drag began.
  int Grabbed = None;
  bool Shift = false, Control = false;
  Eigen::Vector2d FirstPixel = Eigen::Vector2d::Zero();
  Gizmo First;
  Motion FirstMotion;
  Eigen::Vector3d FirstOrigin, FirstNormal, FirstTip, FirstTurn; ///< of a frame
};
