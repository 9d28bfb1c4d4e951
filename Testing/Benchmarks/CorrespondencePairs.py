"""Pairs of surfaces with the true correspondence, from the models that the build downloads: a
model, and the same one moved by a known map, each remeshed for itself.

    /usr/bin/python3 Testing/Benchmarks/CorrespondencePairs.py FOLDER [--points 5000] [PAIR ...]

Writes a folder for each pair, prints a line for each and fails where a surface is not what its row
says. For other benchmarks: `for pair in pairs(folder, names, points)`. What lies in the folder:

A.off, B.off       the surfaces; their numbering, pose and triangles are independent
truth.txt          a line for each point of A: its triangle of B, barycentric coordinates, position
mirrored.txt       the same for the mirror image of the truth, where the model has a known one
landmarks5.txt, landmarks12.txt   a line each: point of A, nearest point of B, position on B
facts.json         what is printed

Needs Debian's python3-scipy and python3-vtk9.
"""
import json
import os
import zlib

import sweep

sweep.use_one_thread()  # before numpy is loaded

import numpy  # noqa: E402
import scipy.sparse.csgraph  # noqa: E402
import scipy.spatial.transform  # noqa: E402

import PairDeformation as shapes  # noqa: E402

X, Y, Z = (1, 0, 0), (0, 1, 0), (0, 0, 1)
FINE = 8000       # a model of fewer points is split before it is moved
SYMMETRIC = 0.05  # of the longest side: 95 % of a model's points have a mirror image this near


def limbs(kind, places, begin, end, axis, amounts):
    return [(kind, place, begin, end, axis, amount) for place, amount in zip(places, amounts)]


MAN_HANDS = (.02, .18, .42), (.33, .05, .49)
MAN_FEET = (.38, .0, .02), (.01, .18, .0)
HOMER_HANDS = (.55, .56, .31), (.01, .56, .31)
HOMER_FEET = (.39, .01, .14), (.17, .0, .18)
ARMADILLO_HANDS = (.07, .8, .0), (.77, .89, .09)
ARMADILLO_FEET = (.66, .0, .36), (.07, .01, .35)
CAMEL_FEET = (.28, .0, .15), (.03, .0, .15), (.27, .0, .62), (.04, .0, .62)
COW_FEET = (.16, .0, .06), (.16, .0, .27), (.64, .01, .07), (.64, .01, .25)
DINO_FEET = (.02, .36, .0), (.46, .39, .01)
TRICERATOPS_FEET = (.41, .0, .0), (.39, .0, .31), (.63, .0, .27), (.63, .01, .05)
BEAR_HANDS = (.05, .62, .16), (.78, .58, .26)
BEAR_FEET = (.01, .09, .28), (.77, .17, .15)

HOMER_SITS = (limbs('turn', HOMER_FEET, .22, .36, X, (-95, -95))
              + limbs('turn', HOMER_HANDS, .18, .28, Z, (70, -70)))
ARMADILLO_BENDS = (limbs('turn', ARMADILLO_HANDS, .25, .42, X, (100, 100))
                   + limbs('turn', ARMADILLO_FEET, .22, .46, X, (-95, -95))
                   + [('turn', (.38, .28, .76), .1, .35, X, 90)])
COW_KNEELS = limbs('turn', COW_FEET, .13, .26, Z, (95, 95, -95, -95))
DINO_TURNS = ([('turn', (.25, .01, .95), .3, .55, X, 80),
               ('turn', (.23, .91, .33), .1, .45, Z, 100)]
              + limbs('turn', DINO_FEET, .3, .5, X, (90, 90)))

def ends(one, other, middle):
    """Two tips turned, and the surroundings of a place swollen."""
    return [('turn', one, .1, .35, Y, 60), ('turn', other, .1, .35, X, 50), ('swell', middle, .1, .4, X, 1.3)]


