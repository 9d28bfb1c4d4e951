"""Curve skeletons of two shapes, matched: animals in two poses, and hands, trees and quadrupeds of
other proportions. Which end belongs to which is known.

    /usr/bin/python3 Testing/Benchmarks/SkeletonPairs.py FOLDER [PAIR ...]

The pairs of animals are those of CorrespondencePairs.py: models moved by a known map, then turned and
remeshed, each for itself. The other pairs are made here of limbs: both shapes have the same limbs, and
those of the second have other lengths, radii and directions. An end of a skeleton is right if its place
is the end of the target's skeleton that is nearest to where the truth takes it.

What is claimed: no end is wrong that the kernel does not name as ambiguous; a pair that is matched has
no wrong end; other numbers and directions of branches change nothing; at least 8 pairs are matched. The
other pairs are ambiguous, or refused as different. The kernel's options were set before the pairs were
run, and none was changed after.

Needs Debian's python3-scipy and python3-vtk9.
"""
import collections
import os
import zlib

import sweep

sweep.use_one_thread()  # before numpy is loaded

import numpy  # noqa: E402
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy  # noqa: E402
from vtkmodules.vtkCommonDataModel import vtkImageData  # noqa: E402
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D  # noqa: E402

import CorrespondencePairs  # noqa: E402
import PairDeformation  # noqa: E402

ANIMALS = ('armadillo-bends', 'camel-looks', 'bear-bends', 'triceratops-turns', 'diplodocus-turns',
           'camel-big-head', 'triceratops-tail', 'bear-grows', 'man-walks', 'cow-kneels', 'dino-turns',
           'elephant-kneels')
NEAR = 0.02  # of the longest side: as good as the nearest end

# name: (parent or None, vector from the parent's tip, radii at begin and tip); those whose name ends
# with a dot have others at their tip.
HAND = {
    'palm.': (None, (0, 0.9, 0), 0.4, 0.4), 'wrist': ('', (0, -1.2, 0), 0.36, 0.3),
    'thumb': ('', (-1.2, 0.6, 0.1), 0.16, 0.12),
    'knuckle 1.': ('palm.', (-0.4, 0.1, 0), 0.2, 0.18), 'index': ('knuckle 1.', (-0.5, 1.3, 0), 0.13, 0.1),
    'knuckle 2.': ('palm.', (0.4, 0.1, 0), 0.2, 0.18), 'ring': ('knuckle 2.', (0.25, 1.5, 0), 0.13, 0.1),
    'middle': ('palm.', (-0.05, 1.9, 0), 0.13, 0.1), 'little': ('knuckle 2.', (1.1, 0.6, 0), 0.12, 0.09)}
TREE = {
    'trunk.': (None, (0, 0, 2.2), 0.3, 0.22), 'root': ('', (0.1, 0, -0.8), 0.34, 0.3),
    'left.': ('trunk.', (-1.2, 0.2, 0.7), 0.18, 0.14), 'right.': ('trunk.', (0.9, -0.5, 1.2), 0.2, 0.15),
    'back': ('trunk.', (0.2, 1.6, 0.9), 0.13, 0.09), 'left long': ('left.', (-1.3, 0.3, 0.9), 0.12, 0.08),
    'left short': ('left.', (-0.3, -0.6, 0.6), 0.11, 0.08),
    'right long': ('right.', (0.5, -0.9, 1.5), 0.13, 0.09),
    'right short': ('right.', (0.9, 0.5, 0.4), 0.11, 0.08)}
QUADRUPED = {
    'spine.': (None, (2.6, 0, 0.1), 0.42, 0.46), 'tail': ('', (-1.5, 0, 0.3), 0.12, 0.07),
    'neck.': ('spine.', (0.9, 0, 1.0), 0.24, 0.2), 'nose': ('neck.', (0.8, 0, -0.2), 0.2, 0.14),
    'left front': ('spine.', (0.1, 0.9, -1.5), 0.17, 0.13),
    'right front': ('spine.', (0.1, -0.9, -1.5), 0.17, 0.13),
    'left hind': ('', (0, 1.0, -1.8), 0.22, 0.14), 'right hind': ('', (0, -1.0, -1.8), 0.22, 0.14)}
KINDS = {'hand': HAND, 'tree': TREE, 'quadruped': QUADRUPED}
MADE = tuple('%s-%d' % (kind, i) for kind in KINDS for i in (1, 2, 3, 4))


def turned(vector, radians, generator):
    """The vector, turned about a random axis."""
    axis = generator.normal(size=3)
    matrix = PairDeformation.axis_rotations(axis, numpy.array([numpy.degrees(radians)]))[0]
    return matrix @ vector


def place_limbs(limbs, generator, change):
    """(begin, tip, radii) of each limb by name. change: 0 for the shape itself, 1 for lengths and radii
    up to a fifth longer or shorter and directions up to 20 degrees off."""
    placed, tips = {}, {'': numpy.zeros(3)}
    for name, (parent, vector, first, last) in limbs.items():
        longer, thicker = 1.2 ** (change * generator.uniform(-1, 1, 2))
        along = turned(numpy.array(vector, float), change * 0.35 * generator.uniform(), generator)
        begin = tips[parent or '']
        tips[name] = begin + longer * along
        placed[name] = begin, tips[name], first * thicker, last * thicker
    return placed


