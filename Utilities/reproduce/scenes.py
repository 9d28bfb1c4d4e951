"""What the figures and the feature experiments share: shapes, volume maps, tables, panels."""
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
from vtkmodules.vtkFiltersCore import vtkAppendPolyData  # noqa: E402

START = time.time()

MULTI_LEVEL = 1 # of Shape Harmonic Volume Map's Method


def say(text):
    print('%6.1f s  %s' % (time.time() - START, text), flush=True)


def model_file(name):
    """A model of libcgal-demo, which set-up unpacks into the build."""
    folder = os.environ.get('SHAPEMAP_MODELS', os.path.join(BUILD, 'models'))
    return os.path.join(folder, name)


def checked(algorithm):
    """Updates an algorithm; raises with its words where it fails."""
    messages = shapetesting.run(algorithm)
    if messages or algorithm.GetOutputDataObject(0).GetNumberOfPoints() == 0:
        raise RuntimeError(' '.join(messages) or 'an empty output')
    return algorithm


def filter_of(name, *inputs, **options):
    """The updated filter vtkShapeX of X = `name`, with one data set on each port."""
    algorithm = getattr(shapemap, 'vtkShape' + name)()
    for port, data in enumerate(inputs):
        algorithm.SetInputDataObject(port, data)
    for option, value in options.items():
        getattr(algorithm, 'Set' + option)(value)
    return checked(algorithm)


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
