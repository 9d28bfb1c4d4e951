"""200 eigenpairs of a surface of 44,460 points, beside scipy's eigsh (ARPACK with a shift, SuperLU) on
the same matrices, one thread each. Builds what it needs and fails where it takes more than half as
long, or the eigenvalues differ. Needs Debian's python3-scipy.

    /usr/bin/python3 Testing/Benchmarks/LaplaceSpectrum.py [--build build] [--pairs 200] [MODEL.off]
"""
import argparse
import os
import subprocess
import sys
import tempfile
import time

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
MOST = 0.5  # of scipy's seconds
for name in ('OPENBLAS_NUM_THREADS', 'OMP_NUM_THREADS', 'VTK_SMP_MAX_THREADS'):
    os.environ[name] = '1'  # before numpy is loaded

import numpy  # noqa: E402
import scipy.sparse  # noqa: E402
import scipy.sparse.linalg  # noqa: E402


def matrices(path):
    """The stiffness and the masses that spectrum_case wrote."""
    values = numpy.fromfile(path)
    points = int(values[0])
    masses, rest = values[1:1 + points], values[1 + points:]
    rows, columns, entries = rest[1:].reshape(3, int(rest[0]))
    stiffness = scipy.sparse.csc_matrix((entries, (rows.astype(int), columns.astype(int))),
                                        shape=(points, points))
    return stiffness, scipy.sparse.diags(masses, format='csc')


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('model', nargs='?', default='refined_elephant.off')
    parser.add_argument('--build', default=os.path.join(ROOT, 'build'))
    parser.add_argument('--pairs', type=int, default=200)
    arguments = parser.parse_args()
    subprocess.run(['cmake', '--build', arguments.build, '--target', 'spectrum_case'], check=True,
                   stdout=subprocess.DEVNULL)
    model = os.path.join(arguments.build, 'models', arguments.model)
    with tempfile.NamedTemporaryFile() as file:
        line = subprocess.run(
            [os.path.join(arguments.build, 'bin', 'spectrum_case'), model, str(arguments.pairs),
             file.name], check=True, capture_output=True, text=True).stdout
        stiffness, masses = matrices(file.name)
    print('ShapeMap', line.strip())
    ours = {key: float(value) for key, value in (word.split('=') for word in line.split())}
    start, cpu = time.perf_counter(), time.process_time()
    values, functions = scipy.sparse.linalg.eigsh(stiffness, arguments.pairs, masses, sigma=-1e-8)
    wall, cpu = time.perf_counter() - start, time.process_time() - cpu
    weighted = (masses @ functions) * values
    residuals = numpy.linalg.norm(stiffness @ functions - weighted, axis=0)[1:]
    residuals /= numpy.linalg.norm(weighted, axis=0)[1:]
    print('scipy    points=%d pairs=%d cpu=%.2f wall=%.2f residual=%.2g first=%.9g last=%.9g' % (
        stiffness.shape[0], arguments.pairs, cpu, wall, residuals.max(), values[1], values[-1]))
    ratio = ours['cpu'] / cpu
    print('CPU seconds: %.3f of scipy\'s (at most %g)' % (ratio, MOST))
    same = max(abs(ours['first'] / values[1] - 1), abs(ours['last'] / values[-1] - 1)) < 1e-6
    print('eigenvalues', 'agree' if same else 'DIFFER')
    sys.exit(0 if ratio <= MOST and same else 1)


if __name__ == '__main__':
    main()
