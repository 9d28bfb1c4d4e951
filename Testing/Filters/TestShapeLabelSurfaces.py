"""Shape Label Surfaces: the surfaces between the labels of an image, shared by the regions.

As an example: a segmentation with two regions that touch; Threshold by Patch takes out the interface
between them."""
import numpy
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkMultiBlockDataSet
import shapemap

import shapetesting
from shapetesting import fact, points, triangles

SIZE = (40, 36, 30)


def image(values, name='Label', at_cells=False, spacing=(1.0, 1.0, 1.0), first=(0, 0, 0)):
    """An image with an array; values: by i, j, k."""
    data = vtkImageData()
    more = 1 if at_cells else 0
    data.SetExtent(*(number for axis in range(3)
                     for number in (first[axis], first[axis] + values.shape[axis] - 1 + more)))
    data.SetSpacing(spacing)
    array = numpy_to_vtk(values.ravel(order='F'), deep=True)
    array.SetName(name)
    (data.GetCellData() if at_cells else data.GetPointData()).SetScalars(array)
    return data


def surfaces(data, **settings):
    algorithm = shapetesting.new(shapemap.vtkShapeLabelSurfaces, data, **settings)
    return shapetesting.outputs(algorithm)


def regions(surface):
    return vtk_to_numpy(surface.GetCellData().GetArray('Regions'))


i, j, k = numpy.indices(SIZE)
ball = (i - 20.2) ** 2 + (j - 17.9) ** 2 + (k - 14.6) ** 2 < 13.0 ** 2
labels = numpy.where(ball, numpy.where(i + 0.3 * j < 25.4, 2, 9), 0).astype(numpy.uint8)

# The example: through ParaView's own proxies.
source = simple.TrivialProducer()
source.GetClientSideObject().SetOutput(image(labels))
extracted = simple.ShapeLabelSurfaces(Input=source, LabelArray='Label')
extracted.UpdatePipeline()
surface = shapetesting.output(extracted)
interface = simple.Threshold(Input=extracted, Scalars=['CELLS', 'Patch'], LowerThreshold=2, UpperThreshold=2)
interface.UpdatePipeline()
assert 0 < shapetesting.output(interface).GetNumberOfCells() < surface.GetNumberOfCells() / 2

# Each pair of labels; the normal leaves the first. Points of the interface lie in its plane.
pairs = regions(surface)
assert {tuple(pair) for pair in pairs} == {(2, 0), (9, 0), (9, 2)}
corners = points(surface)[triangles(surface)]
normals = numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
inner = (pairs == (9, 2)).all(axis=1)
assert (normals[inner] @ (-1.0, -0.3, 0.0) > 0.0).all()
outer = corners[~inner].mean(axis=1) - (20.2, 17.9, 14.6)
assert ((normals[~inner] * outer).sum(axis=1) > 0.0).mean() > 0.999
heights = (corners[inner].reshape(-1, 3) @ (1.0, 0.3, 0.0) - 25.4) / numpy.hypot(1.0, 0.3)
assert numpy.sqrt((heights ** 2).mean()) < 0.15, heights.std()

# The facts: the volumes of the voxels, and the exact ones.
outputs = surfaces(image(labels), LabelArray='Label')
table = outputs[-1]
for column, expected in (('Labels', (2, 9)), ('Components', (1, 1)), ('EulerNumbers', (2, 2)),
                         ('VoxelVolumes', ((labels == 2).sum(), (labels == 9).sum()))):
    found = vtk_to_numpy(table.GetColumnByName('LabelSurfaces.' + column)).ravel()
    assert tuple(found) == expected, (column, found)
volumes = vtk_to_numpy(table.GetColumnByName('LabelSurfaces.Volumes')).ravel()
assert abs(volumes.sum() / (4.0 / 3.0 * numpy.pi * 13.0 ** 3) - 1.0) < 5e-3
assert fact(outputs[0], 'LabelSurfaces.Intersections') == 0

# The rim where both regions meet the outside is one closed curve of points of the surface.
curves = outputs[1]
assert curves.GetNumberOfLines() == 1 and curves.GetNumberOfVerts() == 0
originals = vtk_to_numpy(curves.GetPointData().GetArray('SurfacePointId'))
assert (points(outputs[0])[originals] == points(curves)).all()

# Labels at cells are samples at the centres of the cells.
cells = surfaces(image(labels, at_cells=True), LabelArray='Label')[0]
assert numpy.allclose(points(cells), points(surface) + 0.5, atol=1e-9)

