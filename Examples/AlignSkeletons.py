"""Maps the solid of one figure onto another, and aligns the skeletons inside."""
import os

import shapemap
from paraview.simple import *

data = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'Data', '')

# TargetPosition maps the surface of A to that of B. Each skeleton consists of five curves inside.
figure = OpenDataFile(data + 'FigureASmall.vtp')
bones = OpenDataFile(data + 'FigureASkeleton.vtp')
target = OpenDataFile(data + 'FigureBSkeleton.vtp')
solid = ShapeTetrahedralize(Input=figure)

# With a weight near 0 the error at the bones is measured, but not reduced.
errors = []
for weight in (1e-6, 20.0):
    mapped = ShapeHarmonicVolumeMap(
        Domain=solid, Boundary=figure, MapArray='TargetPosition', Features=[bones],
        TargetFeatures=[target], FeatureWeight=weight)
    mapped.UpdatePipeline()
    bones_error, surface_error = (shapemap.facts(mapped)[name]
                                  for name in ('RMSEFeatures', 'RMSEVertices'))
    print('FeatureWeight %g: error %.2f %% at the bones, %.2f %% at the surface' % (
        weight, 100 * bones_error, 100 * surface_error))
    errors.append(bones_error)
assert errors[1] < 0.5 * errors[0]
