"""Shape Mesh Motion: a volume mesh that follows its boundary.

As an example: tetrahedra around a body in a box. The body turns, and the mesh is moved with it; facts say how good the
cells are before and after."""
import math

import numpy
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdList
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkMultiBlockDataSet, vtkUnstructuredGrid
from vtkmodules.vtkFiltersCore import vtkExtractCells
import shapemap

import shapetesting
from shapetesting import array, check_refused, copy, fact, points


def cells(data, name):
    return vtk_to_numpy(data.GetCellData().GetArray(name))


def moved_by(mesh, boundary, **settings):
    algorithm = shapetesting.new(shapemap.vtkShapeMeshMotion, mesh, boundary, **settings)
    return shapetesting.outputs(algorithm)[0]


def surface_of(mesh, targets):
    """The boundary of a mesh whose points move to the targets."""
    from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
    source = copy(mesh)
    shapetesting.add_array(source, targets, 'TargetPosition')
    geometry = vtkGeometryFilter()
    geometry.SetInputData(source)
    geometry.Update()
    return geometry.GetOutput()


def part(surface, chosen):
    """The cells of a surface whose points are all chosen."""
    others = [i for i in range(surface.GetNumberOfCells()) if not all(
        chosen[surface.GetCell(i).GetPointId(k)] for k in range(surface.GetCell(i).GetNumberOfPoints()))]
    return shapetesting.without_cells(surface, others)


def rotation(angle):
    c, s = math.cos(angle), math.sin(angle)
    return numpy.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])


# The example.
body = simple.Clean(Input=simple.Sphere(Radius=0.25, ThetaResolution=24, PhiResolution=13))
long_body = simple.Transform(Input=body)
long_body.Transform.Scale = [1.0, 0.5, 0.7]
box = simple.Subdivide(Input=simple.Triangulate(Input=simple.Clean(Input=simple.Box(XLength=1.5))),
                               NumberofSubdivisions=3)
mesh_filter = simple.ShapeTetrahedralize(Input=simple.AppendGeometry(Input=[box, long_body]))
turned = simple.Calculator(Input=long_body, ResultArrayName='TargetPosition', Function=(
    '(0.96*coordsX-0.28*coordsY)*iHat+(0.28*coordsX+0.96*coordsY)*jHat+coordsZ*kHat'))
motion = simple.ShapeMeshMotion(Input=mesh_filter, Boundary=turned)
motion.UpdatePipeline()
result, mesh = shapetesting.output(motion), shapetesting.output(mesh_filter)
assert fact(result, 'MeshMotion.InvertedAfter') == 0 == cells(result, 'Inverted').sum()
assert fact(result, 'MeshMotion.MovingPoints') >= points(shapetesting.output(long_body)).shape[0]
assert fact(result, 'MeshMotion.UnmatchedPoints') == 0
assert 0.0 < cells(result, 'ScaledJacobian').min() == fact(result, 'MeshMotion.MinimumScaledJacobianAfter')
assert cells(result, 'NonOrthogonality').max() == fact(result, 'MeshMotion.MaximumNonOrthogonalityAfter') < 90.0
assert (array(result, 'SourcePosition') == points(mesh)).all()
turn = numpy.array([[0.96, -0.28, 0.0], [0.28, 0.96, 0.0], [0.0, 0.0, 1.0]])
wall = numpy.abs(points(mesh) / [0.75, 0.5, 0.5]).max(axis=1) > 1.0 - 1e-9
assert wall.sum() > 300 and (points(result)[wall] == points(mesh)[wall]).all(), 'the box moved'
near = numpy.linalg.norm(points(mesh) / [0.25, 0.125, 0.175], axis=1) < 1.0001
assert abs(points(result) - points(mesh) @ turn.T)[near].max() < 1e-6, 'the body is not where it should be'

