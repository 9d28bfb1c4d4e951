"""Features of real models set down on others, drawn with a fixed seed: every result must be a manifold,
watertight where both were, with the Euler number that gluing gives, in its old place when dropped there,
and meet the target smoothly; and features of 10,000 triangles dragged over a target of 75,000.

    /usr/bin/python3 Testing/Benchmarks/PasteFeatures.py [--build build] [--count 20]

Builds what it needs, prints a line for each, and fails where a claim at the end does not hold."""
import argparse
import os
import random
import subprocess
import sys

import numpy

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
MODELS = ['armadillo', 'bear', 'bull', 'bunny00', 'camel', 'cow', 'elephant', 'femur', 'hand',
          'homer', 'lion-head', 'man', 'mannequin-devil', 'pig', 'triceratops']
for threads in ('VTK_SMP_MAX_THREADS', 'OPENBLAS_NUM_THREADS', 'OMP_NUM_THREADS'):
    os.environ[threads] = '1'


def numbers(words):
    return numpy.array([float(word) for word in words.split(',') if word])


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--build', default=os.path.join(ROOT, 'build'))
    parser.add_argument('--case', help='the program, where it is not to be built')
    parser.add_argument('--count', type=int, default=20)
    arguments = parser.parse_args()
    case = arguments.case or os.path.join(arguments.build, 'bin', 'paste_case')
    if not arguments.case:
        subprocess.run(['cmake', '--build', arguments.build, '--target', 'paste_case'], check=True,
                       stdout=subprocess.DEVNULL)

    def run(*words):
        return subprocess.run([case, *words], capture_output=True, text=True, timeout=600).stdout

    def model(name):
        return os.path.join(arguments.build, 'models', name + '.off')

    draw = random.Random(2010)
    refused, wrong, before, after, in_place = 0, [], [], [], []
    for index in range(arguments.count):
        feature, target = draw.sample(MODELS, 2)
        lines = run('drop', model(feature), model(target), str(draw.randrange(1000))).splitlines()
        line = lines[-1] if lines else 'failed: no output'
        if 'refused=' in line:
            refused += 1
            print('%2d %s on %s: %s' % (index, feature, target, line))
            continue
        if not line.startswith('draws=') or 'failed:' in line:
            wrong.append(index)
            print('%2d %s on %s: %s' % (index, feature, target, line))
            continue
        facts = dict(word.split('=') for word in line.split())
        opened = [int(word) for word in facts['open'].split(',')]
        right = (int(facts['nonmanifold']) == 0 and opened[0] == opened[1] and int(facts['result']) ==
                 int(facts['target']) - 1 + int(facts['euler']))
        if not right:
            wrong.append(index)
        in_place.append(float(facts['inplace']))
        angles = numbers(facts['before']), numbers(facts['after'])
        before.append(angles[0])
        after.append(angles[1])
        print('%2d %s (%s triangles) on %s: %s; in place %.2g; layouts %s; angles, median and 95th '
              'percentile: %.1f %.1f before, %.1f %.1f after' % (
                  index, feature, facts['triangles'], target, 'right' if right else 'WRONG',
                  in_place[-1], facts['conformal'], *[numpy.percentile(values, share)
                                                      for values in angles for share in (50, 95)]))
        sys.stdout.flush()
    seconds = []
    for feature in ('refined_elephant', 'armadillo'):
        drag = run('drag', model(feature), model('bunny00'), '10000', '300').strip()
        print(feature, drag)
        seconds.append(float(dict(word.split('=') for word in drag.split())['cpu']))
    before, after = numpy.concatenate(before), numpy.concatenate(after)
    median, high = numpy.percentile(after, [50, 95])
    first = numpy.percentile(before, [50, 95])
    claims = [
        ('refused: at most 3 of 20', refused, refused <= 0.15 * arguments.count),
        ('wrong results: none', wrong, not wrong),
        ('farthest off in place, over the diagonal: 1e-6', max(in_place), max(in_place) < 1e-6),
        ('median of the angles at the joins: 3 degrees', median, median <= 3.0),
        ('95th percentile: 10 degrees', high, high <= 10.0),
        ('a third of %.1f and %.1f before' % tuple(first), (median, high),
         median <= first[0] / 3.0 and high <= first[1] / 3.0),
        ('updates a second while dragging: 15', 1.0 / max(seconds), max(seconds) <= 1 / 15),
    ]
    for claim, value, holds in claims:
        print('%s %s: %s' % ('holds' if holds else 'FAILS', claim, value))
    sys.exit(0 if all(holds for _, _, holds in claims) else 1)


if __name__ == '__main__':
    main()
