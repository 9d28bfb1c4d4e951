"""Shape Transfer Fields: the values of one shape at the corresponding points of another.

As an example: Input receives the arrays of Source. With Direction Pull, Input has the map array that
leads into Source; with Push, Source has the one that leads into Input."""
import numpy
from paraview import simple
from vtkmodules.vtkCommonCore import vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkDataSetAttributes, vtkImageData, vtkMultiBlockDataSet
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkExtractCells, vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource, vtkTexturedSphereSource
from vtkmodules.util.numpy_support import numpy_to_vtk
import shapemap

import shapetesting
from shapetesting import add_array, array, copy, fact, points, read

LINEAR = numpy.array([[1.2, 0.3, 0.0], [-0.1, 0.9, 0.2], [0.0, 0.4, 1.1]])
SHIFT = numpy.array([3.0, -2.0, 1.0])


def affine(places):
    return places @ LINEAR.T + SHIFT


def inverse(places):
    return (places - SHIFT) @ numpy.linalg.inv(LINEAR).T


def field(places):
    return places @ [2.0, -3.0, 0.5] + 7.0


def new(receiver, giver, direction='Pull'):
    return shapetesting.new(
        shapemap.vtkShapeTransferFields, receiver, giver, Direction=['Pull', 'Push'].index(direction))


def result(*arguments):
    return shapetesting.outputs(new(*arguments))[0]


def error_of(*arguments):
    return shapetesting.refusal(new(*arguments))


def lattice(low, high, count):
    image = vtkImageData()
    image.SetDimensions(count, count, count)
    image.SetOrigin(low, low, low)
    image.SetSpacing(*[(high - low) / (count - 1)] * 3)
    return image


def places_of(data):
    return numpy.array([data.GetPoint(i) for i in range(data.GetNumberOfPoints())])


def with_map(data, targets):
    mapped = copy(data)
    add_array(mapped, targets, 'TargetPosition')
    return mapped


def add_cells(data, values, name):
    values = numpy_to_vtk(numpy.ascontiguousarray(values), deep=True)
    values.SetName(name)
    data.GetCellData().AddArray(values)


# The example: a bent bar of hexahedra and the straight box that its map leads to. The distance to
# the box's boundary is drawn in the bar, and the bar's own in the box.
bar = simple.XMLUnstructuredGridReader(FileName=[shapetesting.data_file('BentBarSmall.vtu')])
box = simple.Box(XLength=4.0, YLength=1.0, ZLength=1.0)
box_surface = simple.Clean(Input=box)
straight = simple.Calculator(Input=bar, CoordinateResults=1, Function='TargetPosition')
in_box = simple.ShapeBoundaryDistance(Input=straight, Surface=box_surface)
bent = simple.ShapeTransferFields(Input=bar, Source=in_box, Direction='Pull')
bent.UpdatePipeline()
drawn = shapetesting.output(bent)
targets = array(read('BentBarSmall.vtu'), 'TargetPosition')
depth = (abs(targets) - [2.0, 0.5, 0.5]).max(axis=1)
assert abs(array(drawn, 'BoundaryDistance') - depth).max() < 1e-6
assert fact(drawn, 'TransferFields.OutsidePoints') == 0
in_bar = simple.ShapeBoundaryDistance(
    Input=bar, Surface=simple.ExtractSurface(Input=bar), Signed=1)
back = simple.ShapeTransferFields(Input=straight, Source=in_bar, Direction='Push')
back.UpdatePipeline()
assert abs(array(shapetesting.output(back), 'BoundaryDistance') - array(
    shapetesting.output(in_bar), 'BoundaryDistance')).max() < 1e-6

# A giver with all kinds of arrays.
ball = read('BallSmall.vtu')
ball_points = points(ball)
giver = copy(ball)
add_array(giver, field(ball_points), 'Temperature')
add_array(giver, ball_points.astype(numpy.float32), 'Single')
add_array(giver, numpy.arange(997), 'Number')
add_array(giver, ball_points, 'Normals')
words = vtkStringArray()
words.SetName('Word')
for i in range(997):
    words.InsertNextValue('point %d' % i)
giver.GetPointData().AddArray(words)
add_cells(giver, numpy.arange(864), 'Cell')

