"""Pictures of single predictions and their mean: a point relative to the samples of a curve, one after the
other, in a sum and in the integral; and the image of a point in an exponential map. Needs Debian's python3-scipy."""
import time

import numpy
from scipy.spatial import ConvexHull

import composition_common as common
import scenes  # knows where off.py is

import off
from composition_common import deform, handle
from composition_maps import irregular, patch
from composition_poisson import angle_weighted
from composition_rows import HANDLE, Row
from scenes import array, points
from shapetesting import triangles

GREEN, RED, INK = [0.05, 0.55, 0.20], [0.85, 0.10, 0.12], [0.15, 0.17, 0.20]
PLAN = [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]


def lines(*curves):
    """Polylines through these positions."""
    first = numpy.cumsum([0] + [len(curve) for curve in curves])
    data = off.surface(numpy.concatenate(curves), [])
    data.SetLines(off.surface(points(data), [list(range(a, b)) for a, b in zip(first, first[1:])]).GetPolys())
    return data


# Figure 3: in the plane, where a frame is an angle.

REST = numpy.array([[-1.0, 0.0], [-0.5, 0.0], [0.0, 0.0], [0.5, 0.0], [1.0, 0.0]])
MOVED = numpy.array([[-0.95, -0.35], [-0.6, 0.0], [0.0, 0.22], [0.55, 0.0], [0.8, -0.45]])


def tangent_angles(curve):
    """The directions from the point before to the point after each one."""
    around = numpy.concatenate([curve[:1], curve, curve[-1:]])
    return numpy.arctan2(*(around[2:] - around[:-2]).T[::-1])


def turn(angles):
    cosines, sines = numpy.cos(angles), numpy.sin(angles)
    return numpy.stack([numpy.stack([cosines, -sines], -1), numpy.stack([sines, cosines], -1)], -2)


def sampled(count):
    """So many samples at equal distances on REST: their positions, where they go, and their frames, both
    linear in between; and the length that each represents."""
    lengths = numpy.append(0.0, numpy.linalg.norm(numpy.diff(REST, axis=0), axis=1).cumsum())
    wanted = numpy.linspace(0.0, lengths[-1], count)
    turns = turn(tangent_angles(MOVED) - tangent_angles(REST))
    rest, moved, frames = [numpy.stack([numpy.interp(wanted, lengths, column) for column in values.reshape(
        len(REST), -1).T], axis=-1) for values in (REST, MOVED, turns)]
    shares = numpy.full(count, lengths[-1] / (count - 1))
    shares[[0, -1]] *= 0.5
    return rest, moved, frames.reshape(-1, 2, 2), shares


def predictions(places, count):
    """Equation 1: where each sample says that a point is; and its weights of equation 4, k = 2."""
    rest, moved, frames, shares = sampled(count)
    ways = places[:, None] - rest[None]
    weights = shares / (ways ** 2).sum(axis=2)
    return moved + numpy.einsum('jkl,ijl->ijk', frames, ways), weights / weights.sum(axis=1, keepdims=True)


def summed(places, count):
    """Equation 5."""
    there, weights = predictions(places, count)
    return numpy.einsum('ij,ijk->ik', weights, there)


def in_space(places):
    return numpy.column_stack([places, numpy.zeros(len(places))])


def integrated(places):
    """Equation 2 for k = 2, by Shape Deform; the normals of the curve lie in the plane."""
    normals = [in_space(numpy.column_stack([-numpy.sin(angles), numpy.cos(angles)]))
               for angles in (tangent_angles(REST), tangent_angles(MOVED))]
    curve = handle(in_space(REST), in_space(MOVED), *normals, closed=False)
    return points(deform(lines(in_space(places)), curve, Method=common.BOUNDARY_RELATIVE, IntegrateCurves=True,
                         Multiresolution=common.OFF))[:, :2]


