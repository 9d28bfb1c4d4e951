"""Damaged models turned into solids: each of the build's models as it is, then mutations of the closed ones.

    python3 Testing/Benchmarks/Solidify.py [--folder FOLDER] [--mutations 300] [--half 1] [--wrap] [MODEL ...]

Models are files in the formats OFF, STL, PLY and OBJ, also those in folders below, such as those of the
package assimp-testmodels in /usr/share/assimp/models. VTK reads the last three; its reader crashes on
issue623.ply of that package.

The mutations occur as often as in 10,000 printable models: 26 % have several components (debris), 22 %
edges that are not manifold (fins), 16 % degenerate triangles, 11 % holes, 10 % are not oriented, 45 %
cross themselves; and half of the files are soups. Every result must be valid for CGAL, or an error names
the defect; there is no crash and no run of more than 120 s; a right model stays bit for bit. --half 1 or 2
takes every other model, so that one half serves to develop and the other one to report. --wrap also wraps
each input that was changed by CGAL, with as many triangles; then the result must not be farther from the
input on 90 % of them, nor from the creases of the model, and take at most twice the time. --plates adds
damaged plates that are thinner than the offset of that wrap: the result must stay within half of their
thickness, so that both of their sides are kept.
"""
import collections
import os
import random
import tempfile

import sweep

SHARES = {'holes': 0.11, 'duplicates': 0.16, 'degenerate': 0.16, 'fins': 0.22, 'debris': 0.26,
          'crossing': 0.45, 'soup': 0.5, 'reversed': 0.10}
LIMIT = 120
# Of each of these, some plates.
PLATES = (['soup', 'holes'], ['duplicates', 'reversed'], ['fins', 'degenerate', 'debris'], ['soup', 'reversed'])


def write_plate(path, cells, thickness):
    """A plate of the size 1 x 0.8, each side of which has cells x cells squares."""
    number = cells + 1
    points = [(i / cells, 0.8 * j / cells, z) for z in (0.0, thickness) for j in range(number)
              for i in range(number)]
    triangles = []

    def add(*quad):
        triangles.extend([(quad[0], quad[1], quad[2]), (quad[0], quad[2], quad[3])])

    for j in range(cells):
        for i in range(cells):
            first = i + number * j
            below = (first, first + number, first + number + 1, first + 1)
            add(*below)
            add(*(point + number * number for point in reversed(below)))
    border = ([(i, 0) for i in range(cells)] + [(cells, j) for j in range(cells)] +
              [(cells - i, cells) for i in range(cells)] + [(0, cells - j) for j in range(cells)])
    for (i, j), (k, m) in zip(border, border[1:] + border[:1]):
        one, other = i + number * j, k + number * m
        add(one, other, other + number * number, one + number * number)
    with open(path, 'w') as file:
        file.write('OFF\n%d %d 0\n' % (len(points), len(triangles)))
        file.writelines('%.17g %.17g %.17g\n' % point for point in points)
        file.writelines('3 %d %d %d\n' % triangle for triangle in triangles)


def main():
    parser = sweep.parser(__doc__)
    parser.add_argument('--mutations', type=int, default=300)
    parser.add_argument('--half', type=int, choices=(1, 2))
    parser.add_argument('--wrap', action='store_true')
    parser.add_argument('--plates', action='store_true')
    options = parser.parse_args()
    program, claims = sweep.Program(options), sweep.Claims()
    counts = collections.Counter()
    table = sweep.Table('model:<24', 'method:<10', 'before:8d', 'after:8d', 'kept:8d', 'mended:7d', 'made:6d',
                        'gaps:4d', 'pieces:6d', 'euler:6d', 'valid:5d', 'grid:7.4f', 'distance:9.2e', 'crease:9.2e', 'away:9.2e', 'far:9.2e', 'cpu:7.2f')

    pairs = []  # ours and CGAL's, of the same input

    def solidify(name, path, mutations, seed):
        outcome = program.run('solidify', path, *mutations, seconds=LIMIT, Seed=seed, Wrap=int(options.wrap))
        what = ' '.join([name] + mutations)
        note = ' '.join(mutations)
        if outcome.error:
            counts['refused'] += 1
            table.print(dict(model=name), ('%s: ' % note if note else '') + outcome.error)
            claims.check(what, 'ends', outcome.error.split('\n')[0], outcome.code in (1, outcome.DOES_NOT_APPLY),
                         'with a solid or a reason')
            return None
        for row in outcome.rows:
            table.print(dict(row, model=name), note)
        row = outcome.rows[0]
        counts[row['method']] += 1
        if len(outcome.rows) > 1:
            pairs.append((row, outcome.rows[1]))
        claims.at_least(what, 'valid for CGAL', row['valid'], 1)
        return row

    sound = []
    models = sweep.models(options, formats=('.off', '.stl', '.ply', '.obj'))
    if options.half:
        models = models[options.half - 1::2]
    for name, path in models:
        row = solidify(name, path, [], 1)
        if row and row['method'] == 'unchanged':
            claims.at_least(name, 'bit for bit', row['same'], 1)
            sound.append((name, path))
    print('as they are:', dict(counts))
    counts.clear()
    chance = random.Random(1)
    for seed in range(options.mutations if sound else 0):
        mutations = []
        while not mutations:
            mutations = [each for each, share in SHARES.items() if chance.random() < share]
        name, path = chance.choice(sound)
        solidify(name, path, mutations, seed)
    print('mutations:', dict(counts))
    with tempfile.TemporaryDirectory() as folder:
        for cells in (10, 20, 40) if options.plates else ():
            thickness = 1.0 / (90.0 * cells)
            path = os.path.join(folder, 'plate%d.off' % cells)
            write_plate(path, cells, thickness)
            for seed, mutations in enumerate(PLATES):
                row = solidify('plate%d' % cells, path, mutations, seed)
                claims.at_most('plate%d %s' % (cells, ' '.join(mutations)), 'distance from the plate in %',
                               row['distance'] if row else float('inf'), 50.0 * thickness)
    if pairs:
        def share(figure, chosen=pairs):
            return sum(ours[figure] <= peer[figure] for ours, peer in chosen) / max(len(chosen), 1)
        claims.at_least('beside CGAL', 'share not farther by the larger distance', share('far'), 0.9)
        claims.at_least('beside CGAL', 'share whose result is not farther from the input', share('away'), 0.9)
        creased = [pair for pair in pairs if max(each['crease'] for each in pair) > 0]
        claims.at_least('beside CGAL', 'share of creases not farther', share('crease', creased), 0.9)
        claims.at_most('beside CGAL', 'CPU seconds relative to CGAL',
                       sum(ours['cpu'] for ours, _ in pairs) / sum(peer['cpu'] for _, peer in pairs), 2.0)
    claims.finish()


if __name__ == '__main__':
    main()
