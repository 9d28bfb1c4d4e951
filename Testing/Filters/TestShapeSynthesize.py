"""Shape Synthesize: samples of a statistical shape, and data inside that move along.

As an example: a bar with two modes, its hexahedra in a sample, saved as a deck."""
import os
import tempfile

import numpy
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import (
    vtkDataObject, vtkImageData, vtkMultiBlockDataSet, vtkPolyData, vtkUnstructuredGrid)
import shapemap

import decks
import shapetesting
from shapetesting import add_array, array, check_refused, copy, fact, facts, outputs, points, read


def atlas_of(template, modes, mean=None):
    atlas = copy(template)
    add_array(atlas, points(template), 'SourcePosition')
    for k, mode in enumerate(modes):
        add_array(atlas, mode, 'Mode%d' % k)
    if mean is not None:
        shapetesting.set_points(atlas, mean)
    return atlas


def new(*inputs, weights=(), **settings):
    algorithm = shapetesting.new(shapemap.vtkShapeSynthesize, *inputs, Tetrahedra=4000, **settings)
    for k, weight in enumerate(weights):
        algorithm.SetWeights(k, weight)
    return algorithm


# The example: a box that is bent, or twisted, and its hexahedra.
bar = read('BentBarSmall.vtp')
shapetesting.set_points(bar, array(bar, 'TargetPosition'))
solid = read('BentBarSmall.vtu')
shapetesting.set_points(solid, array(solid, 'TargetPosition'))


def bent(places):
    x, y, _ = places.T
    return 0.15 * numpy.c_[-x * y, x**2 / 2, 0 * x]


def twisted(places):
    x, y, z = places.T
    return 0.2 * numpy.c_[0 * x, -x * z, x * y]


places = points(bar)
atlas = atlas_of(bar, [bent(places), twisted(places)])
add_array(atlas, places[:, 0] + 5.0, 'ThicknessMean')
add_array(atlas, places[:, 1] - 1.0, 'ThicknessMode0')
add_array(atlas, numpy.ones(len(places)), 'MeanOfNothingMean')
producers = []
for data in (atlas, solid):
    producers.append(simple.TrivialProducer())
    producers[-1].GetClientSideObject().SetOutput(data)
sample = simple.ShapeSynthesize(Atlas=producers[0], Data=producers[1], Weights=[1.5, -2.0])
sample.UpdatePipeline()
shape, moved, _ = [shapetesting.output(sample, port) for port in range(3)]
summed = places + 1.5 * bent(places) - 2.0 * twisted(places)
assert abs(points(shape) - summed).max() < 1e-14, 'the mean plus the modes, by their weights'
assert (array(shape, 'SourcePosition') == places).all()
assert abs(array(shape, 'Thickness') - (places[:, 0] + 5.0 + 1.5 * (places[:, 1] - 1.0))).max() < 1e-14
assert not shape.GetPointData().HasArray('MeanOfNothing')
for data in (shape, moved):
    assert list(vtk_to_numpy(data.GetFieldData().GetArray('Weights'))) == [1.5, -2.0]
assert (array(moved, 'SourcePosition') == points(solid)).all() and not array(moved, 'OutsideDomain').any()
# Points of the surface go where the surface goes.
given = points(solid)
on_surface = (abs(given) >= [2, 0.5, 0.5]).any(axis=1)
expected = given + 1.5 * bent(given) - 2.0 * twisted(given)
assert abs(points(moved) - expected)[on_surface].max() < 0.01, 'apart from straight edges of triangles'
assert abs(points(moved) - expected).max() < 0.02, 'and the rest is near, since the modes are smooth'
assert fact(moved, 'Synthesize.Modes') == 2 and fact(moved, 'Synthesize.InvertedBefore') == 0
assert fact(moved, 'Synthesize.BoundaryPoints') == on_surface.sum()
assert fact(moved, 'Synthesize.BoundaryDistance') < 1e-10
quality = vtk_to_numpy(moved.GetCellData().GetArray('ScaledJacobian'))
assert fact(moved, 'Synthesize.MinimumScaledJacobian') == quality.min() > 0.8

