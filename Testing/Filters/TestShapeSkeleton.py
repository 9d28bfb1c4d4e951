"""Shape Skeleton: the curve skeleton of a solid, and its match with that of another.

As an example: the skeleton of a figure."""
import numpy
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
import shapemap

import shapetesting
from shapetesting import array, fact, points

skeleton = simple.ShapeSkeleton(Input=simple.XMLPolyDataReader(FileName=shapetesting.data_file('FigureASmall.vtp')))
skeleton.UpdatePipeline()
figure = shapetesting.output(skeleton)
degree = array(figure, 'Degree')
assert figure.GetNumberOfCells() == figure.GetNumberOfLines() >= 5, 'arms, legs and head'
assert (degree == 1).sum() >= 5 and (degree >= 3).any(), numpy.bincount(degree.astype(int))
# A tree: one point more than edges.
edges = sum(figure.GetCell(i).GetNumberOfPoints() - 1 for i in range(figure.GetNumberOfCells()))
assert edges == figure.GetNumberOfPoints() - 1, (edges, figure.GetNumberOfPoints())
assert degree.sum() == 2 * edges
assert array(figure, 'Radius').min() > 0.0
ids = vtk_to_numpy(figure.GetCellData().GetArray('BranchId'))
assert ids.tolist() == list(range(len(ids)))

facts = shapetesting.outputs(shapetesting.new(
    shapemap.vtkShapeSkeleton, shapetesting.read('TwoTorusSmall.vtp')))
assert fact(facts[0], 'Skeleton.Cycles') == 2 and fact(facts[0], 'Skeleton.Components') == 1
assert facts[0].GetPointData().GetArray('TargetPosition') is None

# The same figure, turned by 90 degrees and twice as large: First maps the skeleton by the same motion, up to
# the symmetry of the figure; Refuse either finds the same or says what is ambiguous.
surface = shapetesting.read('FigureASmall.vtp')
turn = 2.0 * numpy.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
target = shapetesting.copy(surface)
shapetesting.set_points(target, points(surface) @ turn.T)
matched = shapetesting.outputs(shapetesting.new(shapemap.vtkShapeSkeleton, surface, target, Ambiguous=1))[0]
assert fact(matched, 'Skeleton.Difference') < 1.0
places, wanted = array(matched, 'TargetPosition'), points(matched) @ turn.T
distance = numpy.linalg.norm(places[:, None] - wanted[None], axis=2).min(axis=1)
size = numpy.ptp(points(target), axis=0).max()
assert distance.max() < 0.05 * size, 'every place is on the turned skeleton: %g' % (distance.max() / size)
assert matched.GetCellData().GetArray('TargetBranchId').GetNumberOfTuples() == matched.GetNumberOfCells()

# Two figures alone: matched, their skeletons and the surfaces' landmarks (the ends) align the volume map.
other = shapetesting.read('FigureBSmall.vtp')
bones = shapetesting.outputs(shapetesting.new(shapemap.vtkShapeSkeleton, surface, other, Ambiguous=1))[0]
bones_of_other = points(shapetesting.outputs(shapetesting.new(shapemap.vtkShapeSkeleton, other))[0])
assert fact(bones, 'Skeleton.LeftOut') == fact(bones, 'Skeleton.TargetLeftOut') == 0
size = numpy.ptp(points(other), axis=0).max()
ends = numpy.flatnonzero(array(bones, 'Degree') == 1)
truth = array(surface, 'TargetPosition')
for end in ends:
    nearest = numpy.linalg.norm(points(surface) - points(bones)[end], axis=1).argmin()
    gap = numpy.linalg.norm(array(bones, 'TargetPosition')[end] - truth[nearest]) / size
    assert gap < 0.1, 'an end goes to that of another limb: %g' % gap
landmarks = vtkPolyData()
landmarks.SetPoints(vtkPoints())
targets = vtkDoubleArray()
targets.SetName('TargetPosition')
targets.SetNumberOfComponents(3)
for end in ends:
    landmarks.GetPoints().InsertNextPoint(points(bones)[end])
    targets.InsertNextTuple(array(bones, 'TargetPosition')[end])
landmarks.GetPointData().AddArray(targets)
match = shapetesting.outputs(shapetesting.new(
    shapemap.vtkShapeCorrespondence, surface, other, landmarks, Method=0))[0]


def map_bones(features):
    """How far the mapped skeleton is from the other one, and its points from their places (root mean
    square, in parts of the size)."""
    mapped = shapetesting.outputs(shapetesting.new(
        shapemap.vtkShapeHarmonicVolumeMap, bones, match, features))[0]
    to_curve = numpy.linalg.norm(points(mapped)[:, None] - bones_of_other, axis=2).min(axis=1)
    to_place = numpy.linalg.norm(points(mapped) - array(bones, 'TargetPosition'), axis=1)
    return numpy.sqrt((to_curve ** 2).mean()) / size, numpy.sqrt((to_place ** 2).mean()) / size


without, aligned = map_bones([]), map_bones([bones])
print('from the other skeleton, and from the places on it: %s without features, %s with them' % (
    without, aligned))
assert aligned[0] < 0.75 * without[0] and aligned[1] < 0.4 * without[1]
assert max(aligned) < 0.0075, 'Fig. 3 of the paper: 0.54 % (our curves have edges of 1 %)'

# A ball has one point, as a vertex; a ring has one closed branch, which is ambiguous.
ball = shapetesting.outputs(shapetesting.new(shapemap.vtkShapeSkeleton, shapetesting.read('DentedSphere600.vtp')))[0]
assert fact(ball, 'Skeleton.Cycles') == 0 and ball.GetNumberOfCells() >= 1

shapetesting.check_refused(shapetesting.new(
    shapemap.vtkShapeSkeleton, surface, shapetesting.read('TwoTorusSmall.vtp')), 'different graphs', 'Resolution')
shapetesting.check_refused(shapetesting.new(
    shapemap.vtkShapeSkeleton, shapetesting.without_cells(surface, [0])), 'open', 'Shape Fill Holes')
