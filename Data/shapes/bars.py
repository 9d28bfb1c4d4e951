"""Bent and twisted bars, whose map straightens them: a closed-form bend of the box [-2, 2] x [-1/2, 1/2]^2."""

import numpy as np

from . import meshes, solids

LENGTH = 4.0


def bend(box, bend_angle, twist_angle):
    """The box's points twisted around x by twist_angle from end to end, then bent in the plane z = 0.

    The bend keeps the length of the axis: it becomes an arc of bend_angle (radians, not zero).
    """
    share = box[:, 0] / LENGTH
    c, s = np.cos(twist_angle * share), np.sin(twist_angle * share)
    y, z = c * box[:, 1] - s * box[:, 2], s * box[:, 1] + c * box[:, 2]
    radius = LENGTH / bend_angle
    angle = bend_angle * share
    return np.stack([(radius - y) * np.sin(angle), radius - (radius - y) * np.cos(angle), z], axis=1)


def bar(across, bend_angle, twist_angle):
    """Surface: points, triangles, target; `across` cells on the short sides, four times as many along."""
    lattice, quads = meshes.box_surface((4 * across, across, across))
    box = lattice / across - np.array([2, 0.5, 0.5])
    points = bend(box, bend_angle, twist_angle)
    return points, meshes.split_quads(points, quads), box


def bar_solid(across, bend_angle, twist_angle):
    """Solid: points, hexahedra, target."""
    lattice, hexahedra = solids.box_lattice((4 * across, across, across))
    box = lattice / across - np.array([2, 0.5, 0.5])
    return bend(box, bend_angle, twist_angle), hexahedra, box
