"""Landmarks and a seed are picked with the mouse; distances start at the seed. The recorded script has them to
the last bit.

TestPicked.py: in the window's own process; TestPicked.py pvserver: in a server."""
import contextlib
import json
import os
import subprocess
import sys
import tempfile

import shapetesting
import window

PICK = window.PROPERTIES + 'ShapeLandmarks/Buttons/Pick'
# Head and belly of one figure and the other, where they stand beside each other in the view; a knee of the first.
PAIRS = [((0.370, 0.318), (0.635, 0.318)), ((0.370, 0.467), (0.635, 0.447))]
SEED = (0.346, 0.6)
RESULTS = '''
import json
from paraview.simple import FindSource
marks, distances = FindSource('ShapeLandmarks1'), FindSource('ShapeGeodesicDistance1')
for made in (marks, distances):
    made.UpdatePipeline()
with open(%r, 'w') as file:
    json.dump([list(marks.PointsA), list(marks.PointsB), list(distances.SeedPoints),
               distances.PointData.GetArray('GeodesicDistance').GetRange()], file)
'''


def play(port, folder):
    script, picked, repeated = (os.path.join(folder, name) for name in ('trace.py', 'picked.json', 'repeated.json'))
    w = window.Window(port)
    w.fill_screen()
    w.menu('menuTools', 'actionToolsStartStopTrace')
    w.accept('TraceOptionsDialog')
    w.open('FigureBSmall.vtp')
    w.open('FigureASmall.vtp')
    w.filter('Shape Landmarks')
    w.choose_inputs(SurfaceB='FigureBSmall.vtp')
    w.apply()
    w.wait(300)
    w.click('cameraToolbar/actionPositiveY')
    w.event(PICK, 'set_boolean', 'true')
    for pair in PAIRS:
        for place in pair:
            w.drag([place])
    w.key(window.ESCAPE)
    w.apply()

    w.select('/0/1|0')
    w.filter('Shape Geodesic Distance')
    w.choose(window.PROPERTIES + 'Method/ComboBox', 'Exact')
    w.event(PICK, 'set_boolean', 'true')
    w.drag([SEED])
    w.key(window.ESCAPE)
    w.apply()
    w.wait(300)
    w.python('''
        import numpy, onsurface
        from vtkmodules.util.numpy_support import vtk_to_numpy
        from vtkmodules.vtkCommonCore import mutable, vtkIdList
        from vtkmodules.vtkCommonDataModel import vtkCellLocator, vtkGenericCell
        made = FindSource('ShapeGeodesicDistance1')
        assert GetDisplayProperties(made).ColorArrayName[1] == 'GeodesicDistance'
        seed = numpy.array(made.SeedPoints)
        onsurface.Surface(made).check_under(seed, %r)
        surface = servermanager.Fetch(made)
        points = vtk_to_numpy(surface.GetPoints().GetData())
        distances = vtk_to_numpy(surface.GetPointData().GetArray('GeodesicDistance'))
        straight = numpy.linalg.norm(points - seed, axis=1)
        assert (distances > straight - 1e-6).all(), 'shorter than a straight line'
        # Inside the seed's triangle, a straight line is the shortest path.
        locator, corners = vtkCellLocator(), vtkIdList()
        locator.SetDataSet(surface)
        locator.BuildLocator()
        surface.GetCellPoints(locator.FindCell(seed, 1e-10, vtkGenericCell(), mutable(0), [0] * 3, [0] * 3), corners)
        ids = [corners.GetId(i) for i in range(3)]
        assert abs(distances[ids] - straight[ids]).max() < 1e-6, (distances[ids], straight[ids])
        assert distances.min() == distances[ids].min(), distances.min()''' % (SEED,))
    w.python('''
        from paraview import smtrace
        with open(%r, 'w') as file:
            file.write(smtrace.stop_trace())''' % script)
    w.python(RESULTS % picked)
    w.run(200)

    with open(script, 'a') as file:
        file.write(RESULTS % repeated)
    subprocess.run(['pvpython', script], check=True, timeout=200)
    seen, again = (json.load(open(path)) for path in (picked, repeated))
    assert [len(values) for values in seen] == [6, 6, 3, 2], seen
    assert seen == again, (seen, again)


with tempfile.TemporaryDirectory() as folder, (
        shapetesting.server(['pvserver']) if sys.argv[1:] == ['pvserver'] else contextlib.nullcontext()) as port:
    play(port, folder)
