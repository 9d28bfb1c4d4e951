"""The boundary of a shape is moved, rotated, scaled and tilted in the window, and frames are set at points of
it: the shape follows while the mouse moves, and each drag is one step to undo.

TestDragCurve.py: in the window's own process; TestDragCurve.py pvserver: in a server."""
import contextlib
import sys

import shapetesting
import window


def drag(w, begin, *places, shift=0, control=0):
    """The left button is pressed at a place, moved over others and released; places are positions in space."""
    w.python('mouse(%s, %d, %d, "MouseMoveEvent", "LeftButtonPressEvent")' % (begin, shift, control))
    for place in places:
        w.python('mouse(%s, %d, %d, "MouseMoveEvent")' % (place, shift, control))
        w.wait(100)
    w.python('mouse(%s, 0, 0, "LeftButtonReleaseEvent")' % (places or (begin,))[-1])
    w.wait(200)


def play(port):
    w = window.Window(port)
    # A barrel: part 0 of its boundary is the lower rim, which is longer, and part 1 the upper one.
    w.python('''
        barrel = Sphere(registrationName='Barrel', Radius=1, ThetaResolution=48, PhiResolution=24, StartPhi=30,
                        EndPhi=100)
        Show(barrel)
        view = GetActiveView()
        view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [2, -5, 3], [0, 0, 0.3], [0, 0, 1]
        SetActiveSource(barrel)
        Render()''')
    w.filter('Shape Deform')
    w.wait(100)
    w.apply()
    w.wait(300)
    w.python('''
        import numpy
        import onsurface
        from vtkmodules.util.numpy_support import vtk_to_numpy

        made = GetActiveSource()
        assert made.SMProxy.GetXMLName() == 'ShapeDeform'
        interactor = view.GetInteractor()
        updates = []

        def watch():
            made.SMProxy.AddObserver('UpdateDataEvent', lambda caller, event: updates.append(
                (list(made.HandleMotions), list(made.FrameRotations))))

        watch()

        def mouse(place, shift, control, *events):
            pixel = onsurface.Surface.pixel(place).round().astype(int)
            interactor.SetEventInformation(int(pixel[0]), int(pixel[1]), control, shift)
            for event in events:
                interactor.InvokeEvent(event)

        def arrays(port, *names):
            data = servermanager.Fetch(made, idx=port).GetPointData()
            return [vtk_to_numpy(data.GetArray(name)).copy() for name in names]

        def positions(port):
            return vtk_to_numpy(servermanager.Fetch(made, idx=port).GetPoints().GetData()).astype(float)

        def centre(part):
            return positions(1)[arrays(1, 'Part')[0] == part].mean(axis=0)  # the samples are evenly spaced

        def axis(part):
            ring = positions(1)[arrays(1, 'Part')[0] == part] - centre(part)
            normal = -numpy.cross(ring, numpy.roll(ring, -1, axis=0)).sum(axis=0)  # away from the surface
            return normal / numpy.linalg.norm(normal)

        def pixel_length(place):
            """The length of a pixel at a place."""
            back = numpy.array(view.CameraPosition) - view.CameraFocalPoint
            depth = (numpy.array(view.CameraPosition) - place) @ back / numpy.linalg.norm(back)
            return 2.0 * depth * numpy.tan(numpy.radians(view.CameraViewAngle) / 2.0) / view.ViewSize[1]

        def gizmo(part):
            """Centre, knob, the direction at right angles, and tip."""
            there, normal = centre(part), axis(part)
            ring = positions(1)[arrays(1, 'Part')[0] == part] - there
            radius = numpy.linalg.norm(ring, axis=1).mean()
            first = ring[0] - ring[0] @ normal * normal
            first *= radius / numpy.linalg.norm(first)
            tip = there + (radius + 24 * pixel_length(there)) * normal
            return there, there + first, numpy.cross(normal, first), tip

        def angle(a, b):
            return numpy.degrees(numpy.arccos(a @ b / numpy.linalg.norm(a) / numpy.linalg.norm(b)))

        back = numpy.array(view.CameraPosition) - view.CameraFocalPoint
        right = numpy.cross(view.CameraViewUp, back)
        right /= numpy.linalg.norm(right)
        up = numpy.cross(back, right)
        up /= numpy.linalg.norm(up)
        rest = positions(0)
        assert abs(rest - arrays(0, 'SourcePosition')[0]).max() == 0
        assert made.HandleMotions == [] and made.FrameRotations == []
        assert set(arrays(1, 'Part')[0]) == {0, 1} and centre(1)[2] > centre(0)[2]
        camera = list(view.CameraPosition)
        start, way = centre(1), 0.4 * right + 0.2 * up''')

    # The ball of the upper rim: the rim follows the mouse in the plane of the view, and the lower one stays.
    drag(w, 'start', 'start + 0.3 * way', 'start + 0.6 * way', 'start + way')
    w.check(window.PANEL + 'Accept', 'enabled', 'false')
    w.undo()
    w.redo()
    w.undo()
    w.python('''
        assert abs(positions(0) - rest).max() == 0 and made.HandleMotions == []
        pixel = pixel_length(start)
        assert len(updates) == 7, updates
        for (motions, frames), share in zip(updates, (0.3, 0.6, 1.0, 1.0)):
            assert motions[0] == 1 and motions[4:] == [0, 0, 0, 1] and frames == [], motions
            assert numpy.linalg.norm(motions[1:4] - share * way) < 1.5 * pixel, (motions, share * way)
        assert updates[4] == updates[6] == ([], []) and updates[5] == updates[3], updates''')
    drag(w, 'start', 'start + 0.5 * way', 'start + way')
    w.python('''
        moved = numpy.array(made.HandleMotions[1:4])
        assert numpy.allclose(made.HandleMotions, updates[3][0], atol=1e-6), (made.HandleMotions, updates[3])
        source, part = arrays(1, 'SourcePosition', 'Part')
        assert abs(positions(1) - source - numpy.outer(part, moved)).max() < 1e-6
        now = positions(0)
        rim = rest[:, 2] > rest[:, 2].max() - 1e-6
        assert abs(now[rim] - rest[rim] - moved).max() < 1e-6
        other = rest[:, 2] < rest[:, 2].min() + 1e-6
        assert abs(now[other] - rest[other]).max() < 1e-6 and list(view.CameraPosition) == camera
        updates.clear()
        before = made.HandleMotions[:]''')

    # Escape takes a drag back.
    w.python('mouse(centre(1), 0, 0, "MouseMoveEvent", "LeftButtonPressEvent")')
    w.python('mouse(centre(1) + 0.3 * right, 0, 0, "MouseMoveEvent")')
    w.wait(100)
    w.key(window.ESCAPE)
    w.python('mouse(centre(1), 0, 0, "LeftButtonReleaseEvent")')
    w.wait(100)
    w.python('assert len(updates) == 2 and made.HandleMotions == before, updates; updates.clear()')

    # The knob rotates and scales; with Shift it only rotates, with Control it only scales.
    w.python('''
        def turned(degrees, factor):
            there, knob, across, tip = fixed
            radians = numpy.radians(degrees)
            return there + factor * (numpy.cos(radians) * (knob - there) + numpy.sin(radians) * across)

        fixed, normal = gizmo(1), axis(1)''')
    drag(w, 'fixed[1]', 'turned(20, 0.9)', 'turned(40, 0.7)')
    w.python('''
        part, turn, scale = made.HandleMotions[0], numpy.array(made.HandleMotions[4:7]), made.HandleMotions[7]
        assert part == 1 and abs(turn - 40 * normal).max() < 3 and abs(scale - 0.7) < 0.04, made.HandleMotions
        assert made.HandleMotions[1:4] == before[1:4], made.HandleMotions
        source, part = arrays(1, 'SourcePosition', 'Part')
        base = numpy.linalg.norm(source[part == 1] - source[part == 1].mean(axis=0), axis=1)
        assert abs(numpy.linalg.norm(positions(1)[part == 1] - centre(1), axis=1) - scale * base).max() < 1e-5
        assert angle(axis(1), normal) < 0.1
        fixed = gizmo(1)''')
    drag(w, 'fixed[1]', 'turned(30, 1.3)', shift=1)
    w.python('''
        assert made.HandleMotions[7] == scale and abs(made.HandleMotions[4:7] - 70 * normal).max() < 6, made.HandleMotions
        turn, fixed = made.HandleMotions[4:7], gizmo(1)''')
    drag(w, 'fixed[1]', 'turned(25, 1.2)', control=1)
    w.python('''
        assert made.HandleMotions[4:7] == turn and abs(made.HandleMotions[7] / scale - 1.2) < 0.06, made.HandleMotions
        fixed = gizmo(1)
        pulled = fixed[3] + 0.3 * right - 0.1 * up''')

    # The tip of the axis tilts: the axis points to the mouse.
    drag(w, 'fixed[3]', 'fixed[3] + 0.1 * right', 'pulled')
    w.python('''
        assert angle(axis(1), pulled - fixed[0]) < 1.5 < angle(normal, pulled - fixed[0]), axis(1)
        assert abs(centre(1) - fixed[0]).max() < 1e-5
        updates.clear()
        still = positions(0)
        source, part = arrays(1, 'SourcePosition', 'Part')
        samples = numpy.flatnonzero(part == 0)
        # Two samples of the lower rim: the one nearest to the viewer, and one beside the barrel.
        front = samples[(source[samples] @ back).argmax()]
        side = samples[(source[samples] @ right).argmax()]''')

    # A click adds a frame, which changes nothing.
    drag(w, 'source[front]')
    drag(w, 'source[side]')
    w.python('''
        frames = numpy.reshape(made.FrameRotations, (2, 6))
        assert abs(frames[:, :3] - source[[front, side]]).max() < 1e-6 and abs(frames[:, 3:]).max() == 0, frames
        assert abs(positions(0) - still).max() < 1e-6

        def stick(sample):
            there, normal = positions(1)[sample], arrays(1, 'TargetNormal')[0][sample]
            return there, there + 60 * pixel_length(there) * normal

        place, tip = stick(side)
        target = tip + 0.3 * up''')
    # Its tip turns the shape there; the other frame holds, and between them the rotation is shared.
    drag(w, 'tip', 'tip + 0.1 * up', 'target')
    w.python('''
        frames = numpy.reshape(made.FrameRotations, (2, 6))
        normals, turns = arrays(1, 'TargetNormal', 'FrameTurn')
        assert abs(frames[0, 3:]).max() == 0 and angle(normals[side], target - place) < 1.5, frames
        size = numpy.linalg.norm(turns[samples], axis=1)
        assert size[samples == front] == 0 and size.max() == size[samples == side] > 10, size
        assert numpy.allclose(turns[side], frames[1, 3:]) and ((size > 1) & (size < size.max() - 1)).sum() > 30
        peeled = positions(0)
        assert abs(peeled - still).max() > 0.02
        assert abs(peeled[other] - rest[other]).max() < 1e-6
        place, tip = stick(side)''')
    drag(w, 'tip', 'tip + 0.1 * up')
    w.undo()
    w.python('assert numpy.allclose(made.FrameRotations, frames.ravel()) and abs(positions(0) - peeled).max() < 1e-6')

    # A state file brings everything back, and the handle, too.
    w.python('''
        kept = list(made.HandleMotions), list(made.FrameRotations)
        path = %r
        servermanager.SaveState(path)
        ResetSession()
        LoadState(path)
        made, view = FindSource('ShapeDeform1'), GetActiveView()
        interactor = view.GetInteractor()
        assert (list(made.HandleMotions), list(made.FrameRotations)) == kept
        made.UpdatePipeline()
        assert abs(positions(0) - peeled).max() < 1e-9
        SetActiveSource(None)
        SetActiveSource(made)
        Render()
        watch()''' % w.file('state.pvsm'))
    w.wait(300)
    # Delete removes the frame under the mouse.
    w.python('''
        place, tip = stick(side)
        mouse(tip, 0, 0, "MouseMoveEvent")''')
    w.key(window.DELETE)
    w.wait(200)
    w.python('''
        assert numpy.allclose(made.FrameRotations, kept[1][:6]), made.FrameRotations
        assert abs(positions(0) - still).max() < 1e-6
        start = centre(0)''')
    drag(w, 'start', 'start - 0.2 * up')
    w.python('''
        assert list(made.HandleMotions[:8]) == kept[0] and made.HandleMotions[8] == 0, made.HandleMotions
        assert abs(centre(0) - start + 0.2 * up).max() < 2 * pixel_length(start), centre(0)''')
    w.run(seconds=240)


with contextlib.ExitStack() as stack:
    play(stack.enter_context(shapetesting.server(sys.argv[1:])) if sys.argv[1:] else None)
