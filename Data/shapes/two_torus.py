"""A round surface of genus 2 and its polycube, a slab with two square holes."""

import numpy as np

from . import meshes

RING, TUBE, BLEND = 1.3, 0.5, 0.12


def polycube(cells):
    """Lattice and quads of the slab 6.2 x 3.6 x 1 (centred) with two holes of 1.6 x 1.6; bars `cells` wide.

    `cells` is a multiple of 5. Returns points in the slab's units.
    """
    if cells < 5 or cells % 5:
        raise ValueError(f"the slab needs bars of a multiple of 5 cells, not {cells}")
    hole = 8 * cells // 5
    filled = np.ones((3 * cells + 2 * hole, 2 * cells + hole, cells), dtype=bool)
    for start in (cells, 2 * cells + hole):
        filled[start:start + hole, cells:cells + hole] = False
    lattice, quads = meshes.voxel_surface(filled)
    return (lattice - np.array(filled.shape) / 2) / cells, quads


def distance_and_gradient(p):
    """Two rings side by side, as a soft minimum of their distance functions; the surface is where it is zero."""
    values, gradients = [], []
    for centre in (-RING, RING):
        q = p - np.array([centre, 0, 0])
        around = np.hypot(q[:, 0], q[:, 1])
        out = around - RING
        length = np.hypot(out, q[:, 2])
        values.append(length - TUBE)
        gradients.append(np.stack([out * q[:, 0] / around, out * q[:, 1] / around, q[:, 2]], 1) / length[:, None])
    # The nearer ring is subtracted first: no overflow.
    near = np.minimum(*values)
    weights = [np.exp((near - v) / BLEND) for v in values]
    total = weights[0] + weights[1]
    gradient = (weights[0] / total)[:, None] * gradients[0] + (weights[1] / total)[:, None] * gradients[1]
    return near - BLEND * np.log(total), gradient


def project(points, steps):
    """Newton steps along the gradient, onto the surface."""
    for _ in range(steps):
        value, gradient = distance_and_gradient(points)
        points = points - (value / (gradient**2).sum(axis=1))[:, None] * gradient
    return points


def two_torus(cells):
    """Points, triangles, target: the polycube's quads drawn over the rings and evened out on them."""
    target, quads = polycube(cells)
    average = meshes.NeighbourAverage(quads, len(target))
    points = project(meshes.taubin(target, quads, 2 * cells), 8)
    for _ in range(cells * cells):
        points = project(points + 0.5 * (average(points) - points), 1)
    points = project(points, 6)
    return points, meshes.split_quads(points, quads), target
