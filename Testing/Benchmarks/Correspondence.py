"""Maps between surfaces against their true ones, by every method, on pairs made of real models.

    /usr/bin/python3 Testing/Benchmarks/Correspondence.py FOLDER [--points 5000] [--pairs NAME ...]
                                                          [--methods NAME ...]

FOLDER gets the pairs (CorrespondencePairs.py says what they are) where they are not there yet. Prints
a line for each map, then the claims and whether they hold. Errors are lengths along the surface over the root of its area, times 1000. One thread.
"""
import sweep
from CorrespondencePairs import pairs

# With how many landmarks each method runs, and on which groups of pairs; -12: twelve, and B mirrored,
# so that they are on the wrong sides; ALONE: none, and B mirrored.
ALONE = -1
WHOLE = ('isometric', 'stretched', 'noisy')
# The pairs on which the numbers of BlendedIntrinsic's triplets were chosen. Their worst mean is 70.
CHOSEN = ('man-walks', 'armadillo-bends', 'cow-kneels', 'dino-turns', 'triceratops-turns', 'bear-grows',
          'cow-giraffe', 'triceratops-tail')
RUNS = (
    ('FunctionalMap', 0, ('isometric', 'stretched', 'noisy')),
    ('FunctionalMap', 5, ('isometric', 'stretched', 'noisy')),
    ('FunctionalMap', 12, WHOLE),
    ('FunctionalMap', -12, WHOLE),
    ('FunctionalMap', 5, ('unseen',)),
    ('FunctionalMap', 12, ('unseen',)),
    ('FunctionalMap', -12, ('unseen',)),
    ('FunctionalMap', 0, ('copied',)),
    ('FunctionalMap', ALONE, ('copied',)),
    ('FunctionalMap', 12, ('copied',)),
    ('FunctionalMap', -12, ('copied',)),
    ('FunctionalMap', 0, ('partial',)),
    ('FunctionalMap', 5, ('partial',)),
    ('ReversibleHarmonic', 0, ('stretched',)),
    ('ReversibleHarmonic', 12, ('isometric', 'stretched', 'noisy')),
    ('ReversibleHarmonicFromCells', 12, ('stretched',)),
    ('GromovWasserstein', 12, ('isometric', 'stretched')),
    ('HeatKernel', 5, ('isometric', 'noisy')),
    ('HeatKernel', 12, ('stretched',)),
    ('HeatKernel', 5, ('partial', 'unseen part')),
    ('BlendedIntrinsic', 12, ('isometric', 'stretched')),
    ('BlendedIntrinsic', 0, ('isometric', 'stretched')),
    ('BlendedIntrinsicByVotes', 0, ('isometric', 'stretched')),
    ('BlendedIntrinsicOfTriplets', 0, ('isometric', 'stretched', 'unseen')),
    ('BlendedIntrinsicOfTriplets', 5, ('isometric', 'stretched')),
    ('CommonSphere', 12, ('isometric', 'stretched')),
    ('CommonOrbifold', 5, ('isometric', 'stretched')),
    ('CommonOrbifold', 12, ('isometric', 'stretched')),
    ('WeightedAverages', 12, ('isometric', 'stretched')),
)


def measure(program, folder, landmarks, method):
    """The outcome of a map: its figures, or what it refuses the pair for."""
    marks = 'landmarks%d.txt' % abs(landmarks) if landmarks not in (0, ALONE) else 'none'
    marks = 'mirrored:' + marks if landmarks < 0 else marks
    return program.run('correspondence', folder, marks, method, 'none', seconds=1200)


def mean(rows, method, landmarks, group, number):
    own = [row[number] for name, count, kind, row in rows
           if name == method and count == landmarks and kind == group]
    return sum(own) / len(own) if own else float('nan')


