"""Landmarks are picked in the window: on two surfaces in one view, drawn apart or overlapping, and in two
views. They are dragged, removed, named and undone, saved in the state and in a file. Then Shape
Correspondence uses them. With a folder as argument, it gets a picture of each step."""
import os
import sys

import window

w = window.Window()
GROUP = window.PROPERTIES + 'ShapeLandmarks/'
SPLIT = window.VIEW.replace('Frame.0', 'Frame.%d')


def picture(name):
    if len(sys.argv) > 1:
        w.screenshot(os.path.join(sys.argv[1], name + '.png'))


def pick(*names):
    """Clicks at places that Python knows by name."""
    for name in names:
        w.drag([PLACES[name]])


# Two figures, the second drawn beside the first one and smaller: the surfaces in data coordinates overlap.
PLACES = {'head A': (0.367, 0.334), 'hand A': (0.265, 0.375), 'belly A': (0.367, 0.447), 'foot A': (0.34, 0.658),
          'head B': (0.66, 0.364), 'hand B': (0.586, 0.375), 'belly B': (0.66, 0.462), 'foot B': (0.641, 0.598),
          'none': (0.5, 0.8)}
w.open('FigureASmall.vtp')
w.open('FigureBSmall.vtp')
w.python('''
    import numpy, onsurface
    a, b = FindSource('FigureASmall.vtp'), FindSource('FigureBSmall.vtp')
    view = GetActiveView()
    made = ShapeLandmarks(registrationName='Landmarks', SurfaceA=a, SurfaceB=b)
    Show(a, view).Position = [-0.6, 0, 0]
    shown = Show(b, view)
    shown.Position, shown.Scale = [0.6, 0, 0.1], [0.8, 0.8, 0.8]
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [0, -4, 0.5], [0, 0, 0.5], [0, 0, 1]
    SetActiveSource(made)
    Render()
    surfaces = onsurface.Surface(a), onsurface.Surface(b)

    def points(side):
        return numpy.array(list((made.PointsA, made.PointsB)[side])).reshape(-1, 3)

    def in_view(side, place):
        return place + [-0.6, 0, 0] if side == 0 else 0.8 * place + [0.6, 0, 0.1]

    def same(place):
        return place

    def check(pixels, move=in_view):
        """The pairs are on their surfaces, where they were clicked."""
        assert len(points(0)) == len(points(1)) == len(pixels), (points(0), points(1))
        for i, pair in enumerate(pixels):
            for side, pixel in enumerate(pair):
                surfaces[side].check_at(points(side)[i], move(side, points(side)[i]), pixel)''')
w.apply()
w.fill_screen()

# Pairs may begin on either surface. A click beside the surfaces counts for nothing; Esc cancels a half.
w.event(GROUP + 'Buttons/Pick', 'set_boolean', 'true')
pick('head A', 'none', 'head B', 'hand B', 'hand A', 'foot A')
w.key(window.ESCAPE)
pick('belly A', 'belly B', 'foot B')
picture('half')
pick('foot A')
w.undo()
pairs = [(PLACES[name + ' A'], PLACES[name + ' B']) for name in ('head', 'hand', 'belly', 'foot')]
w.python('check(%r)' % pairs[:3])  # a pair is one step
pick('foot B', 'foot A')
w.undo()
w.redo()
w.python('check(%r)' % pairs)
w.check(GROUP + 'Buttons/Pick', 'checked', 'true')
w.key(window.ESCAPE)
w.check(GROUP + 'Buttons/Pick', 'checked', 'false')

# A landmark is dragged on its surface, and back; its partner stays. A removed pair comes back.
moved = (0.655, 0.44)
w.drag([pairs[2][1], (0.66, 0.45), moved])
w.drag([moved, (0.66, 0.45), pairs[2][1]])
w.mouse('Move', pairs[1][0])
w.key(window.DELETE)
w.wait(100)
w.undo()
w.python('check(%r)' % pairs)
w.drag([pairs[2][1], (0.66, 0.45), moved])
pairs[2] = (pairs[2][0], moved)
w.python('check(%r)' % pairs)

# Names are those of the table, and go with their pair.
w.event(GROUP + 'Landmarks', 'editAccepted', '2.0,belly')
w.wait(100)
w.python("assert list(made.Names) == ['', '', 'belly'], made.Names")
w.mouse('Move', pairs[1][0])
w.key(window.DELETE)
w.wait(100)
pairs = [pairs[i] for i in (0, 2, 3)]
w.python("check(%r); assert list(made.Names) == ['', 'belly'], made.Names" % pairs)
picture('named')

