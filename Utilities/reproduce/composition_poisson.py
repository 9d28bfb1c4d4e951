"""A picture of one ear, with long and thin triangles at its base, joined to a bunny by the upwind
front and by Poisson mesh merging (Yu et al., "Mesh editing with Poisson-based gradient field
manipulation", 2004), which is written out here. Needs Debian's python3-scipy."""
import numpy
from scipy.sparse import coo_matrix
from scipy.sparse.linalg import splu

import composition_common as common
import panels
import scenes  # knows where off.py is

import off
from composition_common import cut, facing
from composition_rows import Row
from composition_soups import EAR, around_ear
from scenes import points
from shapetesting import closed_curve, triangles


def stitched(first, second):
    """Triangles between two closed curves that run alike: the shorter of both diagonals each time. The
    numbers of the second curve follow those of the first."""
    start = numpy.linalg.norm(second - first[0], axis=1).argmin()
    faces, i, j = [], 0, 0
    while i < len(first) or j < len(second):
        a, b = i % len(first), (start + j) % len(second)
        next_a, next_b = (i + 1) % len(first), (start + j + 1) % len(second)
        forward = numpy.linalg.norm(first[next_a] - second[b]) < numpy.linalg.norm(first[a] - second[next_b])
        if j == len(second) or (i < len(first) and forward):
            faces.append([next_a, a, len(first) + b])
            i += 1
        else:
            faces.append([a, len(first) + b, len(first) + next_b])
            j += 1
    return numpy.array(faces)


