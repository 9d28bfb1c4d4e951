"""What FilterCases.py gives to filters: shapes, and what is made of them. Each input is a function without
arguments, which is called when a case needs it; its result is kept."""
import functools
import math
import os

import sweep

import numpy
import off
import shapetesting
from shapetesting import add_array, points, set_points
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray, vtkImageData, vtkMultiBlockDataSet, vtkPolyData)
from vtkmodules.vtkFiltersCore import (
    vtkAppendPolyData, vtkContourFilter, vtkReverseSense, vtkStripper)
from vtkmodules.vtkFiltersModeling import vtkLinearSubdivisionFilter

MODELS = os.path.join(os.environ.get('SHAPEMAP_PREFIX', sweep.BUILD), 'models')

SURFACES = ('BentBarSmall.vtp', 'DentedSphere600.vtp', 'FigureASmall.vtp', 'PhantomBrainSmall.vtp',
            'PhantomHeadSmall.vtp', 'PhantomSkullSmall.vtp', 'TwistedBarSmall.vtp',
            'TwoTorusSmall.vtp')
SOLIDS = ('BallSmall.vtu', 'BentBarSmall.vtu', 'CubeSmall.vtu', 'TwistedBarSmall.vtu')
CLOSED = ('anchor', 'bear', 'bunny00', 'camel', 'cow', 'eight', 'elephant', 'femur', 'hand', 'man')
SPHERES = ('bear', 'bunny00', 'camel', 'cow', 'hand', 'man')  # of genus 0
OPEN = ('elephant-with-holes', 'head', 'mask_cone', 'mushroom', 'pig')
SMALL = ('anchor', 'cow', 'eight', 'elephant', 'femur')  # closed, for what takes longer

GOES, CAME = 'TargetPosition', 'SourcePosition'


def recipe(function):
    """Its calls make such functions, the same one of the same arguments."""
    made = functools.lru_cache(None)(function)
    return functools.lru_cache(None)(lambda *arguments: functools.partial(made, *arguments))


def of(function):
    """A recipe for what is made of another input."""
    return recipe(lambda source, *arguments: function(source(), *arguments))


def loaded(name):
    """A shape of Data/ or a demo model, with data of each kind that filters pass on."""
    if '.' in name:
        data = shapetesting.copy(shapetesting.read(name))
    else:
        data = off.read(os.path.join(MODELS, name + '.off'))
    places = points(data)
    add_array(data, places[:, 2] * 1.0, 'Height')
    add_array(data, numpy.arange(len(places)), 'Number')
    outwards = places - places.mean(axis=0)
    add_array(data, (outwards / numpy.linalg.norm(outwards, axis=1)[:, None]).astype(numpy.float32),
              'Outwards')
    data.GetPointData().SetActiveNormals('Outwards')
    data.GetPointData().SetActiveScalars('Height')
    marks = shapetesting.numpy_to_vtk(numpy.arange(data.GetNumberOfCells()) % 7, deep=True)
    marks.SetName('Mark')
    data.GetCellData().AddArray(marks)
    remark = vtkStringArray()
    remark.SetName('Remark')
    remark.InsertNextValue('about ' + name)
    data.GetFieldData().AddArray(remark)
    return data

shape = recipe(loaded)


def places_of(coordinates):
    """Points, each with a vertex."""
    data = vtkPolyData()
    data.SetPoints(shapetesting.vtkPoints())
    set_points(data, numpy.array(coordinates, float))
    data.SetVerts(vtkCellArray())
    for i in range(len(coordinates)):
        data.InsertNextCell(1, 1, [i])
    return data


def extremes(data, count):
    """The numbers of points farthest along directions, far apart."""
    directions = numpy.array([[1, .1, 0], [-1, 0, .1], [0, 1, .1], [.1, -1, 0], [0, .1, 1],
                              [.1, 0, -1]])
    return list(dict.fromkeys((points(data) @ directions.T).argmax(axis=0)))[:count]


@of
def seeds(data, count):
    return places_of(points(data)[extremes(data, count)])


@of
def landmarks(data, count):
    """Seeds and where the map of the data sends them."""
    chosen = extremes(data, count)
    made = places_of(points(data)[chosen])
    add_array(made, shapetesting.array(data, GOES)[chosen], GOES)
    return made


@of
def extreme(data, index):
    chosen = extremes(data, 6)
    return points(data)[chosen[index % len(chosen)]].tolist()


