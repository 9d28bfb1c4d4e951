"""Surfaces from .off files, and from numpy arrays."""
import itertools

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

from shapemap import vtkShapeOFFReader


def read(path):
    """The surface in an .off file, as vtkPolyData with double points."""
    reader = vtkShapeOFFReader()
    reader.SetFileName(path)
    problems = []
    reader.AddObserver('ErrorEvent', lambda *_: problems.append(path))
    reader.Update()
    if problems:
        raise ValueError(path + ' cannot be read; the error output says why')
    return reader.GetOutputDataObject(0)


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
