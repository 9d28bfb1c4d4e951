"""Shape Foam Writer: ParaView's reader of OpenFOAM finds the cells, patches and zones that were written, and a
mesh is replaced only by a complete one and only where that was asked for.

As an example: a bar of two materials is saved as an OpenFOAM case, and opened again."""
import os
import resource
import tempfile

import numpy
from paraview import simple
from paraview.modules.vtkRemotingServerManager import vtkSMProxyManager
import shapemap
from vtkmodules.util.misc import calldata_type
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid
from vtkmodules.vtkIOGeometry import vtkOpenFOAMReader

import calculix
import gmsh_reader
import shapetesting
from shapetesting import points

FILES = 'boundary', 'cellZones', 'faceZones', 'faces', 'neighbour', 'owner', 'points'
folder = tempfile.mkdtemp()

# The example.
places, corners, materials = calculix.bent_bar()
source = simple.TrivialProducer()
source.GetClientSideObject().SetOutput(calculix.hexahedra(places, corners, materials))
path = os.path.join(folder, 'bar.foam')
simple.SaveData(path, source, FeatureAngle=45)
opened = simple.OpenDataFile(path)
opened.UpdatePipeline()
assert opened.GetDataInformation().GetNumberOfCells() == len(corners)
assert sorted(os.listdir(os.path.join(folder, 'constant', 'polyMesh'))) == list(FILES)

# A case has one mesh, so the writer is not offered for several blocks.
listed = vtkSMProxyManager.GetProxyManager().GetWriterFactory().GetSupportedFileTypes
assert 'OpenFOAM mesh(*.foam )' in listed(source.SMProxy, 0)
several = simple.GroupDatasets(Input=[source, source])
several.UpdatePipeline()
assert 'OpenFOAM mesh' not in listed(several.SMProxy, 0) and 'Gmsh mesh' in listed(several.SMProxy, 0)


def read(path):
    """{name: data set} of the blocks of a case: the mesh, its patches and its zones."""
    reader = vtkOpenFOAMReader()
    reader.SetFileName(path)
    reader.SetReadZones(True)
    reader.UpdateInformation()
    reader.EnableAllPatchArrays()
    reader.Update()
    found = {}

    def collect(group):
        for i in range(group.GetNumberOfBlocks()):
            block = group.GetBlock(i)
            if block.IsA('vtkMultiBlockDataSet'):
                collect(block)
            else:
                found[group.GetMetaData(i).Get(group.NAME())] = block
    collect(reader.GetOutput())
    return found


def cells(grid):
    """(type, set of positions) of each cell, in single precision, as this reader has them."""
    rounded = points(grid).astype(numpy.float32)
    offsets = vtk_to_numpy(grid.GetCells().GetOffsetsArray())
    used = vtk_to_numpy(grid.GetCells().GetConnectivityArray())
    return [(grid.GetCellType(i), {tuple(rounded[k]) for k in used[offsets[i]:offsets[i + 1]]})
            for i in range(grid.GetNumberOfCells())]


def area(surface):
    """The sum of the area vectors, and the volume of the cone over the surface."""
    a, b, c, d = points(surface)[vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 4)].transpose(
        1, 0, 2)
    halves = [numpy.cross(p - a, q - a) / 2.0 for p, q in ((b, c), (c, d))]
    return sum(halves).sum(axis=0), sum((half * a).sum() for half in halves) / 3.0


blocks = read(path)
mesh = source.GetClientSideObject().GetOutputDataObject(0)
patches = ['Patch%d' % k for k in range(6)]
assert set(blocks) == {'internalMesh', 'Region0', 'Region1', 'Interface0_1', *patches}, set(blocks)
written = cells(mesh)
assert cells(blocks['internalMesh']) == written, 'cells keep their order and kind'
for region in (0, 1):
    assert cells(blocks['Region%d' % region]) == [written[i] for i in numpy.flatnonzero(materials == region)]
assert sorted(blocks[name].GetNumberOfCells() for name in patches) == [6, 6, 12, 12, 18, 18]
assert numpy.linalg.norm(sum(area(blocks[name])[0] for name in patches)) < 1e-6, 'the patches are closed'
enclosed = sum(area(blocks[name])[1] for name in patches)
assert abs(enclosed - gmsh_reader.volume(mesh)) < 1e-2 * enclosed, 'the boundary faces outwards'
assert blocks['Interface0_1'].GetNumberOfCells() == 6
assert area(blocks['Interface0_1'])[0][0] > 1.4, 'the interface faces out of region 0'