# Pulled through a known affine map a linear field is exact, in an image, which stays one.
receiver = lattice(-0.4, 0.4, 9)
inside = places_of(receiver)  # in the ball's space
pulled = result(with_map(receiver, inside), giver)
assert pulled.GetClassName() == 'vtkImageData'
assert abs(array(pulled, 'Temperature') - field(inside)).max() < 1e-12
assert array(pulled, 'Single').dtype == numpy.float32
assert abs(array(pulled, 'Single') - inside).max() < 1e-6
assert fact(pulled, 'TransferFields.OutsidePoints') == 0 == array(pulled, 'OutsideDomain').sum()
assert not pulled.GetPointData().HasArray('Normals'), 'normals belong to the shape'
# Whole numbers and words stay what they are: those of a corner of the cell around the place.
numbers, cells = array(pulled, 'Number'), array(pulled, 'Cell')
assert numbers.dtype.kind == 'i'
labels = pulled.GetPointData().GetAbstractArray('Word')
for i in range(0, 729, 7):
    corners = [giver.GetCell(int(cells[i])).GetPointId(k) for k in range(8)]
    assert numbers[i] in corners and labels.GetValue(i) == 'point %d' % numbers[i]
    low, high = ball_points[corners].min(axis=0), ball_points[corners].max(axis=0)
    assert (low - 1e-9 <= inside[i]).all() and (inside[i] <= high + 1e-9).all()

# Pushed through it, too; the map array becomes the inverse, which pulls the same values.
mapped_giver = with_map(giver, affine(ball_points))
target = copy(ball)
shapetesting.set_points(target, affine(0.9 * ball_points))
pushed = result(target, mapped_giver, 'Push')
assert abs(array(pushed, 'Temperature') - field(0.9 * ball_points)).max() < 1e-12
assert abs(array(pushed, 'TargetPosition') - 0.9 * ball_points).max() < 1e-12
assert fact(pushed, 'TransferFields.OutsidePoints') == 0
again = result(with_map(target, array(pushed, 'TargetPosition')), giver)
assert abs(array(again, 'Temperature') - array(pushed, 'Temperature')).max() < 1e-12
# There and back: what was pushed to the target is pulled back to the ball.
home = copy(ball)
shapetesting.set_points(home, 0.8 * ball_points)
home = result(with_map(home, affine(0.8 * ball_points)), pushed)
assert abs(array(home, 'Temperature') - field(0.8 * ball_points)).max() < 1e-12

# Maps compose: target(receiver) = giver(receiver's target); the first map is kept.
composed = result(with_map(receiver, 0.5 * inside), mapped_giver)
assert abs(array(composed, 'TargetPosition') - affine(0.5 * inside)).max() < 1e-12
assert abs(array(composed, 'ReceiverTargetPosition') - 0.5 * inside).max() == 0
# There and back is the identity: f, then its inverse.
loop = result(with_map(ball, affine(0.9 * ball_points)), pushed)
assert abs(array(loop, 'TargetPosition') - 0.9 * ball_points).max() < 1e-12

# Where names meet nothing is lost: the giver's gets Giver in front, in every block.
named = with_map(receiver, inside)
add_array(named, numpy.arange(729.0), 'Temperature')
add_array(named, numpy.full(729, 5.0), 'OutsideDomain')
blocks = vtkMultiBlockDataSet()
blocks.SetBlock(0, named)
blocks.SetBlock(2, with_map(ball, 0.9 * ball_points))
tree = result(blocks, giver)
assert tree.GetNumberOfBlocks() == 3 and tree.GetBlock(1) is None
first = tree.GetBlock(0)
assert (array(first, 'Temperature') == numpy.arange(729)).all()
assert (array(first, 'GiverTemperature') == array(pulled, 'Temperature')).all()
assert (array(first, 'ReceiverOutsideDomain') == 5.0).all()
assert abs(array(tree.GetBlock(2), 'GiverTemperature') - field(0.9 * ball_points)).max() < 1e-12
clash = copy(giver)
add_cells(clash, numpy.arange(864), 'Temperature')
both = result(with_map(receiver, inside), clash)
assert (array(both, 'GiverTemperature') == array(both, 'Cell')).all()

