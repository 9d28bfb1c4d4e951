"""Round bodies made of limbs, each a ball that moves along a segment and changes its size: their soft union."""

import numpy as np

from . import meshes


def both_sides(limbs):
    """Limbs as (a, b, radius at a, radius at b): those beside the plane x = 0, and their mirror images."""
    for a, b, *radii in limbs:
        for mirror in (1, -1) if a[0] else (1,):
            side = np.array([mirror, 1, 1])
            yield (side * a, side * b, *radii)


def foot_on(a, b, p):
    """The share of the way from a to b at which the segment is nearest to each point."""
    return np.clip((p - a) @ (b - a) / ((b - a) @ (b - a)), 0, 1)


class Body:
    """The soft minimum of the limbs' distance functions; the surface is where it is zero."""

    def __init__(self, limbs, blend):
        self.limbs, self.blend = list(both_sides(limbs)), blend

    def distance_and_gradient(self, p):
        values, gradients = [], []
        for a, b, first, last in self.limbs:
            share = foot_on(a, b, p)
            offset = p - a - share[:, None] * (b - a)
            length = np.linalg.norm(offset, axis=1)
            values.append(length - first - (last - first) * share)
            taper = np.where((share > 0) & (share < 1), (last - first) / ((b - a) @ (b - a)), 0)
            gradients.append(offset / np.maximum(length, 1e-12)[:, None] - taper[:, None] * (b - a))
        near = np.min(values, axis=0)
        weights = np.exp((near - np.array(values)) / self.blend)
        total = weights.sum(axis=0)
        return near - self.blend * np.log(total), np.einsum("li,lij->ij", weights / total, gradients)

    def project(self, points, steps):
        """Newton steps along the gradient, onto the surface."""
        for _ in range(steps):
            value, gradient = self.distance_and_gradient(points)
            points = points - (value / (gradient**2).sum(axis=1))[:, None] * gradient
        return points

    def surface(self, voxel, low, shape):
        """Points and triangles: voxels of a side of `voxel`, from the corner `low`, drawn onto the surface and evened
        out on it."""
        centres = low + voxel * (np.stack(np.indices(shape), axis=-1).reshape(-1, 3) + 0.5)
        lattice, quads = meshes.voxel_surface((self.distance_and_gradient(centres)[0] < 0).reshape(shape))
        points = low + voxel * lattice
        average = meshes.NeighbourAverage(quads, len(points))
        points = self.project(meshes.taubin(points, quads, 2), 8)
        for _ in range(12):
            points = self.project(points + 0.5 * (average(points) - points), 1)
        points = self.project(points, 6)
        return points, meshes.split_quads(points, quads)
