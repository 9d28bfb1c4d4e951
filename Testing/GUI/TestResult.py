"""The panel sums up what a filter did, in words; it follows the filter, and has all facts in a table.

TestResult.py: in the window's own process; TestResult.py pvserver: in a server."""
import contextlib
import sys

import numpy
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


def shown(fact):
    """A fact as the table shows it."""
    if isinstance(fact, str):
        return fact
    return ', '.join('{:,}'.format(int(number)) if number == int(number) else '%.3g' % number
                     for number in numpy.ravel(fact))


def check_table(w, found):
    """A row for each fact, with its name and value."""
    w.check(RESULT + '/Facts', 'rowCount', str(len(found)))
    for row, name in enumerate(sorted(found)):
        w.check(RESULT + '/Facts', 'modelItemData', '%d.0,%s' % (row, name))
        w.check(RESULT + '/Facts', 'modelItemData', '%d.1,%s' % (row, shown(found[name])))


def play(port):
    first, other = facts(), facts(AreaWeight=2.0)
    assert text(first) != text(other), text(first)
    w = window.Window(port)
    w.open('DentedSphere600.vtp')
    w.filter('Shape Parameterize')
    w.apply()
    w.check(RESULT, 'visible', 'true')
    w.check(RESULT + '/Lines', 'text', text(first))
    w.check(RESULT + '/Warnings', 'visible', 'false')
    w.check(RESULT + '/Facts', 'visible', 'false')
    w.event(RESULT + '/All', 'set_boolean', 'true')
    w.check(RESULT + '/Facts', 'visible', 'true')
    check_table(w, first)

    # Another run has other facts, and a file has none.
    w.event(window.PROPERTIES + 'AreaWeight/DoubleLineEdit0', 'set_string', '2')
    w.apply()
    w.check(RESULT + '/Lines', 'text', text(other))
    check_table(w, other)
    w.select('/0/0|0')
    w.check(RESULT, 'visible', 'false')

    # Pressed flat, half of a sphere is turned over: a warning.
    w.python("""
        flat = Calculator(Input=GetActiveSource(), ResultArrayName='TargetPosition',
                          Function='coordsX*iHat + coordsY*jHat')
        Show(flat)
        SetActiveSource(flat)""")
    w.wait(100)
    w.filter('Shape Map Quality')
    w.apply()
    w.check(RESULT + '/Warnings', 'visible', 'true')
    w.check(RESULT + '/Warnings', 'text', 'The map flips cells.')
    w.run()


with contextlib.ExitStack() as stack:
    play(stack.enter_context(shapetesting.server(sys.argv[1:])) if sys.argv[1:] else None)
