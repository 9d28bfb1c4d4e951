#include "pqShapeStopWatch.h"

#include <QGuiApplication>

#include <xcb/xcb.h>

#include <chrono>
#include <cstdlib>
#include <memory>
#include <utility>
#include <vector>

namespace
{

struct Free
{
  void operator()(void* reply) const { std::free(reply); }
};

template <typename Reply>
std::unique_ptr<Reply, Free> Own(Reply* reply)
{
  return std::unique_ptr<Reply, Free>(reply);
}

/// The state of mouse and keyboard, asked over a connection of its own.
class XServer
{
public:
  explicit XServer(xcb_window_t window)
    : Window(window)
  {
    const auto geometry = Own(xcb_get_geometry_reply(
      this->Connection.get(), xcb_get_geometry(this->Connection.get(), window), nullptr));
    this->Root = geometry ? geometry->root : XCB_NONE;
    this->FindEscape();
  }

  bool IsDownIn(const QRect& button) const
  {
    // From the root down to the window: another window may lie above it.
    for (xcb_window_t at = this->Root; at != XCB_NONE;)
    {
      const auto pointer = Own(xcb_query_pointer_reply(
        this->Connection.get(), xcb_query_pointer(this->Connection.get(), at), nullptr));
      if (!pointer)
      {
        return false;
      }
      if (at == this->Window)
      {
        return (pointer->mask & XCB_BUTTON_MASK_1) != 0 &&
          button.contains(pointer->win_x, pointer->win_y);
      }
      at = pointer->child;
    }
    return false;
  }

  bool IsEscapeDown() const
  {
    const auto focus = Own(xcb_get_input_focus_reply(
      this->Connection.get(), xcb_get_input_focus(this->Connection.get()), nullptr));
    const auto keys = Own(xcb_query_keymap_reply(
      this->Connection.get(), xcb_query_keymap(this->Connection.get()), nullptr));
    if (!focus || !keys || focus->focus != this->Window)
    {
      return false;
    }
    for (const xcb_keycode_t code : this->Escape)
    {
      if ((keys->keys[code / 8] >> (code % 8)) & 1)
      {
        return true;
      }
    }
    return false;
  }

private:
  void FindEscape()
  {
    constexpr xcb_keysym_t escape = 0xff1b;
    const xcb_setup_t* setup = xcb_get_setup(this->Connection.get());
    if (!setup)
    {
      return;
    }
    const int count = setup->max_keycode - setup->min_keycode + 1;
    const auto mapping = Own(xcb_get_keyboard_mapping_reply(this->Connection.get(),
      xcb_get_keyboard_mapping(
        this->Connection.get(), setup->min_keycode, static_cast<std::uint8_t>(count)),
      nullptr));
    for (int i = 0; mapping && i < count; ++i)
    {
      if (xcb_get_keyboard_mapping_keysyms(mapping.get())[i * mapping->keysyms_per_keycode] ==
        escape)
      {
        this->Escape.push_back(static_cast<xcb_keycode_t>(setup->min_keycode + i));
      }
    }
  }

  const xcb_window_t Window;
  std::unique_ptr<xcb_connection_t, decltype(&xcb_disconnect)> Connection{
    xcb_connect(nullptr, nullptr), &xcb_disconnect
  };
  xcb_window_t Root = XCB_NONE;
  std::vector<xcb_keycode_t> Escape;
};

} // namespace

bool pqShapeStopWatch::IsPossible()
{
  return QGuiApplication::platformName() == "xcb";
}

pqShapeStopWatch::pqShapeStopWatch(
  std::uint32_t window, const QRect& button, std::function<void()> pressed)
  : Window(window)
  , Button(button)
  , Pressed(std::move(pressed))
  , Thread([this] { this->Run(); })
{
}

pqShapeStopWatch::~pqShapeStopWatch()
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Ended = true;
  }
  this->Wake.notify_one();
  this->Thread.join();
}

void pqShapeStopWatch::Run()
{
  constexpr auto interval = std::chrono::milliseconds(15); // less than a click lasts
  const XServer server(this->Window);
  bool before = true; // what is held down from the beginning was meant for something else
  std::unique_lock<std::mutex> lock(this->Mutex);
  while (!this->Wake.wait_for(lock, interval, [this] { return this->Ended; }))
  {
    const bool now = server.IsDownIn(this->Button) || server.IsEscapeDown();
    if (now && !before)
    {
      this->Pressed();
      return;
    }
    before = now;
  }
}
