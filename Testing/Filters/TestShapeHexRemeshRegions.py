"""Shape Hex Remesh of regions that touch: from an image of labels, and from its surface.

As an example: a segmentation with two regions; colour the hexahedra by RegionId."""
import os
import tempfile

import numpy
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkMultiBlockDataSet
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer
import shapemap

import shapetesting
from shapetesting import fact, points

SIZE = 17


def image(values, name='Label'):
    data = vtkImageData()
    data.SetDimensions(*values.shape)
    array = numpy_to_vtk(values.ravel(order='F'), deep=True)
    array.SetName(name)
    data.GetPointData().SetScalars(array)
    return data


def new(surface=None, labels=None, inner=None, **settings):
    algorithm = shapemap.vtkShapeHexRemesh()
    for port, data in ((0, surface), (3, labels)):
        if data:
            algorithm.SetInputDataObject(port, data)
    if inner:
        producer = vtkTrivialProducer()
        producer.SetOutput(inner)
        algorithm.AddInnerSurfaces(producer.GetOutputPort())
    for name, value in settings.items():
        getattr(algorithm, 'Set' + name)(value)
    return algorithm


def many(data, name):
    return vtk_to_numpy(shapetesting.facts(data).GetArray('HexRemesh.' + name)).ravel()


def cells(data, name):
    return vtk_to_numpy(data.GetCellData().GetArray(name))


def check(solid, boundary):
    assert solid.GetNumberOfCells() > 0 and cells(solid, 'ScaledJacobian').min() > 0.0
    regions = cells(solid, 'RegionId')
    assert set(regions) == {2, 9} and (many(solid, 'RegionLabels') == (2, 9)).all()
    assert (many(solid, 'RegionEulerNumbers') == 2).all() and (many(solid, 'RegionComponents') == 1).all()
    assert (many(solid, 'RegionHexahedra') == [(regions == label).sum() for label in (2, 9)]).all()
    volumes = [cells(solid, 'Volume')[regions == label].sum() for label in (2, 9)]
    assert numpy.allclose(many(solid, 'RegionVolumes'), volumes, rtol=0.02)
    assert fact(solid, 'HexRemesh.Regions') == 2
    pairs = cells(boundary, 'Regions')
    assert {tuple(pair) for pair in pairs} == {(2, 0), (9, 0), (9, 2)}
    assert ((pairs[:, 1] == 0) == (cells(boundary, 'Interface') == 0)).all()
    # The normal leaves the first region: upwards, for the interface.
    ids = vtk_to_numpy(boundary.GetPolys().GetConnectivityArray()).reshape(-1, 4)
    corners = points(boundary)[ids[(pairs == (9, 2)).all(axis=1)]]
    normals = numpy.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
    assert len(normals) > 0 and (normals.sum(axis=0)[0] < 0.0)


i, j, k = numpy.indices((SIZE,) * 3)
ball = (i - 8) ** 2 + (j - 8) ** 2 + (k - 8) ** 2 < 6.6 ** 2
labels = numpy.where(ball, numpy.where(i < 8, 2, 9), 0).astype(numpy.uint8)

# The example: through ParaView's own proxies. ParaView connects the active source to the first input
# that is not given, which is Surface.
source = simple.TrivialProducer()
source.GetClientSideObject().SetOutput(image(labels))
remesh = simple.ShapeHexRemesh(Surface=None, Labels=source, LabelArray='Label', CellSize=2.0)
remesh.UpdatePipeline()
solid, boundary = shapetesting.output(remesh, 0), shapetesting.output(remesh, 1)
check(solid, boundary)

# The writers name the regions, the interface and the patches.
folder = tempfile.mkdtemp()
for ending, names in (('inp', ('Region2', 'Region9', 'Interface2_9', 'Patch0', 'Patch1')),
                      ('msh', ('Region2', 'Region9', 'Interface2_9', 'Patch0')),
                      ('feb', ('Region2', 'Region9', 'Interface2_9', 'Patch0'))):
    path = os.path.join(folder, 'regions.' + ending)
    simple.SaveData(path, remesh)
    text = open(path, errors='replace').read()
    for name in names:
        assert name in text, (ending, name)
for ending in ('k', 'mesh'):
    path = os.path.join(folder, 'regions.' + ending)
    simple.SaveData(path, remesh)
    assert os.path.getsize(path) > 10 * solid.GetNumberOfCells(), ending

# The surface of the same labels gives the same hexahedra, also as a block.
surfaces = shapetesting.new(shapemap.vtkShapeLabelSurfaces, image(labels), LabelArray='Label')
surface = shapetesting.outputs(surfaces)[0]
block = vtkMultiBlockDataSet()
block.SetBlock(0, surface)
for data in (surface, block):
    other = new(data, CellSize=2.0)
    assert not shapetesting.run(other)
    assert (points(other.GetOutputDataObject(0)) == points(solid)).all()

# What cannot be: the message has the fact and the remedy.
two = surface.NewInstance()
two.DeepCopy(surface)
two.GetCellData().GetArray('Regions').SetComponent(0, 1, two.GetCellData().GetArray('Regions').GetComponent(0, 0))
grey = image(numpy.where(ball, 0.5, 0.0))
for algorithm, words in (
        (new(), ('Surface', 'Labels', 'connected')),
        (new(surface, image(labels)), ('Labels', 'both', 'disconnect')),
        (new(surface, inner=surface), ('Regions', 'Inner Surfaces', 'disconnect')),
        (new(labels=image(labels), SizeArray='Size'), ('Size Array', 'None')),
        (new(surface, Method=1), ('grid', 'Method')),
        (new(two), ('both sides', 'Regions')),
        (new(labels=grey), ('no label', 'integers')),
        (new(labels=image(labels), LabelArray='Absent'), ('Absent', 'Label')),
        (new(labels=image(0 * labels)), ('outside',)),
        (new(labels=vtkImageData()), ('no points',))):
    shapetesting.check_refused(algorithm, *words)
