"""Transfers a field from a straight box to a bent bar by the map between them, and one back."""
import os

from paraview.simple import *

data = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'Data', '')

# The bar has the array TargetPosition: where in the box each of its points goes.
bar = OpenDataFile(data + 'BentBarSmall.vtu')
box = Calculator(Input=bar, CoordinateResults=1, Function='TargetPosition')

# A field of the box: Pull fetches for each point of the bar the value at its TargetPosition.
heated = Calculator(Input=box, ResultArrayName='Temperature', Function='20 + 10*coordsX')
in_bar = ShapeTransferFields(Input=bar, Source=heated, Direction='Pull')
in_bar.UpdatePipeline()
low, high = in_bar.PointData['Temperature'].GetRange()
print('temperature in the bar: %.2f to %.2f' % (low, high))
assert in_bar.FieldData['TransferFields.OutsidePoints'].GetRange() == (0, 0)
assert abs(low) < 1e-9 and abs(high - 40) < 1e-9

# The other way, Push: here the source has the map array, which leads into the receiver.
depth = ShapeBoundaryDistance(Input=bar, Surface=ExtractSurface(Input=bar))
in_box = ShapeTransferFields(Input=box, Source=depth, Direction='Push')
in_box.UpdatePipeline()
print('depth below the bar\'s surface, in the box: %.2f to %.2f' %
      in_box.PointData['BoundaryDistance'].GetRange())
assert abs(in_box.PointData['BoundaryDistance'].GetRange()[0] -
           depth.PointData['BoundaryDistance'].GetRange()[0]) < 1e-6
