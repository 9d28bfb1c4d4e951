"""Surfaces in the Object File Format, which ParaView does not read."""
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData


def read(path):
    """The surface of triangles in the file, as vtkPolyData with double points."""
    with open(path) as file:
        words = [word for line in file for word in line.split('#')[0].split()]
    if not words or words[0] != 'OFF':
        raise ValueError(path + ' does not begin with OFF')
    points, faces = int(words[1]), int(words[2])
    coordinates = numpy.array(words[4:4 + 3 * points], float).reshape(-1, 3)
    faces = numpy.array(words[4 + 3 * points:4 + 3 * points + 4 * faces], int).reshape(-1, 4)
    if (faces[:, 0] != 3).any():
        raise ValueError(path + ' has faces that are not triangles')
    return surface(coordinates, faces[:, 1:])


def surface(points, triangles):
    """Points (n x 3) and triangles (m x 3 indices) as vtkPolyData."""
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    data.GetPoints().SetData(numpy_to_vtk(numpy.ascontiguousarray(points), deep=True))
    cells = vtkCellArray()
    corners = numpy.ascontiguousarray(triangles, dtype=numpy.int64).ravel()
    cells.SetData(3, numpy_to_vtkIdTypeArray(corners, deep=True))
    data.SetPolys(cells)
    return data
