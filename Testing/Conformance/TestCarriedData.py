"""Every filter that derives a mesh carries data by one rule (vtkShapeCarry). Each is run on inputs with an
array of each kind, at points and cells:
- values (float, double, colours) that are linear in the position stay linear at points on the input;
- integers, ids, words and bits are those of one point or cell of the input, all of the same one;
- arrays keep type, components, names of components and role; none is lost, except those that LOST names;
- global ids and ghost marks are not carried; normals are unit vectors;
- what is NaN at one point of the input is a number at all points that do not come from there."""
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkBitArray, vtkStringArray
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray, vtkDataSetAttributes, vtkUnstructuredGrid)

import filters
import shapetesting
from shapetesting import array, points, read

SLOPES = numpy.array([[1.5, -0.5, 0.25], [0.0, 2.0, 1.0], [-1.0, 0.5, 0.75]])
ROLES = {'Float': vtkDataSetAttributes.SCALARS, 'Double': vtkDataSetAttributes.VECTORS,
         'Texture': vtkDataSetAttributes.TCOORDS, 'Words': vtkDataSetAttributes.PEDIGREEIDS}
# What is not passed on, and why.
TRANSFERRED = 'arrays on another mesh have no role there'
SHOWN = 'the array of the result is the active one'
LOST = {
    **{(name, 'role Float'): SHOWN for name in (
        'ShapeFillHoles', 'ShapeParameterize', 'ShapePolycube', 'ShapeTetrahedralize', 'ShapeUntangle')},
    ('ShapeExponentialMap', 'role Texture'): 'the map itself is the texture coordinates',
    ('ShapeTransferFields', 'role Float'): TRANSFERRED,
    ('ShapeTransferFields', 'role Double'): TRANSFERRED,
    ('ShapeTransferFields', 'role Texture'): TRANSFERRED,
    ('ShapeTransferFields', 'role Words'): TRANSFERRED,
}


def linear(places):
    return places @ SLOPES.T + [0.5, -1.0, 2.0]


def colours(places):
    return 127.0 + 20.0 * places


def places_of(data, cells):
    if not cells:
        return points(data)
    return numpy.array([points(data)[[data.GetCell(i).GetPointId(k) for k in
                                      range(data.GetCell(i).GetNumberOfPoints())]].mean(axis=0)
                        for i in range(data.GetNumberOfCells())])


