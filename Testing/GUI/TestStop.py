"""The abort button of the status bar stops a Shape Hex Remesh of the bunny, which takes a minute, and so does
Escape: its output is empty, Apply is enabled and runs it again.

TestStop.py: in the window's own process; TestStop.py pvserver: in a server."""
import contextlib
import os
import sys

import shapetesting
import window

sys.path.append(os.path.join(shapetesting.ROOT, 'Utilities', 'reproduce'))
import scenes


def play(port):
    w = window.Window(port)
    w.fill_screen()
    surface = w.file('bunny.vtp')
    shapetesting.write(scenes.model('bunny00'), surface)
    w.open(surface)
    w.filter('Shape Hex Remesh')
    w.wait(100)
    w.python('''
        import os
        import subprocess
        import time
        import abortbutton

        assert abortbutton.find() is None, 'the button is enabled before the filter runs'
        made = GetActiveSource()

        def press(what, result):
            global presser
            presser = subprocess.Popen(['python3', abortbutton.__file__, what, result])

        def check_stopped(what, result):
            now = time.time()
            try:
                presser.wait(5)  # until the button or the key is released
            except subprocess.TimeoutExpired:
                presser.kill()
                raise AssertionError('the filter ended before the button was enabled')
            pressed = float(open(result).read().split()[0])
            with open(os.environ['STOP_TIMES'], 'a') as file:
                file.write('%s: %.2f s from the press until the window goes on\\n' % (what, now - pressed))
            assert made.GetDataInformation().GetNumberOfCells() == 0, 'the filter was not stopped' ''')
    for what in ('button', 'Escape'):
        result = w.file(what + '.txt')
        w.python('press(%r, %r)' % (what, result))
        w.apply()
        w.python('check_stopped(%r, %r)' % (what, result))
        w.wait(500)
        w.check(window.PANEL + 'Accept', 'enabled', 'true')
        w.python('assert abortbutton.find() is None, "the button is enabled after the end"')
        if what == 'button':
            w.screenshot(os.path.join(shapetesting.BUILD, 'Testing', 'Temporary', 'Stopped.png'))

    # A run that nobody stops has its whole result.
    w.python('made.Method = "Grid"; made.CellsOnLongestSide = 6')
    w.apply()
    w.check(window.PANEL + 'Accept', 'enabled', 'false')
    w.python('assert made.GetDataInformation().GetNumberOfCells() > 20')
    w.run(240)


times = os.environ['STOP_TIMES'] = os.path.join(shapetesting.BUILD, 'Testing', 'Temporary', 'stop-times.txt')
os.makedirs(os.path.dirname(times), exist_ok=True)
open(times, 'w').close()
with contextlib.ExitStack() as stack:
    play(stack.enter_context(shapetesting.server(sys.argv[1:])) if sys.argv[1:] else None)
print(open(times).read())
