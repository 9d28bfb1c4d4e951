"""Shape Solidify: any polygons become the closed surface of a solid.

As an example: a dome as unconnected triangles, closed again."""
import numpy
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import VTK_QUAD, VTK_TETRA, VTK_TRIANGLE, vtkCellArray, vtkPolyData
from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid
from vtkmodules.vtkCommonCore import vtkIdList, vtkPoints
from vtkmodules.vtkFiltersCore import vtkFeatureEdges, vtkMassProperties, vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource
import shapemap

import shapetesting
from shapetesting import fact, points, read, triangles

METHODS = {'Automatic': 0, 'Report': 1, 'Mend': 2, 'Solid': 3, 'Wrap': 4}


def new(surface, method='Automatic', **properties):
    return shapetesting.new(shapemap.vtkShapeSolidify, surface, Method=METHODS[method], **properties)


def solid(surface, method='Automatic', **properties):
    return shapetesting.outputs(new(surface, method, **properties))


def cells(data, name):
    return vtk_to_numpy(data.GetCellData().GetArray(name))


def open_or_tangled(data):
    edges = vtkFeatureEdges()
    edges.SetInputData(data)
    edges.FeatureEdgesOff()
    edges.Update()
    return edges.GetOutput().GetNumberOfCells()


def volume(data):
    mass = vtkMassProperties()
    mass.SetInputData(data)
    mass.Update()
    return mass.GetVolume()


def soup(surface):
    """An unstructured grid of unconnected triangles."""
    grid = vtkUnstructuredGrid()
    scattered = vtkPoints()
    scattered.SetDataType(surface.GetPoints().GetDataType())
    scattered.SetData(numpy_to_vtk(points(surface)[triangles(surface).ravel()], deep=True))
    grid.SetPoints(scattered)
    for cell in range(surface.GetNumberOfCells()):
        grid.InsertNextCell(VTK_TRIANGLE, 3, [3 * cell, 3 * cell + 1, 3 * cell + 2])
    return grid


# The example.
dome = simple.Sphere(Radius=1.0, ThetaResolution=40, PhiResolution=40, EndPhi=120.0)
scattered = simple.Shrink(Input=dome, ShrinkFactor=1.0)
whole = simple.ShapeSolidify(Input=scattered)
whole.UpdatePipeline()
found = shapetesting.output(whole)
assert open_or_tangled(found) == 0
assert fact(found, 'Solidify.OpenLoops') == 1 and fact(found, 'Solidify.GapsClosed') == 1
# Shrink moves some points by rounding. Of the dome's own triangles, all are kept, and the float coordinates are
# the same numbers.
before = shapetesting.output(dome)
found = solid(soup(before))[0]
assert (cells(found, 'Origin') == 0).sum() == before.GetNumberOfCells()
assert (cells(found, 'Origin') == 1).sum() == 0 and (cells(found, 'Origin') == 2).any()
kept = points(found)[triangles(found)[cells(found, 'Origin') == 0]]
assert (kept == points(before)[triangles(before)]).all()
assert fact(found, 'Solidify.DistanceFromInput') < 1e-9

# A right surface comes back bit for bit, with its data, quads included; its output has no defects.
sphere = read('DentedSphere600.vtp')
same, defects = solid(sphere)[:2]
assert (points(same) == points(sphere)).all() and (triangles(same) == triangles(sphere)).all()
assert (cells(same, 'Origin') == 0).all() and defects.GetNumberOfPoints() == 0
assert fact(same, 'Solidify.Method') == 'Report' and fact(same, 'Solidify.Defects') == 0
assert same.GetPointData().GetNumberOfArrays() == sphere.GetPointData().GetNumberOfArrays()
cube = vtkCubeSource()
cube.Update()
quads = solid(cube.GetOutput())[0]
assert fact(quads, 'Solidify.DuplicatePoints') == 16, 'each corner of the source occurs three times'
assert quads.GetNumberOfCells() == 12 and abs(volume(quads) - 1.0) < 1e-12
triangulate = vtkTriangleFilter()
triangulate.SetInputData(cube.GetOutput())
triangulate.Update()
clean = solid(triangulate.GetOutput())[0]
quads_only = vtkPolyData()
quads_only.SetPoints(clean.GetPoints())
polygons = vtkCellArray()
for corners in ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)):
    ids = vtkIdList()
    for corner in corners:
        ids.InsertNextId(corner)
    polygons.InsertNextCell(ids)
quads_only.SetPolys(polygons)
reported = solid(quads_only, 'Report')[0]
assert reported.GetNumberOfCells() == 6 and reported.GetCellType(0) == VTK_QUAD

