"""Shape Medit Writer: Gmsh reads the same mesh from its files.

As an example: a solid of hexahedra in two layers is saved with the quadrilaterals of its boundary."""
import os
import tempfile

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersSources import vtkCellTypeSource
from paraview import simple
from paraview.modules.vtkRemotingServerManager import vtkSMProxyManager
import shapemap

import calculix
import gmsh_reader
from shapetesting import points

folder = tempfile.mkdtemp()

# The example: the grid, bent so that no coordinate is round, with a layer in RegionId.
block = calculix.block((6, 4, 5), (3.0, 2.0, 2.5))
places = points(block)
places = places + 0.1 * numpy.sin(places[:, [1, 2, 0]])
corners = vtk_to_numpy(block.GetCells().GetConnectivityArray()).reshape(-1, 8)
layers = (points(block)[corners].mean(axis=1)[:, 0] > 2.0).astype(int)
solid = calculix.hexahedra(places, corners, layers)
source = simple.TrivialProducer()
source.GetClientSideObject().SetOutput(solid)
path = os.path.join(folder, 'block.mesh')
simple.SaveData(path, source, FeatureAngle=45)
listed = vtkSMProxyManager.GetProxyManager().GetWriterFactory().GetSupportedFileTypes(source.SMProxy, 0)
assert 'Medit mesh(*.mesh )' in listed, listed

found, elements = gmsh_reader.read(path)
assert found.shape == places.shape
# Gmsh numbers anew, and writes 16 digits: nodes are found by their places.
nearest = numpy.array([abs(places - place).max(axis=1).argmin() for place in found])
assert (numpy.sort(nearest) == numpy.arange(len(places))).all()
assert abs(found - places[nearest]).max() < 1e-15
assert set(elements) == {3, 5}, set(elements)
written = {tuple(cell): layer + 1 for cell, layer in zip(corners, layers)}
read = {tuple(nearest[cell]): reference for cell, reference in zip(*elements[5])}
assert written == read
again = calculix.hexahedra(found, elements[5][0])
assert abs(gmsh_reader.volume(again) - gmsh_reader.volume(solid)) < 1e-12 * gmsh_reader.volume(solid) and gmsh_reader.volume(again) > 10.0
quads, references = elements[3]
assert len(quads) == 2 * (6 * 4 + 4 * 5 + 5 * 6) + 4 * 5, 'the boundary, and between the layers'
assert sorted(numpy.bincount(references)[1:]) == [20, 20, 20, 24, 24, 30, 30]
# Seen from outside: the boundary encloses the volume that the hexahedra fill.
a, b, c, d = found[quads[references <= 6]].transpose(1, 0, 2)
enclosed = sum((numpy.cross(p - a, q - a) * a).sum() for p, q in ((b, c), (c, d))) / 6.0
assert abs(enclosed - gmsh_reader.volume(solid)) < 1e-3 * gmsh_reader.volume(solid), 'faces are not flat'

# Tetrahedra and their triangles.
tetrahedra = vtkCellTypeSource()
tetrahedra.SetCellType(10)
tetrahedra.SetBlocksDimensions(3, 3, 3)
tetrahedra.Update()
writer = shapemap.vtkShapeMeditWriter()
writer.SetInputConnection(tetrahedra.GetOutputPort())
writer.SetFileName(os.path.join(folder, 'tetrahedra.mesh'))
assert writer.Write()
found, elements = gmsh_reader.read(writer.GetFileName())
assert len(found) == tetrahedra.GetOutput().GetNumberOfPoints()
assert len(elements[4][0]) == tetrahedra.GetOutput().GetNumberOfCells()
a, b, c, d = found[elements[4][0]].transpose(1, 0, 2)
assert abs((numpy.cross(b - a, c - a) * (d - a)).sum() / 6.0 - 27.0) < 1e-12
assert (numpy.bincount(elements[2][1])[1:] == 18).all() and elements[2][1].max() == 6

# Surface cells of the mesh's own are kept, with their region.
surface = vtkCellTypeSource()
surface.SetCellType(9)
surface.SetBlocksDimensions(4, 3, 1)
surface.Update()
writer.SetInputConnection(surface.GetOutputPort())
assert writer.Write()
found, elements = gmsh_reader.read(writer.GetFileName())
assert set(elements) == {3} and (elements[3][1] == 1).all() and len(elements[3][0]) == 12

# What cannot be written is said.
messages = []
writer.SetFileName(folder)
writer.AddObserver('ErrorEvent', lambda *_: messages.append('refused'))
assert not writer.Write() and messages and os.path.isdir(folder)
print('Gmsh reads the points, hexahedra, quadrilaterals and references that were written')