# A file of the pairs has every bit of them.
table = w.file('pairs.csv')
w.click(GROUP + 'Buttons/Save')
w.event('SaveLandmarks', 'filesSelected', table)
w.wait(100)
w.python('''
    saved = points(0), points(1)
    lines = open(%r).read().splitlines()
    assert lines[0] == 'x,y,z,tx,ty,tz,name' and len(lines) == 4, lines
    rows = numpy.array([line.split(',')[:6] for line in lines[1:]], dtype=float)
    assert (rows == numpy.hstack(saved)).all()
    assert [line.split(',')[6] for line in lines[1:]] == ['"1"', '"belly"', '"3"'], lines''' % table)

# Where the surfaces overlap, the one in front is meant; without a translation, they are in one place.
w.python('''
    made.PointsA, made.PointsB, made.Names = [], [], []
    shown.Position, shown.Scale = [0, -0.5, 0], [1, 1, 1]
    GetDisplayProperties(a, view).Position = [0, 0, 0]
    Render()''')
w.event(GROUP + 'Buttons/Pick', 'set_boolean', 'true')
middle = (0.5, 0.45)
w.drag([middle])
w.python("view.CameraPosition = [0, 4, 0.5]; Render()")
w.drag([middle])
picture('overlap')
w.python('''
    assert len(points(0)) == len(points(1)) == 1
    assert points(0)[0, 1] > 0.0 and points(1)[0, 1] < 0.0, 'not on the faces that were in front'
    made.PointsA, made.PointsB = [], []
    view.CameraPosition = [0, -4, 0.5]
    shown.Position = [0, 0, 0]''')

# Each surface in a view of its own.
w.python('''
    Hide(b, view)
    other = CreateView('RenderView')
    GetLayout(view).SplitHorizontal(0, 0.5)
    AssignViewToLayout(view=other, layout=GetLayout(view), hint=2)
    Show(b, other)
    for each in (view, other):
        each.CameraPosition, each.CameraFocalPoint, each.CameraViewUp = [0, -4, 0.5], [0, 0, 0.5], [0, 0, 1]
        Render(each)
    SetActiveView(view)
    SetActiveSource(made)''')
w.wait(500)
w.event(GROUP + 'Buttons/Pick', 'set_boolean', 'true')


def click(frame, place):
    for command, button, buttons in (('Move', 0, 0), ('Press', 1, 1), ('Release', 1, 0)):
        w.event(SPLIT % frame, 'mouse' + command, '(%r,%r,%d,%d,0)' % (*place, button, buttons))
    w.wait(100)


for place in (middle, (0.5, 0.3), (0.5, 0.38)):
    click(1, place)
    click(2, place)
picture('views')
w.python('''
    for each in (view, other):
        SetActiveView(each)
        side = 0 if each == view else 1
        for place, pixel in zip(points(side), %r):
            surfaces[side].check_at(place, place, pixel)
    assert len(points(0)) == len(points(1)) == 3, (points(0), points(1))
    assert abs(points(0) - points(1)).max() > 1e-3, 'the surfaces are the same' ''' % [
    middle, (0.5, 0.3), (0.5, 0.38)])

# What the file had is there again, and the filter's outputs are the landmarks of Shape Correspondence.
w.click(GROUP + 'Buttons/Load')
w.event('LoadLandmarks', 'filesSelected', table)
w.wait(100)
state = w.file('landmarks.pvsm')
w.python('''
    assert (points(0) == saved[0]).all() and (points(1) == saved[1]).all(), points(0)
    assert list(made.Names) == ['', 'belly', ''], made.Names
    import shapemap
    both = ShapeCorrespondence(SurfaceA=a, SurfaceB=b, Landmarks=made, Method='FunctionalMap', CoarsePoints=300)
    both.UpdatePipeline()
    assert shapemap.facts(both)['Landmarks'] == 3.0
    SaveState(%r)
    ResetSession()
    LoadState(%r)
    made = FindSource('Landmarks')
    assert (points(0) == saved[0]).all() and list(made.Names) == ['', 'belly', '']''' % (state, state))
w.run(240)
