"""Maps through hyperbolic orbifolds from 5 to 20 landmarks, on pairs made of real models.

    /usr/bin/python3 Testing/Benchmarks/HyperbolicOrbifold.py FOLDER [--points 5000] [--pairs NAME ...]

FOLDER gets the pairs (CorrespondencePairs.py says what they are) where they are not there yet. A map that turns
a triangle over on its tile is an error, so each row has none. Prints a line for each map, then the claims and
whether they hold. Errors are lengths along the surface over the root of its area, times 1000. The peer is the
map through a common sphere from the same landmarks. One thread.
"""
import os

import sweep

sweep.use_one_thread()  # before numpy is loaded

import numpy  # noqa: E402

from CorrespondencePairs import pairs  # noqa: E402
import PairDeformation as shapes  # noqa: E402

NAMES = 'homer-sits', 'bear-grows', 'cow-giraffe', 'man-fat', 'camel-big-head'
COUNTS = 5, 8, 12, 16, 20
PEER = 'CommonSphere'


def write_landmarks(folder, count):
    """So many points of A, far from each other along it, and the nearest points of B to their true places."""
    path = os.path.join(folder, 'spread%d.txt' % count)
    (places, faces), (others, _) = (shapes.read(os.path.join(folder, name + '.off')) for name in 'AB')
    truth = numpy.loadtxt(os.path.join(folder, 'truth.txt'))[:, -3:]
    chosen = list(shapes.farthest_points(places, faces, count))
    partners = [int(numpy.linalg.norm(others - place, axis=1).argmin()) for place in truth[chosen]]
    kept = [k for k in range(count) if partners[k] not in partners[:k]]
    with open(path, 'w', encoding='ascii') as file:
        file.writelines('%d %d\n' % (chosen[k], partners[k]) for k in kept)
    return os.path.basename(path), [chosen[k] for k in kept], others[[partners[k] for k in kept]]


def measure(program, pair, count, method):
    """The row of a map, with the largest error of a landmark over the longest side."""
    marks, chosen, wanted = write_landmarks(pair['folder'], count)
    images = os.path.join(pair['folder'], 'images.txt')
    found = program.run('correspondence', pair['folder'], marks, method, images, seconds=1200)
    if found.error:
        return None, found.error
    misses = numpy.linalg.norm(numpy.loadtxt(images)[chosen] - wanted, axis=1)
    return dict(found.row(), landmark=misses.max() / numpy.ptp(wanted, axis=0).max()), ''


def main():
    parser = sweep.parser(__doc__, models=False)
    parser.add_argument('folder')
    parser.add_argument('--points', type=int, default=5000)
    parser.add_argument('--pairs', nargs='+', default=NAMES)
    options = parser.parse_args()
    program, claims, rows, refused = sweep.Program(options), sweep.Claims(), [], []
    table = sweep.Table('pair:<18', 'landmarks:9d', 'method:<14', 'mean:8.2f', 'median:8.2f', 'trip:8.4f',
                        'reversed:9.5f', 'landmark:9.1e', 'cpu:7.2f')
    for pair in pairs(options.folder, options.pairs, options.points, program):
        for count in COUNTS:
            for method in ('CommonOrbifold', PEER):
                row, error = measure(program, pair, count, method)
                first = dict(pair=pair['name'], landmarks=count, method=method)
                if row is None:
                    refused.append((pair['name'], count, method))
                    table.print(first, 'refused: ' + error)
                    continue
                rows.append({**row, **first})
                table.print(rows[-1])
    own = [row for row in rows if row['method'] == 'CommonOrbifold']
    claims.none('hyperbolic orbifold', 'maps refused', [row for row in refused if row[2] == 'CommonOrbifold'])
    claims.at_most('hyperbolic orbifold', 'largest error of a landmark', max(row['landmark'] for row in own), 1e-9)
    for key, what in (('cpu', 'CPU seconds'), ('mean', 'mean error')):
        ours, theirs = (sum(row[key] for row in rows if row['method'] == method)
                        for method in ('CommonOrbifold', PEER))
        claims.note('hyperbolic orbifold', what + ', of that of ' + PEER, '%.2f' % (ours / theirs))
    claims.finish()


if __name__ == '__main__':
    main()
