"""A pebble with dents and bumps; central projection takes it onto the unit sphere."""

import numpy as np

from . import meshes


def dented_sphere(frequency):
    """Points, triangles, target. The radius is a smooth function of the direction, from about 0.6 to 1.25."""
    target, triangles = meshes.geodesic_sphere(frequency)
    # Centres on a golden spiral, so that no symmetry hides a mistake; dents and bumps take turns.
    count = 15
    k = np.arange(count)
    height = 1 - (2 * k + 1) / count
    turn = np.pi * (3 - 5**0.5) * k
    ring = np.sqrt(1 - height**2)
    centres = np.stack([ring * np.cos(turn), ring * np.sin(turn), height], axis=1)
    depth = np.where(k % 2 == 0, -0.34, 0.24) * (1 + 0.2 * np.cos(3.0 * k))
    sharpness = np.where(k % 2 == 0, 14.0, 9.0)
    radius = 1 + (depth * np.exp(sharpness * (target @ centres.T - 1))).sum(axis=1)
    return radius[:, None] * target, triangles, target
