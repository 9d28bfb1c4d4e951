"""200 eigenpairs of a surface of 44,460 points, beside scipy's eigsh (ARPACK with a shift, SuperLU) on
the same matrices, one thread each, in turn. It takes at most half as long, and the eigenvalues agree.
Needs Debian's python3-scipy.

    /usr/bin/python3 Testing/Benchmarks/LaplaceSpectrum.py [--pairs 200] [--runs 1] [MODEL]
"""
import tempfile
import time

import sweep

sweep.use_one_thread()  # before numpy is loaded

import numpy  # noqa: E402
import scipy.sparse  # noqa: E402
import scipy.sparse.linalg  # noqa: E402

MOST = 0.5  # of scipy's seconds


def matrices(path):
    """The stiffness and the masses that the case laplace_spectrum wrote."""
    values = numpy.fromfile(path)
    points = int(values[0])
    masses, rest = values[1:1 + points], values[1 + points:]
    rows, columns, entries = rest[1:].reshape(3, int(rest[0]))
    stiffness = scipy.sparse.csc_matrix((entries, (rows.astype(int), columns.astype(int))),
                                        shape=(points, points))
    return stiffness, scipy.sparse.diags(masses, format='csc')


def solve_by_scipy(stiffness, masses, pairs):
    """The row of eigsh (ARPACK)."""
    start, cpu = time.perf_counter(), time.process_time()
    values, functions = scipy.sparse.linalg.eigsh(stiffness, pairs, masses, sigma=-1e-8)
    wall, cpu = time.perf_counter() - start, time.process_time() - cpu
    weighted = (masses @ functions) * values
    residuals = numpy.linalg.norm(stiffness @ functions - weighted, axis=0)[1:]
    residuals /= numpy.linalg.norm(weighted, axis=0)[1:]
    return dict(points=stiffness.shape[0], pairs=pairs, cpu=cpu, wall=wall, residual=residuals.max(),
                first=values[1], last=values[-1])


def main():
    parser = sweep.parser(__doc__)
    parser.add_argument('--pairs', type=int, default=200)
    parser.add_argument('--runs', type=int, default=1)
    options = parser.parse_args()
    program, claims = sweep.Program(options), sweep.Claims()
    table = sweep.Table('model:<18', 'method:<9', 'points:7d', 'pairs:5d', 'cpu:8.2f', 'wall:8.2f',
                        'mib:6.0f', 'residual:9.2g', 'first:12.9g', 'last:12.9g')
    for name, path in sweep.models(options, ['refined_elephant']):
        with tempfile.NamedTemporaryFile() as file:
            def solve():
                return program.run('laplace_spectrum', path, options.pairs, file.name).row()
            ours, peer = sweep.medians(
                options.runs, solve, lambda: solve_by_scipy(*matrices(file.name), options.pairs))
        for method, row in (('ShapeMap', ours), ('scipy', peer)):
            table.print(dict(row, model=name, method=method))
        claims.at_most(name, "CPU seconds, of scipy's", ours['cpu'] / peer['cpu'], MOST)
        claims.at_most(name, "difference from scipy's first and last eigenvalue", max(
            abs(ours[key] / peer[key] - 1.0) for key in ('first', 'last')), 1e-6)
    claims.finish()


if __name__ == '__main__':
    main()
