"""VTK XML files: doubles, inline, compressed, the same bytes for the same values."""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON, vtkCellArray, vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter, vtkXMLUnstructuredGridWriter


def _data_set(data, points, cells, target):
    coordinates = vtkPoints()
    coordinates.SetData(numpy_to_vtk(np.ascontiguousarray(points, dtype=np.float64), deep=True))
    data.SetPoints(coordinates)
    if target is not None:
        array = numpy_to_vtk(np.ascontiguousarray(target, dtype=np.float64), deep=True)
        array.SetName("TargetPosition")
        data.GetPointData().AddArray(array)
    cell_array = vtkCellArray()
    cell_array.SetData(
        numpy_to_vtkIdTypeArray(np.arange(len(cells) + 1, dtype=np.int64) * cells.shape[1], deep=True),
        numpy_to_vtkIdTypeArray(np.ascontiguousarray(cells, dtype=np.int64).reshape(-1), deep=True))
    return cell_array


def _write(writer, data, path):
    writer.SetInputData(data)
    writer.SetFileName(str(path))
    # Inline, in base64: raw appended data are not XML, and today's expat does not let VTK 9.2 read them.
    writer.SetDataModeToBinary()
    writer.SetCompressorTypeToZLib()
    writer.SetCompressionLevel(9)
    writer.SetIdTypeToInt32()
    writer.SetByteOrderToLittleEndian()
    if not writer.Write():
        raise OSError(f"cannot write {path}")


def write_surface(path, points, triangles, target):
    """A .vtp file of triangles, with the point array TargetPosition."""
    data = vtkPolyData()
    data.SetPolys(_data_set(data, points, triangles, target))
    _write(vtkXMLPolyDataWriter(), data, path)


def write_solid(path, points, hexahedra, target=None):
    """A .vtu file of hexahedra, with the point array TargetPosition where there is a target."""
    data = vtkUnstructuredGrid()
    data.SetCells(VTK_HEXAHEDRON, _data_set(data, points, hexahedra, target))
    _write(vtkXMLUnstructuredGridWriter(), data, path)
