"""Shape Fill Holes: the holes of a surface filled, or what curves bound.

As an example: a sphere with a cap cut off, whole again; and a wire cube."""
import numpy
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_LINE, vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkFeatureEdges
import shapemap

import shapetesting
from shapetesting import array, copy, fact, points, read


def new(surface, **properties):
    return shapetesting.new(shapemap.vtkShapeFillHoles, surface, **properties)


def filled(surface, **properties):
    return shapetesting.outputs(new(surface, **properties))[0]


def facts(data, name):
    values = shapetesting.facts(data).GetAbstractArray('FillHoles.' + name)
    return [values.GetValue(i) for i in range(values.GetNumberOfValues())] if values else []


def cells(data, name):
    return vtk_to_numpy(data.GetCellData().GetArray(name))


def open_edges(data):
    """Edges with one triangle, and with three or more."""
    edges = vtkFeatureEdges()
    edges.SetInputData(data)
    edges.FeatureEdgesOff()
    edges.Update()
    return edges.GetOutput().GetNumberOfCells()


# The example: a sphere without its polar cap, filled in the sphere's own shape.
cup = simple.Sphere(Radius=1.0, ThetaResolution=60, PhiResolution=40, StartPhi=70.0)
whole = simple.ShapeFillHoles(Input=cup)
whole.UpdatePipeline()
found = shapetesting.output(whole)
assert open_edges(found) == 0
assert facts(found, 'Loops') == [1.0] and facts(found, 'Method') == ['Fair']
assert facts(found, 'SelfIntersections') == [0.0]
before = shapetesting.output(cup)
new_points = points(found)[before.GetNumberOfPoints():]
errors = numpy.linalg.norm(new_points, axis=1) - 1.0
assert numpy.sqrt((errors ** 2).mean()) < 0.0003, numpy.sqrt((errors ** 2).mean())
assert new_points[:, 2].max() > 0.99 and new_points[:, 2].min() > 0.34
assert facts(found, 'NormalDeviationAfter')[0] < 1.0 < 60.0 < facts(
    found, 'NormalDeviationBefore')[0]

# A disk deformed after parameters, live: the same filter again, with another rigidity.
whole.FillMethod = 'Deformation'
heights = []
for rigidity in (0.5, 1.0, 2.0):
    whole.Rigidity = rigidity
    whole.UpdatePipeline()
    found = shapetesting.output(whole)
    assert open_edges(found) == 0 and facts(found, 'Method') == ['Deformation']
    heights.append(points(found)[before.GetNumberOfPoints():, 2].max())
assert heights == sorted(heights) and heights[2] > heights[0] + 0.1, heights
whole.FillMethod = 'Membrane'
whole.UpdatePipeline()
flat = points(shapetesting.output(whole))[before.GetNumberOfPoints():]
assert abs(flat[:, 2] - numpy.cos(numpy.radians(70.0))).max() < 1e-6

# A wire cube: its edges are lines, and the normals at its corners, outwards, tell the six faces.
corners = numpy.array([[x, y, z] for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)], dtype=float)
wires = vtkPolyData()
wires.SetPoints(vtkPoints())
places, lines, number = [], [], {}
for a in range(8):
    for b in range(a + 1, 8):
        if abs(corners[a] - corners[b]).sum() == 2.0:
            along = []
            for t in numpy.linspace(0.0, 1.0, 9):
                place = tuple((1 - t) * corners[a] + t * corners[b])
                if place not in number:
                    number[place] = len(places)
                    places.append(place)
                along.append(number[place])
            lines += list(zip(along, along[1:]))
shapetesting.set_points(wires, numpy.array(places))
wires.SetLines(vtkCellArray())
for line in lines:
    wires.InsertNextCell(VTK_LINE, 2, line)
normals = numpy.array(places) / numpy.linalg.norm(places, axis=1)[:, None]
shapetesting.add_array(wires, normals, 'Normals')
cube = filled(wires, FillMethod=3)
assert open_edges(cube) == 0 and facts(cube, 'Loops') == [6.0]
assert cube.GetNumberOfLines() == len(lines) and cube.GetNumberOfPolys() > 6 * 64
assert abs(abs(points(cube)).max(axis=1) - 1.0).max() < 1e-9
# By Automatic it bulges, the patches' normals at the wires those given.
round_cube = filled(wires)
assert open_edges(round_cube) == 0 and sum(facts(round_cube, 'SelfIntersections')) == 0
assert numpy.linalg.norm(points(round_cube), axis=1).min() > 1.0

# Without normals a circle's patch lies in its plane, to the left of its points.
angles = 2.0 * numpy.pi * numpy.arange(40) / 40
circle = shapetesting.closed_curve(
    numpy.transpose([numpy.cos(angles), numpy.sin(angles), numpy.full(40, 2.0)]))
disk = filled(circle)
assert abs(points(disk)[:, 2] - 2.0).max() < 1e-12
triangles = points(disk)[shapetesting.triangles(disk)]
areas = numpy.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
assert areas[:, 2].min() > 0.0
assert abs(0.5 * areas[:, 2].sum() - 20.0 * numpy.sin(2.0 * numpy.pi / 40)) < 1e-9

# Points, cells and data of the input stay; in fills they go on from the loop.
surface = read('DentedSphere600.vtp')
ids = numpy.arange(surface.GetNumberOfCells())
centres = points(surface)[shapetesting.triangles(surface)].mean(axis=1)
holed = shapetesting.without_cells(
    surface, ids[(centres[:, 0] > 0.75) | (centres[:, 1] > 0.85)].tolist())
