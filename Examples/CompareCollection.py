"""Compares ten shapes at once, and finds the one that is unlike the others."""
from paraview.simple import *

# Spheres whose bumps grow at the top; the last one has its bump at the side.
sphere = Clean(Input=Sphere(ThetaResolution=32, PhiResolution=32, Radius=1.0))
bump = 'coords*(1 + %g*exp(6*(%s - 1)))'
functions = [bump % (0.05 * k, 'coordsZ') for k in range(9)] + [bump % (0.3, 'coordsX')]
shapes = [Calculator(Input=sphere, CoordinateResults=1, Function=each) for each in functions]
compared = ShapeCollection(Shapes=GroupDatasets(Input=shapes))
compared.UpdatePipeline()

table = servermanager.Fetch(compared, idx=3)
for row in range(table.GetNumberOfRows()):
    print('shape %d: rank %d, coordinates %6.3f %6.3f' % (row, *(
        table.GetColumnByName(name).GetTuple1(row) for name in ('Rank', 'Embedding0', 'Embedding1'))))
ranks = [table.GetColumnByName('Rank').GetValue(row) for row in range(10)]
assert ranks[9] == 0, 'the last shape is the outlier'
SaveData('where.vtp', OutputPort(compared, 1), DataMode='Binary')
