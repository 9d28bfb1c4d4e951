"""VTK data from numpy arrays, and numpy arrays from VTK data. All arrays are copied."""
from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Optional, Union

import numpy
from numpy.typing import ArrayLike, NDArray
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import (
    VTK_HEXAHEDRON, VTK_PYRAMID, VTK_TETRA, VTK_WEDGE, vtkCellArray, vtkDataObject, vtkPolyData, vtkTable,
    vtkUnstructuredGrid)

__all__ = ['Data', 'cell_array', 'cells', 'column', 'curves', 'mesh', 'point_array', 'points']

#: What an input takes: VTK data; an array of points (n x 3); or points, cells and, optionally, a
#: dictionary of point arrays. Cells: see `mesh`.
Data = Union[vtkDataObject, ArrayLike]
Arrays = Mapping[str, ArrayLike]

_SOLID_CELLS = {4: VTK_TETRA, 5: VTK_PYRAMID, 6: VTK_WEDGE, 8: VTK_HEXAHEDRON}


def mesh(points: ArrayLike, cells: Optional[ArrayLike] = None, arrays: Optional[Arrays] = None, *,
         solid: bool = False) -> vtkDataObject:
    """Make VTK data from arrays.

    Parameters
    ----------
    points : array, n x 3
        The positions of the points.
    cells : array of int, m x k, optional
        The points of each cell, from 0. A surface: triangles (k = 3), quads (4) or larger polygons. A
        solid: tetrahedra (4), pyramids (5), wedges (6) or hexahedra (8). Without cells, each point is a
        vertex.
    arrays : dict, optional
        Point arrays by name, such as ``{'TargetPosition': image}``.
    solid : bool, default False
        Whether the cells are solid.

    Returns
    -------
    vtkPolyData or vtkUnstructuredGrid
        The surface, or the solid.
    """
    return _with_points(vtkUnstructuredGrid() if solid else vtkPolyData(), points, cells, arrays)


def curves(points: ArrayLike, lines: Sequence[Sequence[int]], arrays: Optional[Arrays] = None) -> vtkPolyData:
    """Make polylines from arrays.

    Parameters
    ----------
    points : array, n x 3
        The positions of the points.
    lines : sequence of sequences of int
        The points of each polyline, from 0. A closed one ends with its first point.
    arrays : dict, optional
        Point arrays by name.

    Returns
    -------
    vtkPolyData
        The polylines.
    """
    data = _with_points(vtkPolyData(), points, None, arrays)
    made = vtkCellArray()
    for line in lines:
        made.InsertNextCell(len(line), [int(point) for point in line])
    data.SetLines(made)
    data.SetVerts(None)
    return data


def points(data: vtkDataObject) -> NDArray[numpy.float64]:
    """The positions of the points, n x 3."""
    if hasattr(data, 'GetPoints') and data.GetPoints() is None:
        return numpy.empty((0, 3))
    if hasattr(data, 'GetPoints'):
        return numpy.array(vtk_to_numpy(data.GetPoints().GetData()), dtype=float)
    # Image data and rectilinear grids.
    return numpy.array([data.GetPoint(k) for k in range(data.GetNumberOfPoints())], dtype=float).reshape(-1, 3)


def cells(data: vtkDataObject) -> Any:
    """The points of each cell: an array, m x k, if all cells have k points, else a list of arrays.

    Of a surface, these are its polygons, or its lines if it has no polygon, or its vertices.
    """
    if isinstance(data, vtkPolyData):
        held = next((each for each in (data.GetPolys(), data.GetLines(), data.GetVerts())
                     if each.GetNumberOfCells()), data.GetPolys())
    else:
        held = data.GetCells()
    if held.GetNumberOfCells() == 0:
        return numpy.empty((0, 3), dtype=numpy.int64)
    connectivity = numpy.array(vtk_to_numpy(held.GetConnectivityArray()), dtype=numpy.int64)
    offsets = vtk_to_numpy(held.GetOffsetsArray())
    sizes = numpy.diff(offsets)
    if (sizes == sizes[0]).all():
        return connectivity.reshape(-1, int(sizes[0]))
    return numpy.split(connectivity, offsets[1:-1])