# Points whose place lies beyond the giver take the closest value, are marked and counted; those that
# another process counts are not.
far = lattice(-2.0, 2.0, 9)
beyond = places_of(far)
wide = result(with_map(far, beyond), giver)
outside = array(wide, 'OutsideDomain') == 1
radius = numpy.linalg.norm(beyond, axis=1)
assert outside[radius > 1.03].all() and not outside[radius < 0.97].any()
assert fact(wide, 'TransferFields.OutsidePoints') == outside.sum()
# The value is that of a point of the ball as near as any: one on the ray, up to the facets.
on_ray = beyond[outside] / radius[outside][:, None]
spread = abs(array(wide, 'Single')[outside] - on_ray).max()
assert spread < 0.1, spread
ghostly = with_map(far, beyond)
ghosts = numpy.zeros(729, dtype=numpy.uint8)
ghosts[:100] = vtkDataSetAttributes.DUPLICATEPOINT
add_array(ghostly, ghosts, 'vtkGhostType')
assert fact(result(ghostly, giver), 'TransferFields.OutsidePoints') == outside[100:].sum()
tolerant = new(with_map(far, beyond), giver)
tolerant.SetTolerance(10.0)
assert not shapetesting.run(tolerant)
assert fact(tolerant.GetOutputDataObject(0), 'TransferFields.OutsidePoints') == 0

# A giver in blocks, as an image, or as tetrahedra of its hexahedra gives what it gives whole; cells
# that are hidden or belong to another process do not count.
halves = vtkMultiBlockDataSet()
for side in range(2):
    extract = vtkExtractCells()
    extract.SetInputData(giver)
    extract.AddCellRange(432 * side, 432 * side + 431)
    extract.Update()
    halves.SetBlock(side, extract.GetOutput())
parts = result(with_map(receiver, inside), halves)
assert abs(array(parts, 'Temperature') - field(inside)).max() < 1e-12
ghost_cells = copy(giver)
marks = numpy.zeros(864, dtype=numpy.uint8)
marks[cells[0]] = vtkDataSetAttributes.HIDDENCELL
marks[cells[1]] = vtkDataSetAttributes.DUPLICATECELL
add_cells(ghost_cells, marks, 'vtkGhostType')
rest = result(with_map(receiver, inside), ghost_cells)
assert not numpy.isin(array(rest, 'Cell'), [cells[0], cells[1]]).any()
assert not rest.GetPointData().HasArray('vtkGhostType')
grid = lattice(-1.0, 1.0, 6)
add_array(grid, field(places_of(grid)), 'Temperature')
assert abs(array(result(with_map(receiver, inside), grid), 'Temperature') -
           field(inside)).max() < 1e-12

# A surface gives at the closest place; the map of Shape Parameterize and its inverse are one map.
surface = read('DentedSphere600.vtp')
image = copy(surface)
shapetesting.set_points(image, array(surface, 'TargetPosition'))
add_array(image, points(surface), 'SourcePosition')
round_trip = result(surface, image)
assert abs(array(round_trip, 'SourcePosition') - points(surface)).max() < 1e-12
assert fact(round_trip, 'TransferFields.OutsidePoints') == 0

# Two sheets, nearer to each other than single precision tells TargetPosition apart: the closest place
# is on either of them; the precise map, TargetCell and TargetBarycentric, knows which one is meant.
def sheets(gap, quads=False):
    """Squares of a lattice, the lower ones first, around (3000, 3000, 3000); points know their sheet."""
    side = numpy.arange(9.0)
    flat = numpy.stack(numpy.meshgrid(side, side, indexing='ij'), axis=-1).reshape(-1, 2)
    places = numpy.vstack([numpy.column_stack([flat, numpy.full(81, height)])
                           for height in (-gap / 2, gap / 2)]) + 3000.0
    corner = (9 * numpy.arange(8)[:, None] + numpy.arange(8)).ravel()
    squares = corner[:, None] + [0, 9, 10, 1]
    cells = squares if quads else numpy.vstack([squares[:, :3], squares[:, [0, 2, 3]]])
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    data.GetPoints().SetDataTypeToDouble()
    shapetesting.set_points(data, places)
    data.SetPolys(vtkCellArray())
    for square in numpy.vstack([cells, cells[:, ::-1] + 81]):
        data.GetPolys().InsertNextCell(len(square), square)
    add_array(data, numpy.repeat([0, 1], 81), 'Sheet')
    add_array(data, numpy.repeat([0.0, 1.0], 81), 'SheetReal')
    add_cells(data, numpy.repeat([0, 1], len(cells)), 'SheetOfCell')
    add_array(data, places - 3000.0, 'Here')
    return data


