"""Draws the error curve of a correspondence whose truth is known."""
import os
import sys

import shapemap
from paraview.simple import *

folder = sys.argv[1] if len(sys.argv) > 1 else '.'
data = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'Data', '')

truth = OpenDataFile(data + 'FigureASmall.vtp')  # its TargetPosition is the true map
target = OpenDataFile(data + 'FigureBSmall.vtp')
match = ShapeCorrespondence(SurfaceA=truth, SurfaceB=target, Method='FunctionalMap')
curve = ShapeMapErrorCurve(Input=match, Target=target, Truth=truth)
curve.UpdatePipeline()

# Errors are geodesic distances on the target, divided by the square root of its area.
mean, median, maximum = (shapemap.facts(curve)[name]
                         for name in ('Mean', 'Median', 'Maximum'))
print('error: mean %.4f, median %.4f, maximum %.4f' % (mean, median, maximum))
assert 0.0 < median <= maximum and mean < 0.05

view = CreateView('XYChartView')
shown = Show(curve, view)
shown.UseIndexForXAxis = 0
shown.XArrayName = 'Error'
shown.SeriesVisibility = ['Share']
SaveScreenshot(os.path.join(folder, 'ErrorCurve.png'), view, ImageResolution=[600, 400])
