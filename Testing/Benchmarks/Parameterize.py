"""Sphere, orbifold, disk and free-boundary maps of every surface of genus 0 in a folder of OFF files: a
table of flipped triangles, by exact orientations, energies and CPU seconds. Closed surfaces are cut
open along a tree of paths for the maps to the plane. No map may have a flipped triangle or be refused,
but for the conformal map alone, which may flip: FreeBoundary refines.

    python3 Testing/Benchmarks/Parameterize.py [--seconds 600] [MODEL ...]
"""
import sweep

MAPS = ('Sphere', 'Orbifold3', 'Orbifold4', 'Disk', 'Conformal', 'FreeBoundary')
MAY_FAIL = ('Conformal',)


def main():
    parser = sweep.parser(__doc__)
    parser.add_argument('--seconds', type=int, default=600, help='most for one model')
    options = parser.parse_args()
    sweep.use_one_thread()
    program, claims = sweep.Program(options), sweep.Claims()
    counts = {kind: [0, 0, 0] for kind in MAPS}  # maps, refused, with flips
    failures = []
    table = sweep.Table('model:<24', 'map:<12', 'points:7d', 'flips:6d', 'energy:10.6g',
                        'conformal:9.5g', 'iterations:10d', 'cpu:8.2f')
    for name, path in sweep.models(options):
        found = program.run('parameterize', path, seconds=options.seconds)
        if found.error and (found.rows or found.code not in (1, found.DOES_NOT_APPLY)):
            failures.append('%s: %s' % (name, found.error))
        for row in found.rows[1:]:
            kind, flips = row['map'], row['flips']
            is_refused = flips < 0
            table.print(dict(row, model=name, points=found.rows[0]['points'],
                             flips=None if is_refused else flips), row['message'] * is_refused)
            for index, happened in enumerate((True, is_refused, flips > 0)):
                counts[kind][index] += happened
            if flips != 0 and kind not in MAY_FAIL:
                failures.append('%s: %s: %s' % (
                    name, kind, row['message'] if is_refused else '%d flips' % flips))
    for kind in MAPS:
        claims.note(kind, 'maps, refused, with flips', '%d, %d, %d' % tuple(counts[kind]))
    claims.none('all maps but ' + ', '.join(MAY_FAIL), 'refused, with flips or without an end', failures)
    claims.finish()


if __name__ == '__main__':
    main()
