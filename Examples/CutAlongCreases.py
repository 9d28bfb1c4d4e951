"""Cuts a horn from a ball by five clicks: the loop follows the crease around its foot."""
import math
import os
import sys

import numpy
from paraview import servermanager
from paraview.simple import *
from vtkmodules.util.numpy_support import vtk_to_numpy

folder = sys.argv[1] if len(sys.argv) > 1 else '.'

# A horn on a ball of radius 0.5: within the distance sqrt(0.06) from (0.5, 0, 0), around which is a crease.
ball = Sphere(ThetaResolution=160, PhiResolution=160)
horned = Calculator(Input=ball, CoordinateResults=1,
                    Function='coords*(1 + 8*max(0, 0.06 - (coordsX-0.5)^2 - coordsY^2 - coordsZ^2))')

# Five positions near the foot: it is at the angle 28.4 degrees from the x axis, and they are 5 degrees off.
clicks = []
for k in range(5):
    around, away = 2 * math.pi * (k + 0.3) / 5, math.radians(28.4 + (5 if k % 2 else -5))
    clicks += [0.5 * math.cos(away), 0.5 * math.sin(away) * math.cos(around), 0.5 * math.sin(away) * math.sin(around)]

farthest = {}
for weight in (0.0, 10.0):
    horn = ShapeCutFeature(Input=horned, LoopPoints=clicks, CreaseWeight=weight)
    edges = FeatureEdges(Input=horn, FeatureEdges=0, NonManifoldEdges=0)
    loop = vtk_to_numpy(servermanager.Fetch(edges).GetPoints().GetData())
    angles = numpy.degrees(numpy.arctan2(numpy.hypot(loop[:, 1], loop[:, 2]), loop[:, 0]))
    farthest[weight] = abs(angles - 28.4).max()
print('The loop is at most %.1f degrees from the foot; without Crease Weight, %.1f degrees.' %
      (farthest[10.0], farthest[0.0]))
assert farthest[10.0] < 2.5 < farthest[0.0]
SaveData(os.path.join(folder, 'Horn.stl'), horn)
