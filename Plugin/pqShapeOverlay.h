#pragma once

#include "pqView.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <QObject>
#include <QPointer>
#include <QSet>

#include <Eigen/Core>

#include <functional>
#include <string>
#include <vector>

class QWidget;
class vtkObject;
class vtkProp;
class vtkRenderWindowInteractor;
class vtkRenderer;

/**
 * Actors that the client draws on top of the image from the server, and the mouse and key events of
 * their view.
 */
class pqShapeOverlay : public QObject
{
public:
  /// draw: called before the view is rendered. takeEvent: called with the number of a vtkCommand
  /// event. It returns true to hide the event from the camera.
  pqShapeOverlay(
    const std::function<void()>& draw, const std::function<bool(unsigned long)>& takeEvent);
  ~pqShapeOverlay() override;
  pqShapeOverlay(const pqShapeOverlay&) = delete;
  void operator=(const pqShapeOverlay&) = delete;

  void AddActor(vtkProp* actor);
  /// While the view has the focus, this key (Qt::Key) is sent to the overlay, even if it is a
  /// shortcut of the main window.
  void TakeShortcut(int key) { this->Shortcuts.insert(key); }
  void SetVisible(bool visible);

  /// Returns whether the client can draw into a view. It cannot draw into comparative views.
  static bool CanAttach(pqView* view);
  void Attach(pqView* view);
  void Detach();
  bool IsAttached() const { return !this->Observers.empty(); }
  pqView* GetView() const { return this->View; } ///< null if the overlay is not attached

  ///@{
  /// Valid while the overlay is attached.
  vtkRenderer* GetRenderer() const;
  Eigen::Vector2d GetPixel() const; ///< position of the mouse
  bool IsShiftPressed() const;
  bool IsControlPressed() const;
  std::string GetKey() const; ///< name of the pressed key in X11, such as "bracketleft"
  ///@}

private:
  bool eventFilter(QObject* widget, QEvent* event) override;
  void OnRender() { this->Draw(); }
  bool OnEvent(vtkObject*, unsigned long event, void*) { return this->TakeEvent(event); }

  std::function<void()> Draw;
  std::function<bool(unsigned long)> TakeEvent;
  std::vector<vtkSmartPointer<vtkProp>> Actors;
  QSet<int> Shortcuts;
  QPointer<pqView> View;
  QPointer<QWidget> Widget;
  vtkWeakPointer<vtkRenderer> Renderer;
  vtkWeakPointer<vtkRenderWindowInteractor> Interactor;
  std::vector<unsigned long> Observers;
  unsigned long RenderObserver = 0;
};
