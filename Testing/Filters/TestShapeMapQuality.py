"""Shape Map Quality: how far a map is from an isometry, by cell and in sum.

As an example: give it a surface or solid with TargetPosition, colour it by SymmetricDirichlet, and
read the table from the second output."""
import numpy
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkPlaneSource
import shapemap

import shapetesting
from shapetesting import fact, points, read

MEASURES = ['JacobianDeterminant', 'Dirichlet', 'SymmetricDirichlet', 'ConformalDistortion', 'ARAP',
            'Hencky', 'AMIPS', 'AreaDistortion', 'L2Stretch', 'LinfStretch',
            'SmallestSingularValue', 'LargestSingularValue']
LINEAR = numpy.array([[3.0, 0.4, 0.0], [0.0, 1.0, -0.2], [0.1, 0.0, 0.5]])


def cells(data, name):
    values = data.GetCellData().GetArray(name)
    assert values is not None, 'there is no cell array ' + name
    return vtk_to_numpy(values)


def row(table, measure):
    """Minimum, mean, maximum and share of a measure."""
    names = table.GetColumnByName('Measure')
    at = [names.GetValue(i) for i in range(table.GetNumberOfRows())].index(measure)
    return [table.GetColumnByName(name).GetValue(at)
            for name in ('Minimum', 'Mean', 'Maximum', 'Share')]


def measured(data, array=None):
    """The outputs and the error messages."""
    algorithm = shapemap.vtkShapeMapQuality()
    if array:
        algorithm.SetMapArray(array)
    algorithm.SetInputDataObject(data)
    messages = ' '.join(shapetesting.run(algorithm))
    outputs = [algorithm.GetOutputDataObject(port) for port in range(2)]
    return outputs[0], outputs[1], messages


def with_map(data, targets):
    mapped = shapetesting.copy(data)
    shapetesting.add_array(mapped, targets, 'TargetPosition')
    return mapped


def expected(matrix):
    """Of a linear map of space."""
    s = numpy.linalg.svd(matrix, compute_uv=False)
    s[-1] *= numpy.sign(numpy.linalg.det(matrix))
    d, size = len(s), abs(s.prod())
    area = 0.5 * (size + 1.0 / size)
    angles = numpy.prod([0.5 * abs(s[i] / s[k] + s[k] / s[i]) for i in range(d) for k in range(i)])
    return [s.prod(), (s * s).sum() / 2.0, (s * s + 1.0 / (s * s)).sum(),
            (s * s).sum() / (d * size ** (2.0 / d)), ((s - 1.0) ** 2).sum(),
            (numpy.log(abs(s)) ** 2).sum(), numpy.exp(angles + 0.5 * area), area,
            numpy.sqrt((1.0 / (s * s)).mean()), 1.0 / abs(s).min(), abs(s).min(), abs(s).max()]


# The example: through ParaView's own proxies, the image of Shape Parameterize.
surface = simple.XMLPolyDataReader(FileName=[shapetesting.data_file('DentedSphere600.vtp')])
sphere = simple.ShapeParameterize(Input=surface)
quality = simple.ShapeMapQuality(Input=sphere, MapArray='TargetPosition')
quality.UpdatePipeline()
result, table = shapetesting.output(quality, 0), shapetesting.output(quality, 1)
assert fact(result, 'MapQuality.FlippedCells') == 0 and cells(result, 'Flipped').sum() == 0
assert fact(result, 'MapQuality.DegenerateCells') == 0
assert fact(result, 'MapQuality.Cells') == result.GetNumberOfCells()
assert fact(result, 'MapQuality.MinimumJacobianDeterminant') > 0.0
# Shape Parameterize states the same mean.
assert abs(fact(result, 'MapQuality.MeanConformalDistortion') -
           fact(shapetesting.output(sphere), 'Parameterize.ConformalDistortion')) < 1e-12
