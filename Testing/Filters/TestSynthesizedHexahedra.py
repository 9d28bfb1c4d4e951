"""Hexahedra of a template are carried to 30 samples of three families of shapes: bent bars, dented spheres and
bones with two regions, at random weights from -2 to 2. None is inverted, the minimum scaled Jacobian is at least
0.3, and the boundary is at most 0.5 % of the sample's size from it.

The defaults of Shape Synthesize were chosen on another family: spheres with waves, and twisted bars."""
import os
import sys
import tempfile

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
import shapemap

import calculix
import shapetesting
from shapetesting import add_array, copy, fact, points

sys.path.insert(0, shapetesting.ROOT + '/Data')
from shapes import meshes  # noqa: E402

SAMPLES = 10


def surface_of(places, triangles):
    surface, cells = vtkPolyData(), vtkCellArray()
    surface.SetPoints(vtkPoints())
    shapetesting.set_points(surface, places)
    cells.SetData(numpy_to_vtkIdTypeArray(3 * numpy.arange(len(triangles) + 1), deep=True),
                  numpy_to_vtkIdTypeArray(numpy.asarray(triangles, numpy.int64).ravel(), deep=True))
    surface.SetPolys(cells)
    return surface


def atlas_of(template, modes):
    """The template is the mean."""
    atlas = copy(template)
    add_array(atlas, points(template), 'SourcePosition')
    for k, mode in enumerate(modes):
        add_array(atlas, mode, 'Mode%d' % k)
    return atlas


def bar():
    """Bent in two planes, and thicker in the middle than at the ends."""
    across = 8
    lattice, quads = meshes.box_surface((4 * across, across, across))
    places = lattice / across - numpy.array([2, 0.5, 0.5])
    x, y, z = places.T
    modes = [0.2 * numpy.c_[-x * y, x**2 / 2, 0 * x], 0.15 * numpy.c_[-x * z, 0 * x, x**2 / 2],
             0.1 * numpy.c_[0 * x, y * (1 - x**2 / 2), z * (1 - x**2 / 2)]]
    return surface_of(places, meshes.split_quads(places, quads)), (), modes, {'CellSize': 0.125}


def dent(places, centre, width):
    """Along the normals of a sphere."""
    return numpy.exp(-((places - centre)**2).sum(axis=1) / width**2)[:, None] * places


def dented_sphere():
    places, triangles = meshes.geodesic_sphere(14)
    modes = [-0.2 * dent(places, [0.6, 0.8, 0.0], 0.5), 0.18 * dent(places, [0.0, -0.6, 0.8], 0.6),
             -0.15 * (dent(places, [-1.0, 0.0, 0.0], 0.4) + dent(places, [0.0, 0.0, -1.0], 0.4))]
    return surface_of(places, triangles), (), modes, {'CellSize': 0.12}


def bone():
    """A shaft with thick ends, around a canal: longer, thicker at one end, or bent."""
    ball, triangles = meshes.geodesic_sphere(14)

    def drawn(scale, length):
        width = scale * (0.4 + 0.5 * ball[:, 2:]**2)
        return numpy.c_[width * ball[:, :2], length * ball[:, 2]]

    places = drawn(1.0, 2.0)
    x, y, z = places.T
    modes = [0.1 * numpy.c_[0 * x, 0 * y, z], 0.1 * numpy.c_[x * z, y * z, 0 * z],
             0.12 * numpy.c_[z**2, 0 * y, -2 * x * z]]
    return surface_of(places, triangles), (surface_of(drawn(0.5, 1.4), triangles),), modes, {'CellSize': 0.1}