def precise(data, cells, weights, positions):
    mapped = copy(data)
    add_array(mapped, cells, 'TargetCell')
    add_array(mapped, weights, 'TargetBarycentric')
    add_array(mapped, positions, 'TargetPosition')
    return mapped


thin = sheets(1e-4)
corners = shapetesting.triangles(thin)
random = numpy.random.default_rng(3)
chosen = random.permutation(len(corners))[:200]
weights = random.dirichlet([1.0, 1.0, 1.0], 200)
where = numpy.einsum('ik,ikc->ic', weights, array(thin, 'Here')[corners[chosen]])
dots = vtkPolyData()
dots.SetPoints(vtkPoints())
shapetesting.set_points(dots, random.normal(size=(200, 3)))
single = (where + 3000.0).astype(numpy.float32)
mapped_dots = precise(dots, chosen, weights, single)
exact = result(mapped_dots, thin)
upper = chosen >= 128
for name in ('Sheet', 'SheetReal', 'SheetOfCell'):
    assert (abs(array(exact, name) - upper) < 1e-12).all(), name
assert abs(array(exact, 'Here') - where).max() < 1e-12
assert fact(exact, 'TransferFields.PrecisePoints') == 200
assert fact(exact, 'TransferFields.OutsidePoints') == 0
# A whole number is that of the corner that weighs most.
add_array(thin, numpy.arange(162), 'Id')
assert (array(result(mapped_dots, thin), 'Id') == corners[chosen, weights.argmax(axis=1)]).all()
closest = result(with_map(dots, single), thin)
assert 0.2 < (array(closest, 'SheetOfCell') != upper).mean() < 0.8, 'the sheets are too far apart'
assert fact(closest, 'TransferFields.PrecisePoints') == 0

