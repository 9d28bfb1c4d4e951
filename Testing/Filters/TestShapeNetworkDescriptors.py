"""Shape Network Descriptors: the values of networks whose formulas are known, the scales, what is refused, and a
functional map from them.

As an example: descriptors of two poses of a figure, and the map that they give."""
import os
import sys
import tempfile

import numpy
from paraview import simple
import shapemap

import shapetesting
from shapetesting import add_array, array, check_refused, data_file, points, read, set_points, triangles

sys.path.append(os.path.join(shapetesting.ROOT, 'Data'))
from shapes import networks  # noqa: E402

UNIT_AREA, UNIT_RADIUS, GIVEN = range(3)
FOLDER = tempfile.mkdtemp()


def write_network(nodes, inputs, output=('Output', ['n', 'columns']), constants=None, kind=networks.FLOAT):
    """An ONNX file. nodes: (operation, inputs, output, attributes)."""
    path = os.path.join(FOLDER, '%d.onnx' % len(os.listdir(FOLDER)))
    with open(path, 'wb') as file:
        file.write(networks.network(nodes, inputs, dict([output]), constants, kind))
    return path


def new(path, surface, arrays=(), **settings):
    algorithm = shapetesting.new(shapemap.vtkShapeNetworkDescriptors, surface, FileName=path, **settings)
    for k, name in enumerate(arrays):
        algorithm.SetInputArrays(k, name)
    return algorithm


def descriptors(*arguments, **settings):
    return array(shapetesting.outputs(new(*arguments, **settings))[0], 'NetworkDescriptors')


def passing(name, sizes, output=('Output', ['n', 'columns'])):
    """A network that returns its input."""
    return write_network([('Identity', [name], output[0], {})], {name: sizes}, output)


def close(found, wanted, tolerance=1e-5):
    """Single precision is what a network computes with."""
    assert found.shape == wanted.shape, (found.shape, wanted.shape)
    assert abs(found - wanted).max() <= tolerance * abs(wanted).max(), abs(found - wanted).max()


# The example. The network's weights are random, but its inputs do not depend on the pose.
a, b = (simple.XMLPolyDataReader(FileName=data_file('Figure%sSmall.vtp' % which)) for which in 'AB')
described = [simple.ShapeNetworkDescriptors(Input=figure, FileName=data_file('RandomFeatures.onnx'))
             for figure in (a, b)]
match = simple.ShapeCorrespondence(
    SurfaceA=described[0], SurfaceB=described[1], Method='FunctionalMap', Descriptors='Given',
    DescriptorArrays=['NetworkDescriptors'])
match.UpdatePipeline()
figure = shapetesting.output(match)
errors = numpy.linalg.norm(
    array(figure, 'TargetPosition') - points(shapetesting.output(described[1])), axis=1)
assert array(figure, 'NetworkDescriptors').std(axis=0).min() > 0.0, 'each descriptor differs from point to point'
# Two random points of the figure are about 0.4 of its height apart.
assert numpy.median(errors) < 0.1 * numpy.ptp(points(figure)[:, 1]), numpy.median(errors)

# Inputs are what they are called, in the scale that is chosen.
surface = read('DentedSphere600.vtp')
set_points(surface, 3.0 * points(surface) * [1.0, 1.2, 1.5] + [5.0, -4.0, 3.0])
places, corners = points(surface), triangles(surface)
crosses = numpy.cross(places[corners[:, 1]] - places[corners[:, 0]], places[corners[:, 2]] - places[corners[:, 0]])
doubled = numpy.linalg.norm(crosses, axis=1)
area = doubled.sum() / 2
centroid = (places[corners].mean(axis=1) * doubled[:, None]).sum(axis=0) / doubled.sum()
positions = passing('Positions', ['n', 3])
close(descriptors(positions, surface, Scale=GIVEN), places)
close(descriptors(positions, surface), (places - centroid) / numpy.sqrt(area))
close(descriptors(positions, surface, Scale=UNIT_RADIUS),
      (places - centroid) / numpy.linalg.norm(places - centroid, axis=1).max())
masses = numpy.zeros(len(places))
numpy.add.at(masses, corners, doubled[:, None] / 6)
for sizes in (['n'], ['n', 1], [1, 'n', 1], ['any', 'n']):
    close(descriptors(passing('Masses', sizes, ('Output', sizes)), surface).ravel(), masses / area)
normals = descriptors(passing('Normals', ['n', 3]), surface)
outwards = (normals[corners].sum(axis=1) * crosses).sum(axis=1) / doubled
assert abs(numpy.linalg.norm(normals, axis=1) - 1).max() < 1e-6 and outwards.min() > 2.5
assert descriptors(passing('HeatKernelSignature', ['n', 7]), surface).shape[1] == 7
assert descriptors(passing('WaveKernelSignature', ['n', 'columns']), surface).shape[1] == 100

