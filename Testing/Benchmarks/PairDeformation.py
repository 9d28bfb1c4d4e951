"""Surfaces moved by maps that are known, and closest places on surfaces: what
CorrespondencePairs.py is made of. Needs Debian's python3-scipy and python3-vtk9."""
import numpy
import scipy.sparse
import scipy.sparse.csgraph
import scipy.sparse.linalg
import scipy.spatial.transform
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import mutable, vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData, vtkStaticCellLocator


def read(path):
    """Points (n x 3) and triangles (m x 3) of an OFF file, with or without colours."""
    with open(path, encoding='ascii') as file:
        words = ' '.join(line.split('#')[0] for line in file).split()
    columns = 7 if words[0].startswith('C') else 3
    count, faces = int(words[1]), int(words[2])
    points = numpy.array(words[4:4 + columns * count], float).reshape(count, columns)[:, :3]
    rest = numpy.array(words[4 + columns * count:][:4 * faces], int).reshape(faces, 4)
    if (rest[:, 0] != 3).any():
        raise ValueError(path + ' has polygons')
    return points, rest[:, 1:]


def write(path, points, triangles):
    with open(path, 'w', encoding='ascii') as file:
        file.write('OFF\n%d %d 0\n' % (len(points), len(triangles)))
        numpy.savetxt(file, points, '%.17g')
        numpy.savetxt(file, numpy.column_stack([numpy.full(len(triangles), 3), triangles]), '%d')


