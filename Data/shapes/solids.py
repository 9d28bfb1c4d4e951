"""Solids of hexahedra."""

import numpy as np

from . import meshes


def box_lattice(cells):
    """Lattice points (integers) and hexahedra of a box of cells[0] x cells[1] x cells[2] cells."""
    shape = np.array(cells) + 1
    lattice = np.argwhere(np.ones(shape, dtype=bool))
    corners = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]])
    low = np.argwhere(np.ones(cells, dtype=bool))
    return lattice, np.ravel_multi_index((low[:, None, :] + corners).transpose(2, 0, 1), shape)


def cube(cells, half_side):
    """Points and hexahedra of the cube [-half_side, half_side]^3, `cells` on each side."""
    lattice, hexahedra = box_lattice((cells, cells, cells))
    return half_side * (2 * lattice / cells - 1), hexahedra


def ball(cells):
    """Points and hexahedra of the unit ball, `cells` from pole to pole (a multiple of 4).

    A core of (cells / 2)^3 cells, and cells / 4 layers between it and the sphere: a cube pulled to a ball as a whole
    would have flat angles along the cube's edges. The core bulges, so that its corners are less sharp.
    """
    if cells < 4 or cells % 4:
        raise ValueError(f"a ball needs a multiple of 4 cells from pole to pole, not {cells}")
    side, layers = cells // 2, cells // 4
    lattice, core = box_lattice((side, side, side))
    skin_lattice, quads = meshes.box_surface((side, side, side))
    skin = np.ravel_multi_index(skin_lattice.T, (side + 1,) * 3)

    # Equal angles, not equal lengths, on the sides of the cube.
    cube_points = np.tan(np.pi / 4 * (2 * lattice / side - 1))
    size, bulge = 0.53, 0.5
    inner = size * ((1 - bulge) * (2 * lattice / side - 1) + bulge * meshes.cube_to_ball(2 * lattice / side - 1))
    sphere = meshes.unit(cube_points[skin])
    points, ids = [inner], [skin]
    for layer in range(1, layers + 1):
        t = layer / layers
        points.append((1 - t) * inner[skin] + t * sphere)
        ids.append(len(lattice) + (layer - 1) * len(skin) + np.arange(len(skin)))
    shells = [np.concatenate([below[quads], above[quads]], axis=1) for below, above in zip(ids, ids[1:])]
    return np.concatenate(points), np.concatenate([core] + shells)
