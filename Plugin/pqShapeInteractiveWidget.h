#pragma once

#include "pqPropertyWidget.h"
#include "pqShapeEdit.h"
#include "pqShapeOverlay.h"
#include "pqShapeSurface.h"

#include <QTimer>

#include <Eigen/Core>

#include <functional>
#include <string>
#include <vector>

class QCheckBox;
class QFormLayout;
class QLabel;
class vtkActor;
class vtkPolyData;
class vtkProp;
class vtkRenderer;
class vtkSMProperty;
class vtkSMPropertyGroup;

/**
 * Rows of the panel together with a handle in the view that is dragged over the filter's input.
 *
 * The handle belongs to the window alone: its actors are in the renderer that ParaView draws on top
 * of what the server sends. Mouse and keys are the interactor's events; those that the handle
 * takes do not reach the camera. A drag is worked off by a timer of no length, so that many moves
 * of the mouse in the time of one execution are one; it ends where the button was let go, or the
 * right one pressed.
 *
 * A property group names the properties by function: Surface is the input on which the handle
 * lies, Dragging the property that asks the filter for speed; the others are the subclass's.
 *
 * The handle is where the data are: it does not follow a representation that is moved, turned or
 * scaled in the view. Comparative views have none.
 *
 * Where the filter says `Refused` among its facts, and why in `Refusal`, it shows the last result
 * that it could make, and so does a drag that ends there.
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
  /// `functions` are the properties that a drag changes.
  pqShapeInteractiveWidget(vtkSMProxy* filter, vtkSMPropertyGroup* group,
    const std::vector<std::string>& functions, QWidget* parent);

  ///@{
  /// What a subclass is asked. Parts count up from 1; 0 is none. Drag changes the property values
  /// and returns whether it did. What returns whether it took an event hides it from the camera.
  virtual int FindPart(const Eigen::Vector2d& pixel) = 0;
  virtual void Grab(int part, const Eigen::Vector2d& pixel, bool shift, bool control) = 0;
  virtual bool Drag(const Eigen::Vector2d& pixel) = 0;
  virtual bool PressKey(const std::string& key) = 0;
  virtual bool TurnWheel(int steps, bool control) = 0;
  virtual void Draw() = 0;
  /// The mouse was pressed and released without a drag, beside every part.
  virtual bool Click(const Eigen::Vector2d& /*pixel*/) { return false; }
  virtual bool DoubleClick() { return false; }
  /// The handle appears, and the filter has never been applied.
  virtual void Place() {}
  /// The handle appears, or the filter was updated: what only a server knows is asked for here,
  /// since nothing may be while a view is rendered.
  virtual void ReadFacts() {}
  ///@}

  vtkSMProperty* GetProperty(const std::string& function) const;
  /// What the panel shows: the property's value, or what was typed and not yet applied.
  std::vector<double> GetValues(const std::string& function) const;
  void SetValues(const std::string& function, const std::vector<double>& values);

  /// Appends the panel's usual row for a property, where the group has it.
  void AddRow(const std::string& function);
  void AddWidget(QWidget* widget);
  /// Appends a line on what the mouse and the keys do, or, while the filter refuses, on why it
  /// does.
  void AddHelp(const QString& text);
  void AddActor(vtkProp* actor) { this->Overlay.AddActor(actor); }
  void TakeShortcut(int key) { this->Overlay.TakeShortcut(key); }

  vtkRenderer* GetRenderer() const { return this->Overlay.GetRenderer(); }
  const pqShapeSurface& GetSurface() const { return this->Surface; }
  int GetHovered() const { return this->Hovered; } ///< the part under the mouse
  bool IsRefused() const { return this->Refused; } ///< the filter cannot do what is shown
  /// A change by keys or the wheel: shown, and in full when no other has followed for a moment.
  void Burst(const std::function<void()>& change);
  void EndBurst();
  /// Ends what goes on, be it that the button is still pressed.
  void EndDrag();
  /// A change that is made in full at once.
  void Change(const std::function<void()>& change);
  void RequestRender();

private Q_SLOTS:
  void OnValuesChanged();
  void OnUpdated();

private:
  Q_DISABLE_COPY(pqShapeInteractiveWidget)

  double GetTime() const;
  bool UpdateSurface();
  void UpdateVisibility();
  void Initialize();
  void OnRender();
  bool OnEvent(unsigned long event);
  bool OnMove();
  bool OnPress();
  bool OnRelease();
  void LetGo(); ///< EndDrag, where the mouse was last
  bool OnWheel(int steps);
  bool OnKey();
  bool UpdateHovered();
  void Step();
  void Show();
  void Finish();

  vtkSMPropertyGroup* Group;
  pqShapeSurface Surface;
  pqShapeEdit Edit;
  std::vector<pqPropertyWidget*> Rows;
  QFormLayout* Layout;
  QCheckBox* ShowHandle;
  QLabel* Help;
  QString HelpText;
  pqShapeOverlay Overlay;
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
  bool Initialized = false;
};
