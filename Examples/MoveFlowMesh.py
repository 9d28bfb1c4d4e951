"""Turns a body in a box and moves the tetrahedra around it along, by two methods."""
import os
import sys

import shapemap
from paraview.simple import *

folder = sys.argv[1] if len(sys.argv) > 1 else '.'

# Tetrahedra between a box and a body.
ball = Clean(Input=Sphere(Radius=0.25, ThetaResolution=32, PhiResolution=17))
body = Transform(Input=ball)
body.Transform.Scale = [1.0, 0.4, 0.7]
box = Subdivide(Input=Triangulate(Input=Clean(Input=Box(XLength=1.5))), NumberofSubdivisions=3)
mesh = ShapeTetrahedralize(Input=AppendGeometry(Input=[box, body]))

# The body turns by 0.2 radians; the box stays.
turned = Calculator(Input=body, ResultArrayName='TargetPosition', Function=(
    '(cos(0.2)*coordsX-sin(0.2)*coordsY)*iHat+(sin(0.2)*coordsX+cos(0.2)*coordsY)*jHat+coordsZ*kHat'))
for method in ('Harmonic', 'RadialBasis'):
    motion = ShapeMeshMotion(Input=mesh, Boundary=turned, Method=method)
    motion.UpdatePipeline()
    facts = shapemap.facts(motion)
    print('%s: %d inverted cells, non-orthogonality %.1f before and %.1f after, skewness %.2f and %.2f' % (
        method, facts['InvertedAfter'], facts['MaximumNonOrthogonalityBefore'],
        facts['MaximumNonOrthogonalityAfter'], facts['MaximumSkewnessBefore'], facts['MaximumSkewnessAfter']))
    assert facts['InvertedAfter'] == 0
SaveData(os.path.join(folder, 'moved.vtu'), motion, DataMode='Binary')
