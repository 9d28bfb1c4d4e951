"""Building blocks: geodesic spheres, surfaces of voxel solids, smoothing.

Points are n x 3 doubles, triangles n x 3 and quads n x 4 integers, both counter-clockwise seen from outside.
"""

import numpy as np


def unit(vectors):
    """Each row divided by its length."""
    return vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)


def merge(keys, cells):
    """One point for each distinct key: the index of each one's first appearance, and the renumbered cells."""
    _, first, inverse = np.unique(keys, return_index=True, return_inverse=True)
    return first, inverse.reshape(-1)[cells]


def geodesic_sphere(frequency):
    """The unit sphere: each side of an icosahedron cut in `frequency` parts; 10 frequency^2 + 2 points."""
    g = (1 + 5**0.5) / 2
    corners = unit(np.array([[-1, g, 0], [1, g, 0], [-1, -g, 0], [1, -g, 0], [0, -1, g], [0, 1, g],
                             [0, -1, -g], [0, 1, -g], [g, 0, -1], [g, 0, 1], [-g, 0, -1], [-g, 0, 1]]))
    faces = np.array([[0, 11, 5], [0, 5, 1], [0, 1, 7], [0, 7, 10], [0, 10, 11], [1, 5, 9], [5, 11, 4],
                      [11, 10, 2], [10, 7, 6], [7, 1, 8], [3, 9, 4], [3, 4, 2], [3, 2, 6], [3, 6, 8],
                      [3, 8, 9], [4, 9, 5], [2, 4, 11], [6, 2, 10], [8, 6, 7], [9, 8, 1]])
    f = frequency
    grid = [(i, j) for i in range(f + 1) for j in range(f + 1 - i)]
    place = {ij: n for n, ij in enumerate(grid)}
    local = [(place[i, j], place[i + 1, j], place[i, j + 1]) for i, j in grid if i + j < f]
    local += [(place[i + 1, j], place[i + 1, j + 1], place[i, j + 1]) for i, j in grid if i + j < f - 1]
    shares = np.array([(f - i - j, i, j) for i, j in grid])

    # A point is known by the corners that it lies between and its integer shares in them.
    lattice = np.zeros((20, len(grid), 12), dtype=np.int64)
    for face, rows in zip(faces, lattice):
        rows[:, face] = shares
    keys = np.zeros(20 * len(grid), dtype=np.int64)
    for column in lattice.reshape(-1, 12).T:
        _, keys = np.unique(keys * (f + 1) + column, return_inverse=True)
    cells = (np.arange(20)[:, None, None] * len(grid) + np.array(local)).reshape(-1, 3)
    first, triangles = merge(keys.reshape(-1), cells)
    return unit(lattice.reshape(-1, 12)[first] @ corners), triangles


def voxel_surface(filled):
    """The surface of the filled cells of a boolean grid: lattice points (integers) and quads."""
    shape = np.array(filled.shape)
    padded = np.pad(filled, 1)
    lattice = []
    for axis in range(3):
        # Counter-clockwise around the axis.
        u, v = np.eye(3, dtype=np.int64)[[(axis + 1) % 3, (axis + 2) % 3]]
        for side in (0, 1):
            beyond = np.roll(padded, 1 - 2 * side, axis)[1:-1, 1:-1, 1:-1]
            corner = np.argwhere(filled & ~beyond)
            corner[:, axis] += side
            loop = np.array([0 * u, u, u + v, v])[:: 1 if side else -1]
            lattice.append(corner[:, None, :] + loop)
    lattice = np.concatenate(lattice).reshape(-1, 3)
    first, quads = merge(np.ravel_multi_index(lattice.T, shape + 1),
                         np.arange(len(lattice)).reshape(-1, 4))
    return lattice[first], quads


def box_surface(cells):
    """The surface of a box of cells[0] x cells[1] x cells[2] cells, like voxel_surface."""
    return voxel_surface(np.ones(cells, dtype=bool))


def split_quads(points, quads):
    """Triangles: each quad cut along its shorter diagonal, the first one where they are equal but for rounding."""
    a, b, c, d = quads.T
    first = np.linalg.norm(points[a] - points[c], axis=1) <= (
        1 + 1e-9) * np.linalg.norm(points[b] - points[d], axis=1)
    return np.where(first[:, None, None],
                    np.stack([np.stack([a, b, c], 1), np.stack([a, c, d], 1)], 1),
                    np.stack([np.stack([a, b, d], 1), np.stack([b, c, d], 1)], 1)).reshape(-1, 3)


class NeighbourAverage:
    """The mean of the neighbours along the sides of the cells, for each point: the step of Laplacian smoothing."""

    def __init__(self, cells, count):
        sides = np.stack([cells, np.roll(cells, -1, axis=1)], axis=-1).reshape(-1, 2)
        sides = np.unique(np.concatenate([sides, sides[:, ::-1]]), axis=0)
        self.valence = np.bincount(sides[:, 0], minlength=count)
        slot = np.arange(len(sides)) - np.repeat(np.cumsum(self.valence) - self.valence, self.valence)
        # Empty slots point at an extra row of zeros.
        self.table = np.full((count, self.valence.max()), count)
        self.table[sides[:, 0], slot] = sides[:, 1]

    def __call__(self, points):
        padded = np.vstack([points, np.zeros((1, points.shape[1]))])
        return padded[self.table].sum(axis=1) / self.valence[:, None]


def taubin(points, cells, iterations, shrink=0.5, swell=-0.53):
    """Smooths without the shrinking of Laplacian smoothing (Taubin 1995)."""
    average = NeighbourAverage(cells, len(points))
    for _ in range(iterations):
        for step in (shrink, swell):
            points = points + step * (average(points) - points)
    return points


def cube_to_ball(q):
    """The cube [-1, 1]^3 onto the unit ball: smooth, one-to-one, cube faces to the sphere."""
    s = q * q
    y, z = s[..., [1, 2, 0]], s[..., [2, 0, 1]]
    return q * np.sqrt(1 - y / 2 - z / 2 + y * z / 3)
