"""Moves the nodes of a CalculiX deck by a volume map: every other byte of the deck stays as it is."""
import os
import sys

import shapemap
from paraview.simple import *

folder = sys.argv[1] if len(sys.argv) > 1 else '.'
data = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'Data', '')

# A deck of hexahedra with a material and a step. Take your own instead.
SaveData(os.path.join(folder, 'ball.inp'), OpenDataFile(data + 'BallSmall.vtu'))
with open(os.path.join(folder, 'ball.inp'), 'a') as file:
    file.write('*MATERIAL, NAME=Bone\n*ELASTIC\n1000., 0.3\n*SOLID SECTION, ELSET=Region0, MATERIAL=Bone\n'
               '*STEP\n*STATIC\n*END STEP\n')
deck = ShapeDeckReader(FileNames=[os.path.join(folder, 'ball.inp')])

# The map of a sphere around it: flatter, and bent.
around = Clean(Input=Sphere(Radius=1.5, ThetaResolution=40, PhiResolution=40))
boundary = Calculator(Input=around, ResultArrayName='TargetPosition',
                      Function='coordsX*iHat + coordsY*jHat + (0.6*coordsZ + 0.3*coordsX^2)*kHat')
made = ShapeHarmonicVolumeMap(Domain=deck, Boundary=boundary)
moved = ShapeApplyVolumeMap(Input=deck, Map=OutputPort(made, 1))

# Inverted cells would be mended, and the boundary stays.
mended = ShapeUntangle(Input=moved, RestShape=deck, FixBoundary=1)
mended.UpdatePipeline()
print('%d inverted cells, %d mended' % (shapemap.facts(mended)['InvertedBefore'],
                                        shapemap.facts(mended)['MovedPoints']))
ShapeMovedDeckWriter(Input=mended, FileName=os.path.join(folder, 'moved.inp')).UpdatePipeline()

before, after = (open(os.path.join(folder, name)).read() for name in ('ball.inp', 'moved.inp'))
assert before.partition('*ELEMENT')[2] == after.partition('*ELEMENT')[2] and before != after
assert shapemap.facts(mended)['InvertedAfter'] == 0
