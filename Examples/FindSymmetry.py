"""Finds the left and the right side of a figure, and makes a field on it symmetric."""
import os

from paraview.simple import *

data = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'Data', '')

figure = OpenDataFile(data + 'FigureBSmall.vtp')
field = Calculator(Input=figure, ResultArrayName='Field', Function='sin(9*coordsX) + coordsZ')
found = ShapeSymmetry(Input=field, Array='Field')
found.UpdatePipeline()

surface = servermanager.Fetch(found)
table = servermanager.Fetch(found, idx=2)
for row in range(table.GetNumberOfRows()):
    print('element %d: order %d, reverses orientation: %d, distortion %.4f' % (row, *(
        table.GetColumnByName(name).GetTuple1(row) for name in ('Order', 'Reversing', 'Distortion'))))
assert table.GetNumberOfRows() == 2, 'the identity and the reflection'
given, symmetric = (surface.GetPointData().GetArray(name).GetRange() for name in ('Field', 'Symmetrized'))
assert given[0] - 1e-6 <= symmetric[0] and symmetric[1] <= given[1] + 1e-6, 'a mean is between the values'
SaveData('symmetric.vtp', found, DataMode='Binary')
