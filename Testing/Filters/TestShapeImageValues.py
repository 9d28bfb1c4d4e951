"""Shape Image Values: means of an image within cells, and materials from them.

As an example: a scanned block of bone gets materials and is written for CalculiX. The calibration and
the law are expressions."""
import os
import tempfile

import numpy
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkMultiBlockDataSet
import shapemap

import calculix
import shapetesting
from shapetesting import fact, points


def image(field, kind=float, size=(14, 12, 10), name='HU', turned=False):
    """An image from -0.5 on with a field of the position."""
    data = vtkImageData()
    data.SetExtent(3, 2 + size[0], -4, size[1] - 5, 0, size[2] - 1)
    data.SetSpacing(0.5, 0.4, 0.5)
    if turned:
        data.SetDirectionMatrix(0.8, -0.6, 0, 0.6, 0.8, 0, 0, 0, -1)
        data.SetOrigin(-1.0, -1.0, 3.2)
    else:
        data.SetOrigin(-2.0, 1.1, -0.5)
    places = numpy.array([data.GetPoint(i) for i in range(data.GetNumberOfPoints())])
    array = numpy_to_vtk(field(places).astype(kind), deep=True)
    array.SetName(name)
    data.GetPointData().SetScalars(array)
    return data


def block():
    """Twelve cells in a row, turned and sheared."""
    grid = calculix.block((6, 2, 1), (3.0, 2.0, 1.0))
    places = points(grid)
    shapetesting.set_points(grid, places @ numpy.array([[1.0, 0.1, 0.0], [0.0, 0.9, 0.2], [0.1, 0.0, 1.1]]))
    return grid


def centres(grid):
    corners = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 8)
    return points(grid)[corners].mean(axis=1)


def values(data, name):
    return vtk_to_numpy(data.GetCellData().GetArray(name))


def compute(*inputs, **settings):
    return shapetesting.outputs(shapetesting.new(shapemap.vtkShapeImageValues, *inputs, **settings))


def linear(places):
    return 300.0 + places @ [400.0, 50.0, -30.0]


# The example, through ParaView's own proxies.
mesh, scan = simple.TrivialProducer(), simple.TrivialProducer()
mesh.GetClientSideObject().SetOutput(block())
scan.GetClientSideObject().SetOutput(image(linear))
bone = simple.ShapeImageValues(Input=mesh, Image=scan, ImageArray='HU', Density='0.01 + 0.001 * HU',
                               ModulusLaw='6850 * Density^1.49', Materials=4,
                               BoundaryLayers=0)  # this image has no partial volume
bone.UpdatePipeline()
data = shapetesting.output(bone)
folder = tempfile.mkdtemp()
simple.SaveData(os.path.join(folder, 'bone.inp'), bone, PoissonRatio=0.25, DensityScale=1e-9)
text = open(os.path.join(folder, 'bone.inp')).read()
assert text.count('*MATERIAL, NAME=Material') == text.count('*SOLID SECTION') == 4, text
assert text.count(', .25\n*DENSITY\n') == 4

# A linear field has the mean of the centre, in parallelepipeds, and any spacing and direction.
expected = linear(centres(block()))
assert abs(values(data, 'HU') - expected).max() < 1e-10
assert abs(values(data, 'Density') - (0.01 + 0.001 * expected)).max() < 1e-12
turned = compute(block(), image(linear, turned=True))[0]
full = values(turned, 'Coverage') > 1.0 - 1e-9
assert full.sum() >= 4 and abs(values(turned, 'HU') - expected)[full].max() < 1e-10
assert not turned.GetCellData().HasArray('Modulus'), 'without a density there is no material'

# The modulus is the mean over the cell. The field varies little along two axes: fine sums of the law.
steps = (numpy.arange(40) + 0.5) / 40.0
corners = vtk_to_numpy(block().GetCells().GetConnectivityArray()).reshape(-1, 8)
first = points(block())[corners]
axes = first[:, [1, 3, 4]] - first[:, :1]
weights = numpy.stack(numpy.meshgrid(steps, steps, steps), axis=-1).reshape(-1, 3)
exact = numpy.array([(6850.0 * (0.01 + 0.001 * linear(f[0] + weights @ a)) ** 1.49).mean()
                     for f, a in zip(first, axes)])