def fig3(folder, claims):
    row = Row(3, height=0.8, foot=0.02)
    view = ([0.0, 0.15, 0.0], 2.6, *PLAN)
    point = numpy.array([[0.15, 0.55]])
    for panel, curve, place in ((0, REST, point), (1, MOVED, summed(point, 9))):
        rest, moved, frames, _ = sampled(9)
        there, weights = predictions(point, 9)
        samples, ends = (rest, numpy.repeat(point, 9, axis=0)) if panel == 0 else (moved, there[0])
        row.tube(panel, lines(in_space(curve)), *view, width=0.006, colour=INK)
        for k in range(9):
            row.tube(panel, lines(in_space(numpy.array([samples[k], ends[k]]))), *view,
                     width=0.0025 if panel == 0 else 0.0015 + 0.008 * weights[0, k], colour=HANDLE)
            axes = numpy.eye(2) if panel == 0 else frames[k]
            for axis in axes.T:
                row.tube(panel, lines(in_space(numpy.array([samples[k], samples[k] + 0.09 * axis]))), *view,
                         width=0.0025, colour=RED)
        if panel == 1:
            row.dots(panel, in_space(ends), view, 0.007, HANDLE)
        row.dots(panel, in_space(place), view, 0.013, GREEN)
    row.caption(0, 'a point relative to samples\nwith frames', 15)
    row.caption(1, 'predictions of the moved samples,\nand their weighted mean (green)', 15)
    across = numpy.linspace(-1.1, 1.1, 600)
    places = numpy.column_stack([across, numpy.full(600, 0.05)])
    exact = integrated(places)
    errors = {count: numpy.linalg.norm(summed(places, count) - exact, axis=1).max() for count in (20, 200, 2000)}
    row.tube(2, lines(in_space(MOVED)), *view, width=0.006, colour=INK)
    row.tube(2, lines(in_space(summed(places, 20))), *view, width=0.008, colour=RED)
    row.tube(2, lines(in_space(exact) + [0.0, 0.0, 0.1]), *view, width=0.003, colour=GREEN)
    row.caption(2, 'a line: the integral (green),\nand the sum over 20 samples (red)', 15)
    claims.note(3, 'sum over 20, 200 and 2000 samples, off the closed form at most, of the length',
                ', '.join('%.1e' % (0.5 * error) for error in errors.values()))
    claims.check(3, '2000 samples, off the closed form', '%.1e' % (0.5 * errors[2000]), 0.5 * errors[2000] < 1e-4,
                 '< 1e-4 of the length')
    claims.check(3, 'ten times as many samples: error falls by', '%.0f times' % (errors[200] / errors[2000]),
                 errors[200] > 30.0 * errors[2000], '> 30 times')
    row.save(folder, 3)


# Figure 10.

def rough_sphere(count, random):
    """Irregularly placed points on the unit sphere, and their triangles."""
    row = numpy.arange(count) + 0.5
    z, angle = 1.0 - 2.0 * row / count, numpy.pi * (1.0 + numpy.sqrt(5.0)) * row
    places = numpy.column_stack([numpy.sqrt(1.0 - z ** 2) * numpy.cos(angle), numpy.sqrt(1.0 - z ** 2) * numpy.sin(angle), z])
    places += 0.35 * numpy.sqrt(4.0 * numpy.pi / count) * random.uniform(-1.0, 1.0, places.shape)
    places /= numpy.linalg.norm(places, axis=1, keepdims=True)
    faces = ConvexHull(places).simplices
    corners = places[faces]
    inward = numpy.linalg.det(corners) < 0.0
    faces[inward] = faces[inward][:, ::-1]
    return off.surface(places, faces.tolist())


def exact_map(places, seed, normal, axis):
    """The exponential map of the unit sphere."""
    second = numpy.cross(normal, axis)
    flat = numpy.stack([places @ axis, places @ second], axis=1)
    length = numpy.maximum(numpy.linalg.norm(flat, axis=1, keepdims=True), 1e-300)
    return numpy.arctan2(length[:, 0], places @ normal)[:, None] * flat / length


def estimates(laid, point, normals):
    """Equation 10: what each upwind neighbour says of the image of a point; the neighbours, and the weights
    of equation 4. The first is the neighbour from which the front came."""
    places, images = points(laid), array(laid, 'TargetPosition')[:, :2].astype(float)
    away = array(laid, 'GeodesicDistance').astype(float)
    faces = triangles(laid)
    around = numpy.setdiff1d(faces[(faces == point).any(axis=1)], point)
    around = around[away[around] < away[point]]
    ways = places[point] - places[around]
    around = around[numpy.argsort(away[around] + numpy.linalg.norm(ways, axis=1))]
    ways = places[point] - places[around]
    seed, axis = (common.facts_of(laid, 'ExponentialMap.' + name) for name in ('SeedNormal', 'XAxis'))
    found = []
    for q, way in zip(around, ways):
        normal = normals[q]
        flat = way - (way @ normal) * normal
        flat *= numpy.linalg.norm(way) / numpy.linalg.norm(flat)
        # The smallest rotation from the seed's normal carries its axes here.
        across = numpy.cross(seed, normal)
        bend = numpy.degrees(numpy.arctan2(numpy.linalg.norm(across), seed @ normal))
        turned = common.turn(across, bend) if bend > 1e-9 else numpy.eye(3)
        found.append(images[q] + [flat @ turned @ axis, flat @ turned @ numpy.cross(seed, axis)])
    weights = 1.0 / (ways ** 2).sum(axis=1)
    return numpy.array(found), around, weights / weights.sum()


