"""Untangles a mesh that a deformation has folded, so that no hexahedron is inverted."""
import os

import shapemap
from paraview.simple import *

data = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'Data', '')

# The centre of a ball is pushed out past its boundary, which does not move.
ball = OpenDataFile(data + 'BallSmall.vtu')
folded = Calculator(Input=ball, CoordinateResults=1,
                    Function='coords + 1.2*(1 - mag(coords)^2)*iHat')

# With a rest shape, the distortion of the map from that shape is reduced. Without it, cells become
# as regular as possible.
mended = ShapeUntangle(Input=folded, RestShape=ball)
mended.UpdatePipeline()

before = shapemap.facts(mended)['InvertedBefore']
after = shapemap.facts(mended)['InvertedAfter']
print('%d inverted hexahedra before, %d after' % (before, after))
assert before > 0 and after == 0
