"""Compares the distortion of two sphere maps, one conformal and one with an area weight."""
import os

import shapemap
from paraview.simple import *

data = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'Data', '')
figure = OpenDataFile(data + 'FigureASmall.vtp')

worst = []
for weight in (0.0, 3.0):
    sphere = ShapeParameterize(Input=figure, AreaWeight=weight)
    quality = ShapeMapQuality(Input=sphere, MapArray='TargetPosition')
    quality.UpdatePipeline()
    assert shapemap.facts(quality)['FlippedCells'] == 0

    # Output 0 has the measures of each triangle, and output 1 is a table that summarises them.
    print('AreaWeight %g' % weight)
    table = servermanager.Fetch(quality, idx=1)
    for row in range(table.GetNumberOfRows()):
        print('  %-20s %s' % (table.GetValueByName(row, 'Measure').ToString(), '  '.join(
            '%s %.3g' % (name.lower(), table.GetValueByName(row, name).ToDouble())
            for name in ('Minimum', 'Mean', 'Maximum'))))
    worst.append(quality.CellData['JacobianDeterminant'].GetRange()[0])
print('smallest ratio of areas: %.1e, and with area weight %.1e' % tuple(worst))
assert worst[1] > worst[0] > 0.0
