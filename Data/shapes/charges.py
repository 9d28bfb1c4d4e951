"""A harmonic map of the dented sphere as a charge set, written down rather than fitted."""

import numpy as np

from . import meshes
from .dented_sphere import dented_sphere

AFFINE = np.array([[1.10, 0.10, 0.00, 0.30], [0.00, 0.90, 0.05, -0.20], [-0.05, 0.00, 1.05, 0.10]])


def dented_sphere_charges(frequency):
    """Points, triangles, charges (n x 3), affine part (3 x 4): charges around the sphere, then its own points."""
    surface, triangles, _ = dented_sphere(frequency)
    around, _ = meshes.geodesic_sphere(1)
    x, y, z = around.T
    charges = 0.7 * np.stack([np.sin(3 * y) + z, np.cos(4 * x) - y, x * y + np.sin(5 * z)], axis=1)
    return (np.concatenate([1.7 * around, surface]), triangles + len(around),
            np.concatenate([charges, np.zeros_like(surface)]), AFFINE)
