"""Shape Untangle on boundary maps that are hard on purpose: solids of 1 to 50,000 tetrahedra whose fixed
boundary goes to a star-shaped surface, while the inner points stay anywhere. A table of inverted
tetrahedra before and after, what was split, seconds, and the longest time without a report of progress.

Sources are random polyhedra, balls and closed models of genus 0, each with a map of its boundary onto the
sphere. A target is r(d) d over the sphere's directions d, with r > 0 for random stars, needles, spirals,
star polyhedra and a polycube. If all triangles of the sphere are positive, the target is star-shaped
around the origin, so that a map with refinement exists. Every case has its own seed. The result is
checked here again: every tetrahedron is positive in rational arithmetic, and the boundary is where it
was put, to the bit. If the boundary crosses itself, that is a proof that cells stay inverted.

With --bent, star-shaped targets are stretched, and then bent by a motion of space, by as much as keeps them
from crossing themselves; models are left out. The column `star` is 1 if a position still sees the whole boundary.

    Utilities/pvpython.sh Testing/Benchmarks/HardBoundaryMaps.py [--bent] [--count 200] [--seed 1] [CASE ...]

A CASE is the number of a case. With --keep the inputs are written to that folder.
"""
import argparse
import fractions
import os
import time

import sweep

import numpy
import off
import scipy.optimize
import shapemap
import shapetesting
from scenes import at
from shapetesting import array, fact, points
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkDelaunay3D
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter

SECONDS, PAUSE = 120.0, 2.0
MODELS = ('homer', 'hand', 'dino', 'triceratops', 'fandisk')


def convex_hull(places):
    """The surface of the convex hull of points on the unit sphere."""
    cloud = vtkPolyData()
    cloud.SetPoints(off.surface(places, []).GetPoints())
    delaunay = vtkDelaunay3D()
    delaunay.SetInputData(cloud)
    skin = vtkGeometryFilter()
    skin.SetInputConnection(delaunay.GetOutputPort())
    skin.Update()
    hull = skin.GetOutput()
    triangles = shapetesting.triangles(hull)
    return off.surface(points(hull).astype(float), triangles.tolist())


def directions_evenly(count, random):
    """Points of a spiral on the sphere, moved a little."""
    i = numpy.arange(count) + 0.5
    z, angle = 1.0 - 2.0 * i / count, numpy.pi * (1.0 + 5.0**0.5) * i
    radius = numpy.sqrt(1.0 - z * z)
    places = numpy.stack([radius * numpy.cos(angle), radius * numpy.sin(angle), z], axis=1)
    places += random.normal(size=places.shape) * 0.5 / count**0.5
    return places / numpy.linalg.norm(places, axis=1)[:, None]


def positive(directions, triangles):
    """Whether each triangle is on the same side of the origin."""
    corners = numpy.hstack([numpy.full((len(triangles), 1), len(directions)), triangles])
    return count_not_positive(numpy.vstack([directions, numpy.zeros(3)]), corners) == 0


def swirled(directions, triangles, turns):
    """The directions turned around z by an angle that depends on the height, by as much as keeps every
    triangle positive."""
    while turns > 0.01:
        angle = turns * numpy.sin(2.0 * directions[:, 2])
        x, y = directions[:, 0], directions[:, 1]
        turned = numpy.stack([x * numpy.cos(angle) - y * numpy.sin(angle),
                              x * numpy.sin(angle) + y * numpy.cos(angle), directions[:, 2]], axis=1)
        if positive(turned, triangles):
            return turned
        turns *= 0.7
    return directions


def random_star(directions, random):
    waves = random.normal(size=(6, 3)) * 3.0
    return numpy.exp(0.35 * numpy.sin(directions @ waves.T).sum(axis=1) +
                     random.normal(size=len(directions)) * random.uniform(0.1, 0.6))