def check(claims, rows):
    """What is claimed."""
    def of(method, landmarks, *groups):
        return [row for name, count, kind, row in rows
                if name == method and count == landmarks and (kind in groups or not groups)]

    claims.at_most('functional map, 5 landmarks', 'isometric pairs: mean',
                   mean(rows, 'FunctionalMap', 5, 'isometric', 'mean'), 12.0)
    # A pair counts where its mirror image is known, and no distance tells it from the truth.
    told = [row for row in of('FunctionalMap', 0) if row['mirroredmean'] >= 0]
    right = [row for row in told if row['mean'] < row['mirroredmean']]
    claims.check('functional map, no landmarks', 'pairs with a mirror image that are not mirrored',
                 '%d of %d' % (len(right), len(told)),
                 len(told) >= 12 and 12 * len(right) >= 9 * len(told), 'at least 9 of 12, of 12 or more')
    for landmarks, most in ((5, 20.0), (0, 60.0)):
        parts = of('FunctionalMap', landmarks, 'partial')
        claims.check('functional map, %d landmarks' % landmarks, 'parts: means, known as parts', ', '.join(
            '%.1f (%s)' % (row['mean'], 'yes' if row['part'] == 1 else 'no') for row in parts),
            len(parts) == 2 and all(row['mean'] <= most and row['part'] == 1 for row in parts),
            'two, at most %g, all known' % most)
    def others(name):
        return [row['mean'] for row in of(name, 0, 'isometric', 'stretched') if row['pair'] not in CHOSEN]

    triplets, distances = others('BlendedIntrinsicOfTriplets'), others('BlendedIntrinsic')
    claims.check('blended intrinsic of triplets', 'means on other pairs', ', '.join('%.1f' % mean for mean in triplets),
                 len(triplets) >= 7 and sum(mean > 75 for mean in triplets) <= sum(mean > 75 for mean in distances),
                 'no more above 75 than with landmarks found by distances')
    # The floor of heat was chosen on the parts that were there first; these are others, with twice their error.
    parts = of('HeatKernel', 5, 'unseen part')
    claims.check('heat kernel, 5 landmarks', 'unseen parts: means, known as parts', ', '.join(
        '%.1f (%s)' % (row['mean'], 'yes' if row['part'] == 1 else 'no') for row in parts),
        len(parts) == 2 and all(row['mean'] <= 50 and row['part'] == 1 for row in parts), 'two, at most 50, all known')
    def mirrored(*kinds):
        own = [(marks, row) for name, marks, kind, row in rows if name == 'FunctionalMap' and kind in kinds]
        return ([row['turned'] for marks, row in own if marks < 0],
                [row['turned'] for marks, row in own if marks >= 0])

    subject = 'called mirrored: from landmarks on the wrong sides, others'
    wrong, others = mirrored(*WHOLE)
    claims.check('functional map', subject, '%d of %d, %d of %d' % (sum(wrong), len(wrong), sum(others), len(others)),
                 len(wrong) == 18 and all(wrong) and not any(others), '18 of 18, none')
    # The threshold was chosen on these 18. On other models, it calls no right map mirrored, but misses a thin
    # cactus, whose two sides are alike.
    wrong, others = mirrored('unseen')
    claims.check('functional map, unseen pairs', subject, '%d of %d, %d of %d' % (
        sum(wrong), len(wrong), sum(others), len(others)), len(others) == 8 and not any(others), 'none of the others')
    wrong, others = ([row['turned'] for marks in chosen for row in of('FunctionalMap', marks, 'copied')]
                     for chosen in ((-12,), (0, 12)))
    claims.check('functional map, copies', subject, '%d of %d, %d of %d' % (
        sum(wrong), len(wrong), sum(others), len(others)),
                 len(wrong) == 8 and len(others) == 16 and not any(others), 'none of the others')
    # Of the copies, tubes with many symmetries (knot, eight) reverse little: they are missed.
    # A shape with a mirror symmetry of its own is as near to its mirror image as to its copy.
    images = [row['image'] for row in of('FunctionalMap', ALONE, 'copied') if not row['reflects']]
    copies = [row['image'] for row in of('FunctionalMap', 0, 'copied')]
    claims.check('functional map, copies, no landmarks', 'known as mirror images: those without symmetry, not mirrored',
                 '%d of %d, %d of %d' % (sum(images), len(images), sum(copies), len(copies)),
                 len(images) == 4 and all(images) and len(copies) == 8 and not any(copies), '4 of 4, none of 8')
    for number, what in (('trip', 'round trip'), ('dirichlet', 'Dirichlet energy')):
        own = mean(rows, 'ReversibleHarmonic', 12, 'stretched', number)
        others = {name: mean(rows, name, 12, 'stretched', number) for name in
                  ('FunctionalMap', 'GromovWasserstein', 'HeatKernel', 'BlendedIntrinsic',
                   'CommonSphere')}
        claims.check('reversible harmonic, 12 landmarks', 'stretched pairs: ' + what, '%.4f' % own,
                     own < min(others.values()), 'the least of ' + ', '.join(
                         '%s %.4f' % other for other in others.items()))


def main():
    parser = sweep.parser(__doc__, models=False)
    parser.add_argument('folder')
    parser.add_argument('--points', type=int, default=5000)
    parser.add_argument('--pairs', nargs='+')
    parser.add_argument('--methods', nargs='+')
    options = parser.parse_args()
    program, claims, rows = sweep.Program(options), sweep.Claims(), []
    table = sweep.Table('pair:<18', 'group:<9', 'method:<27', 'landmarks:9d', *(
        key + ':9.2f' for key in ('mean', 'median', 'p95', 'mirroredmean')), 'trip:7.4f',
        'dirichlet:9.3f', 'cpu:8.2f', 'mib:6.0f')
    for pair in pairs(options.folder, options.pairs, options.points, program):
        for method, landmarks, groups in RUNS:
            if pair['group'] not in groups or options.methods and method not in options.methods:
                continue
            found = measure(program, pair['folder'], landmarks, method)
            first = dict(pair=pair['name'], group=pair['group'], method=method, landmarks=landmarks)
            if found.error:
                table.print(first, 'refused: ' + found.error)
                continue
            rows.append((method, landmarks, pair['group'],
                         {**found.row(), 'pair': pair['name'], 'reflects': pair['reflects']}))
            table.print({**found.row(), **first})
    table = sweep.Table('method:<27', 'landmarks:9d', 'group:<9', 'mean:9.2f', 'trip:7.4f',
                        'dirichlet:9.3f', 'cpu:8.2f')
    for method, landmarks, groups in RUNS:
        for group in groups:
            table.print(dict(method=method, landmarks=landmarks, group=group, **{
                number: mean(rows, method, landmarks, group, number)
                for number in ('mean', 'trip', 'dirichlet', 'cpu')}))
    if not options.pairs and not options.methods:
        check(claims, rows)
        claims.finish()


if __name__ == '__main__':
    main()
