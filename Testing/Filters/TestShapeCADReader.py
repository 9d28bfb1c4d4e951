"""Shape CAD Reader: a plate with a hole, modelled and written as STEP and BREP by Gmsh's OpenCASCADE.

As an example: the file is opened, and the plate is filled with tetrahedra."""
import math
import os
import subprocess
import tempfile

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from paraview import servermanager, simple
from paraview.modules.vtkRemotingServerManager import vtkSMProxyManager
import shapemap

import shapetesting
from shapetesting import fact, points



def numbers(data, name):
    return vtk_to_numpy(data.GetCellData().GetArray(name))


folder = tempfile.mkdtemp()
script = os.path.join(folder, 'plate.geo')
with open(script, 'w') as file:  # Gmsh skips a last line that does not end
    file.write('SetFactory("OpenCASCADE"); Box(1) = {0, 0, 0, 4, 3, 2};'
               'Cylinder(2) = {2, 1.5, -1, 0, 0, 4, 0.75};'
               'BooleanDifference{ Volume{1}; Delete; }{ Volume{2}; Delete; }\n')
for kind in ('step', 'brep'):
    subprocess.check_call(['gmsh', script, '-0', '-o', os.path.join(folder, 'plate.' + kind)],
                          stdout=subprocess.DEVNULL)

plate = simple.OpenDataFile(os.path.join(folder, 'plate.step'))
assert plate.SMProxy.GetXMLName() == 'ShapeCADReader'
plate.Deflection = 0.01
solid = simple.ShapeTetrahedralize(Input=plate)
solid.UpdatePipeline()
surface, edges = shapetesting.output(plate), shapetesting.output(plate, 1)
assert set(numbers(surface, 'Patch')) == set(range(1, 8))
assert set(numbers(surface, 'RegionId')) == {0}
assert fact(surface, 'CADReader.Unit') == 'mm'
assert fact(surface, 'CADReader.OpenEdges') == 0
assert fact(surface, 'CADReader.Deflection') == 0.01
assert 0 < fact(surface, 'CADReader.Distance') <= 0.01
assert surface.GetFieldData().GetAbstractArray('CADReader.RegionNames').GetNumberOfValues() == 1

# Two circles and twelve straight edges; the circles are exact.
assert len(set(numbers(edges, 'Edge'))) == edges.GetNumberOfCells() == 14
curved = [edges.GetCell(i) for i in range(14) if edges.GetCell(i).GetNumberOfPoints() > 2]
assert len(curved) == 2
for circle in curved:
    x, y, z = numpy.array([circle.GetPoints().GetPoint(k) for k in range(circle.GetNumberOfPoints())]).T
    assert abs(numpy.hypot(x - 2.0, y - 1.5) - 0.75).max() < 1e-9 and len(set(z)) == 1
on_surface = {tuple(position) for position in points(surface)}
assert all(tuple(position) in on_surface for position in points(edges))

# The hole's wall moves by the deflection at most.
a, b, c, d = points(shapetesting.output(solid))[
    vtk_to_numpy(shapetesting.output(solid).GetCells().GetConnectivityArray()).reshape(-1, 4)].transpose(1, 0, 2)
volume = numpy.einsum('ij,ij->i', numpy.cross(b - a, c - a), d - a).sum() / 6.0
assert abs(volume - (24.0 - math.pi * 0.75 ** 2 * 2.0)) <= 2.0 * math.pi * 0.75 * 2.0 * 0.01, volume

# Hexahedra know the CAD faces.
remesh = simple.ShapeHexRemesh(Surface=plate, Method='Grid', CellSize=0.4)
assert remesh.PatchArray == 'None'
remesh.PatchArray = 'Patch'
remesh.UpdatePipeline()
hexahedra, boundary = shapetesting.output(remesh), shapetesting.output(remesh, 1)
assert fact(hexahedra, 'HexRemesh.CreasesKept') == 1 and fact(hexahedra, 'HexRemesh.PatchesLost') == 0
assert fact(hexahedra, 'HexRemesh.MinimumScaledJacobian') > 0.2
assert set(numbers(boundary, 'Patch')) == set(numbers(surface, 'Patch'))
assert set(numbers(hexahedra, 'FacePatch').ravel()) == set(numbers(surface, 'Patch')) | {-1}
# The area of each face is that of the CAD face.


def areas(data):
    corners = points(data)[vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(data.GetNumberOfCells(), -1)]
    sizes = sum(numpy.linalg.norm(numpy.cross(corners[:, k] - corners[:, 0], corners[:, k + 1] - corners[:, 0]),
                                  axis=1) for k in range(1, corners.shape[1] - 1)) / 2.0
    return numpy.bincount(numbers(data, 'Patch'), sizes)[1:]


assert abs(areas(boundary) / areas(surface) - 1.0).max() < 0.01, areas(boundary) / areas(surface)
algorithm = shapemap.vtkShapeHexRemesh()
algorithm.SetInputDataObject(0, surface)
algorithm.SetPatchArray('RegionIds')
shapetesting.check_refused(algorithm, "no cell array 'RegionIds'", 'choose another Patch Array, or None')

# A BREP file of the same shape has no unit. Other points of its circles are chosen.
brep = simple.OpenDataFile(os.path.join(folder, 'plate.brep'))
brep.Deflection = 0.01
brep.UpdatePipeline()
assert set(numbers(shapetesting.output(brep), 'Patch')) == set(range(1, 8))
x, y, _ = points(shapetesting.output(brep)).T
assert (abs(numpy.hypot(x - 2.0, y - 1.5) - 0.75) < 1e-9).sum() == len(x) - 8, 'all but the corners'
assert shapetesting.output(brep).GetFieldData().GetAbstractArray('CADReader.Unit') is None

types = vtkSMProxyManager.GetProxyManager().GetReaderFactory().GetSupportedFileTypes(
    servermanager.ActiveConnection.Session).split(';;')
for kind in ('step', 'stp', 'iges', 'igs', 'brep'):
    assert sum('*.' + kind in one.replace('(', ' ').replace(')', ' ').split() for one in types[1:]) == 1, types

# A damaged file is refused, with the line, and leaves nothing.
damaged = os.path.join(folder, 'damaged.step')
with open(damaged, 'w') as file:
    file.write(open(os.path.join(folder, 'plate.step')).read()[:1500])
reader = shapemap.vtkShapeCADReader()
messages = []
reader.AddObserver('ErrorEvent', lambda *_: messages.append('refused'))
reader.SetFileName(damaged)
reader.Update()
assert messages == ['refused'] and reader.GetOutputDataObject(0).GetNumberOfPoints() == 0
assert reader.GetOutputDataObject(1).GetNumberOfPoints() == 0
print(len(points(surface)), 'points on', len(set(numbers(surface, 'Patch'))), 'CAD faces')