shapetesting.add_array(holed, 3.0 * points(holed) @ [1.0, 2.0, -1.0], 'Height')
shapetesting.add_array(holed, numpy.arange(holed.GetNumberOfPoints(), dtype=numpy.int64), 'Number')
shades = numpy.round(120.0 + 100.0 * points(holed))
shapetesting.add_array(holed, shades, 'Light')
shapetesting.add_array(holed, shades.astype(numpy.uint8), 'Colour')
left = numpy_to_vtk(numpy.arange(holed.GetNumberOfCells()), deep=True)
left.SetName('CellNumber')
holed.GetCellData().AddArray(left)
holed.GetCellData().RemoveArray('Filled')
closed = filled(holed)
count, polygons = holed.GetNumberOfPoints(), holed.GetNumberOfCells()
assert facts(closed, 'Loops') == [2.0] and open_edges(closed) == 0
assert (points(closed)[:count] == points(holed)).all()
assert (shapetesting.triangles(closed)[:polygons] == shapetesting.triangles(holed)).all()
marks = cells(closed, 'Filled')
assert (marks[:polygons] == 0).all() and (marks[polygons:] == 1).all() and marks.sum() > 20
assert (cells(closed, 'CellNumber')[:polygons] == numpy.arange(polygons)).all()
for name in ('Height', 'Number'):
    assert (array(closed, name)[:count] == array(holed, name)).all(), name
# A linear function's continuation is near to it, and within what it is on the loop.
heights = array(closed, 'Height')
assert abs(heights - 3.0 * points(closed) @ [1.0, 2.0, -1.0])[count:].max() < 1.5
assert heights[count:].max() < heights[:count].max()
assert numpy.isin(array(closed, 'Number')[count:], array(holed, 'Number')).all()
# Colours, which are bytes, go on like other values.
assert (array(closed, 'Colour')[:count] == array(holed, 'Colour')).all()
light = array(closed, 'Light')[count:]
assert numpy.ptp(light, axis=0).min() > 10.0
assert (array(closed, 'Colour')[count:] == numpy.round(light)).all()

# Which loops: the longest, those chosen, those not too long.
lengths = facts(closed, 'LoopPoints')
longest = filled(holed, Loops=1)
assert facts(longest, 'Loops') == [2.0] and facts(longest, 'LoopPoints') == lengths[:1]
algorithm = new(holed, Loops=2)
algorithm.SetLoopIndices(0, 1)
assert not shapetesting.run(algorithm)
chosen = algorithm.GetOutputDataObject(0)
assert facts(chosen, 'Loop') == [1.0] and facts(chosen, 'LoopPoints') == lengths[1:]
assert open_edges(chosen) == lengths[0]
assert facts(filled(holed, MaximumLength=1e-3), 'Loop') == []

# A closed surface is handed on.
same = filled(surface)
assert facts(same, 'Loops') == [0.0] and (cells(same, 'Filled') == 0).all()
assert (points(same) == points(surface)).all()

# Fewer points where they would be too many.
few = filled(holed, MaximumPoints=5)
assert sum(facts(few, 'Points')) < sum(facts(closed, 'Points')) and open_edges(few) == 0

# What cannot be done is refused with the fact.
algorithm = new(holed, Loops=2)
algorithm.SetLoopIndices(0, 2)
tripod = vtkPolyData()
tripod.SetPoints(vtkPoints())
shapetesting.set_points(tripod, numpy.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], dtype=float))
tripod.SetLines(vtkCellArray())
for line in ((0, 1), (0, 2), (0, 3), (1, 2), (2, 3), (3, 1)):
    tripod.InsertNextCell(VTK_LINE, 2, line)
lonely = copy(tripod)
lonely.SetLines(vtkCellArray())
shapetesting.set_points(lonely, numpy.array([[0, 0, 0], [1, 0, 0], [2, 0, 0]], dtype=float))
for algorithm, words in (
        (algorithm, 'there is no loop 2; the surface has 2'),
        (new(holed, EdgeGrowth=-1.0), 'EdgeGrowth is -1'),
        (new(holed, FillMethod=1, Rigidity=0.0), 'Rigidity is 0'),
        (new(tripod), 'three or more curves meet at 4 points'),
        (new(lonely), 'the 3 distinct points span no surface')):
    message = ' '.join(shapetesting.run(algorithm))
    assert 'Shape Fill Holes: ' in message and words in message, message
    assert algorithm.GetOutputDataObject(0).GetNumberOfPoints() == 0
print('a sphere is whole again, and wires have faces')

# Two spheres that share one point, and a hole in the first: each gets a copy of the point, with its data, and is a
# solid then.
sphere = read('DentedSphere600.vtp')
n = sphere.GetNumberOfPoints()
faces = shapetesting.triangles(sphere)
first = int(points(sphere)[:, 2].argmax())
lower = points(sphere) * [1.0, 1.0, -1.0]
lower += points(sphere)[first] - lower[first]
lower[:, 2] += 2.0 * (points(sphere)[first, 2] - lower[first, 2])
hole = int(numpy.argmin(points(sphere)[faces].mean(axis=1)[:, 2]))
other = numpy.where(faces == first, first, faces + n)[:, ::-1]
touching = vtkPolyData()
touching.SetPoints(vtkPoints())
shapetesting.set_points(touching, numpy.vstack([points(sphere), lower]))
touching.SetPolys(vtkCellArray())
for face in numpy.vstack([numpy.delete(faces, hole, axis=0), other]).tolist():
    touching.InsertNextCell(5, 3, face)
shapetesting.add_array(touching, numpy.arange(2.0 * n), 'Number')
split = filled(touching)
assert facts(split, 'CopiedPoints') == [1.0]
assert split.GetNumberOfPoints() == 2 * n + 1 and split.GetPoint(2 * n) == split.GetPoint(first)
assert array(split, 'Number')[2 * n] == first
assert shapetesting.euler(split) == 4 and open_edges(split) == 0