def thin_ear(head, count=180):
    """The ear of a head, and around it triangles from its loop to a wider one."""
    ear = cut(head, around_ear(head, 4.8), FillHole=False)[0]
    ids, inner = common.rim(ear)
    outer = points(common.outline(head, EAR, [1.0, 0.0, 0.0], [0.0, 0.0, 1.0], 7.0, count))
    # Of both directions, the one in which the next point of the curve is nearer to the next of the rim.
    start = numpy.linalg.norm(outer - inner[0], axis=1).argmin()
    quarter = inner[len(inner) // 4]
    steps = [numpy.linalg.norm(outer[(start + way * count // 4) % count] - quarter) for way in (1, -1)]
    outer = outer if steps[0] < steps[1] else outer[::-1]
    number = numpy.concatenate([ids, ear.GetNumberOfPoints() + numpy.arange(count)])
    faces = numpy.concatenate([triangles(ear), number[stitched(inner, outer)]])
    return off.surface(numpy.concatenate([points(ear), outer]), faces.tolist())


def angle_weighted(places, faces):
    """The normals of points: of their triangles, weighted by the angles there."""
    corners = places[faces]
    normals = numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= numpy.maximum(numpy.linalg.norm(normals, axis=1, keepdims=True), 1e-300)
    sums = numpy.zeros_like(places)
    for k in range(3):
        a, b = (corners[:, (k + step) % 3] - corners[:, k] for step in (1, 2))
        angles = numpy.arctan2(numpy.linalg.norm(numpy.cross(a, b), axis=1), (a * b).sum(axis=1))
        numpy.add.at(sums, faces[:, k], angles[:, None] * normals)
    return sums / numpy.maximum(numpy.linalg.norm(sums, axis=1, keepdims=True), 1e-300)


def frames(loop, normals):
    """Of each point of a closed curve: its tangent, across it, and the normal (columns)."""
    tangents = numpy.roll(loop, -1, axis=0) - numpy.roll(loop, 1, axis=0)
    tangents /= numpy.linalg.norm(tangents, axis=1, keepdims=True)
    across = numpy.cross(normals, tangents)
    across /= numpy.linalg.norm(across, axis=1, keepdims=True)
    return numpy.stack([tangents, across, numpy.cross(tangents, across)], axis=2)


def nearest_rotations(matrices):
    u, _, v = numpy.linalg.svd(matrices)
    u[:, :, 2] *= numpy.sign(numpy.linalg.det(u @ v))[:, None]
    return u @ v


def poisson_merged(places, faces, ids, targets, turns, scales, power):
    """The surface whose boundary points `ids` lie at `targets` and whose gradients are nearest to the
    given ones, rotated by `turns` and scaled: both spread inwards from the boundary points by this
    power of the inverse distance from them."""
    weights = (((places[:, None] - places[ids][None]) ** 2).sum(axis=2) + 1e-12) ** (-0.5 * power)
    weights /= weights.sum(axis=1, keepdims=True)
    spread = nearest_rotations(numpy.einsum('ij,jkl->ikl', weights, turns))
    of_faces = nearest_rotations(spread[faces].mean(axis=1)) * (weights @ scales)[faces].mean(axis=1)[:, None, None]
    right, rows, columns, entries = numpy.zeros_like(places), [], [], []
    for k in range(3):
        a, b, c = (faces[:, (k + step) % 3] for step in range(3))
        one, two = places[b] - places[a], places[c] - places[a]
        # The cotangent at a, of the edge from b to c.
        weight = 0.5 * (one * two).sum(axis=1) / numpy.maximum(
            numpy.linalg.norm(numpy.cross(one, two), axis=1), 1e-300)
        wanted = weight[:, None] * numpy.einsum('ijk,ik->ij', of_faces, places[b] - places[c])
        numpy.add.at(right, b, wanted)
        numpy.add.at(right, c, -wanted)
        rows += [b, c, b, c]
        columns += [b, c, c, b]
        entries += [weight, weight, -weight, -weight]
    count = len(places)
    matrix = coo_matrix((numpy.concatenate(entries), (numpy.concatenate(rows), numpy.concatenate(columns))),
                        shape=(count, count)).tocsc()
    free = numpy.setdiff1d(numpy.arange(count), ids)
    moved = numpy.array(places)
    moved[ids] = targets
    moved[free] = splu(matrix[free][:, free]).solve(right[free] - matrix[free][:, ids] @ targets)
    return moved


def deviations(places, feature_faces, other_faces, ids):
    """The angles between the normals of both sides of the join, in degrees."""
    sides = [angle_weighted(places, faces)[ids] for faces in (feature_faces, other_faces)]
    return numpy.degrees(numpy.arccos(numpy.clip((sides[0] * sides[1]).sum(axis=1), -1.0, 1.0)))


def bends(places, faces):
    """The angle between the triangles at each inner edge, in degrees; edges are ordered by their ends."""
    sides = numpy.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    order = numpy.lexsort(numpy.sort(sides, axis=1).T)
    low = numpy.sort(sides, axis=1)[order]
    first = numpy.flatnonzero((low[1:] == low[:-1]).all(axis=1))
    corners = places[faces]
    normals = numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= numpy.maximum(numpy.linalg.norm(normals, axis=1, keepdims=True), 1e-300)
    one, two = (normals[order[first + step] % len(faces)] for step in (0, 1))
    return numpy.degrees(numpy.arccos(numpy.clip((one * two).sum(axis=1), -1.0, 1.0)))


def fig14abc(folder, claims):
    bunny, ear = common.model('bunny00'), thin_ear(common.model('mannequin-devil'))
    places, faces = points(ear), triangles(ear)
    loop = numpy.array(common.longest_loop(faces))
    ours = facing(ear, bunny, [0.2, 0.1, 0.3], numpy.array([0.0, 0.0, 1.0]), numpy.array([0.0, 1.0, 0.0]),
                  Scale=0.03)
    part = scenes.vtk_to_numpy(ours.GetCellData().GetArray('Part'))
    number = common.pasted_points(ours)[:len(places)]
    everything, other_faces = triangles(ours), triangles(ours)[part != 2]
    at_join = number[loop]
    # The hole, with its loop and the normals there, is that of our result.
    targets = points(ours)[at_join]
    turns = frames(targets, angle_weighted(points(ours), other_faces)[at_join]) @ frames(
        places[loop], angle_weighted(places, faces)[loop]).transpose(0, 2, 1)
    scales = [numpy.linalg.norm(p - numpy.roll(p, 1, axis=0), axis=1) for p in (targets, places[loop])]
    # Of several ways to spread rotations, the one that is smoothest at the join.
    peers = {}
    for power in (1, 2, 4, 8):
        moved = numpy.array(points(ours))
        moved[number] = poisson_merged(places, faces, loop, targets, turns, scales[0] / scales[1], power)
        across = deviations(moved, everything[part == 2], other_faces, at_join)
        peers[numpy.percentile(across, 95)] = power, common.at(ours, moved)
    power, peer = peers[min(peers)]
    claims.note('14 a-c', 'Poisson: the best of the powers 1, 2, 4 and 8 of the inverse distance', '%d' % power)
    thin = numpy.linalg.norm(numpy.diff(places[faces[:, [0, 1, 2, 0]]], axis=1), axis=2)
    claims.note('14 a-c', 'the ear: points; triangles, of which longer than six times their shortest edge',
                '%d; %d, %d' % (len(places), len(faces), (thin.max(axis=1) > 6.0 * thin.min(axis=1)).sum()))
    angles, before = {}, bends(places, faces)
    for name, surface in (('upwind front', ours), ('Poisson', peer)):
        changes = numpy.abs(bends(points(surface)[number], faces) - before)
        claims.note('14 a-c', name + ': angles between triangles of the ear change by, mean and 99 %',
                    '%.2f, %.1f degrees' % (changes.mean(), numpy.percentile(changes, 99)))
        angles[name] = deviations(points(surface), everything[part == 2], other_faces, at_join)
        claims.note('14 a-c', name + ': normals across the join, median, 95 % and largest',
                    '%.2f, %.2f, %.2f degrees' % tuple(numpy.percentile(angles[name], [50, 95, 100])))
    for share, name in ((50, 'median'), (95, '95 %')):
        mine, its = (numpy.percentile(angles[key], share) for key in ('upwind front', 'Poisson'))
        claims.check('14 a-c', 'normals across the join, %s, of that of Poisson merging' % name, '%.2f times' %
                     (mine / its), mine < its, '< 1')
    row = Row(4, height=1.0, foot=0.02)
    ear_view = (points(ear).mean(axis=0), 17.0, [1.0, -0.5, 0.3], [0.0, 0.0, 1.0])
    view = ([0.12, 0.03, 0.0], 1.4, [0.1, 0.3, 1.0], [0.0, 1.0, 0.0])
    display = row.show(0, ear, *ear_view, [0.9, 0.85, 0.8], representation='Surface With Edges', width=0.5)
    display.EdgeColor = [0.35, 0.40, 0.48]
    row.caption(0, 'an ear on thin triangles', 15)
    close = (targets.mean(axis=0), 0.6, [0.6, 0.5, 1.0], [0.0, 1.0, 0.0])
    row.show(1, ours, *view, panels.STEEL)
    row.tube(1, closed_curve(targets), *view, width=0.002)
    row.caption(1, 'joined by the upwind front', 15)
    for panel, name, surface in ((2, 'upwind front', ours), (3, 'Poisson', peer)):
        row.show(panel, surface, *close, panels.STEEL)
        row.caption(panel, '%s: %.1f degrees\nacross the join, 95 %%' % (name, numpy.percentile(angles[name], 95)), 15)
    row.save(folder, '14abc')
