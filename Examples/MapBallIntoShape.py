"""Maps a ball of hexahedra into a cow by the harmonic map that extends a map of its surface."""
import os
import sys

import shapemap
from paraview.simple import *

root = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..')
folder = sys.argv[1] if len(sys.argv) > 1 else '.'
models = os.environ.get('SHAPEMAP_MODELS', os.path.join(root, 'build', 'models'))

cow = OpenDataFile(os.path.join(models, 'cow.off'))
sphere = ShapeParameterize(Input=cow, AreaWeight=3.0)

# The boundary of the domain is the sphere, and its array SourcePosition maps it back to the cow.
# The ball is shrunk to be inside the triangles of the sphere: points outside would not move.
ball = Transform(Input=OpenDataFile(os.path.join(root, 'Data', 'BallSmall.vtu')))
ball.Transform.Scale = [0.97, 0.97, 0.97]
solid = ShapeHarmonicVolumeMap(
    Domain=ball, Boundary=OutputPort(sphere, 1), MapArray='SourcePosition')
solid.UpdatePipeline()

assert shapemap.facts(solid)['OutsidePoints'] == 0
error = shapemap.facts(solid)['RMSEInside']
print('error inside the triangles of the boundary: %.2f %% of the cow\'s size' % (100 * error))
assert error < 0.01
for axis in range(3):
    image, surface = (proxy.GetDataInformation().GetBounds()[2 * axis:2 * axis + 2]
                      for proxy in (solid, cow))
    print('%s: cow %.3f to %.3f, image of the ball %.3f to %.3f' % ('xyz'[axis], *surface, *image))
    assert image[1] - image[0] > 0.5 * (surface[1] - surface[0])
SaveData(os.path.join(folder, 'Cow.vtu'), solid, DataMode='Binary')
