"""A head with a skull in it and a brain in that, and a simple domain for each: sphere, polycube, cube.

x points to an ear, y to the nose, z up. The surfaces are strictly nested: the brain lies within the solid that the
skull's surface bounds, and the skull within the head. So are their targets. The skull has genus 2: each eye socket
goes in at the front and comes out at the temple.
"""

import numpy as np

from . import meshes

# The polycube skull in voxels, as boxes (low corner, high corner); one voxel is UNIT wide in the target.
UNIT = 0.11
CENTRE = np.array([0, -0.5, 0.5])
BONE = [((-4, -5, -1), (4, 3, 6)), ((-4, 3, -1), (4, 4, 4)), ((-3, 0, -3), (3, 4, -1)), ((-2, 1, -5), (2, 4, -3))]
SOCKETS = [((1, 3, 0), (3, 4, 2)), ((1, 2, 0), (4, 3, 2)), ((-3, 3, 0), (-1, 4, 2)), ((-4, 2, 0), (-1, 3, 2))]
BRAIN_LOW, BRAIN_HIGH = np.array([-2.5, -4, 0]), np.array([2.5, 1, 5])

# The face: where on the sphere, how wide (x, y, z), how far it is pulled (x, y, z). x is mirrored where it is not 0.
FEATURES = [
    ((0.00, 0.95, 0.30), (0.42, 0.50, 0.09), (0.00, 0.030, 0.00)),  # brow
    ((0.33, 0.93, 0.13), (0.17, 0.50, 0.11), (0.00, -0.115, 0.00)),  # eye socket
    ((0.33, 0.93, 0.12), (0.10, 0.50, 0.075), (0.00, 0.100, 0.00)),  # eye
    ((0.00, 1.00, 0.05), (0.07, 0.50, 0.16), (0.00, 0.070, 0.00)),  # bridge of the nose
    ((0.00, 0.99, -0.10), (0.10, 0.50, 0.10), (0.00, 0.170, -0.03)),  # tip of the nose
    ((0.12, 0.98, -0.15), (0.07, 0.50, 0.06), (0.02, 0.050, 0.00)),  # nostril
    ((0.48, 0.82, -0.17), (0.22, 0.50, 0.16), (0.02, 0.055, 0.00)),  # cheek
    ((0.00, 0.93, -0.37), (0.16, 0.50, 0.045), (0.00, 0.035, 0.00)),  # upper lip
    ((0.00, 0.90, -0.43), (0.21, 0.50, 0.025), (0.00, -0.035, 0.00)),  # mouth
    ((0.20, 0.90, -0.41), (0.05, 0.50, 0.040), (0.00, -0.020, 0.03)),  # corner of the mouth, smiling
    ((0.00, 0.88, -0.49), (0.14, 0.50, 0.045), (0.00, 0.040, 0.00)),  # lower lip
    ((0.00, 0.75, -0.68), (0.20, 0.50, 0.11), (0.00, 0.110, -0.03)),  # chin
    ((1.00, -0.08, 0.05), (0.60, 0.11, 0.20), (0.16, -0.090, 0.03)),  # ear
    ((1.00, 0.02, 0.03), (0.60, 0.06, 0.09), (-0.07, 0.000, 0.00)),  # ear, its hollow
]


def head(frequency):
    """Points, triangles, target: the unit sphere pulled into a head with a neck."""
    target, triangles = meshes.geodesic_sphere(frequency)
    x, y, z = target.T
    down = np.clip(-z, 0, 1)**2
    points = target * np.array([0.84, 1.02, 1.12])
    # A narrower jaw, and the nape drawn in under the back of the head.
    points[:, 0] *= 1 - 0.24 * down
    points[:, 1] += 0.22 * down * np.clip(1 - y, 0, 2) / 2
    # The neck, with a flat end.
    neck = np.where(z < 0, np.exp(-((x / 0.50)**2 + ((y + 0.10) / 0.50)**2)**3), 0)
    points[:, 2] += neck * (-1.45 - points[:, 2])
    for centre, width, pull in FEATURES:
        for mirror in (1, -1) if centre[0] else (1,):
            side = np.array([mirror, 1, 1])
            weight = np.exp(-(((target - side * centre) / width)**2).sum(axis=1))
            points += weight[:, None] * (side * pull)
    return points, triangles, target


def skull(refinement):
    """Points, triangles, target: the polycube pulled round as the cube is pulled to a ball, then smoothed."""
    low, high = np.array([-4, -5, -5]), np.array([4, 4, 6])
    filled = np.zeros(high - low, dtype=bool)
    for boxes, value in ((BONE, True), (SOCKETS, False)):
        for first, last in boxes:
            filled[tuple(slice(a, b) for a, b in zip(first - low, last - low))] = value
    for axis in range(3):
        filled = np.repeat(filled, refinement, axis)
    lattice, quads = meshes.voxel_surface(filled)
    voxels = lattice / refinement + low - CENTRE
    points = meshes.cube_to_ball(voxels / np.array([4.4, 5.0, 6.2])) * np.array([0.74, 0.93, 1.08])
    average = meshes.NeighbourAverage(quads, len(points))
    for _ in range(refinement**2):
        points = points + 0.5 * (average(points) - points)
    points = points + np.array([0, -0.02, 0])
    return points, meshes.split_quads(points, quads), UNIT * voxels


def brain(cells):
    """Points, triangles, target: two wrinkled hemispheres, a smooth radius over the sphere, onto a cube."""
    lattice, quads = meshes.box_surface((cells, cells, cells))
    cube = 2 * lattice / cells - 1
    direction = meshes.unit(meshes.cube_to_ball(np.tan(np.pi / 4 * cube)))
    x, y, z = direction.T
    wrinkles = np.sin(8 * np.abs(x) + 2 * np.sin(4 * y + 2 * z)) * np.sin(7 * z + 2 * np.sin(5 * y - 3 * np.abs(x)))
    cleft = np.exp(-(x / 0.10)**2) * (1 + np.tanh(4 * (z + 0.2))) / 2
    radius = 1 + 0.035 * wrinkles * (1 - np.exp(-(x / 0.2)**2)) - 0.14 * cleft
    points = radius[:, None] * direction * np.array([0.50, 0.57, 0.45]) + np.array([0, -0.12, 0.30])
    middle, half = (BRAIN_LOW + BRAIN_HIGH) / 2 - CENTRE, (BRAIN_HIGH - BRAIN_LOW) / 2
    return points, meshes.split_quads(points, quads), UNIT * (middle + half * cube)
