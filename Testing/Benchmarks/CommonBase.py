"""Maps of CommonBase between models and their twisted copies, and between two meshes of one shape: no
triangle is flipped, landmarks and curves are exact, and both directions have a small energy. For genus
0 the symmetric Dirichlet energy is compared with that of CommonSphere. The parameters of the method
were chosen on the first ten pairs.
Run with Utilities/pvpython.sh Testing/Benchmarks/CommonBase.py MODELS, the folder of the models."""
import heapq
import os
import sys
import time
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
import shapemap

# Genus, file or shape, landmarks, angle of the twist, curves between landmarks.
PAIRS = [
    (0, 'dragknob.off', 6, 0.6, 0), (0, 'oblong.off', 5, 0.8, 0), (0, 'larger_sphere.off', 8, 0.8, 0),
    (0, 'itemb.off', 6, 0.6, 0), (0, 'ellipsoid.off', 4, 0.6, 0),
    (1, 'rotor.off', 6, 0.4, 0), (1, 'pinion.off', 6, 0.4, 0), (2, 'joint.off', 8, 0.4, 0),
    (3, 'elephant.off', 12, 0.4, 0), (0, 'spool.off', 6, 0.5, 4),
    (0, 'cow.off', 10, 0.4, 2), (0, 'hand.off', 7, 0.4, 2), (0, 'handle.off', 5, 0.5, 1),
    (0, 'cube-meshed.off', 8, 0.5, 3), (1, 'elk.off', 8, 0.4, 2), (1, 'pipe.off', 4, 0.3, 1),
    (2, 'eight.off', 8, 0.4, 2), (3, 'helmet.off', 10, 0.3, 3), (1, 'torus', 4, 0.0, 2),
    (3, 'plate', 10, 0.3, 4)]


def read(path):
    with open(path, encoding='ascii') as file:
        words = ' '.join(line.split('#')[0] for line in file).split()
    count, faces = int(words[1]), int(words[2])
    places = numpy.array(words[4:4 + 3 * count], float).reshape(count, 3)
    return places, numpy.array(words[4 + 3 * count:][:4 * faces], int).reshape(faces, 4)[:, 1:]


def surface(places, triangles):
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    data.GetPoints().SetData(numpy_to_vtk(numpy.ascontiguousarray(places, float), deep=True))
    cells = vtkCellArray()
    offsets = numpy.arange(0, 3 * len(triangles) + 1, 3)
    cells.SetData(numpy_to_vtkIdTypeArray(offsets.astype(numpy.int64), deep=True),
                  numpy_to_vtkIdTypeArray(triangles.astype(numpy.int64).ravel(), deep=True))
    data.SetPolys(cells)
    return data


def energy(places, images, triangles):
    """The symmetric Dirichlet energy, divided by the area; both areas are 1."""
    def edges(points):
        a, b, c = (points[triangles[:, k]] for k in range(3))
        return numpy.stack([b - a, c - a], axis=2)
    forms = []
    for points in (places, images):
        sides = edges(points)
        form = numpy.einsum('tik,til->tkl', sides, sides)
        areas = 0.5 * numpy.sqrt(numpy.maximum(numpy.linalg.det(form), 0))
        forms.append((form / areas.sum(), areas / areas.sum()))
    (one, weights), (other, _) = forms
    return (weights * (numpy.trace(numpy.linalg.solve(one, other), axis1=1, axis2=2) + numpy.trace(
        numpy.linalg.solve(other, one), axis1=1, axis2=2))).sum()


def plate(holes, cells):
    """The surface of a plate of cubes with a row of square holes, and the rims of its first hole and of
    its outside, above and below, as closed lists of points."""
    shape = ((2 * holes + 1) * cells, 3 * cells, cells)
    solid = numpy.ones(shape, bool)
    for hole in range(holes):
        solid[(2 * hole + 1) * cells:(2 * hole + 2) * cells, cells:2 * cells] = False
    padded = numpy.pad(solid, 1)
    index, triangles = {}, []
    for cell in numpy.argwhere(solid):
        for axis in range(3):
            for side in (0, 1):
                beside = cell + 1
                beside[axis] += 2 * side - 1
                if padded[tuple(beside)]:
                    continue
                corners = numpy.tile(cell, (4, 1))
                corners[:, axis] += side
                corners[1:3, (axis + 1) % 3] += 1
                corners[2:, (axis + 2) % 3] += 1
                quad = [index.setdefault(tuple(corner), len(index)) for corner in corners]
                quad = quad if side else quad[::-1]
                triangles += [quad[:3], [quad[0], quad[2], quad[3]]]
    places = numpy.array(list(index), float)

    def rim(x, y, z):
        (left, right), (low, high) = numpy.array(x) * cells, numpy.array(y) * cells
        loop = ([(i, low) for i in range(left, right)] + [(right, j) for j in range(low, high)] +
                [(i, high) for i in range(right, left, -1)] + [(left, j) for j in range(high, low - 1, -1)])
        return [index[i, j, z * cells] for i, j in loop]
    rims = [rim(x, y, z) for z in (0, 1) for x, y in (((0, 2 * holes + 1), (0, 3)), ((1, 2), (1, 2)))]
    return places / cells, numpy.array(triangles), rims


