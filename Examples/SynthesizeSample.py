"""Makes samples of a bone with two modes, moves its hexahedra along, and saves a solver's deck."""
import os
import sys

from paraview.simple import *
import shapemap

folder = sys.argv[1] if len(sys.argv) > 1 else '.'

# A mean shape with its modes, as Shape Atlas makes it: longer, and thicker at one end.
ball = Clean(Input=Sphere(ThetaResolution=48, PhiResolution=48, Radius=1.0))
bone = Calculator(Input=ball, CoordinateResults=1, Function='2*coordsZ*kHat + '
                  '(0.4 + 0.5*coordsZ^2)*(coordsX*iHat + coordsY*jHat)')
atlas = Calculator(Input=bone, ResultArrayName='SourcePosition', Function='coords')
atlas = Calculator(Input=atlas, ResultArrayName='Mode0', Function='0.1*coordsZ*kHat')
atlas = Calculator(Input=atlas, ResultArrayName='Mode1', Function='0.1*coordsZ*(coordsX*iHat + coordsY*jHat)')

# The hexahedra of the template, in each sample.
solid = ShapeHexRemesh(Surface=bone, CellSize=0.15)
sample = ShapeSynthesize(Atlas=atlas, Data=solid)
for number, weights in enumerate(([2.0, 0.0], [-1.0, 1.5], [0.5, -2.0])):
    sample.Weights = weights
    sample.UpdatePipeline()
    facts = shapemap.facts(sample)
    inverted, quality = facts['InvertedAfter'], facts['MinimumScaledJacobian']
    print('sample %d: %d inverted, minimum scaled Jacobian %.2f' % (number, inverted, quality))
    assert inverted == 0 and quality > 0.3
    SaveData(os.path.join(folder, 'sample%d.inp' % number), OutputPort(sample, 1))
