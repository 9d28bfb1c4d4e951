"""Shape Untangle on the sphere maps of every closed surface of genus 0 in a folder of OFF files: a
table of inverted tetrahedra before and after, with the boundary fixed on the sphere's image. Raises
unless none is left on any model.

Each model is made to face outwards, mapped to the sphere, filled with tetrahedra, and these are
carried by the harmonic map of that boundary map; then the boundary's points are put exactly on their
images, which the harmonic map meets only to its tolerance. `map` counts the inverted tetrahedra
before that, `before` after it. The result is checked here again: no determinant is below 0 as
computed with numpy, and every point of the boundary is where it was put, to the bit.

    Utilities/pvpython.sh Testing/Benchmarks/UntangleModels.py [FOLDER] [model ...] [Property=value ...]

Properties are Shape Harmonic Volume Map's. With KEEP=folder in the environment the maps are kept
there, or taken from there.
"""
import glob
import os
import sys
import time

import numpy
import shapemap
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkReverseSense, vtkTriangleFilter

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path += [os.path.join(ROOT, 'Utilities'), os.path.join(ROOT, 'Testing')]

import off
import shapetesting
from shapetesting import array, fact, points


def facing_outwards(surface):
    """A sphere map faces outwards, so the surface must, or else the map mirrors the solid."""
    triangulate = vtkTriangleFilter()
    triangulate.SetInputData(surface)
    triangulate.Update()
    corners = points(triangulate.GetOutput())[shapetesting.triangles(triangulate.GetOutput())]
    if numpy.linalg.det(corners).sum() >= 0.0:
        return surface
    turn = vtkReverseSense()
    turn.SetInputData(surface)
    turn.Update()
    return turn.GetOutput()


def determinants(places, corners):
    a, b, c = (places[corners[:, k]] - places[corners[:, 0]] for k in (1, 2, 3))
    return numpy.einsum('ij,ij->i', numpy.cross(a, b), c)


def corners_of(solid):
    return vtk_to_numpy(solid.GetCells().GetConnectivityArray()).reshape(-1, 4)


def run(algorithm):
    """The reason why it did not work, or nothing."""
    messages = shapetesting.run(algorithm)
    return messages[0].strip().split('): ')[-1] if messages else ''


def carried(surface, settings):
    """The tetrahedra, how the harmonic map moves them, where the boundary belongs, and why not."""
    sphere = shapemap.vtkShapeParameterize()
    sphere.SetInputDataObject(surface)
    reason = run(sphere)
    if reason:
        return None, None, None, reason
    solid = shapemap.vtkShapeTetrahedralize()
    solid.SetInputConnection(sphere.GetOutputPort())
    reason = run(solid)
    if reason:
        return None, None, None, reason
    volume_map = shapemap.vtkShapeHarmonicVolumeMap()
    for key, value in settings.items():
        getattr(volume_map, 'Set' + key)(type(getattr(volume_map, 'Get' + key)())(value))
    volume_map.SetInputConnection(0, solid.GetOutputPort())
    volume_map.SetInputConnection(1, sphere.GetOutputPort())
    reason = run(volume_map)
    rest, moved = solid.GetOutputDataObject(0), volume_map.GetOutputDataObject(0)
    if reason:
        return None, None, None, reason
    ids = array(rest, 'OriginalPointId')
    targets = array(sphere.GetOutputDataObject(0), 'TargetPosition')
    return rest, points(moved), numpy.where((ids >= 0)[:, None], targets[ids], numpy.nan), ''


arguments = sys.argv[1:]
folder = os.path.join(ROOT, 'build', 'models')
if arguments and os.path.isdir(arguments[0]):
    folder = arguments.pop(0)
settings = dict(argument.split('=') for argument in arguments if '=' in argument)
names = [argument for argument in arguments if '=' not in argument]
paths = sorted(glob.glob(os.path.join(folder, '*.off')), key=os.path.getsize)
paths = [path for path in paths if not names or os.path.basename(path)[:-4] in names]
assert paths, 'there are no models in ' + folder
keep = os.environ.get('KEEP')
left, mapped = [], 0
print('%-26s %8s %7s %7s %6s %6s %7s %8s %8s' % (
    'model', 'tets', 'map', 'before', 'after', 'split', 'cells', 'seconds', 'map s'))
for path in paths:
    name = os.path.basename(path)[:-4]
    surface = off.read(path)
    if surface.GetNumberOfCells() == 0:
        continue
    kept = os.path.join(keep, name + '.npz') if keep else ''
    start = time.time()
    surface = facing_outwards(surface)
    if kept and os.path.exists(kept):
        solid = shapemap.vtkShapeTetrahedralize()
        solid.SetInputDataObject(surface)
        assert not run(solid)
        rest, data = solid.GetOutputDataObject(0), numpy.load(kept)
        assert (data['rest'] == points(rest)).all()
        places, boundary = data['moved'], data['boundary']
    else:
        rest, places, boundary, reason = carried(surface, settings)
        if reason:
            print('%-26s no map: %s' % (name, reason.split('\n')[0]), flush=True)
            continue
        if kept:
            numpy.savez(kept, rest=points(rest), moved=places, boundary=boundary)
    map_seconds = time.time() - start
    mapped += 1
    fixed = ~numpy.isnan(boundary[:, 0])
    snapped = numpy.where(fixed[:, None], boundary, places)
    tangled = shapetesting.copy(rest)
    shapetesting.set_points(tangled, snapped)
    untangle = shapemap.vtkShapeUntangle()
    untangle.SetInputDataObject(0, tangled)
    untangle.SetInputDataObject(1, rest)
    start = time.time()
    assert not shapetesting.run(untangle)
    seconds = time.time() - start
    result = untangle.GetOutputDataObject(0)
    untangled = points(result)
    assert (untangled[:len(snapped)][fixed] == snapped[fixed]).all(), 'the boundary moved'
    after = int(fact(result, 'Untangle.InvertedAfter'))
    wrong = int((determinants(untangled, corners_of(result)) < 0.0).sum())
    assert after > 0 or wrong == 0, '%d determinants are negative' % wrong
    print('%-26s %8d %7d %7d %6d %6d %7d %8.2f %8.1f' % (
        name, rest.GetNumberOfCells(), (determinants(places, corners_of(rest)) <= 0.0).sum(),
        fact(result, 'Untangle.InvertedBefore'), after, fact(result, 'Untangle.SplitCells'),
        result.GetNumberOfCells(), seconds, map_seconds), flush=True)
    if after:
        left.append(name)
assert mapped, 'no model could be mapped'
print('%d models mapped; inverted tetrahedra left on %d of them' % (mapped, len(left)))
if left:
    raise AssertionError('inverted tetrahedra are left on ' + ' '.join(left))
