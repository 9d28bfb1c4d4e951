"""Cuts a horn from a ball along a loop, and pastes it onto a planet."""
import math
import os
import sys

import shapemap
from paraview.simple import *

folder = sys.argv[1] if len(sys.argv) > 1 else '.'

ball = Sphere(ThetaResolution=80, PhiResolution=80)
horned = Calculator(
    Input=ball, CoordinateResults=1,
    Function='coords*(1 + 1.2*max(0, 1 - ((coordsX-0.5)^2 + coordsY^2 + coordsZ^2)/0.05)^3)')

# A loop near the surface: a circle around the horn.
loop = []
for k in range(40):
    angle = 2 * math.pi * k / 40
    loop += [0.41, 0.28 * math.cos(angle), 0.28 * math.sin(angle)]
horn = ShapeCutFeature(Input=horned, LoopPoints=loop)  # output 1 is the rest, filled

planet = Sphere(ThetaResolution=90, PhiResolution=90, Radius=1.2)
result = ShapePasteFeature(Feature=horn, Target=planet, Seed=[0.0, 1.0, 0.3], Rotation=30.0)
result.UpdatePipeline()

euler = shapemap.facts(result)['EulerNumber']
top = result.GetDataInformation().GetBounds()[3]
print('Euler number %d (2: closed, no handle), maximum y of the horn %.2f' % (euler, top))
assert euler == 2 and 1.5 < top < 1.9
SaveData(os.path.join(folder, 'HornedPlanet.stl'), result)
