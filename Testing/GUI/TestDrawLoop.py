"""A loop for Shape Cut Feature is drawn in the window, place by place; then its places are moved."""
import window

places = [(0.5, 0.4), (0.45, 0.45), (0.46, 0.52), (0.53, 0.55)]

w = window.Window()
w.open('DentedSphere600.vtp')
w.filter('Shape Cut Feature')
w.wait(100)
w.python('''
    import onsurface
    made = GetActiveSource()
    surface = onsurface.Surface(made.Input)
    camera = list(GetActiveView().CameraPosition)
    updates = []
    made.SMProxy.AddObserver('UpdateDataEvent', lambda caller, event: updates.append(
        (made.SMProxy.GetProperty('Dragging').GetElement(0), list(made.LoopPoints))))

    def check_places(pixels):
        found = list(made.LoopPoints)
        assert len(found) == 3 * len(pixels), found
        for i, pixel in enumerate(pixels):
            surface.check_under(found[3 * i:3 * i + 3], pixel)''')


def draw(clicks):
    w.event(window.PROPERTIES + 'ShapeLoop/DrawLoop', 'set_boolean', 'true')
    for place in clicks:
        w.drag([place])


# What is beside the surface counts for nothing, Backspace takes the last place back; a drag turns the camera.
draw(places[:2] + [(0.02, 0.02), (0.57, 0.5)])
w.key(window.BACKSPACE)
w.drag([(0.2, 0.2), (0.25, 0.2)])
w.python("assert list(GetActiveView().CameraPosition) != camera and not list(made.LoopPoints)")
w.python("GetActiveView().CameraPosition = camera; GetActiveView().CameraViewUp = [0, 1, 0]; Render()")
for place in places[2:]:
    w.drag([place])
w.mouse('DblClick', places[-1], 1, 1)
w.mouse('Release', places[-1], 1)
w.apply()
w.wait(100)
w.check(window.PROPERTIES + 'ShapeLoop/DrawLoop', 'checked', 'false')
w.python('check_places(%r); updates.clear()' % places)

# A place is moved, and what follows is one step to undo.
w.drag([places[3], (0.55, 0.52), (0.57, 0.5)])
w.check(window.PANEL + 'Accept', 'enabled', 'false')
w.undo()
w.redo()
w.python('''
    assert [update[0] for update in updates] == [1, 1, 0, 0, 0], updates
    check_places(%r)
    assert len(updates[3][1]) == 12 and updates[3][1] != updates[4][1] == updates[2][1]''' %
         (places[:3] + [(0.57, 0.5)]))
w.press(places[1])
w.mouse('Release', places[1], 1)
w.key(window.DELETE)
w.wait(100)
w.python('check_places(%r)' % [places[0], places[2], (0.57, 0.5)])

# Escape leaves the loop that was; Enter closes another one.
draw(places)
w.key(window.ESCAPE)
w.python('check_places(%r)' % [places[0], places[2], (0.57, 0.5)])
draw(places)
w.key(window.ENTER)
w.wait(100)
w.python('check_places(%r); updates.clear()' % places)

# What is undone while a place is held is no longer there: the drag changes nothing.
draw(places + [(0.57, 0.5)])
w.key(window.ENTER)
w.wait(100)
w.press((0.57, 0.5))
w.undo()
w.mouse('Move', (0.58, 0.48), 0, 1)
w.mouse('Release', (0.58, 0.48), 1)
w.wait(100)
w.python('''
    assert all(update[0] == 0 for update in updates), updates
    check_places(%r)''' % places)

# Delete removes the place under the mouse: there is none, then, until the mouse moves on.
w.mouse('Move', (0.02, 0.02))
draw(places + [(0.57, 0.5)])
w.key(window.ENTER)
w.wait(100)
w.mouse('Move', places[1])
w.key(window.DELETE)
w.wait(100)
w.key(window.DELETE)
w.wait(100)
w.python('check_places(%r)' % [places[0], *places[2:], (0.57, 0.5)])
w.run()
