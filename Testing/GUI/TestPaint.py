"""A point array is painted in the window: the brush follows the mouse, and each stroke is one step to undo.

TestPaint.py: in the window's own process; TestPaint.py pvserver: in a server."""
import contextlib
import sys

import shapetesting
import window

BRUSH = window.PROPERTIES + 'ShapeBrush/'
SETTINGS = BRUSH + 'Settings/'


def play(port):
    w = window.Window(port)
    w.open('DentedSphere600.vtp')
    w.filter('Shape Paint Array')
    w.wait(100)
    w.check(BRUSH + 'UndoLastStroke', 'enabled', 'false')
    # Paint applies a filter that is new, so that what is painted is seen.
    w.event(BRUSH + 'Paint', 'set_boolean', 'true')
    w.wait(300)
    w.check(window.PANEL + 'Accept', 'enabled', 'false')
    w.event(SETTINGS + 'Radius', 'set_double', '0.3')
    w.event(SETTINGS + 'Value', 'set_double', '2')
    w.python('''
        import numpy
        import onsurface
        from vtkmodules.util.numpy_support import vtk_to_numpy

        made, view = GetActiveSource(), GetActiveView()
        assert made.SMProxy.GetXMLName() == 'ShapePaintArray'
        surface = onsurface.Surface(made.Input)
        camera = list(view.CameraPosition)
        updates = []
        made.SMProxy.AddObserver('UpdateDataEvent', lambda caller, event: updates.append(
            (list(made.Strokes), list(made.StrokePoints))))

        def painted():
            data = servermanager.Fetch(made)
            return tuple(vtk_to_numpy(array).copy() for array in
                         (data.GetPoints().GetData(), data.GetPointData().GetArray('Painted')))

        def by_definition(radius, strength, value, positions):
            places = painted()[0].astype(float)
            share = numpy.linalg.norm(places[:, None] - numpy.reshape(positions, (1, -1, 3)), axis=2).min(axis=1) / radius
            return strength * value * numpy.where(share < 1.0, (1.0 - share**2)**2, 0.0)

        assert not painted()[1].any()''')

    # A stroke: every move of the mouse updates the result, and its positions lie close together.
    path = [(0.45, 0.5), (0.48, 0.5), (0.51, 0.49), (0.55, 0.48)]
    w.drag(path)
    w.check(window.PANEL + 'Accept', 'enabled', 'false')
    w.check(BRUSH + 'UndoLastStroke', 'enabled', 'true')
    w.python('''
        strokes, positions = list(made.Strokes), numpy.reshape(made.StrokePoints, (-1, 3))
        assert len(updates) >= 4 and [len(update[1]) for update in updates] == sorted(
            len(update[1]) for update in updates), [len(update[1]) for update in updates]
        assert strokes == [0.0, 0.3, 1.0, 2.0, float(len(positions))], strokes
        surface.check_under(positions[0], %r)
        surface.check_under(positions[-1], %r, 6)
        gaps = numpy.linalg.norm(numpy.diff(positions, axis=0), axis=1)
        assert len(gaps) > 5 and gaps.max() < 2.0 * 0.3 / 8.0, gaps
        assert numpy.allclose(painted()[1], by_definition(0.3, 1.0, 2.0, positions), atol=1e-12)
        assert painted()[1].max() > 1.0 and list(view.CameraPosition) == camera
        table = GetColorTransferFunction('Painted')
        assert table.RGBPoints[-4] >= painted()[1].max() - 1e-6, 'the colours grow with the values'
        first = painted()[1]''' % (path[0], path[-1]))

    # Undo and redo take one step for a stroke.
    w.drag([(0.5, 0.4), (0.52, 0.42), (0.54, 0.44)])
    w.drag([(0.5, 0.6), (0.52, 0.6)])
    w.undo()
    w.undo()
    w.python('assert len(made.Strokes) == 5 and numpy.array_equal(painted()[1], first), made.Strokes')
    w.drag([(0.5, 0.6), (0.52, 0.6)])
    w.undo()
    w.redo()
    w.python('assert len(made.Strokes) == 10 and not numpy.array_equal(painted()[1], first), made.Strokes')

    # The button and Backspace take the last stroke back; Escape the one that is drawn.
    w.click(BRUSH + 'UndoLastStroke')
    w.wait(100)
    w.python('assert numpy.array_equal(painted()[1], first)')
    w.drag([(0.5, 0.6)])
    w.python('assert len(made.Strokes) == 10 and made.Strokes[-1] == 1.0, made.Strokes')
    w.key(window.BACKSPACE)
    w.wait(100)
    w.press((0.5, 0.6))
    w.mouse('Move', (0.53, 0.6), 0, 1)
    w.wait(100)
    w.python('assert len(made.Strokes) == 10')
    w.key(window.ESCAPE)
    w.mouse('Release', (0.53, 0.6), 1)
    w.wait(100)
    w.python('assert numpy.array_equal(painted()[1], first) and len(made.StrokePoints) == 3 * len(positions)')

    # With Shift, the brush smooths: the values vary less.
    w.drag([path[1], path[2], path[1], path[2]], window.SHIFT)
    w.python('''
        assert made.Strokes[5:8] == [2.0, 0.3, 1.0], made.Strokes
        assert painted()[1].std() < 0.98 * first.std(), (painted()[1].std(), first.std())
        kept = list(made.Strokes), list(made.StrokePoints), painted()[1]''')

    # Keys change the radius, Add adds; without Paint, and beside the surface, a drag rotates the view.
    w.key(0x2b, '+')
    w.choose(SETTINGS + 'Mode', 'Add')
    w.drag([path[0]])
    w.python('''
        assert numpy.allclose(made.Strokes[-5:], [1.0, 0.33, 1.0, 2.0, 1.0]), made.Strokes
        expected = kept[2] + by_definition(0.33, 1.0, 2.0, made.StrokePoints[-3:])
        assert numpy.allclose(painted()[1], expected, atol=1e-12) and list(view.CameraPosition) == camera''')
    w.key(window.BACKSPACE)
    w.wait(100)
    w.drag([(0.02, 0.02), (0.1, 0.05)])
    w.python('assert list(made.Strokes) == kept[0] and list(view.CameraPosition) != camera')
    w.event(BRUSH + 'Paint', 'set_boolean', 'false')
    w.drag([(0.5, 0.5), (0.55, 0.5)])
    w.python('assert list(made.Strokes) == kept[0]')

    # A state file brings the strokes back, and the brush.
    w.python('''
        path = %r
        servermanager.SaveState(path)
        ResetSession()
        LoadState(path)
        made = FindSource('ShapePaintArray1')
        assert (list(made.Strokes), list(made.StrokePoints)) == kept[:2]
        made.UpdatePipeline()
        assert numpy.array_equal(painted()[1], kept[2])
        SetActiveSource(None)
        SetActiveSource(made)
        Render()''' % w.file('state.pvsm'))
    w.wait(300)
    w.check(SETTINGS + 'Radius', 'value', '0.3')
    w.check(SETTINGS + 'Mode', 'currentText', 'Smooth')
    w.run()


with contextlib.ExitStack() as stack:
    play(stack.enter_context(shapetesting.server(sys.argv[1:])) if sys.argv[1:] else None)
