#pragma once

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
class pqView;
class vtkObject;
class vtkProp;
class vtkRenderWindowInteractor;
class vtkRenderer;

/**
 * Actors that the window alone draws, on top of what a server sends, and the mouse and the keys of
 * the view that they are in.
 */
class pqShapeOverlay : public QObject
{
public:
  /// `draw` is called before the view is rendered; `takeEvent` with a vtkCommand event, and returns
  /// whether to hide it from the camera.
  pqShapeOverlay(
    const std::function<void()>& draw, const std::function<bool(unsigned long)>& takeEvent);
  ~pqShapeOverlay() override;
  pqShapeOverlay(const pqShapeOverlay&) = delete;
  void operator=(const pqShapeOverlay&) = delete;

  void AddActor(vtkProp* actor);
  /// While the view has the focus, a key (of Qt::Key) comes here although it is a shortcut of the
  /// window's.
  void TakeShortcut(int key) { this->Shortcuts.insert(key); }
  void SetVisible(bool visible);

  /// Whether a view draws by itself what the window puts into it, as a comparative one does not.
  static bool CanAttach(pqView* view);
  void Attach(pqView* view);
  void Detach();
  bool IsAttached() const { return !this->Observers.empty(); }

  ///@{
  /// While it is attached.
  vtkRenderer* GetRenderer() const;
  Eigen::Vector2d GetPixel() const; ///< of the mouse
  bool IsShiftPressed() const;
  bool IsControlPressed() const;
  std::string GetKey() const; ///< as X names them: "bracketleft"
  ///@}

private:
  bool eventFilter(QObject* widget, QEvent* event) override;
  void OnRender() { this->Draw(); }
  bool OnEvent(vtkObject*, unsigned long event, void*) { return this->TakeEvent(event); }

  std::function<void()> Draw;
  std::function<bool(unsigned long)> TakeEvent;
  std::vector<vtkSmartPointer<vtkProp>> Actors;
  QSet<int> Shortcuts;
  QPointer<QWidget> Widget;
  vtkWeakPointer<vtkRenderer> Renderer;
  vtkWeakPointer<vtkRenderWindowInteractor> Interactor;
  std::vector<unsigned long> Observers;
  unsigned long RenderObserver = 0;
};