# Into the writers: a new deck by its file's name, and the deck that a mesh was read from.
folder = tempfile.mkdtemp()
simple.SaveData(os.path.join(folder, 'sample.inp'), simple.OutputPort(sample, 1))
lines = open(os.path.join(folder, 'sample.inp')).read().splitlines()
nodes = lines[lines.index('*NODE') + 1:][:len(given)]
assert abs(numpy.array([line.split(', ')[1:] for line in nodes], float) - points(moved)).max() < 1e-14
original = decks.write(os.path.join(folder, 'original'), (4, 3, 3))
deck = simple.ShapeDeckReader(FileNames=[original])
deck.UpdatePipeline()
box = simple.Box(XLength=1.0, YLength=1.0, ZLength=2.0, Center=[0.5, 0.5, 1.0])
block = simple.Clean(Input=simple.Triangulate(Input=box))
block = simple.Calculator(Input=block, ResultArrayName='SourcePosition', Function='coords')
block = simple.Calculator(Input=block, ResultArrayName='Mode0', Function='0.1*coordsZ*kHat')
longer = simple.ShapeSynthesize(Atlas=block, Data=deck, Weights=[2.0])
longer.UpdatePipeline()
path = os.path.join(folder, 'moved', 'pull.inp')
os.makedirs(os.path.dirname(path))
simple.ShapeMovedDeckWriter(Input=simple.OutputPort(longer, 1), FileName=path).UpdatePipeline()
again = simple.ShapeDeckReader(FileNames=[path])
again.UpdatePipeline()
before, after = (points(shapetesting.output(each)) for each in (deck, again))
assert abs(after - before * [1.0, 1.0, 1.2]).max() < 1e-9, 'an affine mode moves the deck affinely'

# Other weights use the same solution: the same bits as a filter that has just begun.
live = new(atlas, solid, weights=[0.3, 0.1])
outputs(live)
for weights in ([0.0, 0.0], [2.0, 1.0], [-1.0, 3.0]):
    for k, weight in enumerate(weights):
        live.SetWeights(k, weight)
    kept, fresh = outputs(live), outputs(new(atlas, solid, weights=weights))
    for port in (0, 1):
        assert (points(kept[port]) == points(fresh[port])).all()
    if not any(weights):
        assert (points(kept[0]) == places).all(), 'the mean is the template'
        assert abs(points(kept[1]) - given).max() < 1e-13
# Changed data are seen.
half = copy(solid)
shapetesting.set_points(half, 0.5 * given)
live.SetInputDataObject(1, half)
assert (array(outputs(live)[1], 'SourcePosition') == 0.5 * given).all()
shapetesting.set_points(half, 0.25 * given)
half.Modified()
assert (array(outputs(live)[1], 'SourcePosition') == 0.25 * given).all()
other = atlas_of(bar, [0.1 * places])
live.SetInputDataObject(0, other)
live.SetNumberOfWeights(1)
live.SetWeights(0, 2.0)
assert abs(points(outputs(live)[1]) - 1.2 * 0.25 * given).max() < 1e-12, 'a mode of scale moves the inside by it'
live.SetTetrahedra(8000)
assert fact(outputs(live)[1], 'Synthesize.Tetrahedra') > fact(moved, 'Synthesize.Modes')

# A mean that is not the template: Data are in the template's coordinates.
shifted = atlas_of(bar, [0.1 * places], 2.0 * places + 7.0)
there = outputs(new(shifted, solid, weights=[1.0]))[1]
assert abs(points(there) - (2.1 * given + 7.0)).max() < 1e-11

# Any data set: an image becomes a structured grid, blocks stay blocks, and points and surfaces move.
image = vtkImageData()
image.SetDimensions(5, 3, 3)
image.SetOrigin(-1.0, -0.25, -0.25)
image.SetSpacing(0.5, 0.25, 0.25)
cloud = vtkPolyData()
cloud.SetPoints(shapetesting.vtkPoints())
shapetesting.set_points(cloud, 0.4 * given)
blocks = vtkMultiBlockDataSet()
for k, data in enumerate((image, cloud, None, bar, solid)):
    blocks.SetBlock(k, data)
tree = outputs(new(shifted, blocks, weights=[1.0]))[1]
assert tree.GetNumberOfBlocks() == 5 and tree.GetBlock(2) is None
assert tree.GetBlock(0).GetClassName() == 'vtkStructuredGrid' and tree.GetBlock(0).GetExtent() == (0, 4, 0, 2, 0, 2)
for k in (0, 1, 3, 4):
    block = tree.GetBlock(k)
    assert abs(points(block) - (2.1 * array(block, 'SourcePosition') + 7.0)).max() < 1e-11
assert (points(tree.GetBlock(4)) == points(there)).all()
assert not tree.GetBlock(1).GetCellData().HasArray('Inverted') or tree.GetBlock(1).GetNumberOfCells() == 0

# Points outside stay and are counted, in a warning, too.
far = copy(cloud)
spread = points(cloud).copy()
spread[3] = [0.0, 0.0, 9.0]
spread[5] = [0.0, 0.0, 0.52]  # 0.5 % of the size outside
shapetesting.set_points(far, spread)
made = outputs(new(shifted, far, weights=[1.0]))[1]
assert list(numpy.flatnonzero(array(made, 'OutsideDomain'))) == [3] and (points(made)[3] == spread[3]).all()
assert abs(points(made)[5] - (2.1 * spread[5] + 7.0)).max() < 1e-11, 'a point that is near moves'
assert fact(made, 'Synthesize.OutsidePoints') == 1
assert abs(fact(made, 'Synthesize.TemplateDistance') - 8.5 / 4.0) < 1e-12
assert '1 points of the Data are outside' in fact(made, 'Synthesize.Warning')

