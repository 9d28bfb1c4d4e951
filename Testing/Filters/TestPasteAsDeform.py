"""Shape Paste Feature deforms a feature as Shape Deform does, with every field and option: the loop
that it returns is a Boundary of Shape Deform, by which anything else follows the feature."""
import os
from xml.etree import ElementTree

import numpy
from paraview import simple
import shapemap

import shapetesting
from shapetesting import add_array, array, copy, output, points, triangles

TURNS = 2 * numpy.pi * numpy.arange(40) / 40
CIRCLE = 0.5 * numpy.column_stack([numpy.full(40, numpy.cos(0.6)), numpy.sin(0.6) * numpy.cos(TURNS),
                                   numpy.sin(0.6) * numpy.sin(TURNS)])
SEED, SCALE = [0.0, 1.0, 0.3], 0.8

ball = simple.Sphere(ThetaResolution=80, PhiResolution=80)
horned = simple.Calculator(Input=ball, CoordinateResults=1, Function=(
    'coords*(1+1.2*max(0,1-((coordsX-0.5)^2+coordsY^2+coordsZ^2)/0.05)^3)'))
cut = simple.ShapeCutFeature(Input=horned, LoopPoints=CIRCLE.ravel().tolist())
planet = simple.Sphere(ThetaResolution=60, PhiResolution=60, Radius=1.2)
for source in (cut, planet):
    source.UpdatePipeline()
feature, target = copy(output(cut)), copy(output(planet))
places = points(feature)
size = numpy.linalg.norm(numpy.ptp(places, axis=0))
add_array(feature, 1.0 + 4.0 * places[:, 0] ** 2, 'Stiff')
add_array(feature, 1.0 + 0.3 * numpy.sin(9.0 * places[:, 1]), 'Thick')
add_array(feature, (places[:, 0] > 0.6).astype(numpy.int32), 'Side')


def paste(onto=target, **settings):
    """The feature's points on the target, and the loop."""
    algorithm = shapetesting.new(shapemap.vtkShapePasteFeature, feature, onto, Seed=SEED, Rotation=25.0,
                                 Scale=SCALE, **settings)
    result, loop = shapetesting.outputs(algorithm)[:2]
    # On a manifold, midpoints follow the feature's points; on a soup, they are the last.
    is_soup = shapetesting.fact(result, 'PasteFeature.Soup') == 1.0
    first = (result.GetNumberOfPoints() - len(places) if is_soup
             else triangles(result)[array_of_cells(result, 'Part') == 2].min())
    return points(result)[first:first + len(places)], loop


def array_of_cells(surface, name):
    return numpy.array([surface.GetCellData().GetArray(name).GetValue(i) for i in range(surface.GetNumberOfCells())])


def deform(loop, **settings):
    """The same by Shape Deform, and when the front reached each point."""
    result = shapetesting.outputs(
        shapetesting.new(shapemap.vtkShapeDeform, feature, loop, Scale=SCALE, **settings))[0]
    return points(result), array(result, 'ArrivalTime')


def options():
    """Values of every property that filters share that deform, other than the defaults."""
    chosen = {'Rigidity': 2.5, 'RigidityContrast': 9.0, 'InnerScale': 0.7, 'UpwindRadius': 4.0,
              'MinimumProtrusion': 0.02}
    needed = {'RigidityContrast': {'RigidityBy': 1}, 'IntegrateCurves': {'Method': 1},
              'MinimumProtrusion': {'SegmentBy': 1}}
    path = os.path.join(shapetesting.ROOT, 'Filters', 'VTK', 'Deform', 'vtkShapeDeformingAlgorithm.xml')
    for each in ElementTree.parse(path).getroot().find('.//SourceProxy'):
        name = each.get('name')
        if not each.tag.endswith('Property') or name.startswith('Bias'):
            continue
        if each.find('EnumerationDomain') is not None:
            for entry in each.find('EnumerationDomain'):
                yield {name: int(entry.get('value'))}
        elif each.find('BooleanDomain') is not None:
            yield {name: 1 - int(each.get('default_values')), **needed.get(name, {})}
        else:
            yield {name: chosen[name], **needed.get(name, {})}


FIELDS = {'RigidityArray': 'Stiff', 'ScaleArray': 'Thick', 'SegmentArray': 'Side'}
LEANING = {'BiasFrame': (1.0, 0.5, 0.0), 'BiasWeight': 0.3}
UPRIGHT = {'BiasBy': 1, 'BiasRotation': (10.0, -20.0, 40.0), 'BiasWeight': 0.4}
ALL = {**FIELDS, 'RigidityBy': 1, 'InnerScale': 0.9, 'UpwindRadius': 3.0, 'Distance': 1, 'LaplacianSmoothing': 1}
plain, plain_loop = paste(OptimizeNormals=False)
assert abs(array(plain_loop, 'FrameRotation')).max() < 1e-12
different = 0
for settings in [*options(), *({name: value} for name, value in FIELDS.items()), ALL]:
    pasted, loop = paste(OptimizeNormals=False, **settings)
    deformed, _ = deform(loop, **settings)
    assert abs(pasted - deformed).max() < 1e-12 * size, (settings, abs(pasted - deformed).max() / size)
    different += abs(pasted - plain).max() > 1e-4
    # The bias, by its own properties and by the frames of the loop.
    for bias in (LEANING, UPRIGHT):
        biased, biased_loop = paste(OptimizeNormals=False, **settings, **bias)
        assert abs(biased - pasted).max() > 1e-3
        for deformed in (deform(loop, **settings, **bias)[0], deform(biased_loop, **settings)[0]):
            assert abs(biased - deformed).max() < 1e-12 * size, (settings, bias)
print('%d settings change the feature, and Shape Deform returns each' % different)
assert different >= 13, different

# With a smooth seam, the frames of the loop are optimised, too. Only near the seam does the feature then
# turn further: next to the loop, and within four of its edges.
for settings in ({}, ALL, {**ALL, **UPRIGHT}):
    pasted, loop = paste(**settings)
    assert abs(array(loop, 'FrameRotation')).max() > 0.01
    deformed, arrivals = deform(loop, **{name: value for name, value in settings.items() if 'Bias' not in name})
    ring = array(loop, 'SourcePosition')
    edge = numpy.linalg.norm(ring - numpy.roll(ring, 1, axis=0), axis=1).mean()
    corners = triangles(feature)
    beside = numpy.unique(corners[(arrivals[corners] == 0.0).any(axis=1)])  # points next to the loop
    far = numpy.setdiff1d(numpy.flatnonzero(arrivals >= 4.0 * edge), beside)
    assert len(far) > 100, len(far)
    assert abs(pasted - deformed)[far].max() < 1e-12 * size

# The loop is on the target, and on a soup, too.
pasted, loop = paste(OptimizeNormals=False, BridgeGaps=True, **ALL)
assert abs(pasted - deform(loop, **ALL)[0]).max() < 1e-12 * size
normals = array(loop, 'TargetNormal')
assert abs(numpy.linalg.norm(points(loop), axis=1) - 1.2).max() < 0.01
assert (points(loop) * normals).sum(axis=1).min() > 1.19

# What belongs to the feature follows it: its points alone are moved to where the feature is.
inner = copy(feature)
shapetesting.set_points(inner, 0.98 * places)
pasted, loop = paste(OptimizeNormals=False)
follower = points(shapetesting.outputs(
    shapetesting.new(shapemap.vtkShapeDeform, inner, loop, Scale=SCALE))[0])
assert numpy.linalg.norm(follower - pasted, axis=1).max() < 0.05