def surface_of(placed, spacing=0.05):
    """Points and triangles of the union of rounded cones."""
    low = numpy.min([end - 0.7 for limb in placed.values() for end in limb[:2]], axis=0)
    high = numpy.max([end + 0.7 for limb in placed.values() for end in limb[:2]], axis=0)
    counts = numpy.ceil((high - low) / spacing).astype(int) + 1
    axes = [start + spacing * numpy.arange(count) for start, count in zip(low, counts)]
    z, y, x = numpy.meshgrid(axes[2], axes[1], axes[0], indexing='ij')
    grid = numpy.column_stack([x.ravel(), y.ravel(), z.ravel()])
    least = numpy.full(len(grid), numpy.inf)
    for begin, tip, first, last in placed.values():
        axis = tip - begin
        t = ((grid - begin) @ axis / (axis @ axis)).clip(0.0, 1.0)
        least = numpy.minimum(
            least, numpy.linalg.norm(grid - begin - t[:, None] * axis, axis=1) - first - t * (last - first))
    image = vtkImageData()
    image.SetDimensions(*map(int, counts))
    image.SetOrigin(*low)
    image.SetSpacing(spacing, spacing, spacing)
    image.GetPointData().SetScalars(numpy_to_vtk(least, deep=True))
    contour = vtkFlyingEdges3D()
    contour.SetInputData(image)
    contour.SetValue(0, 0.0)
    contour.Update()
    output = contour.GetOutput()
    triangles = vtk_to_numpy(output.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    return vtk_to_numpy(output.GetPoints().GetData()).astype(float), triangles


Pair = collections.namedtuple('Pair', 'a b truth')  # files of both; truth takes places of A to B


def made_pair(name, folder):
    generator = numpy.random.RandomState(zlib.crc32(name.encode()))
    limbs = KINDS[name.split('-')[0]]
    pose = CorrespondencePairs.random_pose(generator)
    both = [place_limbs(limbs, generator, 0.0), place_limbs(limbs, generator, 1.0)]
    surfaces = [surface_of(placed) for placed in both]
    while PairDeformation.facts(*surfaces[1])['euler'] != 2:  # two limbs touch
        both[1] = place_limbs(limbs, generator, 1.0)
        surfaces[1] = surface_of(both[1])
    tips = [numpy.array([limb[1] for limb_name, limb in placed.items() if not limb_name.endswith('.')])
            for placed in both]
    paths = [os.path.join(folder, name + side + '.off') for side in 'AB']
    PairDeformation.write(paths[0], *surfaces[0])
    PairDeformation.write(paths[1], surfaces[1][0] @ pose.T, surfaces[1][1])
    return Pair(*paths, lambda place: (tips[1] @ pose.T)[nearest(tips[0], place)])


def animal_pair(name, folder, program):
    facts, = CorrespondencePairs.pairs(folder, [name], program=program)
    paths = [os.path.join(facts['folder'], side + '.off') for side in 'AB']
    points = PairDeformation.read(paths[0])[0]
    truth = numpy.loadtxt(os.path.join(facts['folder'], 'truth.txt'))[:, 4:]
    return Pair(*paths, lambda place: truth[nearest(points, place)])


def nearest(places, place):
    return numpy.linalg.norm(places - place, axis=1).argmin()


def in_place(numbers, path):
    """Positions of the program in the space of the model that it read."""
    points = PairDeformation.read(path)[0]
    middle = 0.5 * (points.min(axis=0) + points.max(axis=0))
    size = numpy.ptp(points, axis=0).max()
    return numpy.array(numbers).reshape(-1, 3) * size + middle, size


def judge(pair, row):
    """How many ends are right and wrong, of those that are sure and of those that are ambiguous."""
    ends, _ = in_place(row['ends'], pair.a)
    places, size = in_place(row['to'], pair.b)
    others, _ = in_place(row['targetends'], pair.b)
    counts = collections.Counter()
    for end, place, sure in zip(ends, places, row['sure']):
        wanted = pair.truth(end)
        gap = numpy.linalg.norm(others - wanted, axis=1).min() + NEAR * size
        right = numpy.linalg.norm(place - wanted) <= gap
        counts[('' if sure else 'ambiguous ') + ('right' if right else 'wrong')] += 1
    return counts


def outcome_of(row):
    for word, begin in (('matched', 'matched'), ('ambiguous', 'the matching is ambiguous'),
                        ('too many', 'there are too many'), ('different', 'the skeletons are different')):
        if row['outcome'].startswith(begin):
            return word
    return 'proportions'


def main():
    parser = sweep.parser(__doc__, models=False)
    parser.add_argument('folder')
    parser.add_argument('names', nargs='*', metavar='PAIR')
    options = parser.parse_args()
    os.makedirs(options.folder, exist_ok=True)
    program, claims = sweep.Program(options), sweep.Claims()
    table = sweep.Table('pair:<18', 'outcome:<11', 'branches:8d', 'targetbranches:14d', 'leftout:7d',
                        'difference:10.3f', 'right:5d', 'wrong:5d', 'ambiguous:9d', 'changed:7d',
                        'outside:7d', 'cpu:6.1f')
    found = collections.Counter()
    for name in options.names or MADE + ANIMALS:
        made = name in MADE
        pair = made_pair(name, options.folder) if made else animal_pair(name, options.folder, program)
        row = program.run('skeleton_pair', pair.a, pair.b).row()
        outcome, ends = outcome_of(row), judge(pair, row)
        ambiguous = ends['ambiguous right'] + ends['ambiguous wrong']
        table.print({**row, 'pair': name, 'outcome': outcome, 'right': ends['right'],
                     'wrong': ends['wrong'], 'ambiguous': ambiguous})
        found[outcome] += 1
        claims.at_most(name, 'wrong ends that are not ambiguous', ends['wrong'], 0)
        claims.at_most(name, 'renumberings with another result', row['changed'], 0)
    for outcome, count in sorted(found.items()):
        claims.note('all', outcome, count)
    if not options.names:
        claims.at_least('all', 'matched', found['matched'], 8)
    claims.finish()


if __name__ == '__main__':
    main()