# name: group, model, mirror axis or None, whether the shape has an intrinsic mirror image, changes,
# and what is done to one side: ('cut', axis, share of the box that goes) to A, ('noise', share of
# an edge) to B
PAIRS = {
    'man-walks': ('isometric', 'man', None, True,
                  limbs('turn', MAN_HANDS, .14, .24, X, (-100, -100))
                  + limbs('turn', MAN_FEET, .22, .34, X, (95, 95)), None),
    'homer-sits': ('isometric', 'homer', X, True, HOMER_SITS, None),
    'armadillo-bends': ('isometric', 'armadillo', X, True, ARMADILLO_BENDS, None),
    'camel-looks': ('isometric', 'camel', X, True,
                    limbs('turn', CAMEL_FEET, .22, .34, X, (90, 90, -90, -90))
                    + [('turn', (.14, .93, .97), .3, .55, Y, 100)], None),
    'cow-kneels': ('isometric', 'cow', Z, True, COW_KNEELS, None),
    'diplodocus-turns': ('isometric', 'diplodocus', None, True,
                         [('turn', (.97, .91, .29), .3, .6, Z, -90),
                          ('turn', (.0, .12, .16), .1, .4, Y, 100)], None),
    'dino-turns': ('isometric', 'dino', X, True, DINO_TURNS, None),
    'bear-bends': ('isometric', 'bear', X, True,
                   limbs('turn', BEAR_HANDS, .08, .28, Z, (-90, 90))
                   + limbs('turn', BEAR_FEET, .12, .42, Z, (-90, 90)), None),
    'triceratops-turns': ('isometric', 'triceratops', Z, True,
                          limbs('turn', TRICERATOPS_FEET, .1, .22, Z, (90, 90, -90, -90))
                          + [('turn', (.0, .27, .16), .1, .4, Y, 90)], None),
    'elephant-kneels': ('isometric', 'elephant', None, False,
                        [('turn', (.71, .2, .02), .14, .28, X, 90),
                         ('turn', (.01, .07, .1), .14, .28, Z, -90)], None),
    'bear-grows': ('stretched', 'bear', X, True,
                   limbs('stretch', BEAR_HANDS, .12, .3, X, (2, 2))
                   + limbs('turn', BEAR_FEET, .15, .4, Z, (-50, 50))
                   + [('swell', (.38, .37, .37), .1, .45, X, 1.5)], None),
    'homer-grows': ('stretched', 'homer', X, True,
                    limbs('stretch', HOMER_FEET, .2, .36, Y, (1.8, 1.8)) + HOMER_SITS
                    + [('swell', (.29, .39, .28), .05, .35, X, 1.4)], None),
    'cow-giraffe': ('stretched', 'cow', Z, True,
                    limbs('stretch', COW_FEET, .15, .32, Y, (1.9, 1.9, 1.9, 1.9)) + COW_KNEELS
                    + [('swell', (1., .47, .15), .12, .3, X, 1.5)], None),
    'man-fat': ('stretched', 'man', None, True,
                limbs('stretch', MAN_FEET, .25, .42, Z, (1.5, 1.5))
                + limbs('turn', MAN_HANDS, .14, .24, X, (-90, -90))
                + [('swell', (.21, .16, .5), .1, .45, X, 1.6)], None),
    'triceratops-tail': ('stretched', 'triceratops', Z, True,
                         [('stretch', (.0, .27, .16), .15, .4, X, 2),
                          ('turn', (.0, .27, .16), .1, .4, Y, 90),
                          ('swell', (1., .36, .16), .15, .4, X, .65)], None),
    'camel-big-head': ('stretched', 'camel', X, True,
                         limbs('stretch', CAMEL_FEET, .25, .45, Y, (.6, .6, .6, .6))
                         + [('turn', (.14, .93, .97), .3, .55, Y, 90),
                            ('swell', (.14, .93, .97), .15, .4, X, 1.6)], None),
    'armadillo-upper': ('partial', 'armadillo', X, True, ARMADILLO_BENDS, ('cut', Y, .45)),
    'cow-front': ('partial', 'cow', Z, True, COW_KNEELS, ('cut', X, .4)),
    'homer-noisy': ('noisy', 'homer', X, True, HOMER_SITS, ('noise', .25)),
    'dino-noisy': ('noisy', 'dino', X, True, DINO_TURNS, ('noise', .25)),
    # No threshold was chosen on these: those that were chosen on the others are asserted on them.
    'bull-turns': ('unseen', 'bull', None, True, ends((.92, .68, .65), (.02, .61, .69), (.5, .4, .4)), None),
    'elk-turns': ('unseen', 'elk', None, True, ends((.36, .91, .06), (.58, .27, .95), (.38, .11, .06)), None),
    'hand-turns': ('unseen', 'hand', None, False, ends((.34, .24, .72), (.7, .66, .77), (.54, .67, .06)), None),
    'bear-upper': ('unseen part', 'bear', X, True,
                   limbs('turn', BEAR_HANDS, .08, .28, Z, (-90, 90)), ('cut', Y, .4)),
    'camel-front': ('unseen part', 'camel', X, True,
                    limbs('turn', CAMEL_FEET, .22, .34, X, (90, 90, -90, -90))
                    + [('turn', (.14, .93, .97), .3, .55, Y, 100)], ('cut', Z, .35)),
    'cactus-turns': ('unseen', 'cactus', None, True, ends((.59, .93, .07), (.03, .96, .11), (.21, .0, .11)), None),
    # Copies, remeshed and numbered anew, of models on which nothing was chosen either.
    **{model + '-copied': ('copied', model, None, reflects, [], None) for model, reflects in (
        ('bear_bis', False), ('bunny00', False), ('retinal', False), ('femur', False), ('knot', True),
        ('blobby', True), ('helmet', True), ('eight', True))},
}


