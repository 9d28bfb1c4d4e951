"""Maps a closed surface onto the unit sphere without flipping a triangle, and saves both."""
import os
import sys

import shapemap
from paraview.simple import *

folder = sys.argv[1] if len(sys.argv) > 1 else '.'
data = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'Data', '')

figure = OpenDataFile(data + 'FigureASmall.vtp')
# A conformal map shrinks arms and legs to almost nothing; AreaWeight preserves some of their area.
sphere = ShapeParameterize(Input=figure, Domain='Sphere', AreaWeight=3.0)
sphere.UpdatePipeline()

flipped = shapemap.facts(sphere)['FlippedTriangles']
distortion = shapemap.facts(sphere)['ConformalDistortion']
print('flipped triangles: %d, mean conformal distortion: %.2f' % (flipped, distortion))
assert flipped == 0 and distortion >= 1.0

# Output 0 is the figure, and its TargetPosition is the image of each point. Output 1 is the sphere,
# and its SourcePosition is the position of each point on the figure.
SaveData(os.path.join(folder, 'Figure.vtp'), sphere, DataMode='Binary')
SaveData(os.path.join(folder, 'Sphere.vtp'), OutputPort(sphere, 1), DataMode='Binary')
