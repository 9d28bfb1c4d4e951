"""Maps the solid of one figure onto another from the two surfaces alone, and aligns their skeletons."""
import os

import numpy
import shapemap
from paraview import servermanager
from paraview.simple import *
from vtkmodules.util.numpy_support import vtk_to_numpy

data = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'Data', '')
a = OpenDataFile(data + 'FigureASmall.vtp')
b = OpenDataFile(data + 'FigureBSmall.vtp')

# A figure is symmetric, so the matching is named as ambiguous: First takes the best one.
bones = ShapeSkeleton(Input=a, Target=b, Ambiguous='First')
others = ShapeSkeleton(Input=b)
# The ends of the skeleton are the landmarks of the surfaces: head, hands and feet.
points = MaskPoints(Input=bones, OnRatio=1, MaximumNumberofPoints=100000, GenerateVertices=1,
                    SingleVertexPerCell=1)
ends = Threshold(Input=points, Scalars=['POINTS', 'Degree'], LowerThreshold=1, UpperThreshold=1)
match = ShapeCorrespondence(SurfaceA=a, SurfaceB=b, Landmarks=ExtractSurface(Input=ends),
                            Method='ReversibleHarmonic')


def positions(source):
    source.UpdatePipeline()
    return vtk_to_numpy(servermanager.Fetch(source).GetPoints().GetData())


wanted = positions(others)
size = numpy.ptp(positions(b), axis=0).max()
errors = []
for features in ([], [bones]):
    mapped = ShapeHarmonicVolumeMap(Domain=bones, Boundary=match, MapArray='TargetPosition', Features=features)
    distances = numpy.linalg.norm(positions(mapped)[:, None] - wanted, axis=2).min(axis=1)
    errors.append(numpy.sqrt((distances ** 2).mean()) / size)
    print('%d features: the skeleton is %.2f %% of the size from the other one' % (
        len(features), 100 * errors[-1]))
assert errors[1] < 0.75 * errors[0]
