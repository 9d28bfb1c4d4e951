"""CPU time of one move of the handle of Shape Deform, without drawing:
Utilities/pvpython.sh Testing/Benchmarks/MoveHandle.py

The boundary of a bumpy cap of 74,802 triangles, and then a frame of it, moves a little in each update, as while
the mouse moves. The same with two boundaries (75,624 triangles), of which one stays. The time includes sending the properties to
the filter and running it."""
import time

import numpy
from paraview.simple import *

LIMIT = 1.0 / 15.0  # seconds


def bumpy(end):
    """A sphere cut off at its bottom and, unless `end` is 0, at its top."""
    ball = Sphere(ThetaResolution=274, PhiResolution=138 if end == 0 else 139, Radius=1.0, StartPhi=end,
                  EndPhi=150.0)
    return Calculator(Input=Clean(Input=ball), CoordinateResults=1,
                      Function='coords*(1+0.05*sin(9*coordsX)*cos(8*coordsY))')


for end, word in ((0.0, 'one boundary'), (30.0, 'two boundaries')):
    deform = ShapeDeform(Input=bumpy(end))
    deform.UpdatePipeline()
    triangles = deform.GetDataInformation().GetNumberOfCells()
    for moved in ('part', 'frame'):
        times = []
        for k in range(40):
            share = 0.01 * (k + 1)
            start = time.process_time()
            if moved == 'part':
                deform.HandleMotions = [0, share, 0, share, 20 * share, 30 * share, 0, 1 + 0.1 * share]
            else:
                deform.FrameRotations = [1, 0, -1, 0, 50 * share, 0, -1, 0, -1, 0, 0, 0]
            deform.UpdatePipeline()
            times.append(time.process_time() - start)
        print('%d triangles, %s, a %s moves: %.1f ms median, %.1f ms at most' % (
            triangles, word, moved, 1e3 * numpy.median(times), 1e3 * max(times[1:])))
        assert 74000 < triangles < 77000 and numpy.median(times) < LIMIT
