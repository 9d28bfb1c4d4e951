"""What maps between surfaces cost, beside scipy's eigsh (ARPACK with a shift, SuperLU) for 120
eigenpairs of each of the two surfaces, which is only the first step of a functional map: one thread
each, in one run. Fails where a ratio of CPU seconds, or memory, is above what is claimed.

    /usr/bin/python3 Testing/Benchmarks/CorrespondenceSpeed.py FOLDER [--pair homer-sits]

FOLDER gets the pair of 5,000 points and, in the folder 50000, that of 50,000 (CorrespondencePairs.py).
Needs Debian's python3-scipy.
"""
import argparse
import os
import subprocess
import sys
import tempfile
import time

import LaplaceSpectrum  # sets one thread, before numpy is loaded

import scipy.sparse.linalg
from CorrespondencePairs import ROOT, pairs

EIGENPAIRS = 120
# Points, method, and at most so many times scipy's CPU seconds.
CLAIMS = ((5000, 'FunctionalMap', 2.0), (5000, 'ReversibleHarmonic', 3.75),
          (50000, 'FunctionalMap', 0.4), (50000, 'ReversibleHarmonic', 1.25))
MOST_MIB = 2048


def words(line):
    return {key: float(value) for key, value in
            (word.split('=') for word in line.split()) if ',' not in value}


def spectra(build, folder):
    """scipy's CPU seconds for both surfaces."""
    total = 0.0
    for name in ('A.off', 'B.off'):
        with tempfile.NamedTemporaryFile() as file:
            subprocess.run([os.path.join(build, 'bin', 'spectrum_case'), os.path.join(folder, name),
                            str(EIGENPAIRS), file.name], check=True, stdout=subprocess.DEVNULL)
            stiffness, masses = LaplaceSpectrum.matrices(file.name)
        start = time.process_time()
        scipy.sparse.linalg.eigsh(stiffness, EIGENPAIRS, masses, sigma=-1e-8)
        total += time.process_time() - start
    return total


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('folder')
    parser.add_argument('--pair', default='homer-sits')
    parser.add_argument('--build', default=os.path.join(ROOT, 'build'))
    arguments = parser.parse_args()
    build = arguments.build
    subprocess.run(['cmake', '--build', build, '--target', 'correspondence_case', 'spectrum_case'],
                   check=True, stdout=subprocess.DEVNULL)
    held = True
    for points in sorted({claim[0] for claim in CLAIMS}):
        folder = arguments.folder if points == 5000 else os.path.join(
            arguments.folder, str(points))
        pair = next(iter(pairs(folder, [arguments.pair], points, build)))['folder']
        peer = spectra(build, pair)
        print('%6d points: scipy, the eigenpairs of both: %.2f CPU s' % (points, peer), flush=True)
        for method, most in ((claim[1], claim[2]) for claim in CLAIMS if claim[0] == points):
            row = words(subprocess.run(
                [os.path.join(build, 'bin', 'correspondence_case'), pair, 'landmarks5.txt', method,
                 'none'], check=True, capture_output=True, text=True).stdout)
            holds = row['cpu'] <= most * peer and row['mib'] <= MOST_MIB
            held = held and holds
            print('%6d points: %-18s %6.2f CPU s, %.3f of that (at most %g), %d MiB, %d iterations, '
                  'mean error %.2f: %s' % (
                      points, method, row['cpu'], row['cpu'] / peer, most, row['mib'],
                      row['iterations'], row['mean'], 'holds' if holds else 'FAILS'), flush=True)
    sys.exit(0 if held else 1)


if __name__ == '__main__':
    main()
