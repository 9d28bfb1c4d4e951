"""Shape Deck Reader: the nodes and elements of decks of CalculiX, LS-DYNA and FEBio.

As an example: a deck of two blocks, with a file that it includes, is opened and measured."""
import os
import tempfile

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersVerdict import vtkCellSizeFilter
from paraview import servermanager, simple
from paraview.modules.vtkRemotingServerManager import vtkSMProxyManager
import shapemap

import decks
import shapetesting
from shapetesting import points

folder = tempfile.mkdtemp()
COUNTS = (3, 4, 2)
path = decks.write(folder, COUNTS)
deck = simple.ShapeDeckReader(FileNames=[path])
deck.UpdatePipeline()
data = shapetesting.output(deck)


def volume(grid):
    sizes = vtkCellSizeFilter()
    sizes.SetInputData(grid)
    sizes.Update()
    return vtk_to_numpy(sizes.GetOutput().GetCellData().GetArray('Volume')).sum()


cells, nodes = int(numpy.prod(COUNTS)), int(numpy.prod(numpy.array(COUNTS) + 1))
assert data.GetNumberOfCells() == 2 * cells and data.GetNumberOfPoints() == 2 * nodes + 1
assert abs(volume(data) - decks.SIZE.prod()) < 1e-12
numbers = shapetesting.array(data, 'NodeId')
assert numbers[0] == 1 and numbers[nodes] == 999 + nodes and numbers[-1] == 999 + 2 * nodes
assert points(data)[nodes].tolist() == [0.5, 0.5, 1.0], 'a node that no element uses'
regions = vtk_to_numpy(data.GetCellData().GetArray('RegionId'))
centres = points(data)[vtk_to_numpy(data.GetCells().GetConnectivityArray()).reshape(-1, 8)].mean(axis=1)
assert (regions == (centres[:, 2] > 1.0)).all()
words = data.GetFieldData().GetAbstractArray('RegionName')
assert [words.GetValue(i) for i in range(2)] == ['LOWER', 'UPPER']
assert data.GetFieldData().GetAbstractArray('Deck').GetValue(0) == path
assert data.GetFieldData().GetArray('DeckReader.SkippedElements').GetValue(0) == 0
elements = vtk_to_numpy(data.GetCellData().GetArray('ElementId'))
assert elements[0] == 1 and elements[cells] == 500 + cells

# What the writers of meshes wrote is read back: FEBio's and Abaqus's to the bit, columns of LS-DYNA nearly.
ball = simple.XMLUnstructuredGridReader(FileName=[shapetesting.data_file('BallSmall.vtu')])
bent = simple.Calculator(Input=ball, CoordinateResults=1, Function='coords*1.2345678901 + 0.1*sin(coordsX)*jHat')
bent.UpdatePipeline()
written = shapetesting.output(bent)
for extension, error in (('inp', 0.0), ('feb', 0.0), ('k', 1e-8)):
    name = os.path.join(folder, 'ball.' + extension)
    simple.SaveData(name, bent)
    again = simple.ShapeDeckReader(FileNames=[name])
    again.UpdatePipeline()
    read = shapetesting.output(again)
    assert (abs(points(read) - points(written)) <= error * abs(points(written))).all(), extension
    hexahedra = [i for i in range(read.GetNumberOfCells()) if read.GetCellType(i) == 12]
    assert len(hexahedra) == written.GetNumberOfCells(), extension
    assert abs(volume(read) - volume(written)) < 1e-7, extension

for extension in ('k', 'feb'):
    opened = simple.OpenDataFile(os.path.join(folder, 'ball.' + extension))
    assert opened.SMProxy.GetXMLName() == 'ShapeDeckReader', (extension, opened.SMProxy.GetXMLName())
types = vtkSMProxyManager.GetProxyManager().GetReaderFactory().GetSupportedFileTypes(
    servermanager.ActiveConnection.Session)
assert 'Input deck (*.inp' in types, types

# Wrong decks are refused and leave nothing.
with open(os.path.join(folder, 'wrong.inp'), 'w') as file:
    file.write('*NODE\n1, 0, 0, 0\n*INCLUDE, INPUT=missing.inc\n')
reader = shapemap.vtkShapeDeckReader()
messages = []
reader.AddObserver('ErrorEvent', lambda *_: messages.append('refused'))
reader.SetFileName(os.path.join(folder, 'wrong.inp'))
reader.Update()
assert messages == ['refused'] and reader.GetOutputDataObject(0).GetNumberOfPoints() == 0
print(2 * cells, 'hexahedra read')