def content(name):
    with open(os.path.join(folder, 'constant', 'polyMesh', name)) as file:
        return file.read()


# The file has every bit of the positions, and not only the single precision of the reader.
lines = content('points').split('\n(\n')[1].split('\n)')[0].splitlines()
assert (numpy.array([line.strip('()').split() for line in lines], float) == places).all()

# Each kind of cell is recognized by its faces.
kinds = vtkUnstructuredGrid()
kinds.SetPoints(vtkPoints())
shapetesting.set_points(kinds, numpy.array([
    (0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1), (0, 0, 2), (2, 0, 0),
    (2, 1, 0), (1, 0, 2), (9, 9, 9)], float))
for kind, corner in ((12, range(8)), (14, (4, 5, 6, 7, 8)), (13, (1, 5, 9, 2, 6, 10)), (10, (5, 6, 8, 11))):
    kinds.InsertNextCell(kind, len(corner), list(corner))


def write(grid, name):
    """What the writer says when it cannot write; None if it can."""
    messages = []

    @calldata_type(VTK_STRING)
    def record(caller, event, message):
        messages.append(message)

    writer = shapemap.vtkShapeFoamWriter()
    writer.AddObserver('ErrorEvent', record)
    writer.SetInputData(grid)
    writer.SetFileName(os.path.join(folder, name))
    assert writer.Write() == (not messages), messages
    return messages[0] if messages else None


os.mkdir(os.path.join(folder, 'kinds'))
assert write(kinds, 'kinds/kinds.foam') is None
found = read(os.path.join(folder, 'kinds', 'kinds.foam'))['internalMesh']
assert cells(found) == cells(kinds)
assert found.GetNumberOfPoints() == 12, 'a point that no cell uses is left out'
assert abs(gmsh_reader.volume(found) - 2.0) < 1e-6

# A mesh is replaced if its .foam file is chosen again, and under no other name.
before = {name: content(name) for name in FILES}
assert 'already has a mesh, and other.foam is not its file' in write(kinds, 'other.foam')
assert not os.path.exists(os.path.join(folder, 'other.foam'))
assert before == {name: content(name) for name in FILES}
assert write(kinds, 'bar.foam') is None and content('points').split('\n\n')[1].startswith('12\n')
assert 'Interface' not in content('faceZones') and 'Region1' not in content('cellZones')
assert write(mesh, 'bar.foam') is None and before == {name: content(name) for name in FILES}
# Files that belong to the older mesh alone would no longer fit.
stray = os.path.join(folder, 'constant', 'polyMesh', 'cellLevel')
open(stray, 'w').close()
assert "has 'cellLevel', which belongs to another mesh" in write(kinds, 'bar.foam')
assert before == {name: content(name) for name in FILES} and os.path.exists(stray)
os.remove(stray)

# Where the disk is full, here by a limit on the size of files, the older mesh stays, and a new case leaves
# nothing behind.
limit = resource.getrlimit(resource.RLIMIT_FSIZE)
os.mkdir(os.path.join(folder, 'full'))
resource.setrlimit(resource.RLIMIT_FSIZE, (1024, limit[1]))
try:
    refusals = write(mesh, 'bar.foam'), write(mesh, 'full/bar.foam')
finally:
    resource.setrlimit(resource.RLIMIT_FSIZE, limit)
assert all('could not be written completely' in refusal for refusal in refusals), refusals
assert before == {name: content(name) for name in FILES}
assert sorted(os.listdir(os.path.join(folder, 'constant', 'polyMesh'))) == list(FILES)
assert os.listdir(os.path.join(folder, 'full')) == []

# A folder is made for the mesh, but not for the file itself; a file in the way is no folder.
assert 'choose an existing folder' in write(mesh, 'missing/bar.foam')
assert not os.path.exists(os.path.join(folder, 'missing'))
open(os.path.join(folder, 'full', 'constant'), 'w').close()
assert "cannot make the folder '" in write(mesh, 'full/bar.foam')
assert os.listdir(os.path.join(folder, 'full')) == ['constant']
triangle = shapetesting.copy(kinds)
triangle.InsertNextCell(5, 3, [0, 1, 2])
assert '1 cell without a volume (first cell 4)' in write(triangle, 'bar.foam')
print('ParaView reads the', len(written), 'cells, 6 patches, 2 regions and the interface of an OpenFOAM case')