def point_array(data: vtkDataObject, name: str) -> NDArray[Any]:
    """The values of a point array, one row for each point. Raises KeyError if there is none."""
    return _array(data.GetPointData(), name, 'point array')


def cell_array(data: vtkDataObject, name: str) -> NDArray[Any]:
    """The values of a cell array, one row for each cell. Raises KeyError if there is none."""
    return _array(data.GetCellData(), name, 'cell array')


def column(table: vtkTable, name: str) -> NDArray[Any]:
    """A column of a table. Raises KeyError if there is none."""
    return _array(table.GetRowData(), name, 'column')


def values(held: Any) -> NDArray[Any]:
    """A copy of any VTK array, of strings, too."""
    if isinstance(held, vtkStringArray):
        return numpy.array([held.GetValue(k) for k in range(held.GetNumberOfValues())])
    return numpy.array(vtk_to_numpy(held))


def to_vtk(given: Data, name: str, solid: bool) -> vtkDataObject:
    """What an input was given, as VTK data. `solid`: whether cells of four points are tetrahedra."""
    if isinstance(given, vtkDataObject):
        return given
    if isinstance(given, tuple):
        if len(given) not in (2, 3):
            raise TypeError('%s: give (points, cells) or (points, cells, point arrays), not %d parts' %
                            (name, len(given)))
        size = 1 if given[1] is None else numpy.shape(given[1])[-1]
        return mesh(*given, solid=solid and size in _SOLID_CELLS)
    array = numpy.asarray(given)
    if array.ndim != 2 or array.shape[1] != 3 or array.dtype.kind not in 'fiu':
        raise TypeError('%s: give VTK data, points (n x 3), or (points, cells); not %s' % (name, type(given).__name__))
    return mesh(array)


def _array(held: Any, name: str, kind: str) -> NDArray[Any]:
    found = held.GetAbstractArray(name)
    if found is None:
        names = [held.GetArrayName(k) for k in range(held.GetNumberOfArrays())]
        raise KeyError('there is no %s %s; there are %s' % (kind, name, ', '.join(map(str, names)) or 'none'))
    return values(found)


def _with_points(data: Any, points: ArrayLike, cells: Optional[ArrayLike], arrays: Optional[Arrays]) -> Any:
    positions = numpy.ascontiguousarray(points, dtype=float)
    if positions.ndim != 2 or positions.shape[1] != 3:
        raise ValueError('points have shape %s; give n x 3' % (positions.shape,))
    held = vtkPoints()
    held.SetData(numpy_to_vtk(positions, deep=True))
    data.SetPoints(held)
    _add_cells(data, numpy.arange(len(positions))[:, None] if cells is None else cells, len(positions))
    for name, array in (arrays or {}).items():
        copied = numpy.ascontiguousarray(array)
        if len(copied) != len(positions):
            raise ValueError('the point array %s has %d rows; give one for each of the %d points' %
                             (name, len(copied), len(positions)))
        made = numpy_to_vtk(copied, deep=True)
        made.SetName(name)
        data.GetPointData().AddArray(made)
    return data


def _add_cells(data: Any, given: ArrayLike, count: int) -> None:
    rows = numpy.asarray(given)
    if rows.ndim != 2 or rows.dtype.kind not in 'iu':
        raise ValueError('cells must be an array of integers, m x k')
    if rows.size and (rows.min() < 0 or rows.max() >= count):
        raise ValueError('a cell has the point %d; points are from 0 to %d' %
                         (rows.min() if rows.min() < 0 else rows.max(), count - 1))
    size = rows.shape[1]
    made = vtkCellArray()
    made.SetData(numpy_to_vtkIdTypeArray(size * numpy.arange(len(rows) + 1, dtype=numpy.int64), deep=True),
                 numpy_to_vtkIdTypeArray(numpy.ascontiguousarray(rows, dtype=numpy.int64).ravel(), deep=True))
    if isinstance(data, vtkUnstructuredGrid):
        if size not in _SOLID_CELLS:
            raise ValueError('solid cells have 4, 5, 6 or 8 points, not %d' % size)
        data.SetCells(_SOLID_CELLS[size], made)
    elif size == 1:
        data.SetVerts(made)
    elif size == 2:
        data.SetLines(made)
    else:
        data.SetPolys(made)
