"""Scenes that the reproduced figures and the benchmarks share: models and landmarks, what filters make
of them, and what is measured of that."""
import csv
import os
import sys
import time

import numpy

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
BUILD = os.environ.setdefault(
    'SHAPEMAP_BUILD', os.environ.get('SHAPEMAP_PREFIX', os.path.join(ROOT, 'build')))
sys.path[:0] = [os.path.join(ROOT, 'Testing'), os.path.join(ROOT, 'Utilities')]

# These need the paths above.
import off  # noqa: E402
import shapemap  # noqa: E402
import shapetesting  # noqa: E402
from shapetesting import add_array, array, copy, fact, points, read  # noqa: E402, F401
from vtkmodules.util.numpy_support import vtk_to_numpy  # noqa: E402, F401
from vtkmodules.vtkCommonDataModel import vtkPlane  # noqa: E402
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkTriangleFilter  # noqa: E402
from vtkmodules.vtkFiltersExtraction import vtkExtractGeometry  # noqa: E402
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter  # noqa: E402
from vtkmodules.vtkFiltersVerdict import vtkMeshQuality  # noqa: E402
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter  # noqa: E402

START = time.time()

ACCELERATED, MULTI_LEVEL, SINGLE_SHOT = 0, 1, 2  # of Shape Harmonic Volume Map's Method
# Of the scanned models' sphere maps: limbs must stay large enough to compute on, as in demo.py.
AREA_WEIGHT = 3.0


def say(text):
    print('%6.1f s  %s' % (time.time() - START, text), flush=True)


def model_file(name):
    """A model of libcgal-demo, which set-up unpacks into the build."""
    folder = os.environ.get('SHAPEMAP_MODELS', os.path.join(BUILD, 'models'))
    return os.path.join(folder, name)


def model(name):
    return off.read(model_file(name + '.off'))


def phantom(size='Small'):
    """Head, skull and brain with their maps, of some thousand points each ('') or fewer."""
    return [read('Phantom%s%s.vtp' % (name, size)) for name in ('Head', 'Skull', 'Brain')]


# Filters.

def checked(algorithm):
    """Updates an algorithm; raises with its words where it fails."""
    messages = shapetesting.run(algorithm)
    output = algorithm.GetOutputDataObject(0)
    count = output.GetNumberOfRows() if output.IsA('vtkTable') else output.GetNumberOfPoints()
    if messages or count == 0:
        raise RuntimeError(' '.join(messages) or 'an empty output')
    return algorithm


def filter_of(name, *inputs, **options):
    """The updated filter vtkShapeX of X = `name`, with one data set on each port, or None."""
    algorithm = getattr(shapemap, 'vtkShape' + name)()
    for port, data in enumerate(inputs):
        if data is not None:
            algorithm.SetInputDataObject(port, data)
    for option, value in options.items():
        getattr(algorithm, 'Set' + option)(value)
    return checked(algorithm)


def output_of(name, *inputs, port=0, **options):
    return filter_of(name, *inputs, **options).GetOutputDataObject(port)


def volume_map(domain, boundary, features=(), targets=(), **options):
    """The updated Shape Harmonic Volume Map, by the paper's method unless said otherwise."""
    algorithm = shapemap.vtkShapeHarmonicVolumeMap()
    algorithm.SetMethod(MULTI_LEVEL)
    algorithm.SetInputDataObject(0, domain)
    algorithm.SetInputDataObject(1, boundary)
    for port, data in ((2, features), (3, targets)):
        for surface in data:
            algorithm.AddInputDataObject(port, surface)
    for option, value in options.items():
        getattr(algorithm, 'Set' + option)(value)
    return checked(algorithm)


def sphere_map(surface):
    """The updated Shape Parameterize: the surface with its map onto the sphere, and its image."""
    return filter_of('Parameterize', surface, AreaWeight=AREA_WEIGHT)


def moved_by(charges, data):
    """Where a map takes the points of `data`."""
    moved = output_of('ApplyVolumeMap', data, charges)
    outside = int((array(moved, 'OutsideDomain') == 1).sum())
    if outside > 0.001 * data.GetNumberOfPoints():
        raise RuntimeError('%d points lie outside the domain of the map' % outside)
    return points(moved)


def jumps_across(surface, charges, count, step, random):
    """How far a map carries the two sides of a surface apart, at random positions on it; the sides are
    `step` away from it."""
    places, normals = shapetesting.places_on(surface, count, random)
    sides = [points(output_of('ApplyVolumeMap', point_set(places + side * normals), charges))
             for side in (step, -step)]
    return numpy.linalg.norm(sides[0] - sides[1], axis=1)


def boundary_distance(data, surface, **options):
    """Of the points of a data set, or of positions, from a surface."""
    if isinstance(data, numpy.ndarray):
        data = point_set(data)
    return array(output_of('BoundaryDistance', data, surface, **options), 'BoundaryDistance')