# Heat that flows for some time: what a layer of a diffusion network does, with matrices of two inputs.
# The network declares the number of eigenpairs, so the property does not count.
time = 0.01
heat = write_network(
    [('Mul', ['Arrays', 'Masses'], 'weighted', {}), ('Transpose', ['Eigenfunctions'], 'turned', {'perm': [1, 0]}),
     ('MatMul', ['turned', 'weighted'], 'modes', {}), ('Mul', ['Eigenvalues', 'time'], 'decay', {}),
     ('Neg', ['decay'], 'less', {}), ('Exp', ['less'], 'factor', {}), ('Mul', ['modes', 'factor'], 'cooled', {}),
     ('MatMul', ['Eigenfunctions', 'cooled'], 'Output', {})],
    {'Arrays': ['n', 2], 'Masses': ['n', 1], 'Eigenfunctions': ['n', 40], 'Eigenvalues': [40, 1]},
    constants={'time': numpy.array([[time]])})
add_array(surface, places[:, :1] * places[:, 1:2], 'One')
add_array(surface, places[:, 2], 'Two')
spectrum = shapetesting.new(shapemap.vtkShapeLaplaceSpectrum, surface, NumberOfEigenpairs=40)
analysed = shapetesting.outputs(spectrum)[0]
functions = array(analysed, 'Eigenfunctions')
values = analysed.GetFieldData().GetArray('LaplaceSpectrum.Eigenvalues')
values = numpy.array([values.GetValue(i) for i in range(40)])
given = numpy.column_stack([array(surface, 'One').ravel(), array(surface, 'Two').ravel()])
cooled = functions @ (numpy.exp(-time * area * values)[:, None] * (functions.T @ (masses[:, None] * given)))
close(descriptors(heat, surface, arrays=['One', 'Two'], NumberOfEigenpairs=5), cooled, 1e-4)

# Layers as trained networks have them.
random = numpy.random.default_rng(4)
first, second, bias = random.normal(size=(16, 3)), random.normal(size=(8, 16)), random.normal(size=16)
layers = write_network(
    [('Gemm', ['Positions', 'first', 'bias'], 'hidden', {'transB': 1}), ('Relu', ['hidden'], 'active', {}),
     ('Gemm', ['active', 'second'], 'Output', {'transB': 1})],
    {'Positions': ['n', 3]}, constants={'first': first, 'second': second, 'bias': bias})
wanted = numpy.maximum(places @ first.T + bias, 0) @ second.T
close(descriptors(layers, surface, Scale=GIVEN), wanted)

# Another name of the array; a network after a network.
twice = shapetesting.outputs(new(layers, surface, Scale=GIVEN, ArrayName='First'))[0]
again = descriptors(passing('Arrays', ['n', 'columns']), twice, arrays=['First'])
close(again, wanted)

# What is refused, with the fact and the remedy.
check_refused(new('', surface), 'File Name is empty')
check_refused(new('/no/such/file.onnx', surface), '/no/such/file.onnx')
check_refused(new(data_file('DentedSphere600.vtp'), surface), 'no ONNX network')
check_refused(new(passing('xyz', ['n', 3]), surface), "input 'xyz'", 'Positions', 'rename')
check_refused(new(passing('Positions', [100, 3]), surface), "'Positions' is 100 x 3", '642 x 3')
check_refused(new(passing('Positions', ['n', 4]), surface), "'Positions' is any x 4", '642 x 3')
check_refused(new(passing('Arrays', ['n', 3]), surface), "input 'Arrays'", 'Input Arrays')
check_refused(new(passing('Arrays', ['n', 3]), surface, arrays=['Two']), "'Arrays' is any x 3", 'values are 642')
check_refused(new(passing('Arrays', ['n', 3]), surface, arrays=['Missing']), 'Missing')
check_refused(new(positions, surface, ArrayName=''), 'Array Name is empty')
check_refused(new(write_network([('Transpose', ['Positions'], 'Output', {'perm': [1, 0]})],
                                {'Positions': ['n', 3]}), surface), 'output is 3 x 642', 'row for each of 642')
check_refused(new(write_network([('Log', ['Positions'], 'Output', {})], {'Positions': ['n', 3]}), surface),
              'not finite')
check_refused(new(write_network([('Identity', ['Positions'], 'Output', {})], {'Positions': ['n', 3]},
                                kind=networks.DOUBLE), surface), 'single precision')
check_refused(new(write_network([('NonZero', ['Positions'], 'Output', {})], {'Positions': ['n', 3]}), surface),
              'OpenCV cannot evaluate')
