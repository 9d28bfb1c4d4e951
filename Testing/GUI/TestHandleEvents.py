"""Events that come to a handle at odd times, or from the real keyboard: a drag ends where the button is let go,
and what is done is one step to undo."""
import window

RADIUS = window.PROPERTIES + 'ShapeHandle/Radius/DoubleLineEdit0'
SHOW = window.PROPERTIES + 'ShapeHandle/ShowHandle'
CONTROL_KEY, RETURN_KEY = 0x01000021, 0x01000004

w = window.Window()
w.open_with('DentedSphere600.vtp', 'Shape Exponential Map')
w.python('''
    import subprocess

    import numpy
    import onsurface

    made, view = GetActiveSource(), GetActiveView()
    surface = onsurface.Surface(made.Input)
    interactor = view.GetInteractor()
    updates = []

    made.SMProxy.AddObserver('UpdateDataEvent', lambda caller, event: updates.append((list(made.Seed), made.Radius)))
    camera = list(view.CameraPosition)

    def send(*events):
        """All before the window does anything else, as while a filter runs."""
        width, height = view.ViewSize
        for event, place in events:
            interactor.SetEventInformation(round(place[0] * width), round((1.0 - place[1]) * height))
            interactor.InvokeEvent(event)

    def check(place, *counts):
        """The seed is there, after one of these numbers of updates; and the camera is where it was."""
        surface.check_under(made.Seed, place)
        assert len(updates) in counts, updates
        assert list(view.CameraPosition) == camera
        updates.clear()

    start = list(made.Seed)
    grab = [('MouseMoveEvent', (0.5, 0.5)), ('LeftButtonPressEvent', (0.5, 0.5))]
    drop = [('MouseMoveEvent', (0.55, 0.5)), ('LeftButtonReleaseEvent', (0.55, 0.5))]''')


def back():
    w.python('made.Seed, made.Radius = start, 0.0; view.SMProxy.StillRender(); updates.clear()')


# After the release the mouse moves on.
w.python("send(*grab, *drop, ('MouseMoveEvent', (0.6, 0.45)))")
w.wait(200)
w.python('check((0.55, 0.5), 2)')
back()

# The next press is beside the handle.
w.python("send(*grab, *drop, ('LeftButtonPressEvent', (0.9, 0.1)), ('LeftButtonReleaseEvent', (0.9, 0.1)))")
w.wait(200)
w.python('check((0.55, 0.5), 2)')
back()

# It is on the ball again: Escape takes the second drag back, not the first.
w.python("send(*grab, *drop, ('LeftButtonPressEvent', (0.55, 0.5)), ('MouseMoveEvent', (0.6, 0.45)))")
w.wait(200)
w.key(window.ESCAPE)
w.mouse('Release', (0.6, 0.45), 1)
w.wait(100)
w.python('check((0.55, 0.5), 3, 4)')
back()

# The menu of the right button takes the release of the left one.
w.python('''
    send(*grab, drop[0], ('RightButtonPressEvent', (0.55, 0.5)), ('RightButtonReleaseEvent', (0.55, 0.5)),
         ('MouseMoveEvent', (0.6, 0.45)))''')
w.wait(200)
w.python('check((0.55, 0.5), 2)')
back()

# The second press of a double click begins a drag.
w.mouse('Move', (0.5, 0.5))
w.mouse('DblClick', (0.5, 0.5), 1, 1)
w.mouse('Move', (0.55, 0.5), 0, 1)
w.mouse('Release', (0.55, 0.5), 1)
w.wait(100)
w.python('check((0.55, 0.5), 2)')
back()

# The wheel does nothing to a ball that is held; a handle that is hidden is let go of.
w.press((0.5, 0.5))
w.python("send(('MouseWheelForwardEvent', (0.5, 0.5)))")
w.wait(100)
w.mouse('Move', (0.55, 0.5), 0, 1)
w.wait(100)
w.python('assert made.Radius == 0.0 and len(updates) == 1, updates')
w.event(SHOW, 'set_boolean', 'false')
w.wait(100)
w.python('check((0.55, 0.5), 2)')
w.mouse('Release', (0.55, 0.5), 1)
w.event(SHOW, 'set_boolean', 'true')
w.wait(100)
back()

# Ctrl+Z takes back the last burst of keys, however short ago that was, and redo brings it back.
w.key(0x2b, '+')
w.wait(600)
w.key(0x2b, '+')
w.key(CONTROL_KEY)
w.undo()
w.redo()
w.undo()
w.wait(600)
w.python('''
    radii = [radius for seed, radius in updates]
    once, twice = radii[0], 1.05 * radii[0]
    assert numpy.allclose(radii[-4:], [twice, once, twice, once], rtol=1e-9), radii
    updates.clear()''')
back()

# On a dense screen the ball is drawn larger, and so it is where it can be grabbed.
w.python('''
    view.GetRenderWindow().SetDPI(144)
    beside = 0.5 + 18.0 / view.ViewSize[0]
    send(('LeftButtonPressEvent', (beside, 0.5)), ('MouseMoveEvent', (beside + 0.05, 0.5)),
         ('LeftButtonReleaseEvent', (beside + 0.05, 0.5)))''')
w.wait(200)
w.python('check((0.55, 0.5), 2); view.GetRenderWindow().SetDPI(72)')
back()

# Of a number that is typed Auto Apply sees the end alone.
w.event('MainControlsToolbar/actionAutoApply', 'set_boolean', 'true')
w.event(RADIUS, 'set_string', '')
for key in '0.5':
    w.event(RADIUS, 'keyEvent', '6:%d:0:%s:0:1' % (ord(key), key))
    w.wait(300)
w.python('assert not updates, updates')
w.event(RADIUS, 'keyEvent', '6:%d:0::0:1' % RETURN_KEY)
w.wait(300)
w.python('''
    assert updates and {radius for seed, radius in updates} == {0.5}, updates
    updates.clear()''')
w.event('MainControlsToolbar/actionAutoApply', 'set_boolean', 'false')

# The real keys + and - reach the handle, although they are shortcuts of the window.
w.python('''
    def tool(*arguments):
        return subprocess.check_output(['xdotool', *arguments], text=True).split()

    main = tool('search', '--onlyvisible', '--name', 'ParaView')[0]
    tool('windowmove', main, '0', '0', 'windowsize', main, '1600', '1000')''')
w.wait(500)
w.python("tool('windowfocus', main, 'mousemove', '1000', '300', 'click', '1')")
w.wait(500)
w.python('''
    updates.clear()
    tool('key', 'plus', 'plus', 'minus', 'plus')''')
w.wait(1000)
w.python('assert numpy.isclose(made.Radius, 0.5 * 1.05**2), (made.Radius, updates)')
w.run()