def points_inside(surface, count, random):
    """Evenly distributed random positions inside a closed surface."""
    bounds = numpy.array(surface.GetBounds()).reshape(3, 2)
    found = numpy.zeros((0, 3))
    while len(found) < count:
        candidates = bounds[:, 0] + numpy.ptp(bounds, axis=1) * random.random((4 * count, 3))
        inside = candidates[boundary_distance(candidates, surface) < 0.0]
        if not len(found) and not len(inside):
            raise RuntimeError('of %d random positions in its box none is inside' % len(candidates))
        found = numpy.concatenate([found, inside])
    return found[:count]


# Data sets.

def at(data, places):
    """The same cells with other points."""
    result = copy(data)
    shapetesting.set_points(result, numpy.asarray(places, float))
    return result


def with_array(data, values, name):
    result = copy(data)
    add_array(result, values, name)
    return result


def write(data, path):
    """Every bit of a surface or a solid, for read()."""
    if data.IsA('vtkPolyData'):
        shapetesting.write(data, path)
        return
    writer = vtkXMLUnstructuredGridWriter()
    writer.SetFileName(path)
    writer.SetInputData(data)
    writer.SetDataModeToBinary()
    if not writer.Write():
        raise RuntimeError('cannot write ' + path)


def triangulated(surface):
    triangles = vtkTriangleFilter()
    triangles.SetInputData(surface)
    triangles.PassVertsOff()
    triangles.PassLinesOff()
    triangles.Update()
    return triangles.GetOutput()


def skin(solid):
    """The surface of a solid."""
    surface = vtkDataSetSurfaceFilter()
    surface.SetInputData(solid)
    surface.Update()
    return surface.GetOutput()


def behind(solid, origin, normal):
    """The whole cells behind a plane and those that it crosses."""
    plane = vtkPlane()
    plane.SetOrigin(origin)
    plane.SetNormal(normal)
    extract = vtkExtractGeometry()
    extract.SetInputData(solid)
    extract.SetImplicitFunction(plane)
    extract.ExtractBoundaryCellsOn()
    extract.Update()
    return extract.GetOutput()


def scaled_jacobians(solid):
    """The solid with Verdict's measure of its tetrahedra and hexahedra as cell array `Quality`."""
    quality = vtkMeshQuality()
    quality.SetInputData(solid)
    quality.SetTetQualityMeasureToScaledJacobian()
    quality.SetHexQualityMeasureToScaledJacobian()
    quality.Update()
    return quality.GetOutput()


def append(*surfaces):
    """Several surfaces as one: what bounds a solid and its voids."""
    appended = vtkAppendPolyData()
    for surface in surfaces:
        appended.AddInputData(surface)
    appended.Update()
    return appended.GetOutput()


def longest_side(places):
    return numpy.ptp(places, axis=0).max()


def turned_round(data, name='TargetPosition'):
    """A shape at its image, with the way back as its map array."""
    result = copy(data)
    shapetesting.set_points(result, array(data, name).astype(float))
    add_array(result, points(data), name)
    return result


def curves(lines, samples):
    """Points at equal shares of the arc length of each polyline: k x samples x 3."""
    places = []
    for index in range(lines.GetNumberOfCells()):
        ids = lines.GetCell(index).GetPointIds()
        corners = points(lines)[[ids.GetId(i) for i in range(ids.GetNumberOfIds())]]
        lengths = numpy.linalg.norm(numpy.diff(corners, axis=0), axis=1)
        shares = numpy.append(0.0, lengths.cumsum()) / lengths.sum()
        wanted = numpy.linspace(0.0, 1.0, samples)
        places.append(numpy.stack(
            [numpy.interp(wanted, shares, corners[:, axis]) for axis in range(3)], axis=1))
    return numpy.array(places)


def point_set(places):
    """Points, one vertex each, as vtkPolyData."""
    data = off.surface(places, [])
    cells = off.surface(places, [[i] for i in range(len(places))]).GetPolys()
    data.SetVerts(cells)
    return data


def write_table(path, rows):
    """Rows (dictionaries with the same keys) as CSV."""
    with open(path, 'w', newline='') as file:
        writer = csv.DictWriter(file, list(rows[0]))
        writer.writeheader()
        writer.writerows(rows)


def print_table(rows, columns):
    """Prints some columns: pairs of a key and a format."""
    cells = [[key for key, _ in columns]]
    cells += [[form % row[key] if row[key] != '' else '' for key, form in columns] for row in rows]
    widths = [max(len(line[i]) for line in cells) for i in range(len(columns))]
    for line in cells:
        print('  '.join(text.rjust(width) for text, width in zip(line, widths)), flush=True)
