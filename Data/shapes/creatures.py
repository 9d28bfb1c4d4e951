"""A sitting kitten, whose tail is a handle, and a horse; polycubes drawn by hand for them and for the phantom's skull.

x points to the left, y to the front, z up; both creatures are about 1 tall.
"""

import numpy as np

from .limbs import Body
from .solids import box_lattice

# Of each creature: limbs as (x, y, z) to (x, y, z), radius at either end, both sides where x is not 0; blend.
KITTEN = Body([
    ((0.00, -0.08, 0.23), (0.00, 0.00, 0.50), 0.22, 0.15),  # body
    ((0.00, 0.04, 0.50), (0.00, 0.09, 0.62), 0.13, 0.12),  # neck
    ((0.00, 0.06, 0.80), (0.00, 0.12, 0.78), 0.17, 0.15),  # head
    ((0.00, 0.22, 0.74), (0.00, 0.26, 0.73), 0.07, 0.05),  # muzzle
    ((0.10, 0.07, 0.90), (0.15, 0.07, 1.08), 0.075, 0.045),  # ear
    ((0.13, -0.06, 0.16), (0.17, 0.06, 0.12), 0.13, 0.10),  # haunch
    ((0.09, 0.10, 0.44), (0.10, 0.17, 0.08), 0.080, 0.065),  # front leg
    ((0.10, 0.17, 0.065), (0.10, 0.27, 0.055), 0.065, 0.055),  # paw
    ((0.00, -0.25, 0.08), (0.00, -0.50, 0.10), 0.065, 0.060),  # tail, along the ground,
    ((0.00, -0.50, 0.10), (0.00, -0.56, 0.30), 0.060, 0.055),  # up,
    ((0.00, -0.56, 0.30), (0.00, -0.46, 0.46), 0.055, 0.050),
    ((0.00, -0.46, 0.46), (0.00, -0.12, 0.48), 0.050, 0.050),  # and back
], 0.02)
HORSE = Body([
    ((0.00, -0.30, 0.62), (0.00, 0.02, 0.60), 0.155, 0.150),  # barrel
    ((0.00, 0.02, 0.60), (0.00, 0.26, 0.63), 0.150, 0.145),  # chest
    ((0.00, 0.30, 0.68), (0.00, 0.46, 0.92), 0.110, 0.075),  # neck
    ((0.00, 0.48, 0.94), (0.00, 0.72, 0.84), 0.080, 0.055),  # head
    ((0.05, 0.46, 0.99), (0.06, 0.45, 1.06), 0.025, 0.012),  # ear
    ((0.11, 0.26, 0.56), (0.12, 0.28, 0.30), 0.080, 0.048),  # foreleg
    ((0.12, 0.28, 0.30), (0.12, 0.29, 0.06), 0.048, 0.050),
    ((0.11, -0.34, 0.58), (0.13, -0.32, 0.32), 0.095, 0.052),  # hind leg
    ((0.13, -0.32, 0.32), (0.12, -0.37, 0.06), 0.052, 0.052),
    ((0.00, -0.43, 0.66), (0.00, -0.60, 0.58), 0.055, 0.050),  # tail
    ((0.00, -0.60, 0.58), (0.00, -0.66, 0.34), 0.050, 0.040),
], 0.02)

# Of each polycube: boxes of unit cubes to fill, from corner to corner, then boxes to empty; and where the planes of
# its grid lie around the solid, along each axis.
KITTEN_CUBES = ([
    ((0, 2, 0), (3, 4, 5)),  # body and head
    ((0, 3, 5), (1, 4, 6)), ((2, 3, 5), (3, 4, 6)),  # ears
    ((0, 4, 0), (1, 5, 1)), ((2, 4, 0), (3, 5, 1)),  # paws
    ((1, 1, 0), (2, 2, 1)), ((1, 0, 0), (2, 1, 3)), ((1, 1, 2), (2, 2, 3)),  # tail
], [], ([-0.19, -0.06, 0.06, 0.19], [-0.62, -0.48, -0.22, 0.01, 0.18, 0.34],
        [0.00, 0.15, 0.42, 0.54, 0.70, 0.95, 1.12]))
HORSE_CUBES = ([
    ((0, 2, 2), (3, 6, 4)),  # barrel
    ((0, 2, 0), (1, 3, 2)), ((2, 2, 0), (3, 3, 2)), ((0, 5, 0), (1, 6, 2)), ((2, 5, 0), (3, 6, 2)),  # legs
    ((1, 5, 4), (2, 6, 6)), ((1, 6, 5), (2, 8, 6)),  # neck, head
    ((1, 1, 3), (2, 2, 4)), ((1, 0, 1), (2, 1, 4)),  # tail
], [], ([-0.16, -0.05, 0.05, 0.16], [-0.70, -0.60, -0.44, -0.27, 0.00, 0.24, 0.42, 0.58, 0.76],
        [0.00, 0.34, 0.45, 0.60, 0.73, 0.85, 0.97]))
SKULL_CUBES = ([
    ((0, 0, 1), (5, 3, 4)),  # cranium
    ((1, 1, 0), (4, 3, 1)),  # jaw
], [
    ((1, 2, 2), (2, 3, 3)), ((0, 1, 2), (2, 2, 3)),  # an eye socket, and its way out at the temple
    ((3, 2, 2), (4, 3, 3)), ((3, 1, 2), (5, 2, 3)),
], ([-0.67, -0.50, -0.17, 0.17, 0.50, 0.67], [-0.86, 0.45, 0.63, 0.82], [-0.85, -0.28, -0.09, 0.26, 0.90]))


def creature(body, voxel):
    """Points, triangles, no target."""
    reach = np.concatenate([[a - r, a + r] for limb in body.limbs for a, r in zip(limb[:2], limb[2:])]).reshape(-1, 3)
    low = np.floor(reach.min(axis=0) / voxel) * voxel - 2 * voxel
    shape = np.ceil((reach.max(axis=0) - low) / voxel).astype(int) + 2
    return (*body.surface(voxel, low, shape), None)


def drawn_polycube(boxes, holes, planes):
    """Points and unit hexahedra of a polycube, and where they are drawn around the solid."""
    filled = np.zeros([len(along) - 1 for along in planes], dtype=bool)
    for solid, value in ((boxes, True), (holes, False)):
        for low, high in solid:
            filled[tuple(slice(*ends) for ends in zip(low, high))] = value
    lattice, hexahedra = box_lattice(filled.shape)
    used, hexahedra = np.unique(hexahedra[filled.reshape(-1)], return_inverse=True)
    points = lattice[used]
    drawn = np.stack([np.array(along)[points[:, axis]] for axis, along in enumerate(planes)], axis=1)
    return points.astype(float), hexahedra.reshape(-1, 8), drawn
