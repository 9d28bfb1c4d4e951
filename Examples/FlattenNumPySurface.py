"""Flattens a surface given as NumPy arrays, with the VTK classes alone."""
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
import shapemap

# Half of a cylindrical wall of radius 1 and height 1: points, and the corners of quadrilaterals.
rows, columns = numpy.mgrid[0:17, 0:49]
angles = numpy.pi * columns / 48
points = numpy.stack([numpy.cos(angles), numpy.sin(angles), rows / 16], axis=-1).reshape(-1, 3)
index = numpy.arange(17 * 49).reshape(17, 49)
quads = numpy.stack([index[:-1, :-1], index[:-1, 1:], index[1:, 1:], index[1:, :-1]], axis=-1)

surface = vtkPolyData()
surface.SetPoints(vtkPoints())
surface.GetPoints().SetData(numpy_to_vtk(points))
surface.SetPolys(vtkCellArray())
surface.GetPolys().SetData(4, numpy_to_vtkIdTypeArray(quads.ravel()))

flatten = shapemap.vtkShapeParameterize()
flatten.SetInputDataObject(surface)
flatten.SetDomain(2)  # FreeBoundary: the boundary is not fixed
flatten.Update()
plane = vtk_to_numpy(flatten.GetOutputDataObject(0).GetPointData().GetArray('TargetPosition'))

# A cylinder is developable: its image is a rectangle with sides of pi and 1.
corners = plane[index[[0, 0, -1], [0, -1, 0]]]
sides = numpy.linalg.norm(corners[1:] - corners[0], axis=1)
print('sides %.3f and %.3f' % tuple(sides))
assert abs(sides - [numpy.pi, 1.0]).max() < 0.01 and abs(plane[:, 2]).max() == 0.0