# The mean determinant, weighted by area, is the ratio of the areas of both surfaces.
corners = points(result)[shapetesting.triangles(result)]
areas = 0.5 * numpy.linalg.norm(
    numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
for measure in MEASURES:
    values = cells(result, measure)
    least, mean, greatest, share = row(table, measure)
    assert (least, greatest, share) == (values.min(), values.max(), 0.0), measure
    assert (least, mean, greatest, share) == tuple(fact(result, 'MapQuality.' + name + measure)
                                                   for name in ('Minimum', 'Mean', 'Maximum', 'Share'))
    assert abs(mean - (areas * values).sum() / areas.sum()) < 1e-12 * abs(mean), measure
assert row(table, 'SymmetricDirichlet')[0] >= 4.0

# The mirror image of the sphere is flipped everywhere.
mirrored = with_map(result, -shapetesting.array(result, 'TargetPosition'))
mirrored, table, messages = measured(mirrored)
assert not messages and row(table, 'JacobianDeterminant')[3] == 1.0
assert fact(mirrored, 'MapQuality.FlippedCells') == mirrored.GetNumberOfCells()

# A linear map is known on every cell: hexahedra, voxels of an image, quadrilaterals out of space.
lattice = vtkImageData()
lattice.SetDimensions(4, 3, 5)
lattice.SetSpacing(0.5, 0.7, 0.2)
places = numpy.array([lattice.GetPoint(i) for i in range(lattice.GetNumberOfPoints())])
for data, source in ((read('BallSmall.vtu'), points(read('BallSmall.vtu'))), (lattice, places)):
    for matrix in (LINEAR, -LINEAR):
        solid, table, messages = measured(with_map(data, source @ matrix.T))
        assert not messages and solid.GetClassName() == data.GetClassName(), messages
        for measure, value in zip(MEASURES, expected(matrix)):
            assert numpy.allclose(cells(solid, measure), value, rtol=1e-5), measure
        assert (cells(solid, 'Flipped') == (matrix is not LINEAR)).all()
sheet = vtkPlaneSource()
sheet.SetResolution(3, 4)
sheet.Update()
quads = sheet.GetOutput()
assert quads.GetCell(0).GetNumberOfPoints() == 4
stretched, table, messages = measured(
    with_map(quads, points(quads) @ numpy.diag([3.0, 0.5, 1.0])))
for measure, value in zip(MEASURES, expected(numpy.diag([3.0, 0.5]))):
    assert numpy.allclose(cells(stretched, measure), value, rtol=1e-6), measure

# A bar that is twisted, bent or not: a true map of a solid has no flipped hexahedron.
bar, table, messages = measured(read('TwistedBarSmall.vtu'))
assert not messages and fact(bar, 'MapQuality.FlippedCells') == 0, messages
assert row(table, 'SymmetricDirichlet')[0] >= 6.0 - 1e-9

# Blocks are one whole in the table, and keep their places.
blocks = vtkMultiBlockDataSet()
blocks.SetNumberOfBlocks(3)
blocks.SetBlock(0, with_map(lattice, places))
blocks.SetBlock(2, with_map(lattice, 2.0 * places))
both, table, messages = measured(blocks)
assert not messages and both.GetBlock(1) is None
least, mean, greatest, share = row(table, 'JacobianDeterminant')
assert numpy.allclose((least, mean, greatest), (1.0, 4.5, 8.0)), (least, mean, greatest)
assert fact(both, 'MapQuality.Cells') == 2 * lattice.GetNumberOfCells()

# Ghost cells have values, and are not counted.
ghostly = with_map(lattice, 2.0 * places)
ghosts = numpy.zeros(ghostly.GetNumberOfCells(), dtype=numpy.uint8)
ghosts[:7] = 1
marks = numpy_to_vtk(ghosts, deep=True)
marks.SetName('vtkGhostType')
ghostly.GetCellData().AddArray(marks)
ghostly, table, messages = measured(ghostly)
assert fact(ghostly, 'MapQuality.Cells') == ghostly.GetNumberOfCells() - 7
assert numpy.allclose(cells(ghostly, 'JacobianDeterminant'), 8.0)

# Without a map array, or with one that is no map, it says so; and where there is nothing to measure.
for data, array, words in (
        (read('BallSmall.vtu'), None, "the Input has no point array 'TargetPosition'; make it with Shape Correspondence"),
        (result, 'Elsewhere', "no point array 'Elsewhere'; choose another array"),
        (with_map(lattice, places[:, :2]), None, 'has 2 components, not 3'),
        (with_map(lattice, places * numpy.where(numpy.arange(60) == 7, numpy.nan, 1.0)[:, None]),
         None, "the map array 'TargetPosition' of the Input has 1 point with a value that is not "
         'finite (first at point 7)')):
    output, table, messages = measured(data, array)
    assert 'Shape Map Quality: ' in messages and words in messages, messages
    assert output.GetNumberOfPoints() == 0 and table.GetNumberOfRows() == 0
loose = vtkPolyData()
loose.SetPoints(read('DentedSphere600.vtp').GetPoints())
assert 'has no surface or solid cells' in measured(
    with_map(loose, points(loose)))[2]
flat = with_map(quads, points(quads))
shapetesting.set_points(flat, 0.0 * points(flat))
assert "none of the Input's 12 cells has an area or volume" in measured(flat)[2]
print('maps are measured cell by cell and in sum')
