"""Shape Medit Reader: what Shape Medit Writer and Gmsh wrote.

As an example: a solid is saved as .mesh, and opened again."""
import os
import subprocess
import tempfile

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from paraview import servermanager, simple
from paraview.modules.vtkRemotingServerManager import vtkSMProxyManager
import shapemap

import shapetesting
from shapetesting import points

folder = tempfile.mkdtemp()
path = os.path.join(folder, 'ball.mesh')
ball = simple.XMLUnstructuredGridReader(FileName=[shapetesting.data_file('BallSmall.vtu')])
simple.SaveData(path, ball, FeatureAngle=60)
again = simple.OpenDataFile(path)
again.UpdatePipeline()
assert again.SMProxy.GetXMLName() == 'ShapeMeditReader'
written, read = shapetesting.output(ball), shapetesting.output(again)
assert (points(read) == points(written)).all(), 'to the bit'
hexahedra = [i for i in range(read.GetNumberOfCells()) if read.GetCellType(i) == 12]
assert len(hexahedra) == written.GetNumberOfCells()
references = vtk_to_numpy(read.GetCellData().GetArray('Reference'))
assert (references[hexahedra] == 1).all() and references.min() == 1
corners = vtk_to_numpy(read.GetCells().GetConnectivityArray())[-8 * len(hexahedra):]
assert (corners == vtk_to_numpy(written.GetCells().GetConnectivityArray())).all()

types = vtkSMProxyManager.GetProxyManager().GetReaderFactory().GetSupportedFileTypes(
    servermanager.ActiveConnection.Session).split(';;')
assert sum('*.mesh' in one.replace('(', ' ').replace(')', ' ').split() for one in types[1:]) == 1, types

# Gmsh fills a box with tetrahedra; the triangles' references are the box's faces.
script = os.path.join(folder, 'box.geo')
with open(script, 'w') as file:
    file.write('SetFactory("OpenCASCADE"); Box(1) = {0, 0, 0, 3, 2, 1}; Mesh.MeshSizeMax = 0.5;')
gmsh = os.path.join(folder, 'box.mesh')
subprocess.check_call(['gmsh', script, '-3', '-format', 'mesh', '-o', gmsh], stdout=subprocess.DEVNULL)
box = simple.ShapeMeditReader(FileNames=[gmsh])
box.UpdatePipeline()
data = shapetesting.output(box)
kinds = numpy.array([data.GetCellType(i) for i in range(data.GetNumberOfCells())])
cells = [numpy.array([[data.GetCell(i).GetPointId(k) for k in range(corners)]
                      for i in numpy.flatnonzero(kinds == kind)]) for kind, corners in ((10, 4), (5, 3))]
a, b, c, d = points(data)[cells[0]].transpose(1, 0, 2)
volumes = numpy.einsum('ij,ij->i', numpy.cross(b - a, c - a), d - a) / 6.0
assert abs(abs(volumes).sum() - 6.0) < 1e-9
faces = vtk_to_numpy(data.GetCellData().GetArray('Reference'))[kinds == 5]
a, b, c = points(data)[cells[1]].transpose(1, 0, 2)
areas = numpy.linalg.norm(numpy.cross(b - a, c - a), axis=1) / 2.0
by_face = [areas[faces == face].sum() for face in numpy.unique(faces)]
assert numpy.allclose(sorted(by_face), [2.0, 2.0, 3.0, 3.0, 6.0, 6.0]), by_face

# Wrong files are refused and leave nothing.
with open(path, 'w') as file:
    file.write('MeshVersionFormatted 2\nDimension 3\nVertices\n2\n0 0 0 0\n')
reader = shapemap.vtkShapeMeditReader()
messages = []
reader.AddObserver('ErrorEvent', lambda *_: messages.append('refused'))
reader.SetFileName(path)
reader.Update()
assert messages == ['refused'] and reader.GetOutputDataObject(0).GetNumberOfPoints() == 0
print(len(hexahedra), 'hexahedra and', len(volumes), 'tetrahedra read')