# Inverted cells are untangled, and the boundary stays on the sample.
x, y, z = places.T
deep = numpy.where(y > 0.499, -0.42 * numpy.exp(-(x**2 + z**2) / 0.08), 0.0)
squeezed = atlas_of(bar, [numpy.c_[0 * x, deep, 0 * z]])
for data in (solid, shapetesting.outputs(shapetesting.new(shapemap.vtkShapeTetrahedralize, bar, MaximumVolume=0.01))[0]):
    folded = outputs(new(squeezed, data, weights=[2.0], Untangle=False, WantedScaledJacobian=0.0))[1]
    repaired = outputs(new(squeezed, data, weights=[2.0]))[1]
    before = fact(folded, 'Synthesize.InvertedBefore')
    assert before == fact(repaired, 'Synthesize.InvertedBefore') == fact(folded, 'Synthesize.InvertedAfter')
    print('%d cells inverted, %d left' % (before, fact(repaired, 'Synthesize.InvertedAfter')))
    assert before > 0 and fact(repaired, 'Synthesize.InvertedAfter') == 0
    assert vtk_to_numpy(folded.GetCellData().GetArray('Inverted')).sum() == before
    assert not vtk_to_numpy(repaired.GetCellData().GetArray('Inverted')).any()
    assert fact(repaired, 'Synthesize.BoundaryDistance') < 1e-9
# If the sample's surface goes through itself, no mesh can be right, and a warning says so.
through = outputs(new(squeezed, solid, weights=[3.0]))[1]
left = fact(through, 'Synthesize.InvertedAfter')
assert left > 0 and '%d cells stay inverted' % left in fact(through, 'Synthesize.Warning')
assert 'smaller Weights' in fact(through, 'Synthesize.Warning')

# Time: mode 1 swings through Amplitude and back, and mode 0 stays.
swing = new(atlas, solid, weights=[1.0, 0.5], Animate=1, Amplitude=2.0)
for time, weight in ((0.0, 0.0), (0.25, 2.0), (0.125, 2.0 * 0.5**0.5), (0.75, -2.0), (1.0, 0.0), (7.0, 0.0)):
    swing.UpdateTimeStep(time)
    expected = places + bent(places) + weight * twisted(places)
    assert abs(points(swing.GetOutputDataObject(0)) - expected).max() < 1e-12, time
    for port in (0, 1):
        assert swing.GetOutputDataObject(port).GetInformation().Get(vtkDataObject.DATA_TIME_STEP()) == min(time, 1.0)
played = simple.ShapeSynthesize(Atlas=producers[0], Animate=0)
played.UpdatePipelineInformation()
assert list(played.TimestepValues) == [k / 40 for k in range(41)]
played.Animate = -1
played.UpdatePipelineInformation()
assert not list(played.TimestepValues)

# What cannot be: the fact and the remedy.
plain = read('DentedSphere600.vtp')
check_refused(new(plain), "no point array 'Mode0'", 'Shape Atlas')
gap = atlas_of(bar, [places])
add_array(gap, places, 'Mode2')
check_refused(new(gap), "'Mode2', but no 'Mode1'", 'without a gap')
flat = atlas_of(bar, [places[:, :2]])
check_refused(new(flat), 'Mode0', '3')
bad = atlas_of(bar, [numpy.where(numpy.arange(len(places))[:, None] == 4, numpy.nan, places)])
check_refused(new(bad), "the array 'Mode0' of the Atlas", 'first at point 4')
check_refused(new(atlas, weights=[numpy.inf]), 'Weights', 'not finite')
check_refused(new(atlas, Animate=2), 'Animate is 2', 'modes 0 to 1')
opened = shapetesting.without_cells(atlas, [0, 1])
assert points(outputs(new(opened, weights=[1.0]))[0]).shape == places.shape, 'an open Atlas has samples'
check_refused(new(opened, solid), 'the Atlas', 'Shape Fill Holes')
nowhere = copy(atlas)
nowhere.GetPointData().RemoveArray('SourcePosition')
check_refused(new(nowhere, solid), "no point array 'SourcePosition'", 'disconnect Data')
many = new(atlas, weights=[1.0, 0.0, 3.0, 4.0])
assert (points(outputs(many)[0]) == places + bent(places)).all()
assert 'Weights, but the Atlas has 2 modes; not used are number 2 to 3' in fact(
    outputs(many)[0], 'Synthesize.Warning')
empty = outputs(new(atlas))
assert empty[1].GetNumberOfPoints() == 0 and not facts(empty[0]).HasArray('Synthesize.Tetrahedra')
assert isinstance(outputs(new(atlas, solid))[1], vtkUnstructuredGrid)
print('samples carry their solids along')
