"""Finds the correspondence of two figures from a table of landmarks: head, hands and feet."""
import os
import sys

from paraview.simple import *

folder = sys.argv[1] if len(sys.argv) > 1 else '.'
data = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'Data', '')

# A row for each landmark: a point on surface A, and the corresponding point on surface B.
table = os.path.join(folder, 'Landmarks.csv')
with open(table, 'w') as file:
    file.write('ax,ay,az,bx,by,bz\n'
               '0.000,0.021,1.008,0.000,0.052,1.008\n'
               '0.508,0.017,0.792,0.489,0.039,0.902\n'
               '-0.508,0.017,0.792,-0.489,0.039,0.902\n'
               '0.138,0.020,0.009,0.143,-0.012,0.109\n'
               '-0.138,0.020,0.009,-0.143,-0.012,0.109\n')
rows = TableToPoints(Input=OpenDataFile(table), XColumn='ax', YColumn='ay', ZColumn='az')
landmarks = Calculator(Input=rows, ResultArrayName='TargetPosition',
                       Function='bx*iHat + by*jHat + bz*kHat')

a = OpenDataFile(data + 'FigureASmall.vtp')
b = OpenDataFile(data + 'FigureBSmall.vtp')
match = ShapeCorrespondence(
    SurfaceA=a, SurfaceB=b, Landmarks=landmarks, Method='ReversibleHarmonic')
match.UpdatePipeline()

used, found, area = (match.FieldData['Correspondence.' + name].GetRange()[0]
                     for name in ('Landmarks', 'LandmarksFound', 'ReversedArea'))
print('landmarks: %d, reversed area: %.1f %%' % (used, 100 * area))
assert used == 5 and found == 0 and area < 0.05
quality = ShapeMapQuality(Input=match)
quality.UpdatePipeline()
print('mean symmetric Dirichlet energy: %.2f (4: lengths are preserved)' %
      quality.FieldData['MapQuality.MeanSymmetricDirichlet'].GetRange()[0])
SaveData(os.path.join(folder, 'Matched.vtp'), match, DataMode='Binary')