@of
def lattice(data, count=9):
    """An image that reaches beyond a shape."""
    low, high = points(data).min(axis=0), points(data).max(axis=0)
    image = vtkImageData()
    image.SetDimensions(count, count, count)
    image.SetOrigin(low - 0.06 * (high - low))
    image.SetSpacing(1.12 * (high - low) / (count - 1))
    add_array(image, numpy.arange(count**3) * 0.5, 'Half')
    return image


@of
def section(data, share):
    """The longest closed curve in a plane across the longest side of the box."""
    extent = numpy.ptp(points(data), axis=0)
    height = points(data)[:, extent.argmax()]
    solid = vtkPolyData()
    solid.CopyStructure(data)
    add_array(solid, height, 'height')
    solid.GetPointData().SetActiveScalars('height')
    contour = vtkContourFilter()
    contour.SetInputData(solid)
    contour.SetValue(0, height.min() + share * extent.max())
    stripper = vtkStripper()
    stripper.SetInputConnection(contour.GetOutputPort())
    stripper.JoinContiguousSegmentsOn()
    stripper.Update()
    curves = stripper.GetOutput().GetLines()
    offsets = vtk_to_numpy(curves.GetOffsetsArray())
    coordinates = points(stripper.GetOutput())[vtk_to_numpy(curves.GetConnectivityArray())]
    longest, most = None, 0.0
    for begin, end in zip(offsets, offsets[1:]):
        path = coordinates[begin:end]
        length = numpy.linalg.norm(numpy.diff(path, axis=0), axis=1).sum()
        if length > most:
            longest, most = path[:-1], length
    return shapetesting.closed_curve(longest)


@of
def loop_points(data, share):
    return points(section(lambda: data, share)())[::5].ravel().tolist()


@of
def handle(data):
    """The ends of a surface, one of which is turned."""
    places = points(data)
    axis = numpy.ptp(places, axis=0).argmax()
    low, length = places[:, axis].min(), numpy.ptp(places[:, axis])
    height = ((places[:, axis] - low) / length)[shapetesting.triangles(data)]
    chosen = numpy.flatnonzero((height < 0.15).all(axis=1) | (height > 0.85).all(axis=1))
    ends = shapetesting.copy(shapetesting.with_cells(data, chosen))
    source = points(ends)
    target = source.copy()
    upper = source[:, axis] > low + 0.5 * length
    u, v = (axis + 1) % 3, axis
    about = places.mean(axis=0)
    cosine, sine = math.cos(0.6), math.sin(0.6)
    x, y = source[upper, u] - about[u], source[upper, v] - about[v]
    target[upper, u] = about[u] + cosine * x - sine * y
    target[upper, v] = about[v] + sine * x + cosine * y
    add_array(ends, source, CAME)
    set_points(ends, target)
    return ends


@of
def border(data):
    """The open edges, moved as a saddle."""
    edges = shapetesting.copy(shapetesting.edges_of(data, 'Boundary'))
    source = points(edges)
    size = numpy.ptp(source, axis=0).max()
    middle = (source - source.mean(axis=0)) / size
    add_array(edges, source, CAME)
    set_points(edges, source + 0.4 * size * numpy.outer(middle[:, 0]**2 - middle[:, 1]**2, [0, 0, 1]))
    return edges


@of
def finer(data, times):
    """Each triangle divided into 4, several times."""
    divide = vtkLinearSubdivisionFilter()
    divide.SetInputData(data)
    divide.SetNumberOfSubdivisions(times)
    divide.Update()
    return divide.GetOutput()


@of
def shrunk(data, ratio):
    made = shapetesting.copy(data)
    middle = 0.5 * (points(data).min(axis=0) + points(data).max(axis=0))
    set_points(made, middle + ratio * (points(data) - middle))
    return made


@of
def hollow(data, inner):
    """A surface and, inside it, another that is reversed and bounds a void."""
    reverse = vtkReverseSense()
    reverse.SetInputData(inner())
    append = vtkAppendPolyData()
    append.AddInputData(data)
    append.AddInputConnection(reverse.GetOutputPort())
    append.Update()
    return append.GetOutput()


@of
def tangled(data):
    """A solid, some points of which were moved too far."""
    made = shapetesting.copy(data)
    places = points(data)
    noise = numpy.random.default_rng(7).normal(size=places.shape)
    noise /= numpy.linalg.norm(noise, axis=1)[:, None]
    length = numpy.cbrt(numpy.ptp(places, axis=0).prod() / data.GetNumberOfCells())
    moved = numpy.arange(len(places)) % 41 == 4
    set_points(made, places + 0.8 * length * noise * moved[:, None])
    return made


@of
def in_blocks(data):
    blocks = vtkMultiBlockDataSet()
    blocks.SetBlock(1, data)
    return blocks