# Report finds defects at their positions and changes nothing; Mend gives the same solid again.
broken = soup(shapetesting.without_cells(sphere, [17]))
unchanged, defects = solid(broken, 'Report')[:2]
assert (points(unchanged) == points(broken)).all()
assert unchanged.GetNumberOfCells() == broken.GetNumberOfCells()
kinds = vtk_to_numpy(defects.GetPointData().GetArray('Defect'))
assert fact(unchanged, 'Solidify.OpenLoops') == 1 and (kinds == 9).sum() == 1
hole = points(sphere)[triangles(sphere)[17]]
assert numpy.linalg.norm(hole - points(defects)[kinds == 9][0], axis=1).min() < 1e-6
mended = solid(broken, 'Mend')[0]
assert open_or_tangled(mended) == 0
assert abs(volume(mended) / volume(sphere) - 1.0) < 1e-4
assert fact(mended, 'Solidify.EulerNumber') == 2 and fact(mended, 'Solidify.Pieces') == 1
mended = solid(shapetesting.without_cells(sphere, [17]), 'Mend')[0]
names = {sphere.GetPointData().GetArrayName(i) for i in range(sphere.GetPointData().GetNumberOfArrays())}
assert names <= {mended.GetPointData().GetArrayName(i)
                 for i in range(mended.GetPointData().GetNumberOfArrays())}

# Smallest Piece and Tolerance are lengths.
assert fact(solid(sphere, 'Report', SmallestPiece=100.0)[0], 'Solidify.SmallPieces') == 1
assert fact(solid(sphere, 'Report', Tolerance=0.2)[0], 'Solidify.DuplicatePoints') > 0

# Parts that cross are an error for Mend, and become one solid otherwise; triangles that are not crossed stay.
twice = simple.AppendDatasets(Input=[simple.Sphere(), simple.Sphere(Center=[0.3, 0.0, 0.0])])
twice.UpdatePipeline()
crossing = shapetesting.output(twice)
shapetesting.check_refused(new(crossing, 'Mend'), 'intersects itself', 'pairs of triangles (first at (')
united = solid(crossing)[0]
assert fact(united, 'Solidify.Method') == 'Solid' and fact(united, 'Solidify.GridSpacing') == 0
assert fact(united, 'Solidify.Pieces') == 1 and fact(united, 'Solidify.EulerNumber') == 2
assert open_or_tangled(united) == 0
ball = simple.Sphere()
ball.UpdatePipeline()
one = volume(shapetesting.output(ball))
assert one < volume(united) < 2.0 * one
assert fact(united, 'Solidify.Kept') > 0 and fact(united, 'Solidify.Made') == 0
assert fact(united, 'Solidify.DistanceToInput') < 1e-6

# Wrap makes a plate of a sheet and fills a hollow sphere; its sizes are lengths.
sheet = simple.Plane(XResolution=4, YResolution=4)
sheet.UpdatePipeline()
shapetesting.check_refused(new(shapetesting.output(sheet), 'Solid', DetailSize=0.05), 'enclose nothing', 'Wrap')
plate = solid(shapetesting.output(sheet), 'Wrap', DetailSize=0.05)[0]
assert fact(plate, 'Solidify.Method') == 'Wrap' and fact(plate, 'Solidify.GridSpacing') == 0.0
assert fact(plate, 'Solidify.EulerNumber') == 2 and open_or_tangled(plate) == 0
assert abs(volume(plate) - 0.1 * 0.05) < 1e-6
thick = solid(shapetesting.output(sheet), 'Wrap', DetailSize=0.05, SheetThickness=0.02)[0]
assert abs(volume(thick) - 0.02) < 1e-6
assert (cells(plate, 'Origin') == 2).all()
wrapped = solid(sphere, 'Wrap', DetailSize=0.1, GapSize=0.4)[0]
assert fact(wrapped, 'Solidify.Method') == 'Wrap', 'a right surface is wrapped if one asks for it'
names = {sphere.GetPointData().GetArrayName(i) for i in range(sphere.GetPointData().GetNumberOfArrays())}
assert names <= {wrapped.GetPointData().GetArrayName(i)
                 for i in range(wrapped.GetPointData().GetNumberOfArrays())}

# What it cannot do, it refuses, and says why.
tetrahedron = vtkUnstructuredGrid()
tetrahedron.SetPoints(sphere.GetPoints())
tetrahedron.InsertNextCell(VTK_TETRA, 4, [0, 1, 2, 3])
shapetesting.check_refused(new(tetrahedron), 'vtkTetra', 'cell 0', 'Extract Surface')
shapetesting.check_refused(new(sphere, Tolerance=-1.0), 'Tolerance is -1')
shapetesting.check_refused(new(sphere, Tolerance=50.0), 'no triangle of the surface is left')
shapetesting.check_refused(new(sphere, 'Wrap', DetailSize=1.0, GapSize=0.5), 'GapSize is 0.5')
shapetesting.check_refused(new(sphere, 'Wrap', DetailSize=-1.0), 'DetailSize is -1')
shapetesting.check_refused(new(sphere, 'Wrap', SheetThickness=-1.0), 'SheetThickness is -1')
