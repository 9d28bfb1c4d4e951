"""Shape OFF Reader: real models, colours, file series and messages.

As an example: File > Open, or OpenDataFile, reads an .off file like any other."""
import glob
import os
import tempfile

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from paraview import servermanager, simple
from paraview.modules.vtkRemotingServerManager import vtkSMProxyManager
import shapemap

import shapetesting

models = os.environ['SHAPEMAP_MODELS']
bunny = simple.OpenDataFile(os.path.join(models, 'bunny00.off'))
bunny.UpdatePipeline()
assert bunny.SMProxy.GetXMLName() == 'ShapeOFFReader'
surface = shapetesting.output(bunny)
assert shapetesting.euler(surface) == 2 and shapetesting.edges(surface, 'Boundary') == 0

# No other reader claims the extension, so that ParaView does not ask which one to take.
types = vtkSMProxyManager.GetProxyManager().GetReaderFactory().GetSupportedFileTypes(
    servermanager.ActiveConnection.Session).split(';;')
assert sum('*.off' in one.replace('(', ' ').replace(')', ' ').split() for one in types[1:]) == 1, types


def read(path):
    reader = shapemap.vtkShapeOFFReader()
    messages = []
    reader.AddObserver('ErrorEvent', lambda *_: messages.append('refused'))
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutputDataObject(0), messages


# Every model of the package, against the numbers of its own text.
paths = sorted(glob.glob(os.path.join(models, '*.off')))
assert len(paths) > 100
for path in paths:
    words = [line.split('#')[0].split() for line in open(path)]
    words = [word for line in words for word in line if word not in ('OFF', 'COFF')]
    count, faces = int(words[0]), int(words[1])
    data, messages = read(path)
    assert not messages and data.GetNumberOfPoints() == count and data.GetNumberOfCells() == faces, path
    if data.GetPointData().GetNumberOfArrays() == 0:
        expected = numpy.array(words[3:3 + 3 * count], float).reshape(-1, 3)
        assert (vtk_to_numpy(data.GetPoints().GetData()) == expected).all(), path
    if data.GetPointData().GetNumberOfArrays() + data.GetCellData().GetNumberOfArrays() == 0:
        polygons = data.GetPolys()
        offsets = vtk_to_numpy(polygons.GetOffsetsArray())
        cells = numpy.insert(vtk_to_numpy(polygons.GetConnectivityArray()), offsets[:-1],
                             offsets[1:] - offsets[:-1])
        # A file may go on with words of its own.
        end = 3 + 3 * count + len(cells)
        assert cells.tolist() == [int(word) for word in words[3 + 3 * count:end]], path

# Colours.
folder = tempfile.mkdtemp()
path = os.path.join(folder, 'colours.off')
with open(path, 'w') as file:
    file.write('COFF\n3 2 0\n0 0 0 255 0 0 255\n1 0 0 0 255 0 255\n0 1 0 0 0 255 127\n'
               '2 0 1\n3 0 1 2 9 8 7\n')
data, messages = read(path)
assert (vtk_to_numpy(data.GetPointData().GetArray('RGBA'))[2] == [0, 0, 255, 127]).all()
# The line, which VTK numbers first, has the grey of cells without a colour.
assert vtk_to_numpy(data.GetCellData().GetArray('RGB')).tolist() == [[170, 170, 170], [9, 8, 7]]

# Several files are the steps of an animation.
series = simple.ShapeOFFReader(FileNames=[path, os.path.join(models, 'cube.off')])
assert list(series.TimestepValues) == [0.0, 1.0]
series.UpdatePipeline(1.0)
assert series.GetDataInformation().GetNumberOfPoints() == 8

# Wrong files are refused and leave nothing.
for content in ('OFF\n3 1 0\n0 0 0\n1 0 0\n', 'solid of STL\n', ''):
    with open(path, 'w') as file:
        file.write(content)
    data, messages = read(path)
    assert messages == ['refused'] and data.GetNumberOfPoints() == 0
assert read(os.path.join(folder, 'missing.off'))[1] == ['refused']
print(len(paths), 'models read')
