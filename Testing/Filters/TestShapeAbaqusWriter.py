"""Shape Abaqus Writer: CalculiX reads its files and finds displacements that are known exactly.

As an example: a mesh is saved, and a deck that includes it pulls at one of its sides."""
import os
import resource
import tempfile

import numpy
from vtkmodules.util.misc import calldata_type
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkFiltersSources import vtkCellTypeSource
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from paraview import simple
from paraview.modules.vtkRemotingServerManager import vtkSMProxyManager
import shapemap

import calculix
import shapetesting
from shapetesting import points

# The example: whatever ParaView has as an unstructured grid is saved by its extension.
folder = tempfile.mkdtemp()
ball = simple.XMLUnstructuredGridReader(FileName=[shapetesting.data_file('BallSmall.vtu')])
simple.SaveData(os.path.join(folder, 'ball.inp'), ball, HexahedronType='C3D8R', FeatureAngle=60)
lines = open(os.path.join(folder, 'ball.inp')).read().splitlines()
assert '*ELSET, ELSET=Region0' in lines and '*NSET, NSET=Boundary' in lines
given = points(shapetesting.output(ball))
nodes = lines[lines.index('*NODE') + 1:][:len(given)]
read = numpy.array([line.split(', ') for line in nodes], float)
assert (read[:, 0] == numpy.arange(len(given)) + 1).all()
assert abs(read[:, 1:] - given).max() <= 1e-14, 'rounded where 20 columns are too few'
assert (read[:, 1:] == given)[abs(given) > 0.01].all(), 'to the bit'

# File > Save Data lists it, for unstructured grids and no others.
factory = vtkSMProxyManager.GetProxyManager().GetWriterFactory()
listed = factory.GetSupportedFileTypes(ball.SMProxy, 0)
assert 'Abaqus input(*.inp )' in listed, listed
sphere = simple.Sphere()
sphere.UpdatePipeline()
assert '*.inp' not in factory.GetSupportedFileTypes(sphere.SMProxy, 0)

# Hexahedra of Shape Hex Remesh keep its patches: a smooth shape is one patch, though quads meet at
# sharper angles than Feature Angle somewhere.
for shape, sharp in (('DentedSphere600.vtp', False), ('BentBarSmall.vtp', True)):
    surface = simple.XMLPolyDataReader(FileName=[shapetesting.data_file(shape)])
    remeshed = simple.ShapeHexRemesh(Surface=surface, Method='Grid', CellsOnLongestSide=12)
    simple.SaveData(os.path.join(folder, 'remeshed.inp'), remeshed, FeatureAngle=5)
    text = open(os.path.join(folder, 'remeshed.inp')).read()
    boundary = shapetesting.output(remeshed, 1)
    patches = vtk_to_numpy(boundary.GetCellData().GetArray('Patch'))
    assert (patches.max() > 0) == sharp, patches.max()
    assert text.count('*NSET, NSET=Patch') == patches.max() + 1
    corners = vtk_to_numpy(boundary.GetPolys().GetConnectivityArray()).reshape(-1, 4)
    original = vtk_to_numpy(boundary.GetPointData().GetArray('OriginalPointId'))
    for patch in range(patches.max() + 1):
        block = text.split('*NSET, NSET=Patch%d\n' % patch)[1].split('*')[0]
        written = {int(word) - 1 for word in block.replace(',', ' ').split()}
        assert written == set(original[corners[patches == patch]].ravel().tolist()), (shape, patch)

# A block that is pulled has a linear displacement, which its elements reproduce: the patch test. By
# displacements on the node sets, and by pressure on a surface.
young, poisson, strain = 210.0, 0.3, 0.01


def check_patch_test(grid, element, length, **properties):
    model = calculix.Model(grid, **properties)
    assert any('TYPE=%s,' % element in key for key in model.blocks), list(model.blocks)
    exact = model.points * strain * numpy.array([1.0, -poisson, -poisson])
    symmetry = ['Patch%s, %d, %d' % (model.patch_at(axis, 0.0), axis + 1, axis + 1)
                for axis in range(3)]
    far = model.patch_at(0, length)
    pulled = model.solve(young, poisson, symmetry + ['Patch%s, 1, 1, %r' % (far, length * strain)])
    pressed = model.solve(young, poisson, symmetry,
                          ['*DSLOAD', 'PatchSurface%s, P, %r' % (far, -young * strain)])
    for moved in (pulled, pressed):
        assert abs(moved - exact).max() < 1e-6 * abs(exact).max(), (element, abs(moved - exact).max())
    return model