# As a mesh that moves as a whole, all of it moves alike, with every method. Pieces move like one, and so do cells of
# other shapes.
image = vtkImageData()
image.SetDimensions(7, 6, 5)
image.SetSpacing(0.2, 0.25, 0.3)
places = numpy.array([image.GetPoint(i) for i in range(image.GetNumberOfPoints())])
grid = shapemap.vtkShapeUntangle()
grid.SetInputDataObject(0, image)
assert not shapetesting.run(grid)
hexahedra = copy(grid.GetOutputDataObject(0))
polyhedra = vtkUnstructuredGrid()
polyhedra.SetPoints(hexahedra.GetPoints())
for i in range(hexahedra.GetNumberOfCells()):
    cell = hexahedra.GetCell(i)
    stream = vtkIdList()
    stream.InsertNextId(6)
    for k in range(6):
        face = cell.GetFace(k)
        stream.InsertNextId(4)
        for m in (3, 2, 1, 0) if (i + k) % 2 else range(4):
            stream.InsertNextId(face.GetPointId(m))
    polyhedra.InsertNextCell(42, stream)
moved_rigidly = places @ rotation(1.3).T + [3.0, -1.0, 0.5]
for method in range(2):
    for kernel in range(1 + method):
        result = moved_by(image, surface_of(hexahedra, moved_rigidly), Method=method, Kernel=kernel)
        assert abs(points(result) - moved_rigidly).max() < 1e-6, method
        assert fact(result, 'MeshMotion.InvertedAfter') == 0 == fact(result, 'MeshMotion.Centres')

bent = places + numpy.outer(0.1 * numpy.sin(3.0 * places[:, 0]), [0.0, 1.0, 0.3])
bottom = part(surface_of(hexahedra, bent), places[:, 2] < 1e-9)
for method in range(2):
    whole = moved_by(image, bottom, Method=method)
    assert fact(whole, 'MeshMotion.MovingPoints') == 42 and fact(whole, 'MeshMotion.InvertedAfter') == 0
    assert abs(points(whole) - bent)[places[:, 2] < 1e-9].max() < 1e-12
    assert (points(whole)[places[:, 2] > 1.2 - 1e-9] == places[places[:, 2] > 1.2 - 1e-9]).all()
    for other in (hexahedra, polyhedra):
        assert abs(points(moved_by(other, bottom, Method=method)) - points(whole)).max() < 1e-12, method
    blocks = vtkMultiBlockDataSet()
    for number in range(2):
        extract = vtkExtractCells()
        extract.SetInputData(hexahedra)
        ids = vtkIdList()
        for i in range(number, hexahedra.GetNumberOfCells(), 2):
            ids.InsertNextId(i)
        extract.SetCellList(ids)
        extract.Update()
        blocks.SetBlock(number, extract.GetOutput())
    pieces = moved_by(blocks, bottom, Method=method)
    assert pieces.GetNumberOfCells() == hexahedra.GetNumberOfCells()
    known = {tuple(place): moved for place, moved in zip(places.round(9), points(whole))}
    assert max(abs(known[tuple(place)] - moved).max() for place, moved in zip(
        array(pieces, 'SourcePosition').round(9), points(pieces))) < 1e-9, 'pieces move otherwise'
    assert abs(numpy.sort(cells(pieces, 'NonOrthogonality')) - numpy.sort(cells(whole, 'NonOrthogonality'))).max() < 1e-6

# A motion that folds is counted, and the remedy is said.
through = places.copy()
through[:, 2] += 1.1
algorithm = shapetesting.new(shapemap.vtkShapeMeshMotion, image, part(surface_of(hexahedra, through), places[:, 2] < 1e-9))
folded = shapetesting.outputs(algorithm)[0]
count = fact(folded, 'MeshMotion.InvertedAfter')
assert count > 0 and count == cells(folded, 'Inverted').sum()
assert 'Shape Untangle' in fact(folded, 'MeshMotion.Warning')

away = surface_of(hexahedra, places)
shapetesting.set_points(away, points(away) + 7.0)
check_refused(shapetesting.new(shapemap.vtkShapeMeshMotion, image, away), 'lies on the Boundary', 'Match Tolerance')
check_refused(shapetesting.new(shapemap.vtkShapeMeshMotion, image, surface_of(hexahedra, places), MapArray='None'), 'None')
flat = vtkImageData()
flat.SetDimensions(4, 4, 1)
check_refused(shapetesting.new(shapemap.vtkShapeMeshMotion, flat, away), 'not a tetrahedron')
print('the mesh follows its boundary')
