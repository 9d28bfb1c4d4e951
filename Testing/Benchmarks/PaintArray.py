"""CPU time of one move of the brush of Shape Paint Array, without drawing:
Utilities/pvpython.sh Testing/Benchmarks/PaintArray.py

A stroke on a sphere of 74,528 triangles grows by one position in each update, as while the mouse moves. The
time includes sending the strokes to the filter and running it."""
import time

import numpy
from paraview.simple import *

LIMIT = 1.0 / 15.0  # seconds

sphere = Clean(Input=Sphere(ThetaResolution=274, PhiResolution=138, Radius=1.0))
for share in (0.05, 0.2):
    radius = share * 12.0 ** 0.5  # of the diagonal
    for mode, word in enumerate(('Set', 'Add', 'Smooth')):
        paint = ShapePaintArray(Input=sphere)
        paint.UpdatePipeline()
        positions, times = [], []
        for k in range(100):
            positions += [numpy.cos(0.02 * k), numpy.sin(0.02 * k), 0.0]
            start = time.process_time()
            paint.StrokePoints = positions
            paint.Strokes = [mode, radius, 0.5, 1.0, k + 1]
            paint.UpdatePipeline()
            times.append(time.process_time() - start)
        print('radius %2.0f %%, %-6s: %.1f ms median, %.1f ms at most' % (
            100.0 * share, word, 1e3 * numpy.median(times), 1e3 * max(times[1:])))
        assert numpy.median(times) < LIMIT
