"""What maps between surfaces cost, beside scipy's eigsh (ARPACK with a shift, SuperLU) for 120
eigenpairs of each of the two surfaces, which is only the first step of a functional map: one thread
each, in one run.

    /usr/bin/python3 Testing/Benchmarks/CorrespondenceSpeed.py FOLDER [--pair homer-sits]

FOLDER gets the pair of 5,000 points and, in the folder 50000, that of 50,000 (CorrespondencePairs.py).
Needs Debian's python3-scipy.
"""
import os
import tempfile
import time

import LaplaceSpectrum  # sets one thread, before numpy is loaded
import scipy.sparse.linalg
import sweep
from CorrespondencePairs import pairs

EIGENPAIRS = 120
# Points, method, and at most so many times scipy's CPU seconds.
CLAIMS = ((5000, 'FunctionalMap', 1.25), (5000, 'ReversibleHarmonic', 2.0),
          (50000, 'FunctionalMap', 0.4), (50000, 'ReversibleHarmonic', 1.0))
MOST_MIB = 2048


def spectra(program, folder):
    """scipy's CPU seconds for both surfaces."""
    total = 0.0
    for name in ('A.off', 'B.off'):
        with tempfile.NamedTemporaryFile() as file:
            program.run('laplace_spectrum', os.path.join(folder, name), EIGENPAIRS, file.name).row()
            stiffness, masses = LaplaceSpectrum.matrices(file.name)
        start = time.process_time()
        scipy.sparse.linalg.eigsh(stiffness, EIGENPAIRS, masses, sigma=-1e-8)
        total += time.process_time() - start
    return total


def main():
    parser = sweep.parser(__doc__, models=False)
    parser.add_argument('folder')
    parser.add_argument('--pair', default='homer-sits')
    options = parser.parse_args()
    program, claims = sweep.Program(options), sweep.Claims()
    table = sweep.Table('points:6d', 'method:<18', 'cpu:8.2f', 'mib:6.0f', 'iterations:10d', 'mean:8.2f')
    for points in sorted({claim[0] for claim in CLAIMS}):
        folder = options.folder if points == 5000 else os.path.join(options.folder, str(points))
        pair = next(iter(pairs(folder, [options.pair], points, program)))['folder']
        peer = spectra(program, pair)
        table.print(dict(points=points, method='scipy', cpu=peer), 'the eigenpairs of both')
        for method, most in ((claim[1], claim[2]) for claim in CLAIMS if claim[0] == points):
            row = program.run('correspondence', pair, 'landmarks5.txt', method, 'none').row()
            table.print(dict(row, points=points, method=method))
            subject = '%d points, %s' % (points, method)
            claims.at_most(subject, "CPU seconds, of scipy's", row['cpu'] / peer, most)
            claims.at_most(subject, 'MiB', row['mib'], MOST_MIB)
    claims.finish()


if __name__ == '__main__':
    main()
