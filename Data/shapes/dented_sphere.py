"""A pebble with dents and bumps; central projection takes it onto the unit sphere."""

import numpy as np

from . import meshes


# Centres on a golden spiral, so that no symmetry hides a mistake; dents and bumps take turns.
COUNT = 15
K = np.arange(COUNT)
HEIGHT = 1 - (2 * K + 1) / COUNT
TURN = np.pi * (3 - 5**0.5) * K
RING = np.sqrt(1 - HEIGHT**2)
CENTRES = np.stack([RING * np.cos(TURN), RING * np.sin(TURN), HEIGHT], axis=1)
DEPTH = np.where(K % 2 == 0, -0.34, 0.24) * (1 + 0.2 * np.cos(3.0 * K))
SHARPNESS = np.where(K % 2 == 0, 14.0, 9.0)


def radius(target, depth=DEPTH):
    """The distance from the centre in each direction of the unit sphere; linear in the depths."""
    return 1 + (depth * np.exp(SHARPNESS * (target @ CENTRES.T - 1))).sum(axis=1)


def dented_sphere(frequency):
    """Points, triangles, target. The radius is a smooth function of the direction, from about 0.6 to 1.25."""
    target, triangles = meshes.geodesic_sphere(frequency)
    return radius(target)[:, None] * target, triangles, target