def remeshed(points, triangles, wanted, rounds, program, work):
    """About `wanted` points on the surface, from the kernel, in the surface's own place."""
    shapes.write(work + '.in.off', points, triangles)
    area = 0.5 * numpy.linalg.norm(shapes.area_vectors(points, triangles), axis=1).sum()
    size = numpy.ptp(points, axis=0).max()
    middle = 0.5 * (points.min(axis=0) + points.max(axis=0))
    edge = numpy.sqrt(2.0 * area / (numpy.sqrt(3.0) * wanted)) / size
    for _ in range(2):
        program.run('remesh', work + '.in.off', repr(float(edge)), rounds, 60, work + '.out.off').row()
        new, faces = shapes.read(work + '.out.off')
        edge *= numpy.sqrt(len(new) / wanted)
    os.remove(work + '.in.off')
    os.remove(work + '.out.off')
    return new * size + middle, faces


def mirror(points, triangles, axis):
    """The rigid reflection nearest to that across the box's middle that takes the surface onto
    itself, by iterated closest points: a matrix, an offset, and the 95th percentile of the distance
    to the surface in parts of the longest side."""
    locator = shapes.Locator(points, triangles)
    matrix = numpy.eye(3) - 2.0 * numpy.outer(axis, axis)
    offset = (points.min(axis=0) + points.max(axis=0)) * axis
    sample = points[::max(1, len(points) // 3000)]
    for _ in range(30):
        images = sample @ matrix.T + offset
        nearest = numpy.array([locator.nearest(image)[0] for image in images])
        left, _, right = numpy.linalg.svd((nearest - nearest.mean(axis=0)).T
                                          @ (sample - sample.mean(axis=0)))
        left[:, 2] *= -numpy.linalg.det(left @ right)  # a reflection, not a rotation
        matrix = left @ right
        offset = nearest.mean(axis=0) - sample.mean(axis=0) @ matrix.T
    images = sample @ matrix.T + offset
    gaps = [numpy.linalg.norm(locator.nearest(image)[0] - image) for image in images]
    return matrix, offset, numpy.percentile(gaps, 95) / numpy.ptp(points, axis=0).max()


def without(points, triangles, axis, share):
    """The largest component of what lies beyond a share of the box along an axis."""
    along = points @ axis
    level = along.min() + share * numpy.ptp(along)
    kept = triangles[along[triangles].mean(axis=1) > level]
    while True:  # triangles that hang on one point only, or on one edge, go
        graph = scipy.sparse.csr_matrix(
            (numpy.ones(3 * len(kept)), (kept.ravel(), kept[:, [1, 2, 0]].ravel())),
            shape=(len(points),) * 2)
        _, labels = scipy.sparse.csgraph.connected_components(graph, False)
        largest = numpy.bincount(labels[kept[:, 0]]).argmax()
        edges, shared = shapes.edges_of(kept)
        lone = {tuple(edge) for edge in edges[shared == 1]}
        borders = numpy.bincount(edges[shared == 1].ravel(), minlength=len(points))
        ears = numpy.array([sum(tuple(sorted((t[k], t[(k + 1) % 3]))) in lone for k in range(3)) > 1
                            for t in kept])
        good = (labels[kept[:, 0]] == largest) & ~ears & (borders[kept] <= 2).all(axis=1)
        if good.all():
            break
        kept = kept[good]
    used = numpy.unique(kept)
    place = numpy.full(len(points), -1)
    place[used] = numpy.arange(len(used))
    return points[used], place[kept]


def random_pose(generator):
    return scipy.spatial.transform.Rotation.random(random_state=generator).as_matrix()


def make(name, folder, wanted, program):
    group, model, axis, reflects, changes, side = PAIRS[name]
    work = os.path.join(folder, 'work')
    generator = numpy.random.RandomState(zlib.crc32(name.encode()))
    points, triangles = shapes.read(program.model(model))
    while len(points) < FINE:
        points, triangles = shapes.split(points, triangles)
    after = shapes.moved(points, triangles, changes) @ random_pose(generator).T
    edges, _ = shapes.edges_of(triangles)
    ratios = numpy.abs(numpy.log(
        numpy.linalg.norm(after[edges[:, 0]] - after[edges[:, 1]], axis=1)
        / numpy.linalg.norm(points[edges[:, 0]] - points[edges[:, 1]], axis=1)))
    a, faces_a = remeshed(points, triangles, wanted, 6, program, work)
    order = generator.permutation(len(triangles))
    b, faces_b = remeshed(after, triangles[order], 0.9 * wanted, 8, program, work)
    if side and side[0] == 'cut':
        a, faces_a = without(a, faces_a, numpy.array(side[1]), side[2])
    before, beyond = shapes.Locator(points, triangles), shapes.Locator(b, faces_b)
    normals = shapes.point_normals(after, triangles)
    if side and side[0] == 'noise':
        edge = numpy.sqrt(numpy.linalg.norm(beyond.normals, axis=1).mean() * 2.0 / numpy.sqrt(3.0))
        b = b + shapes.point_normals(b, faces_b) * generator.normal(
            0.0, side[1] * edge, len(b))[:, None]

    def carried(places, directions):
        """Places near the model: where the map takes them on B, and how many face the wrong way."""
        cells, weights, _, wrong = before.find(places, directions)
        there = before.places(cells, weights, after)
        cells, weights, _, wrong_there = beyond.find(there, before.places(cells, weights, normals))
        return cells, weights, beyond.places(cells, weights, b), wrong + wrong_there

    directions = shapes.point_normals(a, faces_a)
    truth = carried(a, directions)
    lines = {'truth': truth}
    gap = None
    if axis:
        matrix, offset, gap = mirror(points, triangles, numpy.array(axis))
        if gap < SYMMETRIC:
            lines['mirrored'] = carried(a @ matrix.T + offset, directions @ matrix.T)
    shapes.write(os.path.join(folder, 'A.off'), a, faces_a)
    shapes.write(os.path.join(folder, 'B.off'), b, faces_b)
    for word, (cells, weights, places, _) in lines.items():
        numpy.savetxt(os.path.join(folder, word + '.txt'),
                      numpy.column_stack([cells, weights, places]), ['%d'] + 6 * ['%.17g'])
    nearest = scipy.spatial.cKDTree(b).query(truth[2])[1]
    for count in (5, 12):
        marks = shapes.farthest_points(a, faces_a, count)
        numpy.savetxt(os.path.join(folder, 'landmarks%d.txt' % count),
                      numpy.column_stack([marks, nearest[marks], truth[2][marks]]),
                      ['%d', '%d'] + 3 * ['%.17g'])
    return {'name': name, 'group': group, 'model': model, 'wanted': wanted, 'reflects': reflects,
            'mirrored': 'mirrored' in lines, 'asymmetry': gap, 'A': shapes.facts(a, faces_a),
            'B': shapes.facts(b, faces_b), 'opposite': truth[3],
            'distortion_mean': ratios.mean(), 'distortion_95': numpy.percentile(ratios, 95)}


def pairs(folder, names=None, points=5000, program=sweep.Program()):
    """Yields the facts of each pair, with `folder` where its files are; makes those that are not
    there with as many points."""
    for name in names or PAIRS:
        place = os.path.join(folder, name)
        path = os.path.join(place, 'facts.json')
        found = None
        if os.path.exists(path):
            with open(path, encoding='ascii') as file:
                found = json.load(file)
        if not found or found['wanted'] != points:
            os.makedirs(place, exist_ok=True)
            found = make(name, place, points, program)
            with open(path, 'w', encoding='ascii') as file:
                json.dump(found, file, indent=1)
        yield {**found, 'folder': place}


def sane(pair):
    whole = pair['group'] not in ('partial', 'unseen part')
    return (all(pair[side]['components'] == 1 and pair[side]['nonmanifold'] == 0 for side in 'AB')
            and pair['B']['border'] == 0 and (pair['A']['border'] == 0) == whole
            and (not whole or pair['A']['euler'] == pair['B']['euler'])
            and pair['opposite'] <= 0.001 * pair['A']['points'])


def main():
    parser = sweep.parser(__doc__, models=False)
    parser.add_argument('folder')
    parser.add_argument('names', nargs='*', metavar='PAIR')
    parser.add_argument('--points', type=int, default=5000)
    options = parser.parse_args()
    claims = sweep.Claims()
    for pair in pairs(options.folder, options.names, options.points, sweep.Program(options)):
        print('%-18s %-9s A %5d points, %3d border; B %5d; Euler %3d; components %d; edges change '
              '%.3f (95 %%: %.3f); mirror image %s; facing away %d' % (
                  pair['name'], pair['group'], pair['A']['points'], pair['A']['border'],
                  pair['B']['points'], pair['B']['euler'], pair['B']['components'],
                  pair['distortion_mean'], pair['distortion_95'],
                  'none' if not pair['reflects'] else
                  'given' if pair['mirrored'] else 'not given', pair['opposite']), flush=True)
        claims.check(pair['name'], 'surfaces', 'sound' if sane(pair) else 'unsound', sane(pair),
                     'as its row says')
    claims.finish()


if __name__ == '__main__':
    main()
