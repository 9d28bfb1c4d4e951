"""Families of shapes with a known mean and known modes of variation.

A family is a surface that depends on parameters, which have mean 0 and variance 1 and are not correlated. Where it is
linear in them, as three of the families are, its mean and its modes follow from its formula, without any sample:
the mean is the shape at 0, and the modes are the principal components of the derivatives by the parameters.

Bars that bend and twist are not linear in the angles: they lie on a curved surface in the space of shapes. Their true
modes are those of its tangent plane at the mean angles, the limit of small deviations. A deviation of s radians adds
terms of s^2 / 2 of the size to the mean shape, and of s^2 / 6 of itself to a mode. The curvature also makes further
modes, with about s^2 / 5 of the variance: 0.05 % for the 3 degrees here, less than Shape Atlas counts as a mode.
"""

import numpy as np

from . import bars, dented_sphere, meshes


class Family:
    """Shapes `place(domain, parameters)` (n x 3), for points of a domain and `count` parameters."""

    def __init__(self, place, count, domain, triangles):
        self.place, self.count, self.domain, self.triangles = place, count, domain, triangles

    def points(self, parameters):
        return self.place(self.domain, np.asarray(parameters, dtype=float))

    def tangents(self):
        """The derivatives by the parameters, by central differences: count x n x 3."""
        step = 1e-4
        return np.array([(self.points(step * unit) - self.points(-step * unit)) / (2 * step)
                         for unit in np.eye(self.count)])

    def weights(self):
        """The share of the mean shape's area that belongs to each point."""
        corners = self.points(np.zeros(self.count))[self.triangles]
        areas = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
        shares = np.bincount(self.triangles.ravel(), np.repeat(areas, 3), minlength=len(self.domain))
        return shares / shares.sum()

    def mean(self):
        """The mean shape, about its centre of area."""
        return centred(self.points(np.zeros(self.count)), self.weights())

    def without_motion(self, displacement):
        """A displacement of the mean shape without the rigid motion in it, which aligned shapes do not have."""
        weights, mean = self.weights(), self.mean()
        moved = centred(displacement, weights)
        turns = [np.cross(axis, mean) for axis in np.eye(3)]
        products = np.array([[product(a, b, weights) for a in turns] for b in turns])
        angles = np.linalg.solve(products, [product(turn, moved, weights) for turn in turns])
        return moved - sum(angle * turn for angle, turn in zip(angles, turns))

    def modes(self):
        """The principal components, the largest first: count x n x 3, each the displacement for one deviation."""
        weights = self.weights()
        tangents = np.array([self.without_motion(tangent) for tangent in self.tangents()])
        products = np.array([[product(a, b, weights) for a in tangents] for b in tangents])
        vectors = np.linalg.eigh(products)[1][:, ::-1]
        return np.einsum("kj,kic->jic", vectors, tangents)


def product(a, b, weights):
    return np.einsum("i,ic,ic", weights, a, b)


def centred(points, weights):
    return points - weights @ points


def parameters(shapes, count, seed):
    """Random ones for an even number of shapes, whose sample has exactly mean 0 and the covariance 1: shapes x count.

    Each set comes with its negative, so that terms of second order do not correlate with the parameters.
    """
    half = np.random.default_rng(seed).normal(size=(shapes // 2, count))
    values = np.vstack([half, -half])
    return values @ np.linalg.inv(np.linalg.cholesky(values.T @ values / (shapes - 1))).T


def ellipsoids(frequency):
    """Of half axes 3, 2 and 1.2, each of which varies."""
    def place(sphere, p):
        return sphere * (np.array([3, 2, 1.2]) + p * [0.3, 0.16, 0.08])
    return Family(place, 3, *meshes.geodesic_sphere(frequency))


def dented_spheres(frequency):
    """The dented sphere, of which a bump and a dent vary in height."""
    def place(sphere, p):
        depth = dented_sphere.DEPTH.copy()
        depth[[5, 10]] += p * [0.1, 0.06]
        return dented_sphere.radius(sphere, depth)[:, None] * sphere
    return Family(place, 2, *meshes.geodesic_sphere(frequency))


def bent_bars(across):
    """Bars bent by about 60 degrees and twisted by about 30."""
    lattice, quads = meshes.box_surface((4 * across, across, across))
    box = lattice / across - np.array([2, 0.5, 0.5])

    def place(domain, p):
        return bars.bend(domain, np.pi / 3 + 0.05 * p[0], np.pi / 6 + 0.05 * p[1])
    return Family(place, 2, box, meshes.split_quads(box, quads))


def two_region_bones(frequency):
    """A shaft with two ends: bone around marrow. Length, one end, and the thickness of the bone vary."""
    sphere, triangles = meshes.geodesic_sphere(frequency)
    count = len(sphere)

    def place(domain, p):
        z = domain[:, 2:]
        inside = (np.arange(2 * count) >= count)[:, None]
        profile, end = 0.35 + 0.45 * z**2, 0.02 * (1 + z)**2
        across = np.where(inside, 0.55 * (profile + p[1] * end) - 0.06 * p[2] * profile, profile + p[1] * end)
        return np.hstack([across * domain[:, :2], np.where(inside, 0.85, 1) * (1.8 + 0.15 * p[0]) * z])
    return Family(place, 3, np.vstack([sphere, sphere]), np.vstack([triangles, count + triangles[:, ::-1]]))