def with_data(data, first=0, ghosts=True):
    """A copy with an array of each kind at points and cells, each of which has a number from `first`."""
    data = shapetesting.copy(data)
    data.GetPointData().Initialize()
    data.GetCellData().Initialize()
    for attributes, places in ((data.GetPointData(), places_of(data, False)),
                               (data.GetCellData(), places_of(data, True))):
        count = len(places)
        numbers = first + 3 * numpy.arange(count)

        def add(values, name, make=numpy_to_vtk):
            made = make(numpy.ascontiguousarray(values), deep=True)
            made.SetName(name)
            attributes.AddArray(made)
            return made

        double = add(linear(places), 'Double')
        for k, word in enumerate(('East', 'North', 'Up')):
            double.SetComponentName(k, word)
        add(linear(places)[:, 0].astype(numpy.float32), 'Float')
        add(linear(places)[:, :2], 'Texture')
        add(numpy.rint(colours(places)).astype(numpy.uint8), 'Colours')
        add(numbers.astype(numpy.int32), 'Integers')
        add(numpy.stack([numbers, -numbers], axis=1).astype(numpy.int16), 'Pairs')
        add(numbers, 'Ids', numpy_to_vtkIdTypeArray)
        spoiled = linear(places)[:, 0]
        spoiled[0] = numpy.nan
        add(spoiled, 'Spoiled')
        add((places + [0.1, 0.2, 0.3]) / numpy.linalg.norm(places + [0.1, 0.2, 0.3], axis=1)[:, None],
            'Normals')
        if ghosts:
            add(numpy.zeros(count, dtype=numpy.uint8), vtkDataSetAttributes.GhostArrayName())
        attributes.SetGlobalIds(add(numpy.arange(count), 'GlobalIds', numpy_to_vtkIdTypeArray))
        words, bits = vtkStringArray(), vtkBitArray()
        words.SetName('Words')
        bits.SetName('Bits')
        for number in numbers:
            words.InsertNextValue('number %d' % number)
            bits.InsertNextValue(int(number) // 3 % 2)
        attributes.AddArray(words)
        attributes.AddArray(bits)
        for name, role in ROLES.items():
            attributes.SetActiveAttribute(name, role)
        attributes.SetActiveAttribute('Normals', vtkDataSetAttributes.NORMALS)
    return data


def run(name, inputs, **options):
    algorithm = filters.quick(name)
    for port, data in inputs.items():
        algorithm.SetInputDataObject(port, data)
    for option, value in options.items():
        getattr(algorithm, 'Set' + option)(*value if isinstance(value, tuple) else (value,))
    messages = shapetesting.run(algorithm)
    assert not messages, (name, messages)
    held = [algorithm.GetOutputDataObject(port) for port in range(algorithm.GetNumberOfOutputPorts())]
    return [output for output in held if not output.IsA('vtkTable')]


def words_of(attributes, name):
    words = attributes.GetAbstractArray(name)
    return [words.GetValue(i) for i in range(words.GetNumberOfValues())]


def check(name, attributes, given, of='points', prefix='', places=None, on=None, some=None):
    """attributes: of an output; given: of the input. places: where on the input each point is, if it is on
    it and `on` says so. some: tuples that have a source, all by default."""
    say = '%s, %s' % (name, of)
    count = attributes.GetNumberOfTuples()
    assert count > 0, say
    some = numpy.ones(count, dtype=bool) if some is None else some

    def values(array):
        return vtk_to_numpy(attributes.GetArray(prefix + array))

    for i in range(given.GetNumberOfArrays()):
        source = given.GetAbstractArray(i)
        carried = attributes.GetAbstractArray(prefix + source.GetName())
        if source.GetName() in ('GlobalIds', vtkDataSetAttributes.GhostArrayName()):
            assert not carried and not attributes.GetGlobalIds(), (say, source.GetName())
            continue
        if source.GetName() == 'Normals':  # vtkShapeMeasures says who may keep them
            if carried:
                lengths = numpy.linalg.norm(vtk_to_numpy(carried)[some], axis=1)
                assert abs(lengths - 1.0).max() < 1e-12, (say, 'normals are no unit vectors')
            continue
        assert carried, (say, source.GetName(), 'is lost')
        assert carried.GetDataType() == source.GetDataType(), (say, source.GetName())
        assert carried.GetNumberOfComponents() == source.GetNumberOfComponents(), (say, source.GetName())
        assert [carried.GetComponentName(k) for k in range(carried.GetNumberOfComponents())] == [
            source.GetComponentName(k) for k in range(source.GetNumberOfComponents())], (say, source.GetName())
    for array_name, role in ROLES.items():
        active = attributes.GetAbstractAttribute(role)
        kept = active and active.GetName() == prefix + array_name
        assert kept or (name, 'role ' + array_name) in LOST, (say, 'role of', array_name)

    numbers = values('Integers')[some]
    assert set(numbers.tolist()) <= set(vtk_to_numpy(given.GetArray('Integers')).tolist()), (say, 'integers')
    assert (values('Ids')[some] == numbers).all() and (values('Pairs')[some, 0] == numbers).all(), say
    assert (values('Pairs')[some, 1] == -numbers).all(), say
    words = words_of(attributes, prefix + 'Words')
    bits = attributes.GetAbstractArray(prefix + 'Bits')
    for i, number in zip(numpy.flatnonzero(some), numbers):
        assert words[i] == 'number %d' % number and bits.GetValue(int(i)) == number // 3 % 2, (say, i)
    if places is not None:
        on = numpy.ones(count, dtype=bool) if on is None else on
        assert on.sum() > 10, say
        wanted, size = linear(places[on]), abs(linear(places[on])).max()
        assert abs(values('Double')[on] - wanted).max() < 1e-12 * size, (say, 'double')
        assert abs(values('Float')[on] - wanted[:, 0]).max() < 1e-6 * size, (say, 'float')
        assert abs(values('Texture')[on] - wanted[:, :2]).max() < 1e-12 * size, (say, 'texture')
        assert abs(values('Colours')[on] - colours(places[on])).max() <= 1.0, (say, 'colours')
        spoiled = values('Spoiled')[on]
        sound = numpy.isfinite(spoiled)
        assert sound.sum() > 0.9 * len(sound), (say, 'NaN spreads')
        assert abs(spoiled[sound] - wanted[sound, 0]).max() < 1e-12 * size, (say, 'beside NaN')


def check_cells(name, attributes, given, prefix='', some=None, of='cells'):
    """That each cell has all the data of one cell of the input."""
    check(name, attributes, given, of, prefix, some=some)
    numbers = vtk_to_numpy(attributes.GetArray(prefix + 'Integers'))
    first = vtk_to_numpy(given.GetArray('Integers'))[0]
    rows = (numbers - first) // 3
    some = numpy.ones(len(rows), dtype=bool) if some is None else some
    for array_name in ('Double', 'Float', 'Texture', 'Colours', 'Spoiled'):
        same = numpy.array_equal(vtk_to_numpy(attributes.GetArray(prefix + array_name))[some],
                                 vtk_to_numpy(given.GetArray(array_name))[rows[some]],
                                 equal_nan=array_name != 'Colours')
        assert same, (name, of, array_name)


def check_both(name, output, given, **options):
    check(name, output.GetPointData(), given.GetPointData(), **options)
    check_cells(name, output.GetCellData(), given.GetCellData())


def outside_fills(output):
    """Points that a triangle of the surface has."""
    kept = shapetesting.triangles(output)[vtk_to_numpy(output.GetCellData().GetArray('Filled')) == 0]
    on = numpy.zeros(output.GetNumberOfPoints(), dtype=bool)
    on[kept] = True
    return on


sphere = with_data(read('DentedSphere600.vtp'))
open_surface = with_data(filters.good_input('ShapeFillHoles', 0))
loop = filters.good_input('ShapeCutFeature', 1)

filled, = run('ShapeFillHoles', {0: open_surface})
check_both('ShapeFillHoles', filled, open_surface, places=points(filled), on=outside_fills(filled))
assert not outside_fills(filled).all() or len(points(filled)) == len(points(open_surface))

feature, rest = run('ShapeCutFeature', {0: sphere, 1: loop})
for part, on in ((feature, None), (rest, outside_fills(rest))):
    check_both('ShapeCutFeature', part, sphere, places=points(part), on=on)
    assert (array(part, 'OriginalPointId') < 0).any(), 'the loop makes no new point'

patch, = run('ShapeExponentialMap', {0: sphere}, Seed=(0.0, 0.0, 1.0), Radius=0.8)
check_both('ShapeExponentialMap', patch, sphere, places=points(patch))

cones = vtkUnstructuredGrid()
cones.SetPoints(shapetesting.closed_curve(points(sphere)[[0, 200, 400]]).GetPoints())
# Its outputs are in pieces like its input, which keep their ghost marks.
image = run('ShapeParameterize', {0: with_data(read('DentedSphere600.vtp'), ghosts=False), 1: cones},
            Domain=3)[1]
check_both('ShapeParameterize', image, sphere, places=array(image, 'SourcePosition'))
assert image.GetNumberOfPoints() > sphere.GetNumberOfPoints(), 'no point is doubled'

tetrahedra, = run('ShapeTetrahedralize', {0: sphere}, MaximumVolume=0.01)
on = array(tetrahedra, 'OriginalPointId') >= 0
assert not on.all()
check('ShapeTetrahedralize', tetrahedra.GetPointData(), sphere.GetPointData(),
      places=points(tetrahedra), on=on)
assert not tetrahedra.GetCellData().HasArray('Integers'), 'no tetrahedron comes from a triangle'

# A pair of tetrahedra without room is split; many others are as they were.
roof = numpy.array([[0, -1, 0], [0, 1, 0], [0, 0, -0.2], [1, 0, 0], [0, 0, -1], [-1, 0, 0]], dtype=float)
at_rest = roof.copy()
at_rest[2] = [0, 0, 1]


def roofs(places):
    """Ten solids of four tetrahedra around an axis, side by side."""
    many = 0.2 * numpy.concatenate([places + [3.0 * i, 0.0, 0.0] for i in range(10)])
    grid = vtkUnstructuredGrid()
    grid.SetPoints(shapetesting.closed_curve(many).GetPoints())
    cells = vtkCellArray()
    for i in range(10):
        for k in range(4):
            cells.InsertNextCell(4, [6 * i + j for j in (0, 1, 2 + k, 2 + (k + 1) % 4)])
    grid.SetCells(10, cells)
    return grid


rest_shape = roofs(at_rest)
tangled = with_data(rest_shape)
shapetesting.set_points(tangled, points(roofs(roof)))
mended, = run('ShapeUntangle', {0: tangled, 1: rest_shape})
assert (array(mended, 'OriginalPointId') < 0).any(), 'nothing was split'
check_both('ShapeUntangle', mended, tangled, places=array(mended, 'SourcePosition'))

# A map that leaves inverted tetrahedra, and the solid without them.
surface = read('DentedSphere600.vtp')
solid = with_data(shapetesting.copy(tetrahedra))
mapped = run('ShapeHarmonicVolumeMap', {0: solid, 1: surface}, FoldFree=1)[0]
check_both('ShapeHarmonicVolumeMap', mapped, solid, places=array(mapped, 'SourcePosition'))

# Fields of a solid at places inside it.
giver = with_data(read('BallSmall.vtu'))
receiver = shapetesting.copy(read('DentedSphere600.vtp'))
places = 0.5 * points(receiver) / numpy.linalg.norm(points(receiver), axis=1).max()
receiver.GetPointData().Initialize()
shapetesting.add_array(receiver, places, 'TargetPosition')
received, = run('ShapeTransferFields', {0: receiver, 1: giver})
check('ShapeTransferFields', received.GetPointData(), giver.GetPointData(), places=places)
check_cells('ShapeTransferFields', received.GetPointData(), giver.GetCellData(), prefix='Giver')

# A feature on a target: what both have is blended at the seam, what one has is 0 on the other.
target = with_data(read('DentedSphere600.vtp'), first=10000)
own = numpy_to_vtk(numpy.full(target.GetNumberOfPoints(), 5, dtype=numpy.int32), deep=True)
own.SetName('OfTheTarget')
target.GetPointData().AddArray(own)
pasted, _ = run('ShapePasteFeature', {0: with_data(filters.good_input('ShapePasteFeature', 0)), 1: target},
                Seed=(-0.3, 0.2, 0.9))
parts = vtk_to_numpy(pasted.GetCellData().GetArray('Part'))
of_target = numpy.zeros(pasted.GetNumberOfPoints(), dtype=bool)
of_target[shapetesting.triangles(pasted)[parts == 0]] = True
of_target[shapetesting.triangles(pasted)[parts != 0]] = False
is_targets = array(pasted, 'Integers') >= 10000
assert is_targets[of_target].all() and not is_targets.all()
assert (array(pasted, 'OfTheTarget') == numpy.where(is_targets, 5, 0)).all()
check('ShapePasteFeature', pasted.GetPointData(), target.GetPointData(), 'points of the target',
      places=points(pasted), on=of_target, some=is_targets)
check_cells('ShapePasteFeature', pasted.GetCellData(), target.GetCellData(), some=parts < 2)

print('data are carried by one rule')
