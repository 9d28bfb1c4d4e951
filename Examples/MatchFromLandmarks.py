"""Finds the correspondence of two figures from landmarks: head, hands and feet."""
import os
import sys

import shapemap
from paraview.simple import *

folder = sys.argv[1] if len(sys.argv) > 1 else '.'
data = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'Data', '')

a = OpenDataFile(data + 'FigureASmall.vtp')
b = OpenDataFile(data + 'FigureBSmall.vtp')
# A row for each landmark: x, y, z on surface A, and the corresponding position on surface B.
landmarks = ShapeLandmarks(
    SurfaceA=a, SurfaceB=b, Names=['head', 'left hand', 'right hand', 'left foot', 'right foot'],
    PointsA=[0.000, 0.021, 1.008,
             0.508, 0.017, 0.792,
             -0.508, 0.017, 0.792,
             0.138, 0.020, 0.009,
             -0.138, 0.020, 0.009],
    PointsB=[0.000, 0.052, 1.008,
             0.489, 0.039, 0.902,
             -0.489, 0.039, 0.902,
             0.143, -0.012, 0.109,
             -0.143, -0.012, 0.109])
match = ShapeCorrespondence(
    SurfaceA=a, SurfaceB=b, Landmarks=landmarks, Method='ReversibleHarmonic')
match.UpdatePipeline()

used, found, area = (shapemap.facts(match)[name]
                     for name in ('Landmarks', 'LandmarksFound', 'ReversedArea'))
print('landmarks: %d, reversed area: %.1f %%' % (used, 100 * area))
assert used == 5 and found == 0 and area < 0.05
quality = ShapeMapQuality(Input=match)
quality.UpdatePipeline()
print('mean symmetric Dirichlet energy: %.2f (4: lengths are preserved)' %
      shapemap.facts(quality)['MeanSymmetricDirichlet'])
SaveData(os.path.join(folder, 'Matched.vtp'), match, DataMode='Binary')
