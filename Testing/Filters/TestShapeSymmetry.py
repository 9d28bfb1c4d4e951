"""Shape Symmetry: the maps of a surface to itself that keep distances along it."""
import numpy
from paraview import simple
import shapemap
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet

import shapetesting
from shapetesting import add_array, array, check_refused, copy, fact, points, read, set_points, triangles


def new(data, **settings):
    return shapetesting.new(shapemap.vtkShapeSymmetry, data, **settings)


def outputs(*arguments, **settings):
    return shapetesting.outputs(new(*arguments, **settings))


def of_cells(data, name):
    return vtk_to_numpy(data.GetCellData().GetArray(name))


# The example: an ellipsoid has three reflections, three rotations by half a turn, and the point reflection.
sphere = simple.Clean(Input=simple.Sphere(ThetaResolution=36, PhiResolution=36, Radius=1.0))
function = 'coordsX*iHat + 1.4*coordsY*jHat + 2*coordsZ*kHat'
ellipsoid = simple.Calculator(Input=sphere, CoordinateResults=1, Function=function)
found = simple.ShapeSymmetry(Input=ellipsoid, Array='Normals')
found.UpdatePipeline()
surface, fixed, elements, composition, facts = (shapetesting.output(found, port) for port in range(5))
order = int(fact(surface, 'Symmetry.Order'))
assert order == 8 and fact(surface, 'Symmetry.Reversing') == 4 and fact(surface, 'Symmetry.Generators') == 3
products = numpy.array([vtk_to_numpy(composition.GetColumn(k)) for k in range(order)])
assert (products == products.T).all() and (numpy.diag(products) == 0).all(), 'each is its own inverse'
assert (vtk_to_numpy(elements.GetColumnByName('Order')) == [1] + 7 * [2]).all()
places = points(surface)
signs = set()
for k in (1, 2, 3):
    images = array(surface, 'Generator%d' % k)
    sign = numpy.sign((images * places).sum(axis=0))
    signs.add(tuple(sign))
    error = numpy.linalg.norm(images - sign * places, axis=1)
    print('a generator', sign, 'mean error', error.mean())
    assert error.mean() < 0.02, 'the coordinates change signs: %s' % error.mean()
assert len(signs) == 3
# The domain is an octant: each copy has an eighth of the area.
corners = places[triangles(surface)]
areas = numpy.linalg.norm(numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
shares = numpy.bincount(of_cells(surface, 'Copy'), areas, minlength=8) / areas.sum()
assert abs(8 * shares - 1).max() < 0.1, shares
representatives = places[array(surface, 'Orbit')]
assert abs(abs(representatives) - abs(places)).mean() < 0.05, 'points of an orbit differ by signs'
# The normals of opposite sides cancel out.
assert abs(array(surface, 'Symmetrized')).mean() < 0.02
# The reflections keep the three ellipses in the coordinate planes.
curves = points(fixed)[vtk_to_numpy(fixed.GetLines().GetConnectivityArray()).reshape(-1, 2)]
assert abs(curves).min(axis=2).max() < 0.05, 'away from the planes: %s' % abs(curves).min(axis=2).max()
assert len(numpy.unique(of_cells(fixed, 'Element'))) == 3, 'the point reflection keeps no point'

# A figure has its left and its right side, in any pose. Its map is precise.
for name in ('FigureASmall.vtp', 'FigureBSmall.vtp'):
    figure = outputs(read(name))
    assert fact(figure[0], 'Symmetry.Order') == 2, name
    assert fact(figure[0], 'Symmetry.Reversing') == 1, name
    assert figure[1].GetNumberOfCells() > 10
straight = outputs(read('FigureASmall.vtp'))[0]
error = numpy.linalg.norm(array(straight, 'TargetPosition') - points(straight) * [-1, 1, 1], axis=1)
print('a figure: mean error', error.mean())
assert error.mean() < 0.02 * numpy.ptp(points(straight)[:, 2])
cells, weights = array(straight, 'TargetCell'), array(straight, 'TargetBarycentric')
assert abs(numpy.einsum('ik,ikc->ic', weights, points(straight)[triangles(straight)[cells]]) -
           array(straight, 'TargetPosition')).max() < 1e-6

# The surface in two blocks is the same surface.
figure = read('FigureASmall.vtp')
tree = vtkMultiBlockDataSet()
tree.SetBlock(1, figure)
again = outputs(tree)[0].GetBlock(1)
assert (array(again, 'TargetPosition') == array(straight, 'TargetPosition')).all()

# A surface without symmetry has the identity alone: nothing is divided, and every point is its own image.
bumps = read('DentedSphere600.vtp')
places = points(bumps)
for towards, height in (([0.6, 0.8, 0.0], 0.5), ([-0.5, 0.3, 0.8], 0.8), ([0.1, -0.9, 0.4], 0.3)):
    cosines = (places @ towards) / numpy.linalg.norm(places, axis=1)
    places = places * (1 + height * numpy.exp(8 * (cosines - 1)))[:, None]
set_points(bumps, places)
alone = outputs(bumps)
assert fact(alone[0], 'Symmetry.Order') == 1 and fact(alone[0], 'Symmetry.Generators') == 0
assert (array(alone[0], 'TargetPosition') == points(alone[0])).all()
assert (of_cells(alone[0], 'Copy') == 0).all() and alone[1].GetNumberOfCells() == 0

# What is refused.
round_one = simple.Clean(Input=simple.Sphere(ThetaResolution=24, PhiResolution=24))
round_one.UpdatePipeline()
check_refused(new(shapetesting.output(round_one)), 'more than 64 symmetries', 'MaximumOrder')
check_refused(new(figure, Array='Nothing'), 'Nothing', 'choose another Array')
for name, value in (('Tolerance', 0.0), ('MaximumOrder', 0), ('SearchPoints', 10), ('CoarsePoints', 10), ('Element', -1)):
    check_refused(new(figure, **{name: value}), name)
