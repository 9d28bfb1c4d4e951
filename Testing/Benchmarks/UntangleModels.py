"""Shape Untangle on the sphere maps of every closed surface of genus 0 in a folder of OFF files: a
table of inverted tetrahedra before and after, with the boundary fixed on the sphere's image. None is
left on any model.

Each model is made to face outwards, mapped to the sphere, filled with tetrahedra, and these are
carried by the harmonic map of that boundary map; then the boundary's points are put exactly on their
images, which the harmonic map meets only to its tolerance. `map` counts the inverted tetrahedra
before that, `before` after it. A boundary that crosses itself is a proof that cells stay inverted. The result is checked here again: no determinant is below 0 as
computed with numpy, and every point of the boundary is where it was put, to the bit.

    Utilities/pvpython.sh Testing/Benchmarks/UntangleModels.py [--keep FOLDER] [MODEL ...] [Property=value ...]

Properties are Shape Harmonic Volume Map's. With --keep the maps are kept in that folder, or taken from
there.
"""
import os
import time

import sweep

import numpy
import off
import shapemap
import shapetesting
from scenes import at, triangulated
from shapetesting import array, fact, points
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkPolyDataNormals, vtkReverseSense


def mended(surface):
    """Triangles that disagree are turned, points that none uses are left out."""
    clean = vtkCleanPolyData()
    clean.PointMergingOff()
    clean.SetInputData(surface)
    agree = vtkPolyDataNormals()
    agree.SetInputConnection(clean.GetOutputPort())
    agree.SplittingOff()
    agree.ConsistencyOn()
    agree.Update()
    return agree.GetOutput()


def facing_outwards(surface):
    """A sphere map faces outwards, so the surface must, or else the map mirrors the solid."""
    triangles = triangulated(surface)
    corners = points(triangles)[shapetesting.triangles(triangles)]
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
    sweep.set_properties(volume_map, settings)
    volume_map.SetInputConnection(0, solid.GetOutputPort())
    volume_map.SetInputConnection(1, sphere.GetOutputPort())
    reason = run(volume_map)
    rest, moved = solid.GetOutputDataObject(0), volume_map.GetOutputDataObject(0)
    if reason:
        return None, None, None, reason
    ids = array(rest, 'OriginalPointId')
    targets = array(sphere.GetOutputDataObject(0), 'TargetPosition')
    return rest, points(moved), numpy.where((ids >= 0)[:, None], targets[ids], numpy.nan), ''


def mapped(surface, settings, kept):
    """The same from the file `kept` if it is there; else that is written, if there is to be one."""
    surface = facing_outwards(surface)
    if kept and os.path.exists(kept):
        solid = shapemap.vtkShapeTetrahedralize()
        solid.SetInputDataObject(surface)
        assert not run(solid)
        rest, data = solid.GetOutputDataObject(0), numpy.load(kept)
        assert (data['rest'] == points(rest)).all()
        return rest, data['moved'], data['boundary'], ''
    rest, places, boundary, reason = carried(surface, settings)
    if 'opposite orientation' in reason or 'no triangle uses' in reason:
        rest, places, boundary, reason = carried(facing_outwards(mended(surface)), settings)
        kept = ''  # the folder is for surfaces as they are
    if kept and not reason:
        numpy.savez(kept, rest=points(rest), moved=places, boundary=boundary)
    return rest, places, boundary, reason


def main():
    parser = sweep.parser(__doc__)
    parser.add_argument('--keep', help='a folder for the maps')
    options = parser.parse_args()
    claims, left, proven, maps = sweep.Claims(), [], [], 0
    table = sweep.Table('model:<26', 'tetrahedra:10d', *(key + ':7d' for key in (
        'map', 'before', 'after', 'split', 'cells')), 'seconds:8.2f', 'mapseconds:10.1f')
    for name, path in sweep.models(options):
        surface = off.read(path)
        if surface.GetNumberOfCells() == 0:
            continue
        start = time.time()
        rest, places, boundary, reason = mapped(
            surface, sweep.properties(options),
            os.path.join(options.keep, name + '.npz') if options.keep else '')
        if reason:
            table.print({'model': name}, 'no map: ' + reason.split('\n')[0])
            continue
        map_seconds = time.time() - start
        maps += 1
        fixed = ~numpy.isnan(boundary[:, 0])
        snapped = numpy.where(fixed[:, None], boundary, places)
        untangle = shapemap.vtkShapeUntangle()
        untangle.SetInputDataObject(0, at(rest, snapped))
        untangle.SetInputDataObject(1, rest)
        start = time.time()
        assert not shapetesting.run(untangle)
        seconds = time.time() - start
        result = untangle.GetOutputDataObject(0)
        untangled = points(result)
        after = int(fact(result, 'Untangle.InvertedAfter'))
        wrong = int((determinants(untangled, corners_of(result)) < 0.0).sum())
        assert (untangled[:len(snapped)][fixed] == snapped[fixed]).all(), 'the boundary moved'
        assert after > 0 or wrong == 0, '%d determinants are negative' % wrong
        table.print(dict(
            model=name, tetrahedra=rest.GetNumberOfCells(),
            map=int((determinants(places, corners_of(rest)) <= 0.0).sum()),
            before=int(fact(result, 'Untangle.InvertedBefore')), after=after,
            split=int(fact(result, 'Untangle.SplitCells')), cells=result.GetNumberOfCells(),
            seconds=seconds, mapseconds=map_seconds), str(fact(result, 'Untangle.Reason')))
        if after:
            crosses = 'crosses itself' in str(fact(result, 'Untangle.Reason'))
            (proven if crosses else left).append(name)
    claims.at_least('models', 'mapped', maps, 1)
    print('%d valid, %d with a proven reason: %s' % (
        maps - len(left) - len(proven), len(proven), ', '.join(proven)))
    claims.none('%d models' % maps, 'inverted tetrahedra left', left)
    claims.finish()


if __name__ == '__main__':
    main()
