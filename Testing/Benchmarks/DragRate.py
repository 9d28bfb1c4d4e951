"""How often a second a filter follows the mouse in the real window, and where the time goes.

paste: a feature of some 10,000 triangles is set down on another place of the bunny (75,408). deform: the
boundary of the bunny, whose base is cut off, is translated; frame: a frame at a point of this boundary is
rotated, while three others hold. modes: the slider of a mode of Shape Synthesize is moved by the arrow keys,
which carries 20,000 hexahedra of a bone. Without a graphics card everything is drawn by the processor, and the
size of the view counts most.

Utilities/pvpython.sh Testing/Benchmarks/DragRate.py paste|deform|frame|modes WIDTH HEIGHT [pvserver]
prints the size of the view, the median updates a second, those without the drawing (by the clock and, in case
other programs run, by the CPU time of the window's main thread) and, in milliseconds for an update, the median
time in the filter (where the window runs it), from there until the data are in the view, for drawing, and for
the rest. Last come the CPU times of an update in the main thread and in the other threads, those of Mesa."""
import contextlib
import os
import sys
import tempfile

from paraview import simple

import sweep

import scenes
import shapetesting

sys.path.append(os.path.join(sweep.ROOT, 'Testing', 'GUI'))
import window

UPDATES = 40
SECONDS = 40
SLIDER = (182, 832)  # the place of the slider of Mode0 on the screen


def begin(w, size):
    """The bunny in a view of this size."""
    surface = w.file('bunny.vtp')
    shapetesting.write(scenes.model('bunny00'), surface)
    w.python('''
        import subprocess
        import numpy
        import onsurface
        subprocess.check_call(['xdotool', 'search', '--onlyvisible', '--name', 'ParaView',
                               'windowmove', '0', '0', 'windowsize', '1600', '1000'])
        bunny = XMLPolyDataReader(registrationName='Bunny', FileName=[%r])
        Show(bunny)
        GetLayout().PreviewMode = %r
        bounds = numpy.reshape(bunny.GetDataInformation().GetBounds(), (3, 2))''' % (surface, size))


def paste(w):
    w.python('''
        size = 0.1 * numpy.linalg.norm(bounds[:, 1] - bounds[:, 0])
        ball = Sphere(registrationName='Ball', Radius=size, ThetaResolution=265, PhiResolution=265)
        place = '((coordsX-%r)^2+coordsY^2+coordsZ^2)/%r^2' % (size, size)
        horn = Calculator(registrationName='Horn', Input=ball, ResultArrayName='Horn', CoordinateResults=1,
                          Function='coords*(1+1.2*max(0, 1-%s/0.16)^3)' % place)
        loop = [[0.8 * size, 0.6 * size * numpy.cos(angle), 0.6 * size * numpy.sin(angle)]
                for angle in numpy.linspace(0, 6, 20)]
        ShapeCutFeature(registrationName='Cut', Input=horn, LoopPoints=numpy.ravel(loop).tolist())
        ResetCamera()
        Render()''')
    w.wait(1000)
    w.filter('Shape Paste Feature')
    w.choose_inputs(Feature='Cut: Feature', Target='Bunny')
    w.wait(100)
    w.apply()
    w.wait(1000)
    w.python('''
        made, view = GetActiveSource(), GetActiveView()
        start = numpy.array(view.ViewSize) // 2''')