random = numpy.random.RandomState(3)


def distorted(grid, high):
    """The points of a box moved by up to an eighth of a cell of size 1; those of a side within it."""
    places = points(grid)
    step = 0.12 * random.uniform(-1.0, 1.0, places.shape)
    step[(places == 0.0) | (places == high)] = 0.0
    moved = shapetesting.copy(grid)
    shapetesting.set_points(moved, places + step)
    return moved


# Cells of any shape pass with C3D8; with CalculiX's C3D8R and C3D8I only parallelepipeds do.
straight = calculix.block((6, 3, 3), (6.0, 3.0, 3.0))
cube = distorted(straight, [6.0, 3.0, 3.0])
model = check_patch_test(cube, 'C3D8', 6.0, HexahedronType=0)
assert abs(sum(model.shares(model.patch_at(0, 6.0)).values()) - 9.0) < 1e-12, 'the area of a side'
check_patch_test(straight, 'C3D8R', 6.0, HexahedronType=1)
check_patch_test(straight, 'C3D8I', 6.0)

# Two materials in a row stretch as springs do, and meet in a node set.
corners = vtk_to_numpy(straight.GetCells().GetConnectivityArray()).reshape(-1, 8)
two = calculix.hexahedra(points(straight), corners,
                         points(straight)[corners].mean(axis=1)[:, 0] > 3.0)
model = calculix.Model(two, HexahedronType=0)
between = model.node_set('Interface0_1')
assert (model.points[between, 0] == 3.0).all() and len(between) == 16
symmetry = ['Patch%s, %d, %d' % (model.patch_at(axis, 0.0), axis + 1, axis + 1) for axis in range(3)]
moved = model.solve({0: 100.0, 1: 300.0}, 0.0, symmetry + ['Patch%s, 1, 1, 0.12' % model.patch_at(0, 6.0)])
assert abs(moved[between, 0] - 0.09).max() < 1e-7

# Tetrahedra of any shape, and wedges that are prisms.
for kind, element in ((10, 'C3D4'), (13, 'C3D6')):
    source = vtkCellTypeSource()
    source.SetCellType(kind)
    source.SetBlocksDimensions(3, 3, 3)
    source.Update()
    solid = source.GetOutput()
    check_patch_test(distorted(solid, 3.0) if kind == 10 else solid, element, 3.0)

# Voxels become hexahedra; ghost cells stay out.
voxels = vtkAppendFilter()
image = vtkRTAnalyticSource()
image.SetWholeExtent(0, 3, 0, 3, 0, 3)
voxels.SetInputConnection(image.GetOutputPort())
voxels.Update()
assert voxels.GetOutput().GetCellType(0) == 11
model = calculix.Model(voxels.GetOutput())
assert abs(model.solve(1.0, 0.0, [
    'Patch%s, 1, 3' % model.patch_at(0, 0.0),
    'Patch%s, 1, 1, 0.3' % model.patch_at(0, 3.0)])[:, 0] - 0.1 * model.points[:, 0]).max() < 1e-6
ghosted = shapetesting.copy(cube)
ghosts = numpy_to_vtk(numpy.array([1] + [0] * 53, numpy.uint8), deep=True)
ghosts.SetName('vtkGhostType')
ghosted.GetCellData().AddArray(ghosts)
assert len(calculix.Model(ghosted).elements()) == 53

# Points that a mesh has twice, as in a crack, stay two; of several blocks each has its own file.
halves = calculix.hexahedra(
    numpy.concatenate([points(straight)] * 2), numpy.concatenate([corners, corners + len(points(straight))]))
source = simple.TrivialProducer()
source.GetClientSideObject().SetOutput(halves)
simple.SaveData(os.path.join(folder, 'twice.inp'), source)
assert open(os.path.join(folder, 'twice.inp')).read().count(', 6., 3., 3.\n') == 2
simple.SaveData(os.path.join(folder, 'blocks.inp'), simple.GroupDatasets(Input=[source, ball]))
sizes = [os.path.getsize(os.path.join(folder, name)) for name in (
    'twice.inp', 'blocks0.inp', 'ball.inp', 'blocks1.inp')]
