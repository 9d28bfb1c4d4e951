"""Transfers a field from a straight box to a bent bar by the map between them, and one back."""
import os

import shapemap
from paraview.simple import *

data = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'Data', '')

# The array TargetPosition of the bar maps each of its points into the box.
bar = OpenDataFile(data + 'BentBarSmall.vtu')
box = Calculator(Input=bar, CoordinateResults=1, Function='TargetPosition')

# Transfer a field of the box to the bar: with Pull, each point takes the value at its TargetPosition.
heated = Calculator(Input=box, ResultArrayName='Temperature', Function='20 + 10*coordsX')
in_bar = ShapeTransferFields(Input=bar, Source=heated, Direction='Pull')
in_bar.UpdatePipeline()
low, high = in_bar.PointData['Temperature'].GetRange()
print('temperature in the bar: %.2f to %.2f' % (low, high))
assert shapemap.facts(in_bar)['OutsidePoints'] == 0
assert abs(low) < 1e-9 and abs(high - 40) < 1e-9

# Transfer a field of the bar to the box: with Push, the source has the map array.
depth = ShapeBoundaryDistance(Input=bar, Surface=ExtractSurface(Input=bar))
in_box = ShapeTransferFields(Input=box, Source=depth, Direction='Push')
in_box.UpdatePipeline()
print('depth below the bar\'s surface, in the box: %.2f to %.2f' %
      in_box.PointData['BoundaryDistance'].GetRange())
assert abs(in_box.PointData['BoundaryDistance'].GetRange()[0] -
           depth.PointData['BoundaryDistance'].GetRange()[0]) < 1e-6