def seconds(surface, seeds, radius):
    """CPU seconds of all seeds without and with averaging, the minimum of alternating runs."""
    found = {False: [], True: []}
    filters = {}
    for average in found:
        filters[average] = scenes.shapemap.vtkShapeExponentialMap()
        filters[average].SetInputDataObject(0, surface)
        filters[average].SetRadius(radius)
        filters[average].SetUpwindAverage(average)
        scenes.checked(filters[average])
    for _ in range(5):
        for average in found:
            begin = time.process_time()
            for seed in seeds:
                filters[average].SetSeed(*seed)
                filters[average].Update()
            found[average].append(time.process_time() - begin)
    return min(found[False]), min(found[True])


def fig10(folder, claims):
    sphere = rough_sphere(1500, numpy.random.RandomState(10))
    errors = {}
    for average in (False, True):
        laid = patch(sphere, [0.0, 0.0, 1.0], 1.3, UpwindAverage=average, NormalSmoothing=0)
        seed, normal, axis = (common.facts_of(laid, 'ExponentialMap.' + name) for name in ('Seed', 'SeedNormal', 'XAxis'))
        exact = exact_map(points(laid), seed, normal, axis)
        errors[average] = numpy.linalg.norm(array(laid, 'TargetPosition')[:, :2] - exact, axis=1)
        claims.note(10, ('mean of several' if average else 'one neighbour') +
                    ': off the exact map of the sphere, mean and largest', '%.4f, %.4f' % (
                        errors[average].mean(), errors[average].max()))
    claims.check(10, 'mean of several, error against that of one neighbour', '%.2f times' % (
        errors[True].mean() / errors[False].mean()), errors[True].mean() < 0.6 * errors[False].mean(), '< 0.6')
    images = array(laid, 'TargetPosition')[:, :2].astype(float)
    normals = angle_weighted(points(laid), triangles(laid))
    away = array(laid, 'GeodesicDistance')
    single, mean = [], []
    every = {}
    for point in numpy.flatnonzero((away > 0.5) & (away < 1.1)):
        found, around, weights = estimates(laid, point, normals)
        if len(found) > 1:
            single.append(numpy.linalg.norm(found - exact[point], axis=1).mean())
            mean.append(numpy.linalg.norm(weights @ found - exact[point]))
            every[point] = found, around, weights
    claims.check(10, 'eq. 10 and 11 written out: mean error of one estimate, and of their mean', '%.4f, %.4f' % (
        numpy.mean(single), numpy.mean(mean)), numpy.mean(mean) < numpy.mean(single), 'less')
    # The point whose estimates differ most, of those with four.
    four = [point for point in every if len(every[point][0]) == 4]
    point = max(four, key=lambda each: numpy.ptp(every[each][0], axis=0).max())
    found, around, weights = every[point]
    row = Row(3, height=0.9, foot=0.1)
    view = (numpy.append(images[point] * 0.93, 0.0), 0.42, *PLAN)
    flat = common.at(laid, in_space(images) - [0.0, 0.0, 0.05])
    front = away[triangles(laid)].max(axis=1) < away[point] + 1e-9
    for panel, shown in ((0, found[:1]), (1, found), (2, found)):
        display = row.show(panel, common.cells_of(flat, front), *view, [0.90, 0.92, 0.94],
                           representation='Surface With Edges', width=1.0)
        display.EdgeColor, display.Ambient = [0.60, 0.65, 0.70], 0.4
        for q, estimate in zip(around, shown):
            row.tube(panel, lines(in_space(numpy.array([images[q], estimate]))), *view, width=0.004, colour=HANDLE)
            row.dots(panel, in_space(images[[q]]), view, 0.012, HANDLE)
        row.dots(panel, in_space(shown) + [0.0, 0.0, 0.02], view, 0.012, RED if panel < 2 else [0.95, 0.65, 0.60])
    row.dots(2, in_space((weights @ found)[None]) + [0.0, 0.0, 0.04], view, 0.012, RED)
    row.dots(2, in_space(exact[[point]]) + [0.0, 0.0, 0.06], view, 0.008, GREEN)
    off_by = numpy.linalg.norm(found - exact[point], axis=1)
    row.caption(0, 'the estimate of one upwind neighbour:\noff by %.4f' % off_by[0], 15)
    row.caption(1, 'those of all upwind neighbours:\noff by %.4f to %.4f' % (off_by.min(), off_by.max()), 15)
    row.caption(2, 'their weighted mean: off by %.4f' % numpy.linalg.norm(weights @ found - exact[point]), 15)
    row.footnote('blue: neighbours that the front has met; red: estimates; green: the exact image, on a sphere')
    bunny = irregular(common.model('bunny00'), 0.2, numpy.random.RandomState(11))
    seeds = points(bunny)[::bunny.GetNumberOfPoints() // 40]
    one, several = seconds(bunny, seeds, 0.2 * common.diagonal(bunny))
    claims.note(10, 'CPU time of patches on the bunny, averaging against one neighbour', '%+.0f %%' % (
        100.0 * (several / one - 1.0)))
    row.save(folder, 10)