def split(points, triangles):
    """Each triangle in four, at the middles of its edges."""
    sides = numpy.sort(triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    edges, place = numpy.unique(sides, axis=0, return_inverse=True)
    ab, bc, ca = (len(points) + place.reshape(-1, 3)).T
    a, b, c = triangles.T
    return (numpy.vstack([points, points[edges].mean(axis=1)]),
            numpy.vstack([numpy.column_stack(corners) for corners in (
                (a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca))]))


def area_vectors(points, triangles):
    a, b, c = (points[triangles[:, k]] for k in range(3))
    return numpy.cross(b - a, c - a)


def point_normals(points, triangles):
    sums = numpy.zeros_like(points)
    vectors = area_vectors(points, triangles)
    for k in range(3):
        numpy.add.at(sums, triangles[:, k], vectors)
    return sums / numpy.linalg.norm(sums, axis=1, keepdims=True)


def edges_of(triangles):
    """Each edge once, and how many triangles share it."""
    sides = numpy.sort(triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    return numpy.unique(sides, axis=0, return_counts=True)


def edge_graph(points, triangles):
    edges, _ = edges_of(triangles)
    lengths = numpy.linalg.norm(points[edges[:, 0]] - points[edges[:, 1]], axis=1)
    return scipy.sparse.csr_matrix((lengths, edges.T), shape=(len(points), len(points)))


def edge_distances(points, triangles, source):
    return scipy.sparse.csgraph.dijkstra(edge_graph(points, triangles), False, source)


def farthest_points(points, triangles, count):
    """Each the farthest along edges from those before it; the first is farthest from point 0."""
    graph = edge_graph(points, triangles)
    found = [int(scipy.sparse.csgraph.dijkstra(graph, False, 0).argmax())]
    distances = scipy.sparse.csgraph.dijkstra(graph, False, found[0])
    while len(found) < count:
        found.append(int(distances.argmax()))
        distances = numpy.minimum(distances, scipy.sparse.csgraph.dijkstra(graph, False, found[-1]))
    return found


def facts(points, triangles):
    """Points, Euler number, components, edges on a border and edges of more than two triangles."""
    edges, shared = edges_of(triangles)
    used = len(numpy.unique(triangles))
    graph = scipy.sparse.csr_matrix((numpy.ones(len(edges)), edges.T), shape=(len(points),) * 2)
    parts = scipy.sparse.csgraph.connected_components(graph, False)[0] - (len(points) - used)
    return {'points': len(points), 'euler': int(used - len(edges) + len(triangles)),
            'components': int(parts), 'border': int((shared == 1).sum()),
            'nonmanifold': int((shared > 2).sum())}


class Locator:
    """Closest places on a surface, on the side that faces the same way where two sides are near."""

    def __init__(self, points, triangles):
        self.points, self.triangles = points, triangles
        self.normals = area_vectors(points, triangles)
        self.data = vtkPolyData()
        places = vtkPoints()
        places.SetData(numpy_to_vtk(numpy.ascontiguousarray(points), deep=True))
        self.data.SetPoints(places)
        cells = vtkCellArray()
        cells.SetData(3, numpy_to_vtkIdTypeArray(
            numpy.ascontiguousarray(triangles.ravel(), numpy.int64), deep=True))
        self.data.SetPolys(cells)
        self.locator = vtkStaticCellLocator()
        self.locator.SetDataSet(self.data)
        self.locator.BuildLocator()
        self.reach = 4.0 * numpy.sqrt(numpy.linalg.norm(self.normals, axis=1).mean())

    def nearest(self, place):
        found, cell, part, square = [0.0] * 3, mutable(0), mutable(0), mutable(0.0)
        self.locator.FindClosestPoint(place, found, cell, part, square)
        return found, int(cell)

    def _within(self, cell, place):
        """The place of a triangle that is closest to another place."""
        a, b, c = self.points[self.triangles[cell]]
        normal = numpy.cross(b - a, c - a)
        weights = numpy.array([numpy.dot(numpy.cross(q - p, place - p), normal)
                               for p, q in ((b, c), (c, a), (a, b))])
        if (weights >= 0).all():
            return weights @ (a, b, c) / weights.sum()
        ends = [p + min(max((place - p) @ (q - p) / ((q - p) @ (q - p)), 0.0), 1.0) * (q - p)
                for p, q in ((a, b), (b, c), (c, a))]
        return min(ends, key=lambda end: numpy.linalg.norm(end - place))

    def find(self, places, normals):
        """Triangles, barycentric coordinates and positions, and how many places face a side that
        looks the other way all the same."""
        cells, found, opposite = numpy.zeros(len(places), int), numpy.zeros((len(places), 3)), 0
        near = vtkIdList()
        for i, place in enumerate(places):
            found[i], cells[i] = self.nearest(place)
            if self.normals[cells[i]] @ normals[i] > 0:
                continue
            box = [x for k in range(3) for x in (place[k] - self.reach, place[k] + self.reach)]
            self.locator.FindCellsWithinBounds(box, near)
            facing = [near.GetId(k) for k in range(near.GetNumberOfIds())
                      if self.normals[near.GetId(k)] @ normals[i] > 0]
            if not facing:
                opposite += 1
                continue
            ends = [self._within(cell, place) for cell in facing]
            best = int(numpy.argmin([numpy.linalg.norm(end - place) for end in ends]))
            cells[i], found[i] = facing[best], ends[best]
        return cells, self.barycentrics(cells, found), found, opposite

    def barycentrics(self, cells, places):
        a, b, c = (self.points[self.triangles[cells, k]] for k in range(3))
        normal, square = self.normals[cells], (self.normals[cells] ** 2).sum(axis=1)
        weights = numpy.column_stack([
            (numpy.cross(q - p, places - p) * normal).sum(axis=1) / square
            for p, q in ((b, c), (c, a), (a, b))]).clip(0.0, 1.0)
        return weights / weights.sum(axis=1, keepdims=True)

    def places(self, cells, weights, values):
        """Values at the points (n x d), at places in triangles."""
        return (values[self.triangles[cells]] * weights[:, :, None]).sum(axis=1)


def falling(distances, begin, end):
    """1 up to `begin`, 0 from `end` on, smooth between."""
    t = ((distances - begin) / (end - begin)).clip(0.0, 1.0)
    return 1.0 - t * t * (3.0 - 2.0 * t)


def axis_rotations(axis, degrees):
    axis = numpy.asarray(axis, float) / numpy.linalg.norm(axis)
    turns = numpy.radians(degrees)[:, None] * axis
    return scipy.spatial.transform.Rotation.from_rotvec(turns).as_matrix()


def moved(points, triangles, changes, rounds=60):
    """The surface with limbs turned, stretched and swollen: the one whose edges are nearest to what
    a linear map at each point makes of them (as rigid as possible, Sorkine and Alexa 2007, with
    stretches that are asked for). Rotations are given beyond each bend and found in it.

    changes: (kind, place, begin, end, axis, amount): with the distance along edges from the point
    nearest to `place`, whole up to `begin` and none from `end` on, all in parts of the longest side
    of the box, from its least corner. Kinds: 'turn' by degrees about an axis, 'stretch' along an
    axis by a factor, 'swell' by a factor.
    """
    size = numpy.ptp(points, axis=0).max()
    parts = (points - points.min(axis=0)) / size
    count = len(points)
    turns = numpy.tile(numpy.eye(3), (count, 1, 1))
    stretches = turns.copy()
    bends = numpy.zeros(count, bool)
    for kind, place, begin, end, axis, amount in changes:
        tip = int(numpy.linalg.norm(parts - place, axis=1).argmin())
        share = falling(edge_distances(parts, triangles, tip), begin, end)
        if kind == 'turn':
            turns = axis_rotations(axis, share * amount) @ turns
            bends |= (share > 0) & (share < 1)
        elif kind == 'stretch':
            along = numpy.asarray(axis, float) / numpy.linalg.norm(axis)
            stretches = stretches + (
                share * (amount - 1.0))[:, None, None] * numpy.outer(along, along)
        else:
            stretches = stretches * (1.0 + share * (amount - 1.0))[:, None, None]
    a, b, c = (points[triangles[:, k]] for k in range(3))
    double = numpy.linalg.norm(area_vectors(points, triangles), axis=1)
    cotangents = numpy.column_stack([((q - p) * (r - p)).sum(axis=1) / double for p, q, r in (
        (a, b, c), (b, c, a), (c, a, b))]).clip(0.05, 20.0)
    tails = triangles[:, [1, 2, 0]].ravel()
    heads = triangles[:, [2, 0, 1]].ravel()
    weights = scipy.sparse.csr_matrix((cotangents.ravel(), (tails, heads)), shape=(count, count))
    weights = (weights + weights.T).tocoo()
    tails, heads, weights = weights.row, weights.col, weights.data
    laplacian = scipy.sparse.csc_matrix((-weights, (tails, heads)), shape=(count, count))
    laplacian -= scipy.sparse.diags(numpy.asarray(laplacian.sum(axis=1)).ravel())
    held = scipy.sparse.csc_matrix(([1.0], ([0], [0])), shape=(count, count))
    solve = scipy.sparse.linalg.splu((laplacian + held).tocsc()).solve
    edges = points[tails] - points[heads]
    result = points
    for step in range(rounds):
        if step:  # rotations in the bends from the edges as they are
            reached = result[tails] - result[heads]
            inside = bends[tails]
            asked = numpy.einsum('eij,ej->ei', stretches[tails[inside]], edges[inside])
            sums = numpy.zeros((count, 3, 3))
            numpy.add.at(sums, tails[inside], weights[inside, None, None]
                         * reached[inside][:, :, None] * asked[:, None, :])
            left, _, right = numpy.linalg.svd(sums[bends])
            left[:, :, 2] *= numpy.linalg.det(left @ right)[:, None]
            turns[bends] = left @ right
        maps = turns @ stretches
        wanted = 0.5 * weights[:, None] * numpy.einsum(
            'eij,ej->ei', maps[tails] + maps[heads], edges)
        sums = numpy.zeros((count, 3))
        numpy.add.at(sums, tails, wanted)
        result = solve(sums)
    return result - result.mean(axis=0) + points.mean(axis=0)
