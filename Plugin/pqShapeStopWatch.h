#pragma once

#include <QRect>

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <thread>

/**
 * Notices in a thread of its own that a button of a window is pressed while the window processes no
 * event. It asks the X server where the mouse is and which buttons and keys are down. Processing
 * events instead would let timers and other widgets use the pipeline that is running.
 */
class pqShapeStopWatch
{
public:
  /// Returns whether this platform can tell: Qt must use X11.
  static bool IsPossible();

  /// `button` is in physical pixels of the window. `pressed` is called once, in the thread of the
  /// watch, when the left mouse button goes down there, or Escape while the window has the focus.
  pqShapeStopWatch(std::uint32_t window, const QRect& button, std::function<void()> pressed);
  /// Ends the watch.
  ~pqShapeStopWatch();

  pqShapeStopWatch(const pqShapeStopWatch&) = delete;
  pqShapeStopWatch& operator=(const pqShapeStopWatch&) = delete;

private:
  void Run();

  const std::uint32_t Window;
  const QRect Button;
  const std::function<void()> Pressed;
  std::mutex Mutex;
  std::condition_variable Wake;
  bool Ended = false;
  std::thread Thread; ///< last: it uses the others
};
