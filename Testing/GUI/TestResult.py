"""The panel sums up what a filter did, in words; it follows the filter, and has all facts in a table.

TestResult.py: in the window's own process; TestResult.py pvserver: in a server."""
import contextlib
import sys

from paraview import simple

import shapemap
import shapetesting
import window

RESULT = window.PANEL + 'ShapeResult'

surface = simple.XMLPolyDataReader(FileName=[shapetesting.data_file('DentedSphere600.vtp')])


def facts(**properties):
    """All facts of Shape Parameterize, read without the window."""
    made = simple.ShapeParameterize(Input=surface, **properties)
    made.UpdatePipeline()
    return shapemap.facts(made)


def text(found):
    return ('Method %s, %d iterations\nMean conformal distortion %.3g (1: angles are preserved)\nFlipped triangles: %d' %
            tuple(found[name] for name in ('Method', 'Iterations', 'ConformalDistortion', 'FlippedTriangles')))


def play(port):
    w = window.Window(port)
    w.open('DentedSphere600.vtp')
    w.filter('Shape Parameterize')
    w.apply()
    w.check(RESULT, 'visible', 'true')
    w.check(RESULT + '/Lines', 'text', text(facts()))
    w.check(RESULT + '/Warnings', 'visible', 'false')
    w.check(RESULT + '/Facts', 'visible', 'false')
    w.event(RESULT + '/All', 'set_boolean', 'true')
    w.check(RESULT + '/Facts', 'visible', 'true')
    w.check(RESULT + '/Facts', 'rowCount', str(len(facts())))

    # Another run has other facts, and a file has none.
    w.event(window.PROPERTIES + 'AreaWeight/DoubleLineEdit0', 'set_string', '2')
    w.apply()
    w.check(RESULT + '/Lines', 'text', text(facts(AreaWeight=2.0)))
    w.select('/0/0|0')
    w.check(RESULT, 'visible', 'false')
    w.run()


with contextlib.ExitStack() as stack:
    play(stack.enter_context(shapetesting.server(sys.argv[1:])) if sys.argv[1:] else None)