def deform(w, frames=False):
    w.python('''
        low, high = bounds[1]
        cut = Clip(registrationName='Cut', Input=bunny, ClipType='Plane', Invert=0)
        cut.ClipType.Origin, cut.ClipType.Normal = [0, low + 0.03 * (high - low), 0], [0, 1, 0]
        base = ExtractSurface(registrationName='Base', Input=cut)
        Show(base)
        Hide(bunny)
        ResetCamera()
        Render()
        SetActiveSource(base)''')
    w.wait(1000)
    w.filter('Shape Deform')
    w.wait(100)
    w.apply()
    w.wait(5000)
    w.python('''
        from vtkmodules.util.numpy_support import vtk_to_numpy
        made, view = GetActiveSource(), GetActiveView()
        handle = servermanager.Fetch(made, idx=1)
        positions = vtk_to_numpy(handle.GetPoints().GetData()).astype(float)
        ends = vtk_to_numpy(handle.GetLines().GetConnectivityArray()).reshape(-1, 2)
        ends = ends[vtk_to_numpy(handle.GetPointData().GetArray('Part'))[ends[:, 0]] == 0]
        lengths = numpy.linalg.norm(positions[ends[:, 0]] - positions[ends[:, 1]], axis=1)
        start = onsurface.Surface.pixel(lengths @ positions[ends].mean(axis=1) / lengths.sum())''')
    if frames:
        w.python('''
            places = positions[ends[:: len(ends) // 4, 0]][:4]
            made.FrameRotations = numpy.hstack([places, numpy.zeros_like(places)]).ravel().tolist()
            Render()
            normal = vtk_to_numpy(handle.GetPointData().GetArray('TargetNormal'))[ends[0, 0]]
            here = onsurface.Surface.pixel(places[0])
            # A frame is drawn 60 pixels long, if it does not point to the viewer.
            back = numpy.array(view.CameraPosition) - view.CameraFocalPoint
            depth = (view.CameraPosition - places[0]) @ back / numpy.linalg.norm(back)
            pixel = 2.0 * depth * numpy.tan(numpy.radians(view.CameraViewAngle) / 2.0) / view.ViewSize[1]
            start = onsurface.Surface.pixel(places[0] + 60 * pixel * normal)''')
        w.wait(1000)


def modes(w):
    """A bone whose sliders move its hexahedra, in place of the bunny."""
    surface, solid = w.file('bone.vtp'), w.file('bone.vtu')
    ball = simple.Clean(Input=simple.Sphere(Radius=1.0, ThetaResolution=48, PhiResolution=48))
    bone = simple.Calculator(Input=ball, CoordinateResults=1, Function='1.8*coordsZ*kHat + '
                             '(0.35 + 0.45*coordsZ^2)*(coordsX*iHat + coordsY*jHat)')
    atlas = simple.Calculator(Input=bone, ResultArrayName='SourcePosition', Function='coords')
    for k, mode in enumerate(('0.14*(coordsZ^2*iHat - 2*coordsX*coordsZ*kHat)', '0.12*coordsZ*kHat',
                              '0.12*coordsZ*(coordsX*iHat + coordsY*jHat)')):
        atlas = simple.Calculator(Input=atlas, ResultArrayName='Mode%d' % k, Function=mode)
    simple.SaveData(surface, atlas)
    simple.SaveData(solid, simple.ShapeHexRemesh(Surface=bone, CellSize=0.0478))
    w.python('''
        Hide(bunny)
        atlas = XMLPolyDataReader(registrationName='Atlas', FileName=[%r])
        bone = XMLUnstructuredGridReader(registrationName='Bone', FileName=[%r])
        Show(atlas)
        Show(bone)
        ResetCamera()
        Render()
        SetActiveSource(atlas)''' % (surface, solid))
    w.wait(1000)
    w.filter('Shape Synthesize')
    w.wait(100)
    w.choose_inputs(Data='Bone')
    w.wait(100)
    w.apply()
    w.wait(5000)
    w.event('MainControlsToolbar/actionAutoApply', 'set_boolean', 'true')
    w.python('made, view = GetActiveSource(), GetActiveView()')


