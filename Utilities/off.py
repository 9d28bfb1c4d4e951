"""Surfaces in the Object File Format, which ParaView does not read."""
import itertools

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData


def read(path):
    """The polygons in the file, as vtkPolyData with double points; colours are left out."""
    with open(path) as file:
        lines = [line.split('#')[0].split() for line in file]
    lines = [line for line in lines if line]
    # The counts may follow the word OFF on its line; COFF is OFF with colours.
    if not lines or lines[0][0] not in ('OFF', 'COFF'):
        raise ValueError(path + ' does not begin with OFF')
    lines[0] = lines[0][1:]
    lines = lines if lines[0] else lines[1:]
    points, faces = int(lines[0][0]), int(lines[0][1])
    if len(lines) < 1 + points + faces:
        raise ValueError(path + ' ends too early')
    coordinates = numpy.array([line[:3] for line in lines[1:1 + points]], float).reshape(-1, 3)
    polygons = [[int(word) for word in line[1:1 + int(line[0])]]
                for line in lines[1 + points:1 + points + faces]]
    return surface(coordinates, polygons)


def surface(points, polygons):
    """Points (n x 3) and polygons (lists of indices) as vtkPolyData."""
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    data.GetPoints().SetData(numpy_to_vtk(numpy.ascontiguousarray(points), deep=True))
    offsets = numpy.cumsum([0] + [len(polygon) for polygon in polygons], dtype=numpy.int64)
    corners = numpy.fromiter(itertools.chain.from_iterable(polygons), numpy.int64)
    cells = vtkCellArray()
    cells.SetData(numpy_to_vtkIdTypeArray(offsets, deep=True),
                  numpy_to_vtkIdTypeArray(corners, deep=True))
    data.SetPolys(cells)
    return data