def needles(directions, random):
    radii = numpy.ones(len(directions))
    chosen = random.choice(len(directions), max(1, len(directions) // 40), replace=False)
    radii[chosen] = random.uniform(3.0, 20.0, len(chosen))
    return radii


def spiral(directions, random):
    angle = numpy.arctan2(directions[:, 1], directions[:, 0])
    return 1.0 + 0.7 * numpy.sin(3.0 * angle + random.uniform(4.0, 12.0) * directions[:, 2])


def star_polyhedron(directions, random):
    axes = directions_evenly(12, random)
    return 0.3 + 2.0 * numpy.maximum((directions @ axes.T).max(axis=1) - 0.75, 0.0) / 0.25


def polycube(directions, random):
    """A cross of three boxes around the origin."""
    sides = random.uniform(0.15, 0.5, (3, 3))
    sides[numpy.arange(3), numpy.arange(3)] = 1.0
    return (1.0 / (abs(directions)[:, None, :] / sides[None]).max(axis=2)).max(axis=1)


def sphere(directions, random):
    return numpy.ones(len(directions))


TARGETS = (random_star, needles, spiral, star_polyhedron, polycube, sphere)


def bent(places, angle):
    """Along an arc of the given angle, or a smaller one where the solid is too thick for it."""
    x, y, z = places.T
    radius = max(numpy.ptp(z) / angle, 1.1 * abs(x).max())
    return numpy.stack([(radius + x) * numpy.cos(z / radius), y, (radius + x) * numpy.sin(z / radius)], axis=1)


def coiled(places, angle):
    """Bent, and sheared along the axis of the arc."""
    curved = bent(places, angle)
    curved[:, 1] += 0.5 * numpy.ptp(curved[:, 0]) * numpy.arctan2(curved[:, 2], curved[:, 0])
    return curved


def bent_twice(places, angle):
    """In two planes, one after the other."""
    x, y, z = bent(places, angle).T
    return bent(numpy.stack([y, x.mean() - x, z], axis=1), 0.5 * angle)


MOTIONS = (bent, coiled, bent_twice)


def moved(images, triangles, motion, random):
    """A star-shaped surface, stretched and moved by as much as keeps its triangles from crossing."""
    long = images * [1.0, 1.0, random.uniform(2.0, 6.0)]
    angle = random.uniform(3.0, 5.0)
    while True:
        places = motion(long, angle)
        corners = places[triangles]
        volume = numpy.linalg.det(corners - places.mean(axis=0)).sum()
        solid = shapemap.vtkShapeTetrahedralize()
        solid.SetInputDataObject(off.surface(places, triangles.tolist()))
        solid.SetMaximumRadiusEdgeRatio(0.0)
        if volume > 0.0 and not shapetesting.run(solid):
            return places
        angle *= 0.8
        assert angle > 0.1, motion.__name__


def source(number, random, is_bent):
    """The name of a surface, itself, and its points' directions."""
    kind = number % 4
    if kind == 0:
        directions = directions_evenly(int(random.integers(7, 15)), random)
        return 'polyhedron', None, directions
    if kind < 3 or is_bent:
        count = int(10.0**random.uniform(1.5, 3.5))
        return 'ball', None, directions_evenly(count, random)
    name = MODELS[(number // 4) % len(MODELS)]
    parameterize = shapemap.vtkShapeParameterize()
    parameterize.SetInputDataObject(off.read(os.path.join(
        os.environ.get('SHAPEMAP_MODELS', os.path.join(sweep.BUILD, 'models')), name + '.off')))
    messages = shapetesting.run(parameterize)
    assert not messages, messages
    surface = parameterize.GetOutputDataObject(0)
    return name, surface, array(surface, 'TargetPosition')


def case(number, seed, is_bent):
    """A name, the solid at rest, where its points are put, and which are on its boundary. At least two
    tetrahedra are inverted."""
    random = numpy.random.default_rng([seed, number])
    while True:
        name, rest, places, fixed = one(number, random, is_bent)
        if count_not_positive(places, corners_of(rest)) >= 2:
            return name, rest, places, fixed


def one(number, random, is_bent):
    name, surface, directions = source(number, random, is_bent)
    if surface is None:
        surface = convex_hull(directions)
        directions = points(surface)
    triangles = shapetesting.triangles(surface)
    target = TARGETS[(number // 4) % len(TARGETS)]
    if target is sphere and name in ('polyhedron', 'ball'):
        target = random_star
    if target is spiral:
        directions = swirled(directions, triangles, random.uniform(1.0, 4.0))
    assert positive(directions, triangles), name
    solid = shapemap.vtkShapeTetrahedralize()
    solid.SetInputDataObject(surface)
    if name == 'polyhedron':
        solid.SetMaximumRadiusEdgeRatio(0.0)
    messages = shapetesting.run(solid)
    assert not messages, messages
    rest = solid.GetOutputDataObject(0)
    ids = array(rest, 'OriginalPointId')
    fixed = ids >= 0
    places = points(rest).astype(float)
    images = directions * target(directions, random)[:, None]
    what = target.__name__
    if is_bent:
        motion = MOTIONS[number // 4 // len(TARGETS) % len(MOTIONS)]
        images, what = moved(images, triangles, motion, random), what + ' ' + motion.__name__
    places[fixed] = images[ids[fixed]]
    return name + ' ' + what, rest, places, fixed


def corners_of(solid):
    return vtk_to_numpy(solid.GetCells().GetConnectivityArray()).reshape(-1, 4)


def boundary_of(corners):
    """The boundary triangles of tetrahedra, facing outwards."""
    faces = corners[:, [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]].reshape(-1, 3)
    _, first, count = numpy.unique(numpy.sort(faces, axis=1), axis=0, return_index=True, return_counts=True)
    return faces[first[count == 1]]


def count_not_positive(places, corners):
    """In rational arithmetic where the determinant in double is not certain."""
    a, b, c = (places[corners[:, k]] - places[corners[:, 0]] for k in (1, 2, 3))
    terms = numpy.einsum('ij,ij->i', numpy.cross(a, b), c)
    bound = 1e-14 * numpy.prod([abs(e).max(axis=1) for e in (a, b, c)], axis=0)
    count = int((terms < -bound).sum())
    for cell in numpy.where(abs(terms) <= bound)[0]:
        p = [[fractions.Fraction(x) for x in places[corner].tolist()] for corner in corners[cell]]
        (a, b, c), (d, e, f), (g, h, i) = ([x - y for x, y in zip(q, p[0])] for q in p[1:])
        count += a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g) <= 0
    return count


def is_star_shaped(places, triangles):
    """Whether a position is on the inner side of all triangles, by more than rounding."""
    a, b, c = (places[triangles[:, k]] for k in range(3))
    normals = numpy.cross(b - a, c - a)
    normals /= numpy.linalg.norm(normals, axis=1)[:, None]
    rows = numpy.hstack([normals, numpy.ones((len(normals), 1))])
    result = scipy.optimize.linprog([0, 0, 0, -1], rows, (normals * a).sum(axis=1), bounds=(None, None))
    return result.status == 0 and result.x[3] > 1e-9 * numpy.ptp(places)


def untangled(rest, places):
    """The output, its seconds, and the longest time without a report of progress."""
    untangle = shapemap.vtkShapeUntangle()
    untangle.SetInputDataObject(0, at(rest, places))
    untangle.SetInputDataObject(1, rest)
    times = [time.time()]
    untangle.AddObserver('ProgressEvent', lambda *_: times.append(time.time()))
    messages = shapetesting.run(untangle)
    times.append(time.time())
    assert not messages, messages
    return untangle.GetOutputDataObject(0), times[-1] - times[0], numpy.diff(times).max()


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--count', type=int, default=200)
    parser.add_argument('--seed', type=int, default=1)
    parser.add_argument('--bent', action='store_true', help='targets that are not star-shaped')
    parser.add_argument('--keep', help='a folder for the inputs')
    parser.add_argument('words', nargs='*', metavar='CASE')
    options = parser.parse_args()
    claims, left, proven = sweep.Claims(), [], []
    slowest, pause = 0.0, 0.0
    table = sweep.Table('case:5d', 'what:<38', *(key + ':8d' for key in (
        'cells', 'before', 'after', 'split', 'added')), 'star:4d', 'seconds:8.2f', 'pause:6.2f')
    numbers = [int(word) for word in options.words] or range(options.count)
    for number in numbers:
        name, rest, places, fixed = case(number, options.seed, options.bent)
        if options.keep:
            numpy.savez(os.path.join(options.keep, '%d.npz' % number), rest=points(rest),
                        places=places, corners=corners_of(rest))
        boundary = boundary_of(corners_of(rest))
        result, seconds, longest = untangled(rest, places)
        after = points(result)
        wrong = count_not_positive(after, corners_of(result))
        assert (after[:len(places)][fixed] == places[fixed]).all(), 'the boundary moved'
        assert wrong == int(fact(result, 'Untangle.InvertedAfter')), (number, wrong)
        table.print(dict(
            case=number, what=name, cells=rest.GetNumberOfCells(),
            before=int(fact(result, 'Untangle.InvertedBefore')), after=wrong,
            split=int(fact(result, 'Untangle.SplitCells')),
            star=is_star_shaped(places, boundary), added=result.GetNumberOfCells() - rest.GetNumberOfCells(), seconds=seconds, pause=longest))
        slowest, pause = max(slowest, seconds), max(pause, longest)
        if wrong:
            reason = str(fact(result, 'Untangle.Reason'))
            print('     ', reason)
            crosses = 'crosses itself' in reason
            (proven if crosses else left).append('%d (%s)' % (number, name))
    print('%d valid, %d with a proven reason: %s' % (
        len(numbers) - len(left) - len(proven), len(proven), ', '.join(proven)))
    claims.none('%d boundary maps' % len(numbers), 'with inverted tetrahedra left', left)
    claims.at_most('slowest', 'seconds', slowest, SECONDS)
    claims.at_most('longest time without progress', 'seconds', pause, PAUSE)
    claims.finish()


if __name__ == '__main__':
    main()