def move_mouse(w):
    """In the view, by a timer: the window's own events would be a test's, which are slow."""
    w.python('''
        interactor = view.GetInteractor()

        def move(event, updates=0):
            interactor.SetEventInformation(round(start[0]) + updates, round(start[1]))
            interactor.InvokeEvent(event)

        def go_on(*ignored):
            """To the right by a pixel for each update."""
            updates = sum(mark[0] == 'data' for mark in marks)
            if updates < %d:
                move('MouseMoveEvent', updates + 1)
            else:
                interactor.DestroyTimer(timer)
                move('LeftButtonReleaseEvent', updates)

        move('MouseMoveEvent')
        move('LeftButtonPressEvent')
        interactor.AddObserver('TimerEvent', go_on)
        timer = interactor.CreateRepeatingTimer(5)''' % UPDATES)


def press_keys(w):
    """The slider of the first mode is clicked, where it lies in a window of this size, and the arrow keys move it."""
    w.python('''
        keys = 'xdotool key --delay 60 ' + ' '.join(['Right'] * 40 + ['Left'] * 80 + ['Right'] * 40)
        subprocess.Popen('xdotool mousemove %d %d click 1; sleep 1; for i in 1 2 3 4; do %%s; done' %% keys, shell=True)'''
             % SLIDER)


def play(scene, size, port, result):
    w = window.Window(port)
    begin(w, size)
    scene(w)
    w.python('''
        import time
        marks = []

        def mark(caller, event, name):
            caller.AddObserver(event, lambda *ignored: marks.append(
                (name, time.perf_counter(), time.thread_time(), time.process_time())))

        filter = made.SMProxy.GetClientSideObject()
        if filter:
            mark(filter, 'StartEvent', 'start')
            mark(filter, 'EndEvent', 'done')
        mark(made.SMProxy, 'UpdateDataEvent', 'data')
        mark(view.SMProxy, 'EndEvent', 'drawn')''')
    (press_keys if scene is modes else move_mouse)(w)
    w.wait(1000 * SECONDS)
    w.python('''
        import shapemap
        first = [mark[1:] for mark in marks if mark[0] == 'data'][:%d]
        assert len(first) == %d, 'only %%d updates' %% len(first)
        assert shapemap.facts(made).get('Refused', 0) == 0

        def median(begin, end, clock=1):
            """In milliseconds, of the times from each `begin` to the `end` that follows it."""
            times, last = [], None
            for mark in marks:
                if mark[0] == end and last is not None:
                    times.append(mark[clock] - last)
                last = mark[clock] if mark[0] == begin else last if mark[0] != end else None
            return 1e3 * numpy.median(times) if times else float('nan')

        def rates(clock):
            """Updates a second, and without the drawing."""
            period = 1e3 * numpy.median(numpy.diff(first, axis=0)[:, clock - 1])
            return 1e3 / period, 1e3 / (period - median('data', 'drawn', clock))

        cpu = 1e3 * numpy.median(numpy.diff(first, axis=0), axis=0)[1:]
        with open(%r, 'w') as file:
            file.write('view %%d x %%d, %%d triangles: %%.1f updates/s, %%.1f without the drawing (%%.1f by the CPU time '
                       'of the main thread); ms: filter %%.0f, data %%.0f, drawing %%.0f, rest %%.0f; CPU %%.0f, other threads %%.0f' %% (
                *view.ViewSize, made.GetDataInformation().GetNumberOfCells(), *rates(1), rates(2)[1],
                median('start', 'done'), median('done', 'data'), median('data', 'drawn'),
                median('drawn', 'start' if filter else 'data'), cpu[0], cpu[1] - cpu[0]))''' % (UPDATES, UPDATES, result))
    w.run(seconds=SECONDS + 120)


scene = {'paste': paste, 'deform': deform, 'modes': modes, 'frame': lambda w: deform(w, frames=True)}[sys.argv[1]]
size = [int(argument) for argument in sys.argv[2:4]]
with contextlib.ExitStack() as stack:
    port = stack.enter_context(shapetesting.server(sys.argv[4:])) if sys.argv[4:] else None
    result = stack.enter_context(tempfile.NamedTemporaryFile('r'))
    play(scene, size, port, result.name)
    print(result.read())
