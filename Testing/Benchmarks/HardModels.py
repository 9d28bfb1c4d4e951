"""The harmonic volume map of surfaces that are hard: needle triangles, thin parts, crossings, a high
genus. Each must finish with a root mean square error inside triangles of at most 5e-3 of the target's
size, or with an error that names the cause; never with a NaN, a crash or after the time limit.

    python3 Testing/Benchmarks/HardModels.py [--method Accelerated] [--limit 600] [MODEL ...]

Data A: a harmonic field; B, of surfaces of genus 0: the sphere map; C: a smooth map that is not
harmonic. All are given at the vertices, linear in the triangles between (Cases/VolumeMap.cxx).
"""
import math
import os

import sweep

MODELS = {'turbine': 'AC', 'cheese': 'AC', 'man': 'ABC', 'camel': 'ABC', 'cow': 'ABC', 'hand': 'ABC'}
LIMIT = 5e-3


def main():
    parser = sweep.parser(__doc__)
    parser.add_argument('--method', default='Accelerated')
    parser.add_argument('--limit', type=float, default=600.0, help='seconds for each')
    options = parser.parse_args()
    program, claims = sweep.Program(options), sweep.Claims()
    table = sweep.Table('model:<12', 'data:<4', 'cpu:8.2f', 'mib:8.1f', 'vertices:10.2e', 'inside:10.2e',
                        'interior:10.2e')
    cache = os.path.join(options.build, 'benchmarks')
    os.makedirs(cache, exist_ok=True)
    for name, path in sweep.models(options, MODELS):
        for data in MODELS.get(name, 'AC'):
            found = program.run('volume_map', path, data, options.method, seconds=options.limit,
                                Cache=cache, Winding=1, Interior=500)
            subject = '%s %s' % (name, data)
            if found.error:
                table.print(dict(model=name, data=data), found.error)
                # An error that the program reports names the cause; a crash and a missing end do not.
                claims.check(subject, 'ends', found.error.split('\n')[0], found.code in (1, found.DOES_NOT_APPLY),
                             'with figures or a reason')
                continue
            row = dict(found.row(), model=name)
            table.print(row)
            errors = [row[key] for key in ('vertices', 'inside', 'interior') if key != 'interior' or
                      data == 'A']
            claims.check(subject, 'errors', 'finite' if all(map(math.isfinite, errors)) else errors,
                         all(map(math.isfinite, errors)), 'finite')
            claims.at_most(subject, 'RMSE inside triangles', row['inside'], LIMIT)
    claims.finish()


if __name__ == '__main__':
    main()
