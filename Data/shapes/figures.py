"""Two human figures, the second the image of the first under a known deformation of space, and their skeletons.

x points to the left hand, y to the front, z up; both are about 1 tall. Figure A stretches out its arms; figure B raises
them by 25 degrees, has broader hips, shorter legs that stand closer, and its flesh lies elsewhere around its bones: a
harmonic map that knows the surfaces alone misses the skeleton.
"""

import numpy as np

from .limbs import Body, foot_on

SHOULDER = 0.80  # the height of the arms' axis
BLEND = 0.02
# Of figure A, as (x, y, z) to (x, y, z), radius at either end; both sides where x is not 0.
LIMBS = [
    ((0.000, 0.00, 0.54), (0.000, 0.00, 0.80), 0.085, 0.075),  # spine
    ((0.050, 0.00, 0.56), (0.075, 0.00, 0.76), 0.075, 0.070),  # flank
    ((0.030, 0.00, 0.80), (0.150, 0.00, 0.80), 0.055, 0.050),  # shoulder
    ((0.150, 0.00, 0.80), (0.470, 0.00, 0.80), 0.050, 0.042),  # arm
    ((0.000, 0.00, 0.82), (0.000, 0.00, 0.90), 0.046, 0.046),  # neck
    ((0.000, 0.01, 0.91), (0.000, 0.01, 0.94), 0.068, 0.068),  # head
    ((0.050, 0.00, 0.53), (0.090, 0.00, 0.50), 0.070, 0.070),  # hip
    ((0.105, 0.00, 0.50), (0.105, 0.00, 0.07), 0.068, 0.046),  # leg
    ((0.105, 0.00, 0.05), (0.115, 0.08, 0.04), 0.046, 0.036),  # foot
]
# The curves of figure A's skeleton, all in the plane y = 0.
BONES = np.array([
    ((0, 0, 0.55), (0, 0, 0.94)),  # spine, neck, head
    ((0, 0, SHOULDER), (0.47, 0, SHOULDER)),  # left arm
    ((0, 0, SHOULDER), (-0.47, 0, SHOULDER)),  # right arm
    ((0.105, 0, 0.48), (0.105, 0, 0.07)),  # left leg
    ((-0.105, 0, 0.48), (-0.105, 0, 0.07)),  # right leg
])
RAISE = np.radians(25)
MARROW = 0.04  # how far from the bones the flesh holds on to them
FLESH = 0.033  # how far it moves beyond


def step(t):
    """Smoothly from 0 at t <= 0 to 1 at t >= 1."""
    t = np.clip(t, 0, 1)
    return t * t * (3 - 2 * t)


def ramp(t):
    """The integral of step: 0 up to t = 0, t - 1/2 from t = 1 on."""
    inner = np.clip(t, 0, 1)
    return inner**3 * (1 - inner / 2) + np.maximum(t - 1, 0)


def raise_arms(x, z):
    """Bends what lies beside the shoulders around the arms' axis, whose lengths are kept."""
    start, width = 0.17, 0.16
    along = np.abs(x)
    # The axis runs at an angle of RAISE * step: its place is an integral of cosine and sine, taken by Gauss's rule.
    nodes, weights = np.polynomial.legendre.leggauss(16)
    bend = np.clip(along - start, 0, width)
    angles = RAISE * step(bend[:, None] * (nodes + 1) / 2 / width)
    axis = np.stack([(np.cos(angles) * weights).sum(axis=1), (np.sin(angles) * weights).sum(axis=1)]) * bend / 2
    beyond = np.maximum(along - start - width, 0)
    angle = RAISE * step(bend / width)
    out = np.minimum(along, start) + axis[0] + beyond * np.cos(angle) - (z - SHOULDER) * np.sin(angle)
    up = axis[1] + beyond * np.sin(angle) + (z - SHOULDER) * np.cos(angle)
    return np.where(x < 0, -out, out), SHOULDER + up


def deform(points):
    """Where each point of figure A is in figure B. One-to-one on the solid.

    First y alone, along which every line is kept in order; then y is scaled and the planes of constant y are all
    deformed alike. Along each bone the speed is constant: equal shares of arc length correspond.
    """
    x, y, z = points.T
    # The flesh moves to the front, that of the legs to the back; the bones stay.
    held = np.ones(len(points))
    for a, b in BONES:
        gap = points - a - foot_on(a, b, points)[:, None] * (b - a)
        held *= 1 - np.exp(-(gap**2).sum(axis=1) / MARROW**2)
    y = y + FLESH * (1 - 2 * step((0.68 - z) / 0.26)) * held
    y = y * (1 + 0.25 * step((0.70 - z) / 0.15) * step((z - 0.30) / 0.20))
    x, z = raise_arms(x, z)
    # Hips broader by 0.28, less down the legs; legs shorter by 0.2. Both are linear along the legs' bones.
    broader = 1 + 0.28 * step((0.78 - z) / 0.26) - 0.02 * ramp((0.52 - z) / 0.04)
    return np.stack([x * broader, y, z + 0.2 * 0.06 * ramp((0.54 - z) / 0.06)], axis=1)


def figure_a(voxel):
    """Points, triangles, target: voxels of a side of `voxel` drawn onto the surface and evened out on it."""
    count = np.ceil(np.array([0.58, 0.16, 1.06]) / voxel).astype(int)
    low = np.array([-count[0], -count[1], 0]) * voxel + np.array([0, 0.02, -0.02])
    shape = count * np.array([2, 2, 1])
    points, triangles = Body(LIMBS, BLEND).surface(voxel, low, shape)
    return points, triangles, deform(points)


def figure_b(voxel):
    """Points, triangles, no target, and the source: figure A's image, point by point."""
    points, triangles, target = figure_a(voxel)
    return target, triangles, None, points


def skeleton_a():
    """Points, and of each curve the number of points: evenly spaced."""
    counts = [40, 48, 48, 42, 42]
    return np.concatenate([a + np.linspace(0, 1, n)[:, None] * (b - a) for (a, b), n in zip(BONES, counts)]), counts


def skeleton_b():
    """The images of figure A's bones, at other places: closer together towards either end in turn."""
    counts = [151, 211, 199, 131, 139]
    curves = []
    for turn, ((a, b), n) in enumerate(zip(BONES, counts)):
        share = np.linspace(0, 1, n)
        share = share + (0.3 - 0.6 * (turn % 2)) * share * (1 - share)
        curves.append(deform(a + share[:, None] * (b - a)))
    return np.concatenate(curves), counts
