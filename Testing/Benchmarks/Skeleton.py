"""Curve skeletons beside those of CGAL: ours have as many cycles as the genus, are inside the surface and
close to CGAL's.

    python3 Testing/Benchmarks/Skeleton.py [--folder FOLDER] [MODEL ...]
"""
import sweep

MODELS = ('armadillo', 'bear', 'camel', 'cow', 'dino', 'eight', 'elephant', 'elk', 'hand', 'homer', 'knot1')


def main():
    options = sweep.parser(__doc__).parse_args()
    program, claims = sweep.Program(options), sweep.Claims()
    table = sweep.Table('model:<12', 'method:<6', 'points:6d', 'branches:8d', 'cycles:6d', 'genus:5d', 'outside:7d',
                        'distance:8.4f', 'inradii:8.3f',
                        'cpu:7.2f')
    for name, path in sweep.models(options, MODELS):
        outcome = program.run('skeleton', path)
        if outcome.error:
            table.print(dict(model=name), outcome.error)
            claims.check(name, 'ends', outcome.error.split('\n')[0], outcome.code == outcome.DOES_NOT_APPLY,
                         'with a skeleton, or a reason')
            continue
        for row in outcome.rows:
            table.print(dict(row, model=name))
        own = outcome.rows[0]
        claims.check(name, 'cycles', own['cycles'], own['cycles'] == own['genus'], 'the genus')
        claims.at_most(name, 'share outside', own['outside'] / own['points'], 0.05)
        if len(outcome.rows) > 1:
            claims.at_most(name, 'distance from CGAL', own['distance'], 0.02)
            print('%s: %.2f times the CPU time of CGAL' % (name, own['cpu'] / max(outcome.rows[1]['cpu'], 1e-3)))
    claims.finish()


if __name__ == '__main__':
    main()