# Integers of any type, and of any size that an int holds; a negative label is a region like others.
for kind in (numpy.int8, numpy.uint16, numpy.int64, numpy.uint64, numpy.float64):
    same = surfaces(image(labels.astype(kind)), LabelArray='Label')[0]
    assert (points(same) == points(surface)).all() and (regions(same) == pairs).all(), kind
renamed = surfaces(image(numpy.choose(numpy.searchsorted((0, 2, 9), labels), (0, -7, 2 ** 31 - 1))),
                   LabelArray='Label')
assert {tuple(pair) for pair in regions(renamed[0])} == {(0, -7), (2 ** 31 - 1, 0), (2 ** 31 - 1, -7)}
same = vtk_to_numpy(renamed[-1].GetColumnByName('LabelSurfaces.Volumes')).ravel()
assert numpy.allclose(same, volumes, rtol=1e-6) and same.min() > 0.0

# An image in pieces is the whole image, whether they share a layer (points) or not (cells).
for at_cells, shared in ((False, 1), (True, 0)):
    blocks = vtkMultiBlockDataSet()
    for number, (first, last) in enumerate(((0, 17 + shared), (17, SIZE[0]))):
        blocks.SetBlock(number, image(labels[first:last], at_cells=at_cells, first=(first, 0, 0)))
    joined = surfaces(blocks, LabelArray='Label')[0]
    whole = cells if at_cells else surface
    assert (points(joined) == points(whole)).all() and (triangles(joined) == triangles(whole)).all()

# Axes may be scaled and turned.
turned = image(labels, spacing=(2.0, 1.0, 0.5))
turned.SetDirectionMatrix(0, -1, 0, 1, 0, 0, 0, 0, 1)
assert numpy.allclose(points(surfaces(turned, LabelArray='Label')[0]),
                      points(surface)[:, [1, 0, 2]] * (-1.0, 2.0, 0.5), atol=1e-9)

# Chosen labels; the others are the outside.
chosen = shapetesting.new(shapemap.vtkShapeLabelSurfaces, image(labels), LabelArray='Label')
chosen.SetLabels(0, 2)
assert (regions(shapetesting.outputs(chosen)[0]) == (2, 0)).all()

# Grey values: the surface lies where they reach the threshold.
distance = 13.0 - numpy.sqrt((i - 20.2) ** 2 + (j - 17.9) ** 2 + (k - 14.6) ** 2)
grey = shapetesting.new(shapemap.vtkShapeLabelSurfaces, image(distance, 'Grey'), LabelArray='Grey', Smoothing=0.0)
grey.SetThresholds(0, 1.5)
radii = numpy.linalg.norm(points(shapetesting.outputs(grey)[0]) - (20.2, 17.9, 14.6), axis=1)
assert abs(radii - 11.5).max() < 3.0 / (8.0 * 11.5)

# Tetrahedra of the regions, which share the points between them.
solid_filter = simple.ShapeTetrahedralize(Input=extracted)
solid_filter.UpdatePipeline()
solid = shapetesting.output(solid_filter)
ids = vtk_to_numpy(solid.GetCellData().GetArray('RegionId'))
assert set(ids) == {2, 9}
tetrahedra = vtk_to_numpy(solid.GetCells().GetConnectivityArray()).reshape(-1, 4)
a, b, c, d = points(solid)[tetrahedra].transpose(1, 0, 2)
each = (numpy.cross(b - a, c - a) * (d - a)).sum(axis=1) / 6.0
assert each.min() > 0.0
for label, volume in zip((2, 9), volumes):
    assert abs(each[ids == label].sum() - volume) < 1e-9 * volume, label
shared = set(tetrahedra[ids == 2].ravel()) & set(tetrahedra[ids == 9].ravel())
assert set(triangles(surface)[inner].ravel()) <= shared, 'with the boundary preserved, points keep their ids'

# What is wrong is said.
for data, settings, expected in (
        (image(labels), {'LabelArray': 'Lable'}, "no array 'Lable'"),
        (image(distance, 'Grey'), {'LabelArray': 'Grey'}, 'set Thresholds'),
        (image(labels.astype(numpy.int64) * 2 ** 40), {'LabelArray': 'Label'}, 'value 2199023255552, but labels'),
        (image(0 * labels), {'LabelArray': 'Label'}, 'no label but the outside'),
        (image(labels), {'LabelArray': 'Label', 'Smoothing': -1.0}, 'Smoothing is -1')):
    said = shapetesting.refusal(shapetesting.new(shapemap.vtkShapeLabelSurfaces, data, **settings))
    assert expected in said, (expected, said)