def ring():
    """Thicker on one side, oval, or bent out of its plane."""
    around, across = 64, 24
    u, v = (angles.ravel() for angles in numpy.meshgrid(
        numpy.arange(around) * 2 * numpy.pi / around, numpy.arange(across) * 2 * numpy.pi / across, indexing='ij'))
    outward = numpy.c_[numpy.cos(u), numpy.sin(u), 0 * u]
    normals = numpy.cos(v)[:, None] * outward + numpy.sin(v)[:, None] * [0, 0, 1]
    places = outward + 0.35 * normals
    rows = numpy.arange(around * across).reshape(around, across)
    next_row, up, next_up = numpy.roll(rows, -1, 0), numpy.roll(rows, -1, 1), numpy.roll(rows, (-1, -1), (0, 1))
    triangles = numpy.r_[numpy.stack([rows, next_row, next_up], 2).reshape(-1, 3),
                         numpy.stack([rows, next_up, up], 2).reshape(-1, 3)]
    x, y, z = places.T
    modes = [0.06 * numpy.cos(u)[:, None] * normals, 0.12 * numpy.c_[x, -y, 0 * z],
             0.12 * numpy.c_[-2 * x * z, 2 * y * z, x**2 - y**2]]
    return surface_of(places, triangles), (), modes, {'CellSize': 0.1}


def hexahedra_of(grid):
    """m x 8"""
    return vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 8)


def read_back(grid):
    """What Shape Deck Reader finds in the deck that Shape Abaqus Writer makes."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, 'sample.inp')
        writer = shapemap.vtkShapeAbaqusWriter()
        writer.SetInputData(grid)
        writer.SetFileName(path)
        assert writer.Write()
        reader = shapemap.vtkShapeDeckReader()
        reader.SetFileName(path)
        reader.Update()
        return reader.GetOutputDataObject(0)


def stretch(grid):
    """If the boundary is displaced by a linear function, CalculiX finds this function inside, too."""
    model = calculix.Model(grid, HexahedronType=0)
    wanted = 0.01 * model.points @ numpy.array([[1.0, 0.4, 0.0], [0.2, -0.5, 0.3], [0.0, 0.1, 0.7]])
    held = ['%d, %d, %d, %.12g' % (node + 1, axis + 1, axis + 1, wanted[node, axis])
            for node in model.node_set('Boundary') for axis in range(3)]
    return abs(model.solve(1.0, 0.3, held) - wanted).max() / abs(wanted).max()


random = numpy.random.RandomState(20)
for make in (bar, dented_sphere, bone, ring):
    template, inner, modes, settings = make()
    solid = shapetesting.outputs(shapetesting.new(shapemap.vtkShapeHexRemesh, template, None, list(inner), **settings))[0]
    synthesize = shapetesting.new(shapemap.vtkShapeSynthesize, atlas_of(template, modes), solid)
    least, farthest, inverted = 1.0, 0.0, 0
    for sample in range(SAMPLES + 4):
        chosen = random.uniform(-2, 2, len(modes)) if sample < SAMPLES else random.choice([-3.0, 3.0], len(modes))
        for k, weight in enumerate(chosen):
            synthesize.SetWeights(k, weight)
        moved = shapetesting.outputs(synthesize)[1]
        assert moved.GetNumberOfCells() == solid.GetNumberOfCells()
        assert fact(moved, 'Synthesize.OutsidePoints') == 0
        assert fact(moved, 'Synthesize.InvertedAfter') == 0
        inverted += fact(moved, 'Synthesize.InvertedBefore')
        minimum = fact(moved, 'Synthesize.MinimumScaledJacobian')
        assert minimum == moved.GetCellData().GetArray('ScaledJacobian').GetRange()[0]
        least = min(least, minimum)
        farthest = max(farthest, fact(moved, 'Synthesize.BoundaryDistance'))
        deck = read_back(moved)
        assert abs(points(deck) - points(moved)).max() <= 1e-14 and (hexahedra_of(deck) == hexahedra_of(moved)).all()
        assert sample > 0 or stretch(moved) < 1e-5
    regions = len(numpy.unique(vtk_to_numpy(moved.GetCellData().GetArray('RegionId')))) \
        if moved.GetCellData().HasArray('RegionId') else 1
    print('%s: %d hexahedra, %d region(s), %d inverted by the map; minimum scaled Jacobian %.3f, boundary %.2e off'
          % (make.__name__, solid.GetNumberOfCells(), regions, inverted, least, farthest))
    assert regions == (2 if make is bone else 1)
    assert least >= 0.3 and farthest <= 0.005, make.__name__
