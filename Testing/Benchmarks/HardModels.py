"""The harmonic volume map of surfaces that are hard: needle triangles, thin parts, crossings, a high
genus. Each must finish with a root mean square error inside triangles of at most 5e-3 of the target's
size, or with an error that names the cause; never with a NaN, a crash or after the time limit. Prints a
table and exits with 1 where that is not so.

    python3 Testing/Benchmarks/HardModels.py [--method Accelerated] [--limit 600] [MODEL ...]

Data A: a harmonic field; B, of surfaces of genus 0: the sphere map; C: a smooth map that is not
harmonic. All are given at the vertices, linear in the triangles between (VolumeMapCase.cxx).
"""
import argparse
import math
import os
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
MODELS = {'turbine': 'AC', 'cheese': 'AC', 'man': 'ABC', 'camel': 'ABC', 'cow': 'ABC', 'hand': 'ABC'}
LIMIT = 5e-3


def judge(command, seconds):
    """Whether a measurement is as required, and its row."""
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=seconds)
    except subprocess.TimeoutExpired:
        return False, 'no end after %g s' % seconds
    if done.returncode < 0:
        return False, 'crashed with signal %d' % -done.returncode
    if done.returncode > 0:
        return True, 'error: ' + done.stderr.strip()
    words = dict(word.split('=', 1) for word in done.stdout.strip().split(' '))
    errors = [float(words[key]) for key in ('vertices', 'inside')]
    if words['data'] == 'A':
        errors.append(float(words['interior']))
    row = '%8.2f %8s %10.2e %10.2e %10s  %s' % (float(words['cpu']), words['mib'], *errors[:2], (
        '%10.2e' % errors[2] if len(errors) > 2 else ''), words['note'])
    return all(map(math.isfinite, errors)) and errors[1] <= LIMIT, row


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('models', nargs='*', default=list(MODELS), metavar='MODEL')
    parser.add_argument('--build', default=os.path.join(ROOT, 'build'))
    parser.add_argument('--folder', default=os.path.join(ROOT, 'build', 'models'))
    parser.add_argument('--case', help='another volume_map_case than the build\'s')
    parser.add_argument('--method', default='Accelerated')
    parser.add_argument('--limit', type=float, default=600.0, help='seconds for each')
    arguments = parser.parse_args()
    case = arguments.case or os.path.join(arguments.build, 'bin', 'volume_map_case')
    if not arguments.case:
        subprocess.run(['cmake', '--build', arguments.build, '--target', 'volume_map_case'],
                       check=True, stdout=subprocess.DEVNULL)
    cache = os.path.join(arguments.build, 'benchmarks')
    os.makedirs(cache, exist_ok=True)
    print('%-12s %-4s %8s %8s %10s %10s %10s' % (
        'model', 'data', 'CPU s', 'MiB', 'vertices', 'inside', 'interior'))
    missed = 0
    for model in arguments.models:
        for data in MODELS.get(model, 'AC'):
            met, row = judge([case, os.path.join(arguments.folder, model + '.off'), data,
                              arguments.method, 'Cache=' + cache, 'Winding=1', 'Interior=500'],
                             arguments.limit)
            missed += not met
            print('%-12s %-4s %s%s' % (model, data, row, '' if met else '  MISSED'), flush=True)
    print('%d missed' % missed)
    sys.exit(1 if missed else 0)


if __name__ == '__main__':
    main()