assert sizes[0] == sizes[1] and abs(sizes[2] / sizes[3] - 1.0) < 0.3, sizes


# What cannot be written is said, and why.
def refused(grid, words, path=os.path.join(folder, 'refused.inp'), **properties):
    messages = []

    @calldata_type(VTK_STRING)
    def record(caller, event, message):
        messages.append(message)

    writer = shapemap.vtkShapeAbaqusWriter()
    writer.AddObserver('ErrorEvent', record)
    writer.SetInputData(grid)
    writer.SetFileName(path)
    for name, value in properties.items():
        getattr(writer, 'Set' + name)(value)
    assert not writer.Write() and len(messages) == 1, messages
    assert 'Shape Abaqus Writer: ' in messages[0] and words in messages[0], messages
    assert path is None or path.startswith('/dev/') or not os.path.isfile(path), 'a part was left'


refused(cube, 'there is no file name', path=None)
refused(cube, 'cannot open the file', path=os.path.join(folder, 'missing', 'x.inp'))
refused(cube, 'No such file or directory', path=os.path.join(folder, 'missing', 'x.inp'))
refused(cube, 'could not be written completely (No space left on device)', path='/dev/full')
refused(vtkUnstructuredGrid(), 'the Input has no cells')
refused(cube, "no cell array 'Layer'", RegionArray='Layer')
refused(cube, 'FeatureAngle is 200', FeatureAngle=200.0)
source = vtkCellTypeSource()
source.SetCellType(25)  # quadratic hexahedra
source.SetBlocksDimensions(2, 1, 1)
source.Update()
refused(source.GetOutput(), 'has 2 cells of the type vtkQuadraticHexahedron (first cell 0)')
nan = shapetesting.copy(cube)
nan.GetPoints().SetPoint(7, numpy.nan, 0.0, 0.0)
refused(nan, 'not finite')
# A file that is there stays as it is where the mesh cannot be written.
kept = os.path.join(folder, 'kept.inp')
open(kept, 'w').write('precious')
writer = shapemap.vtkShapeAbaqusWriter()
writer.AddObserver('ErrorEvent', lambda *_: None)
writer.SetInputData(nan)
writer.SetFileName(kept)
assert not writer.Write() and open(kept).read() == 'precious'
# So does one where the disk is full, here by a limit on the size of files; nothing else is left in the folder.
before = sorted(os.listdir(folder))
open(kept, 'w').write('precious')
limit = resource.getrlimit(resource.RLIMIT_FSIZE)
resource.setrlimit(resource.RLIMIT_FSIZE, (1024, limit[1]))
try:
    writer = shapemap.vtkShapeAbaqusWriter()
    writer.AddObserver('ErrorEvent', lambda *_: None)
    writer.SetInputData(cube)
    writer.SetFileName(kept)
    written = writer.Write()
finally:
    resource.setrlimit(resource.RLIMIT_FSIZE, limit)
assert not written and open(kept).read() == 'precious' and sorted(os.listdir(folder)) == before
# A complete one replaces it, with its permissions, and behind a link.
os.chmod(kept, 0o640)
link = os.path.join(folder, 'link.inp')
os.symlink(kept, link)
writer.SetFileName(link)
assert writer.Write() and os.path.islink(link) and open(kept).read().startswith('*')
assert os.stat(kept).st_mode & 0o777 == 0o640
# What the user stops half-way is not left behind, and is no error.
errors = []
writer = shapemap.vtkShapeAbaqusWriter()
writer.SetInputData(cube)
writer.SetFileName(os.path.join(folder, 'stopped.inp'))
writer.AddObserver('ErrorEvent', lambda *_: errors.append(1))
tag = writer.AddObserver(
    'ProgressEvent', lambda *_: writer.SetAbortExecute(writer.GetProgress() > 0.6))
assert not writer.Write() and not errors and not os.path.exists(writer.GetFileName())
writer.RemoveObserver(tag)
writer.SetAbortExecute(0)
assert writer.Write() and os.path.exists(writer.GetFileName())
print('CalculiX reads what is written, and passes the patch test')
