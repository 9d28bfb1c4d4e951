"""VTK XML files: doubles, inline, compressed, the same bytes for the same values."""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON, vtkCellArray, vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter, vtkXMLUnstructuredGridWriter


def _array(values, name):
    array = numpy_to_vtk(np.ascontiguousarray(values, dtype=np.float64), deep=True)
    array.SetName(name)
    return array


def _data_set(data, points, counts, cells, arrays):
    """Gives `data` its points and point arrays (those that are not None), and returns cells of `counts` corners."""
    coordinates = vtkPoints()
    coordinates.SetData(_array(points, "Points"))
    data.SetPoints(coordinates)
    for name, values in arrays.items():
        if values is not None:
            data.GetPointData().AddArray(_array(values, name))
    offsets = np.concatenate([[0], np.cumsum(counts)])
    cell_array = vtkCellArray()
    cell_array.SetData(
        numpy_to_vtkIdTypeArray(np.ascontiguousarray(offsets, dtype=np.int64), deep=True),
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


def write_surface(path, points, triangles, target, source=None):
    """A .vtp file of triangles, with the point arrays TargetPosition and SourcePosition where there are such."""
    data = vtkPolyData()
    data.SetPolys(_data_set(data, points, [3] * len(triangles), triangles,
                            {"TargetPosition": target, "SourcePosition": source}))
    _write(vtkXMLPolyDataWriter(), data, path)


def write_curves(path, points, counts):
    """A .vtp file of polylines that have counts[i] points of their own each, in order."""
    data = vtkPolyData()
    data.SetLines(_data_set(data, points, counts, np.arange(len(points)), {}))
    _write(vtkXMLPolyDataWriter(), data, path)


def write_charges(path, points, triangles, charges, affine):
    """A .vtp file with a charge set: the point array Charge, the bounding surface, the field data Affine."""
    data = vtkPolyData()
    data.SetPolys(_data_set(data, points, [3] * len(triangles), triangles, {"Charge": charges}))
    data.GetFieldData().AddArray(_array(affine, "Affine"))
    _write(vtkXMLPolyDataWriter(), data, path)


def write_solid(path, points, hexahedra, target=None):
    """A .vtu file of hexahedra, with the point array TargetPosition where there is a target."""
    data = vtkUnstructuredGrid()
    data.SetCells(VTK_HEXAHEDRON, _data_set(data, points, [8] * len(hexahedra), hexahedra,
                                            {"TargetPosition": target}))
    _write(vtkXMLUnstructuredGridWriter(), data, path)
