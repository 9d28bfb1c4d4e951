#pragma once

#include "pqShapeOverlay.h"

#include <functional>
#include <memory>
#include <vector>

class pqView;

/// Overlays in several views. One of them is the current one: the one that is drawn or, otherwise,
/// that had the last event.
class pqShapeOverlays
{
public:
  /// draw: called for the current overlay, before its view is rendered. takeEvent: called for the
  /// current overlay; as for pqShapeOverlay. leave: called before the current overlay changes
  /// because of an event.
  pqShapeOverlays(const std::function<void()>& draw,
    const std::function<bool(unsigned long)>& takeEvent, const std::function<void()>& leave);

  pqShapeOverlay* GetCurrent() const { return this->Current; }
  /// Whether the current overlay had the last event, so that the mouse is in its view.
  bool HasMouse() const { return this->Current == this->Last; }

  bool IsAttached() const;
  /// Detaches the overlays of all other views. Returns whether there were any.
  bool DetachExcept(const std::vector<pqView*>& views);
  /// Attaches overlays to those of `views` that the client can draw into, and detaches all others.
  /// Returns whether anything changed.
  bool Attach(const std::vector<pqView*>& views);
  std::vector<pqView*> GetViews() const;

private:
  pqShapeOverlay* Add();
  void OnDraw(pqShapeOverlay* overlay);
  bool OnEvent(pqShapeOverlay* overlay, unsigned long event);

  std::function<void()> Draw;
  std::function<bool(unsigned long)> TakeEvent;
  std::function<void()> Leave;
  std::vector<std::unique_ptr<pqShapeOverlay>> Items; ///< at least one, maybe without a view
  pqShapeOverlay* Current;
  pqShapeOverlay* Last; ///< that had the last event
};
