"""Shape Paste Feature is dragged over its target in the window: the handle follows the mouse, the filter
runs while it moves and in full in the end, and one undo takes the drag back.

TestDragFeature.py: in the window's own process; TestDragFeature.py pvserver: in a server."""
import contextlib
import sys

import shapetesting
import window


def play(port):
    w = window.Window(port)
    w.python('''
        import numpy
        ball = Sphere(registrationName='Ball', ThetaResolution=48, PhiResolution=48)
        horn = Calculator(registrationName='Horn', Input=ball, ResultArrayName='Horn', CoordinateResults=1, Function=(
            'coords*(1+1.2*max(0, 1-((coordsX-0.5)^2+coordsY^2+coordsZ^2)/0.04)^3)'))
        loop = [[0.4, 0.3 * numpy.cos(angle), 0.3 * numpy.sin(angle)] for angle in numpy.linspace(0, 6, 20)]
        ShapeCutFeature(registrationName='Cut', Input=horn, LoopPoints=numpy.ravel(loop).tolist())''')
    w.open('DentedSphere600.vtp')
    w.filter('Shape Paste Feature')
    w.choose_inputs(Feature='Cut: Feature', Target='DentedSphere600.vtp')
    w.wait(100)
    w.apply()
    w.wait(100)

    # Every update is recorded: whether it was for speed, and the values.
    w.python('''
        import numpy
        import onsurface

        made = GetActiveSource()
        target = onsurface.Surface(made.Target)

        def values():
            return list(made.Seed), made.Rotation, made.Scale

        updates = []
        made.SMProxy.AddObserver('UpdateDataEvent', lambda caller, event: updates.append(
            (made.SMProxy.GetProperty('Dragging').GetElement(0), *values())))
        first = values()
        target.check_under(first[0], (0.5, 0.5))  # where it was put''')

    # The ball, over three places, and back, and forth.
    w.drag([(0.5, 0.5), (0.53, 0.5), (0.56, 0.49), (0.6, 0.48)])
    w.check(window.PANEL + 'Accept', 'enabled', 'false')
    w.undo()
    w.redo()
    w.undo()
    w.python('''
        assert [update[0] for update in updates] == [1, 1, 1, 0, 0, 0, 0], updates
        for update, pixel in zip(updates, [(0.53, 0.5), (0.56, 0.49), (0.6, 0.48), (0.6, 0.48)]):
            target.check_under(update[1], pixel)
            assert update[2:] == (0.0, 1.0), update
        assert updates[4][1:] == updates[6][1:] == first, 'undone'
        assert updates[5][1:] == updates[3][1:], 'redone'
        updates.clear()''')

    # Beside the target the feature stays where it was; Escape takes the drag back.
    w.drag([(0.5, 0.5), (0.6, 0.48), (0.02, 0.02)])
    w.press((0.6, 0.48))
    w.mouse('Move', (0.5, 0.5), 0, 1)
    w.key(window.ESCAPE)
    w.mouse('Release', (0.5, 0.5), 1)
    w.wait(100)
    w.python('''
        assert [update[0] for update in updates] == [1, 0, 1, 0], updates
        for update, pixel in zip(updates, [(0.6, 0.48), (0.6, 0.48), (0.5, 0.5), (0.6, 0.48)]):
            target.check_under(update[1], pixel)
        updates.clear()''')

    # With Shift the ball turns, with Control it scales: 0.5 degrees and 1 % for each pixel.
    w.drag([(0.6, 0.48), (0.65, 0.48)], window.SHIFT)
    w.drag([(0.6, 0.48), (0.6, 0.43)], window.CONTROL)
    w.python('''
        width, height = GetActiveView().ViewSize
        way = int(0.65 * width) - int(0.6 * width)
        rise = int(0.48 * height) - int(0.43 * height)
        assert [update[0] for update in updates] == [1, 0, 1, 0], updates
        assert numpy.isclose(updates[1][2], 0.5 * way) and updates[1][3] == 1.0, updates
        assert numpy.isclose(updates[3][2], 0.5 * way) and numpy.isclose(updates[3][3], 1.01**rise), updates
        made.Rotation, made.Scale = 0.0, 1.0
        Render()
        updates.clear()''')

    # A burst of keys is worked off once in full.
    for key, text in ((0x5b, '['), (0x5b, '['), (0x5d, ']'), (0x2b, '+')):
        w.key(key, text)
    w.wait(600)
    w.undo()
    w.python('''
        assert [update[0] for update in updates][-2:] == [0, 0], updates
        assert all(update[0] == 1 for update in updates[:-2]), updates
        assert updates[-2][2:] == (5.0, 1.05) and updates[-1][2:] == (0.0, 1.0), updates
        updates.clear()''')

    # The knob, which is where the output says that angle 0 points, turns and scales.
    w.python('''
        import shapemap

        def fact(name):
            return shapemap.facts(made)[name]

        seed, normal, direction = fact('Seed'), fact('Normal'), fact('Direction')
        bounds = numpy.reshape(made.Feature.GetDataInformation().GetBounds(), (3, 2))
        radius = 0.5 * numpy.linalg.norm(bounds[:, 1] - bounds[:, 0])
        interactor = GetActiveView().GetInteractor()

        def mouse(event, degrees, factor):
            angle = numpy.radians(degrees)
            arm = numpy.cos(angle) * direction + numpy.sin(angle) * numpy.cross(normal, direction)
            interactor.SetEventInformation(*target.pixel(seed + factor * radius * arm).round().astype(int))
            interactor.InvokeEvent(event)

        mouse('MouseMoveEvent', 0.0, 1.0)
        mouse('LeftButtonPressEvent', 0.0, 1.0)''')
    w.python("mouse('MouseMoveEvent', 40.0, 0.7)")
    w.wait(100)
    w.python("mouse('LeftButtonReleaseEvent', 40.0, 0.7)")
    w.wait(100)
    w.python('''
        assert [update[0] for update in updates] == [1, 0], updates
        assert updates[1][1] == list(made.Seed) and abs(updates[1][2] - 40.0) < 3.0, updates
        assert abs(updates[1][3] - 0.7) < 0.04, updates
        made.Scale = 3.0
        Render()
        updates.clear()''')

    # Where the feature is too large the drag ends with the largest that was not.
    w.drag([(0.6, 0.48), (0.6, 0.43), (0.6, 0.02)], window.CONTROL)
    w.python('''
        assert [update[0] for update in updates] == [1, 1, 0], updates
        assert updates[0][3] == updates[2][3] == made.Scale and 3.0 < made.Scale < 0.2 * updates[1][3], updates
        assert shapemap.facts(made)['Refused'] == 0
        made.Scale = 1.0
        Render()
        updates.clear()''')

    # A state file brings everything back, the handle, too.
    w.python('''
        import numpy
        path = %r
        kept = values()
        servermanager.SaveState(path)
        assert 'Dragging' not in open(path).read()
        ResetSession()
        LoadState(path)
        made = FindSource('ShapePasteFeature1')
        assert values() == kept, (values(), kept)
        SetActiveSource(None)
        SetActiveSource(made)
        Render()''' % w.file('state.pvsm'))
    w.wait(300)
    w.drag([(0.6, 0.48), (0.55, 0.5)])
    w.python('''
        target.check_under(made.Seed, (0.55, 0.5), 6)  # the new window's view differs by some pixels
        assert values()[1:] == kept[1:], values()''')
    printed = w.run()
    assert 'fit' not in printed, printed


with contextlib.ExitStack() as stack:
    play(stack.enter_context(shapetesting.server(sys.argv[1:])) if sys.argv[1:] else None)
