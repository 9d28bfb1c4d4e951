"""How often a second a feature of some 10,000 triangles is set down on another place of the bunny (75,408)
while it is dragged in the real window, and where the time goes. Without a graphics card everything is drawn
by the processor, and the size of the view counts most.

Utilities/pvpython.sh Testing/Benchmarks/DragRate.py WIDTH HEIGHT [pvserver]
prints the size of the view, the updates a second and, in milliseconds for an update, the median time in the
filter (where the window runs it), from there until the data are in the view, for drawing, and for the rest."""
import contextlib
import os
import sys
import tempfile

import sweep

import scenes
import shapetesting

sys.path.append(os.path.join(sweep.ROOT, 'Testing', 'GUI'))
import window

UPDATES = 40
SECONDS = 40


def play(size, port, result):
    w = window.Window(port)
    surface = w.file('bunny.vtp')
    shapetesting.write(scenes.model('bunny00'), surface)
    w.python('''
        import subprocess
        import numpy
        subprocess.check_call(['xdotool', 'search', '--onlyvisible', '--name', 'ParaView',
                               'windowmove', '0', '0', 'windowsize', '1600', '1000'])
        bunny = XMLPolyDataReader(registrationName='Bunny', FileName=[%r])
        Show(bunny)
        GetLayout().PreviewMode = %r
        bounds = numpy.reshape(bunny.GetDataInformation().GetBounds(), (3, 2))
        size = 0.1 * numpy.linalg.norm(bounds[:, 1] - bounds[:, 0])
        ball = Sphere(registrationName='Ball', Radius=size, ThetaResolution=265, PhiResolution=265)
        place = '((coordsX-%%r)^2+coordsY^2+coordsZ^2)/%%r^2' %% (size, size)
        horn = Calculator(registrationName='Horn', Input=ball, ResultArrayName='Horn', CoordinateResults=1,
                          Function='coords*(1+1.2*max(0, 1-%%s/0.16)^3)' %% place)
        loop = [[0.8 * size, 0.6 * size * numpy.cos(angle), 0.6 * size * numpy.sin(angle)]
                for angle in numpy.linspace(0, 6, 20)]
        ShapeCutFeature(registrationName='Cut', Input=horn, LoopPoints=numpy.ravel(loop).tolist())
        ResetCamera()
        Render()''' % (surface, size))
    w.wait(1000)
    w.filter('Shape Paste Feature')
    w.choose_inputs(Feature='Cut: Feature', Target='Bunny')
    w.wait(100)
    w.apply()
    w.wait(1000)
    w.python('''
        import time
        marks = []

        def mark(caller, event, name):
            caller.AddObserver(event, lambda *ignored: marks.append((name, time.perf_counter())))

        made, view = GetActiveSource(), GetActiveView()
        filter = made.SMProxy.GetClientSideObject()
        if filter:
            mark(filter, 'StartEvent', 'start')
            mark(filter, 'EndEvent', 'done')
        mark(made.SMProxy, 'UpdateDataEvent', 'data')
        mark(view.SMProxy, 'EndEvent', 'drawn')''')
    # The window's own events would be a test's, which are slow: the mouse is moved by a timer.
    w.python('''
        interactor = view.GetInteractor()
        middle = numpy.array(view.ViewSize) // 2

        def move(event, updates=0):
            interactor.SetEventInformation(int(middle[0] + updates), int(middle[1]))
            interactor.InvokeEvent(event)

        def go_on(*ignored):
            """To the right by a pixel for each update."""
            updates = sum(name == 'data' for name, at in marks)
            if updates < %d:
                move('MouseMoveEvent', updates + 1)
            else:
                interactor.DestroyTimer(timer)
                move('LeftButtonReleaseEvent', updates)

        move('MouseMoveEvent')
        move('LeftButtonPressEvent')
        interactor.AddObserver('TimerEvent', go_on)
        timer = interactor.CreateRepeatingTimer(5)''' % UPDATES)
    w.wait(1000 * SECONDS)
    w.python('''
        first = [at for name, at in marks if name == 'data'][:%d]
        assert len(first) == %d and shapemap.facts(made)['Refused'] == 0, len(first)

        def median(begin, end):
            """Of the times from each `begin` to the `end` that follows it."""
            times, last = [], None
            for name, at in marks:
                if name == end and last is not None:
                    times.append(at - last)
                last = at if name == begin else last if name != end else None
            return 1e3 * numpy.median(times) if times else float('nan')

        feature, all = made.Feature.GetDataInformation(), made.GetDataInformation()
        with open(%r, 'w') as file:
            file.write('view %%d x %%d, %%d triangles of %%d: %%.1f updates/s; ms: filter %%.0f, data %%.0f, '
                       'drawing %%.0f, rest %%.0f' %% (
                *view.ViewSize, feature.GetNumberOfCells(), all.GetNumberOfCells(),
                (len(first) - 1) / (first[-1] - first[0]), median('start', 'done'), median('done', 'data'),
                median('data', 'drawn'), median('drawn', 'start' if filter else 'data')))''' % (
        UPDATES, UPDATES, result))
    w.run(seconds=SECONDS + 120)


size = [int(argument) for argument in sys.argv[1:3]]
with contextlib.ExitStack() as stack:
    port = stack.enter_context(shapetesting.server(sys.argv[3:])) if sys.argv[3:] else None
    result = stack.enter_context(tempfile.NamedTemporaryFile('r'))
    play(size, port, result.name)
    print(result.read())