def torus(minor, around, across):
    """A torus, and a circle around its hole and one around its tube."""
    u, v = numpy.meshgrid(2 * numpy.pi * numpy.arange(around) / around,
                          2 * numpy.pi * numpy.arange(across) / across, indexing='ij')
    radius = 1 + minor * numpy.cos(v)
    places = numpy.column_stack([(radius * numpy.cos(u)).ravel(), (radius * numpy.sin(u)).ravel(),
                                 (minor * numpy.sin(v)).ravel()])
    i, j = (k.ravel() for k in numpy.meshgrid(numpy.arange(around), numpy.arange(across), indexing='ij'))
    a, b = i * across + j, (i + 1) % around * across + j
    c, d = (i + 1) % around * across + (j + 1) % across, i * across + (j + 1) % across
    triangles = numpy.concatenate([numpy.column_stack([a, b, c]), numpy.column_stack([a, c, d])])
    curves = [list(range(0, around * across, across)) + [0], list(range(across)) + [0]]
    marks = [k * around // 6 * across + across // 4 for k in range(0, 6, 2)] + [0]
    return places, triangles, curves, marks


def spread(places, count):
    chosen = [int(numpy.linalg.norm(places, axis=1).argmax())]
    while len(chosen) < count:
        distances = [numpy.linalg.norm(places - places[i], axis=1) for i in chosen]
        chosen.append(int(numpy.min(distances, axis=0).argmax()))
    return chosen


def paths(places, triangles, chosen, count):
    """The shortest paths along edges between successive landmarks that meet no other one."""
    neighbours = [set() for _ in places]
    for triangle in triangles:
        for k in range(3):
            neighbours[triangle[k]].update((triangle[k - 1], triangle[k - 2]))
    taken, found = set(chosen), []
    for begin, end in zip(chosen, chosen[1:]):
        if len(found) == count:
            break
        queue, before = [(0.0, begin, -1)], {}
        while queue and end not in before:
            length, point, previous = heapq.heappop(queue)
            if point in before:
                continue
            before[point] = previous
            for other in neighbours[point]:
                if other not in before and (other == end or other not in taken):
                    heapq.heappush(queue, (length + numpy.linalg.norm(places[other] - places[point]),
                                           int(other), point))
        if end in before:
            path = [end]
            while before[path[-1]] >= 0:
                path.append(before[path[-1]])
            taken.update(path)
            found.append(path[::-1])
    return found


def distance(points, curve):
    """The largest distance of points from a polyline."""
    a, edge = curve[:-1], numpy.diff(curve, axis=0)
    apart = points[:, None] - a
    share = numpy.clip((apart * edge).sum(axis=2) / (edge ** 2).sum(axis=1), 0, 1)
    return numpy.linalg.norm(apart - share[..., None] * edge, axis=2).min(axis=1).max()


def run(method, a, b, marks, curves):
    """marks, curves: of both surfaces."""
    positions, targets, lines = list(a[0][marks[0]]), list(b[0][marks[1]]), vtkCellArray()
    for k in range(len(positions)):
        lines.InsertNextCell(1, [k])
    vertices, lines = lines, vtkCellArray()
    for of_a, of_b in zip(*curves):
        # A polyline has one list of points: the points of both curves, at equal shares.
        share = numpy.unique(numpy.concatenate([shares(a[0][of_a]), shares(b[0][of_b])]).round(9))
        lines.InsertNextCell(len(share), range(len(positions), len(positions) + len(share)))
        positions += list(along(a[0][of_a], share))
        targets += list(along(b[0][of_b], share))
    landmarks = vtkPolyData()
    landmarks.SetPoints(vtkPoints())
    landmarks.GetPoints().SetData(numpy_to_vtk(numpy.array(positions), deep=True))
    landmarks.SetVerts(vertices)
    landmarks.SetLines(lines)
    array = numpy_to_vtk(numpy.array(targets), deep=True)
    array.SetName('TargetPosition')
    landmarks.GetPointData().AddArray(array)
    algorithm = shapemap.vtkShapeCorrespondence()
    algorithm.SetMethod(method)
    for port, data in enumerate((surface(*a), surface(*b), landmarks)):
        algorithm.SetInputDataObject(port, data)
    start = time.process_time()
    algorithm.Update()
    table = algorithm.GetOutputDataObject(2).GetRowData()
    facts = {table.GetArrayName(i).split('.')[-1]: table.GetAbstractArray(i).GetVariantValue(0).ToDouble()
             for i in range(table.GetNumberOfArrays())}
    maps = [vtk_to_numpy(algorithm.GetOutputDataObject(k).GetPointData().GetArray('TargetPosition'))
            for k in (0, 1)]
    return maps, facts, time.process_time() - start


def shares(curve):
    lengths = numpy.concatenate([[0], numpy.cumsum(numpy.linalg.norm(numpy.diff(curve, axis=0), axis=1))])
    return lengths / lengths[-1]


def along(curve, share):
    return numpy.column_stack([numpy.interp(share, shares(curve), curve[:, k]) for k in range(3)])


def scaled(places):
    return (places - places.mean(axis=0)) / numpy.ptp(places, axis=0).max()


def pair_of(name, count, angle, curve_count):
    """Both surfaces, their landmarks and their curves."""
    if name == 'torus':
        (places, triangles, curves, marks), (others, cells, partners, ends) = torus(0.4, 30, 16), torus(
            0.3, 36, 20)
        return (scaled(places), triangles), (scaled(others), cells), (marks, ends), (curves, partners)
    if name == 'plate':
        places, triangles, curves = plate(3, 3)
        places = scaled(places)
        chosen = spread(places, count)
    else:
        places, triangles = read(os.path.join(sys.argv[1], name))
        places = scaled(places)
        chosen = spread(places, count)
        curves = paths(places, triangles, chosen, curve_count)
    turn = 2 * angle * places[:, 2 if name != 'plate' else 0]
    if name == 'plate':
        places = places[:, [1, 2, 0]]
    twisted = numpy.column_stack([
        1.2 * (numpy.cos(turn) * places[:, 0] - numpy.sin(turn) * places[:, 1]),
        numpy.sin(turn) * places[:, 0] + numpy.cos(turn) * places[:, 1], places[:, 2]])
    return (places, triangles), (twisted, triangles), (chosen, chosen), (curves, curves)


SPHERE, BASE = 5, 9
for genus, name, count, angle, curve_count in PAIRS:
    a, b, marks, curves = pair_of(name, count, angle, curve_count)
    assert len(curves[0]) == curve_count, name
    maps, facts, seconds = run(BASE, a, b, marks, curves)
    assert facts['GenusOfA'] == genus, name
    there, back = energy(a[0], maps[0], a[1]), energy(b[0], maps[1], b[1])
    off = max(abs(maps[0][marks[0]] - b[0][marks[1]]).max(), abs(maps[1][marks[1]] - a[0][marks[0]]).max())
    kept = max([0] + [max(distance(maps[0][of_a], b[0][of_b]), distance(maps[1][of_b], a[0][of_a]))
                      for of_a, of_b in zip(*curves)])
    free, peer = [there, back], [numpy.nan, numpy.nan]
    if genus == 0:
        # CommonSphere keeps no curves: it is compared with a map that keeps none.
        for method, energies in ((SPHERE, peer), (BASE, free)):
            if method == SPHERE or curve_count > 0:
                images = run(method, a, b, marks, ([], []))[0]
                energies[:] = energy(a[0], images[0], a[1]), energy(b[0], images[1], b[1])
    print('%-18s genus %d  %5d points  %2d landmarks  %d curves  %2d flipped  off %.0e %.0e  energy %8.3f '
          'back %8.3f  without curves %.3f %.3f  CommonSphere %.3f %.4g  %5.1f CPU s' % (
              name, genus, len(a[0]), count, curve_count, facts['FlippedTriangles'], off, kept, there,
              back, *free, *peer, seconds), flush=True)
    assert facts['FlippedTriangles'] == 0, name
    assert off < 1e-9 and kept < 1e-9, name
    # What CommonBase lowers: the energies of both directions together.
    assert genus > 0 or sum(free) < sum(peer), name