# Squares count as the triangles that they are cut into, behind vertices and lines, also in blocks.
square = sheets(1e-4, quads=True)
lines = vtkCellArray()
lines.InsertNextCell(2, [0, 1])
square.SetLines(lines)
add_cells(square, numpy.append(-1, numpy.repeat([0, 1], 64)), 'SheetOfCell')
add_cells(square, numpy.arange(129), 'Cell')
split = vtkTriangleFilter()
split.SetInputData(square)
split.PassLinesOff()
split.Update()
pieces = shapetesting.triangles(split.GetOutput())
where = numpy.einsum('ik,ikc->ic', weights, array(square, 'Here')[pieces[chosen]])
squared = precise(dots, chosen + 1, weights, where + 3000.0)
blocks = vtkMultiBlockDataSet()
blocks.SetBlock(1, square)
for source in (square, blocks):
    found = result(squared, source)
    assert abs(array(found, 'Here') - where).max() < 1e-12
    assert (array(found, 'Cell') == 1 + chosen // 2).all()
    assert (array(found, 'SheetOfCell') == upper).all()

# A composed map is no precise one: what belonged to the first map goes aside with it.
onward = precise(thin, numpy.zeros(162, int), numpy.full((162, 3), 1 / 3), -array(thin, 'Here'))
composed = result(mapped_dots, onward)
assert abs(array(composed, 'TargetPosition') + array(exact, 'Here')).max() < 1e-12
assert (array(composed, 'ReceiverTargetCell') == chosen).all()
for name in ('TargetCell', 'TargetBarycentric', 'GiverTargetCell'):
    assert not composed.GetPointData().HasArray(name), name
# Under another name, or towards the Input, it is not asked for.
other = copy(mapped_dots)
add_array(other, where + 3000.0, 'Other')
by_name = new(other, thin)
by_name.SetMapArray('Other')
assert not shapetesting.run(by_name)
assert fact(by_name.GetOutputDataObject(0), 'TransferFields.PrecisePoints') == 0
assert fact(result(thin, precise(thin, chosen[:162], weights[:162], points(thin)), 'Push'),
            'TransferFields.PrecisePoints') == 0

# One made for another surface is left aside, which the output says: the closest places are taken.
without = copy(mapped_dots)
without.GetPointData().RemoveArray('TargetCell')
for source in (square, ball):
    others = result(mapped_dots, source), result(without, source)
    assert fact(others[0], 'TransferFields.PrecisePoints') == 0
    for index in range(source.GetPointData().GetNumberOfArrays()):
        name = source.GetPointData().GetArrayName(index)
        assert (array(others[0], name) == array(others[1], name)).all(), name
misplaced = result(precise(dots, chosen[::-1], weights, single), thin)
assert fact(misplaced, 'TransferFields.PrecisePoints') == 0
assert (array(misplaced, 'SheetOfCell') == array(closest, 'SheetOfCell')).all()
# One that is no map of any surface is refused.
message = error_of(precise(dots, chosen, 1.1 * weights, single), thin)
assert 'does not sum to 1 at 200 points (first at point 0)' in message, message
message = error_of(precise(dots, weights, weights, single), thin)
assert "'TargetCell' of the Input has 3 components, not 1" in message, message

# What cannot be done is named.
message = error_of(receiver, giver)
assert "Shape Transfer Fields: the Input has no point array 'TargetPosition'" in message, message
message = error_of(target, giver, 'Push')
assert "the Source has no point array 'TargetPosition'; make it with Shape Correspondence" in message, message
cloud = vtkPolyData()
cloud.SetPoints(vtkPoints())
cloud.GetPoints().InsertNextPoint(0, 0, 0)
message = error_of(with_map(receiver, inside), cloud)
assert 'in the Source there is no polygon and no solid cell' in message, message
not_finite = affine(ball_points)
not_finite[5] = numpy.nan
message = error_of(target, with_map(giver, not_finite), 'Push')
assert 'the map array of the Source' in message and 'first at point 5' in message, message
print('fields are carried both ways, exactly where they are linear')


# A texture with a seam: a globe whose texture begins and ends at a meridian. The receiver has none there.
def widest(data):
    """The largest difference of the first texture coordinate in a triangle, away from the poles."""
    places, texture = points(data), array(data, 'Texture Coordinates')
    corners = shapetesting.triangles(data)
    corners = corners[numpy.abs(places[corners][:, :, 2]).max(axis=1) < 0.4]
    return numpy.ptp(texture[corners][:, :, 0], axis=1).max()


globe = vtkTexturedSphereSource()
globe.SetThetaResolution(48)
globe.SetPhiResolution(24)
globe.Update()
globe.GetOutput().GetPointData().GetTCoords().SetName('Texture Coordinates')
ball = vtkSphereSource()
ball.SetThetaResolution(31)
ball.SetPhiResolution(17)
ball.Update()
receiver = shapetesting.copy(ball.GetOutput())
turned = points(receiver) @ numpy.array([[numpy.cos(0.1), -numpy.sin(0.1), 0], [numpy.sin(0.1), numpy.cos(0.1), 0],
                                         [0, 0, 1]])
shapetesting.add_array(receiver, turned, 'TargetPosition')
smeared, split = (shapetesting.outputs(shapetesting.new(
    shapemap.vtkShapeTransferFields, receiver, globe.GetOutput(), SplitSeams=each))[0] for each in (False, True))
assert widest(smeared) > 0.9 and widest(split) < 1.1 / 31 + 2.0 / 48, (widest(smeared), widest(split))
count = receiver.GetNumberOfPoints()
assert smeared.GetNumberOfPoints() == count < split.GetNumberOfPoints()
assert split.GetNumberOfCells() == receiver.GetNumberOfCells()
assert (points(split)[:count] == points(receiver)).all() and fact(smeared, 'TransferFields.SeamPoints') == 0
copies = split.GetNumberOfPoints() - count
# Along the meridian; and at the poles, where each triangle has texture coordinates of its own.
assert 15 < fact(split, 'TransferFields.SeamPoints') <= copies < 2 * 17 + 2 * 31
# A copy lies where its point lies, and has its arrays.
gaps = numpy.linalg.norm(points(split)[count:, None] - points(receiver)[None], axis=2)
assert gaps.min(axis=1).max() == 0.0
assert (array(split, 'TargetPosition')[count:] == turned[gaps.argmin(axis=1)]).all()
