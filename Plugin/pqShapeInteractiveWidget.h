#pragma once

#include "pqPropertyWidget.h"
#include "pqShapeEdit.h"
#include "pqShapeOverlays.h"
#include "pqShapeSurface.h"

#include <QTimer>

#include <Eigen/Core>

#include <functional>
#include <string>
#include <vector>

class QCheckBox;
class QFormLayout;
class QLabel;
class pqPipelineSource;
class vtkActor;
class vtkPolyData;
class vtkProp;
class vtkRenderer;
class vtkSMProperty;
class vtkSMPropertyGroup;

/**
 * Base of the widgets that show rows in the properties panel, and a handle in the view that the
 * user drags over the input of the filter.
 *
 * The client draws the handle: its actors are in a renderer that ParaView draws on top of the image
 * from the server. Mouse and keys are events of the interactor. Events that the handle uses do not
 * reach the camera. A timer with zero interval processes a drag, so that all moves of the mouse
 * during one execution of the filter become one step. A drag ends when its button is released or
 * the right button is pressed.
 *
 * The property group assigns a function to each property. Surface is the input on which the handle
 * lies; a handle that lies on no surface overrides UpdateSurface and IsReady instead. Dragging is
 * the property that is 1 during a drag, so that the filter prefers speed. Subclasses define the
 * other functions.
 *
 * By default, the handle is in the active view. It is in data coordinates: it does not follow a
 * representation that is translated, rotated or scaled in the view. Comparative views have no
 * handle.
 *
 * If the fact `Refused` of the filter is 1, its output is the last valid result, and the fact
 * `Refusal` is the reason. A drag that ends in this state returns to the values of the last valid
 * result.
 */
class pqShapeInteractiveWidget : public pqPropertyWidget
{
  Q_OBJECT
  typedef pqPropertyWidget Superclass;

public:
  ~pqShapeInteractiveWidget() override = default;

  void apply() override;
  void reset() override;
  void select() override;
  void deselect() override;
  void setView(pqView* view) override;

protected:
  /// functions: the functions of the properties that a drag changes.
  pqShapeInteractiveWidget(vtkSMProxy* filter, vtkSMPropertyGroup* group,
    const std::vector<std::string>& functions, QWidget* parent);

  ///@{
  /// For subclasses to override. Parts of the handle are numbered from 1, and 0 is no part. Drag
  /// returns whether it changed property values. The other functions of type bool return whether
  /// they used the event. A used event does not reach the camera.
  virtual int FindPart(const Eigen::Vector2d& pixel) = 0;
  virtual void Grab(int part, const Eigen::Vector2d& pixel, bool shift, bool control) = 0;
  virtual bool Drag(const Eigen::Vector2d& pixel) = 0;
  virtual bool PressKey(const std::string& key) = 0;
  virtual bool TurnWheel(int steps, bool control) = 0;
  virtual void Draw() = 0;
  /// Called if the mouse was pressed and released without a drag, away from all parts.
  virtual bool Click(const Eigen::Vector2d& /*pixel*/) { return false; }
  virtual bool DoubleClick() { return false; }
  /// Called if the mouse moved without a drag. Returns whether the handle looks different now.
  virtual bool Hover(const Eigen::Vector2d& /*pixel*/) { return false; }
  /// Called before the filter has first been applied: when the handle appears, and when there is
  /// another surface. What the user has placed must stay.
  virtual void Place() {}
  /// Called when the handle appears and when the filter was updated. Data are fetched from the
  /// server here, because this is not possible while a view is rendered.
  virtual void ReadFacts() {}
  /// Returns the views that show the handle, by default the active one. Views that the client
  /// cannot draw into are ignored.
  virtual std::vector<pqView*> FindViews() const { return { this->view() }; }
  /// Fetches the surfaces that have changed. Returns whether all are there.
  virtual bool UpdateSurface();
  /// Returns whether there is something on which the handle lies.
  virtual bool IsReady() const { return this->Surface.IsThere(); }
  ///@}

  vtkSMProperty* GetProperty(const std::string& function) const;
  /// Returns the values in the panel, including edited values that have not been applied yet.
  std::vector<double> GetValues(const std::string& function) const;
  void SetValues(const std::string& function, const std::vector<double>& values);

  /// Appends the standard row for a property, if the group has it.
  void AddRow(const std::string& function);
  void AddWidget(QWidget* widget);
  /// Appends a text that explains the mouse and the keys. While the result is refused, the reason
  /// is shown instead.
  void AddHelp(const QString& text);
  void AddActor(vtkProp* actor) { this->Overlays.GetCurrent()->AddActor(actor); }
  void TakeShortcut(int key) { this->Overlays.GetCurrent()->TakeShortcut(key); }

  ///@{
  /// The view that is drawn; otherwise, the view of the last event.
  const pqShapeOverlay* GetOverlay() const { return this->Overlays.GetCurrent(); }
  vtkRenderer* GetRenderer() const { return this->Overlays.GetCurrent()->GetRenderer(); }
  pqView* GetDrawnView() const { return this->Overlays.GetCurrent()->GetView(); }
  ///@}
  double GetTime() const; ///< the time of the active view
  const pqShapeSurface& GetSurface() const { return this->Surface; }
  int GetHovered() const { return this->Hovered; } ///< the part under the mouse
  bool IsRefused() const { return this->Refused; } ///< the filter has the fact Refused
  /// Shows a change made by keys or the wheel. The final result is computed after a short pause
  /// without further changes.
  void Burst(const std::function<void()>& change);
  void EndBurst();
  /// Ends a drag or a burst, even if the button is still pressed.
  void EndDrag();
  /// Makes a change and computes its final result immediately.
  void Change(const std::function<void()>& change);
  void RequestRender();
  void RequestUpdate() { this->VisibilityTimer.start(0); } ///< looks for surfaces and views again

private Q_SLOTS:
  void OnValuesChanged();
  void OnUpdated();

private:
  Q_DISABLE_COPY(pqShapeInteractiveWidget)

  void UpdateVisibility();
  void Initialize();
  void OnRender();
  bool OnEvent(unsigned long event);
  bool OnMove();
  bool OnPress();
  bool OnRelease();
  void LetGo(); ///< EndDrag at the last position of the mouse
  bool OnWheel(int steps);
  bool OnKey();
  bool UpdateHovered();
  void Step();
  void Show();
  pqPipelineSource* FindSource() const;
  void Finish();

  vtkSMPropertyGroup* Group;
  pqShapeSurface Surface;
  pqShapeEdit Edit;
  std::vector<pqPropertyWidget*> Rows;
  QFormLayout* Layout;
  QCheckBox* ShowHandle;
  QLabel* Help;
  QString HelpText;
  pqShapeOverlays Overlays;
  QTimer VisibilityTimer, StepTimer, BurstTimer;
  Eigen::Vector2d Pixel = Eigen::Vector2d::Zero();
  Eigen::Vector2d Worked = Eigen::Vector2d::Zero(); ///< the pixel of the last step
  Eigen::Vector2d Pressed = Eigen::Vector2d::Zero();
  int Hovered = 0;
  bool Refused = false;
  bool Grabbed = false;
  bool Released = false;
  bool Clicking = false;
  bool Stepping = false;
};