assert abs(values(data, 'Modulus') / exact - 1.0).max() < 1e-4

# The table: materials ascend, and keep the integrals; the cells have their material's values.
table = shapetesting.output(bone, 1)
column = {name: vtk_to_numpy(table.GetColumnByName(name)) for name in ('Id', 'Modulus', 'Density', 'Volume', 'Cells')}
volume = numpy.linalg.det(axes[0])
assert (column['Id'] == range(4)).all() and (numpy.diff(column['Modulus']) > 0.0).all()
assert column['Cells'].sum() == 12 and abs(column['Volume'].sum() - 12.0 * volume) < 1e-12
for name in ('Modulus', 'Density'):
    integral = values(data, name).sum() * volume
    assert abs((column[name] * column['Volume']).sum() - integral) < 1e-12 * integral
    assert (values(data, 'Material' + name) == column[name][values(data, 'MaterialId')]).all()
assert abs(fact(data, 'ImageValues.Mass') - values(data, 'Density').sum() * volume) < 1e-12
assert fact(data, 'ImageValues.Materials') == 4 and fact(data, 'ImageValues.CellsOutside') == 0

# Integers, several arrays and components; a block and a ghost.
scanned = image(lambda places: numpy.full(len(places), 7), numpy.int16)
colours = numpy_to_vtk(numpy.tile([10, 20, 30], (scanned.GetNumberOfPoints(), 1)).astype(numpy.uint8), deep=True)
colours.SetName('Colour')
scanned.GetPointData().AddArray(colours)
tree = vtkMultiBlockDataSet()
ghosts = vtkUnsignedCharArray()
ghosts.SetName('vtkGhostType')
for number in range(12):
    ghosts.InsertNextValue(1 if number == 5 else 0)
marked = block()
marked.GetCellData().AddArray(ghosts)
tree.SetBlock(0, block())
tree.SetBlock(2, marked)
made = shapetesting.new(shapemap.vtkShapeImageValues, tree, scanned, Density='max(0.1, Value / 7)')
together = shapetesting.outputs(made)
assert together[0].GetNumberOfBlocks() == 3
for number in (0, 2):
    assert abs(values(together[0].GetBlock(number), 'HU') - 7.0).max() < 1e-13
    assert abs(values(together[0].GetBlock(number), 'Colour') / [10, 20, 30] - 1.0).max() < 1e-13
    assert abs(values(together[0].GetBlock(number), 'Density') - 1.0).max() < 1e-13
assert fact(together[0], 'ImageValues.Cells') == 23

# Cells outside of the image: counted, and without a material.
away = block()
shapetesting.set_points(away, points(away) + [3.6, 0.0, 0.0])
cut = compute(away, image(linear))[0]
outside = values(cut, 'Coverage') == 0.0
assert 0 < outside.sum() < 12 and (values(cut, 'HU')[outside] == 0.0).all()
assert fact(cut, 'ImageValues.CellsOutside') == outside.sum()


def refused(*words, mesh=None, scan=None, **settings):
    shapetesting.check_refused(shapetesting.new(
        shapemap.vtkShapeImageValues, mesh or block(), scan or image(linear), **settings), *words)


refused('Image does not contain', 'Threshold', mesh=away, Density='Value')
refused('expression of Density', 'Value or HU', Density='0.001 * Valu')
refused('expression of Modulus Law', 'Density', Density='Value', ModulusLaw='6850 * Density^')
refused('modulus is negative or not finite', 'max(0.01', Density='Value - 1000')
refused('no point array', 'HU', Density='Value', ImageArray='CT')
refused('3 components', Density='Value', ImageArray='Colour', scan=scanned)
refused('sample along its axis k', scan=image(linear, size=(14, 12, 1)))
refused('Materials is 0', Density='Value', Materials=0)
refused('BoundaryLayers is -1', Density='Value', BoundaryLayers=-1)
