"""The sums of 1/r: pair by pair against the bound of the processor, and the multipole method against
the sum pair by pair. Builds what it needs, prints a table and fails where a ratio is missed. All
times are CPU seconds on one thread, medians of five.

    python3 Testing/Benchmarks/FastSummation.py [build folder, default build]
"""
import os
import re
import subprocess
import sys

LEAST_OF_BOUND = 0.85  # of the pairs that the instructions of the innermost loop allow
LEAST_SURFACE = 4.0    # times faster than pair by pair: 100,000 points on the surface, with set-up
LEAST_INSIDE = 25.0    # 1,000,000 points in the volume, with set-up
# Arithmetic of the innermost loop; moves, loads and the loop's own counting go beside it.
ARITHMETIC = re.compile(r'\tv(sub|add|mul|fn?m(add|sub)\d+|rsqrt14)pd\t?')
ADDITION = re.compile(r'\tv(sub|add)pd\t?')


def innermost_loop(program, target):
    """The instructions of the loop over the sources, for three charges and two vectors of points."""
    listing = subprocess.run(['objdump', '-d', '-C', '--no-show-raw-insn', program],
                             check=True, capture_output=True, text=True).stdout
    head = re.compile(r'^[0-9a-f]+ <.*%s.*SumAll<3, false, \(shape::RootError\)0>' % target)
    lines = []
    inside = False
    for line in listing.split('\n'):
        if head.match(line):
            inside = True
        elif inside and not line.strip():
            break
        elif inside:
            lines.append(line)
    if not lines:
        raise SystemExit('the kernel for %s is not in %s' % (target, program))
    address = {int(line.split(':')[0], 16): i for i, line in enumerate(lines)}
    loops = []
    for i, line in enumerate(lines):
        jump = re.search(r'\tj[a-z]+\s+([0-9a-f]+)', line)
        start = address.get(int(jump.group(1), 16)) if jump else None
        if start is not None and start < i:
            body = lines[start:i + 1]
            if any('rsqrt' in inner for inner in body):
                loops.append(body)
    # Innermost: no loop begins in it; of those the one for the most vectors of points.
    inner = [a for a in loops if not any(b is not a and set(b) < set(a) for b in loops)]
    return max(inner, key=lambda body: sum('rsqrt' in line for line in body))


def main():
    build = sys.argv[1] if len(sys.argv) > 1 else 'build'
    subprocess.run(['cmake', '--build', build, '--target', 'fast_summation'], check=True,
                   stdout=subprocess.DEVNULL)
    program = os.path.join(build, 'bin', 'fast_summation')
    output = subprocess.run([program], check=True, capture_output=True, text=True,
                            env=dict(os.environ, OPENBLAS_NUM_THREADS='1')).stdout
    rows = [line.split() for line in output.strip().split('\n')]
    missed = []

    def require(name, ratio, least):
        print('%-64s %8.2f   at least %.2f%s' % (
            name, ratio, least, '' if ratio >= least else '   MISSED'))
        if ratio < least:
            missed.append(name)

    target, lanes, fma, mixed = next(
        (r[1], int(r[2]), float(r[3]), float(r[4])) for r in rows if r[0] == 'vector')
    direct = {int(r[1]): (float(r[2]), float(r[3])) for r in rows if r[0] == 'direct'}
    print('columns   pairs/s of potentials   of gradients')
    for columns, (potentials, gradients) in direct.items():
        print('%7d   %18.3g   %15.3g' % (columns, potentials, gradients))
    print()
    loop = innermost_loop(program, target)
    vectors = sum('rsqrt' in line for line in loop)
    arithmetic = sum(bool(ARITHMETIC.search(line + '\t')) for line in loop)
    additions = sum(bool(ADDITION.search(line + '\t')) for line in loop)
    print('%s: %d arithmetic instructions, %d of them additions, for %d vectors of %d pairs' % (
        target, arithmetic, additions, vectors, lanes))
    print('a second has %.3g FMAs, or %.3g instructions of which a fifth are additions' % (
        fma, mixed))
    require('pair by pair: share of what FMAs alone would allow',
            direct[3][0] / (fma * lanes * vectors / arithmetic), LEAST_OF_BOUND)
    require('pair by pair: share of what the mixture allows',
            direct[3][0] / (mixed * lanes * vectors / arithmetic), LEAST_OF_BOUND)
    print()
    print('%-8s %8s %8s %9s %8s %8s %8s %9s %9s %9s %9s' % (
        'points', 'sources', 'points', 'tolerance', 'set-up', 'sum', 'gradient', 'RMS error',
        'largest', 'x direct', 'x no set-up'))
    ratios = {}
    for row in rows:
        if row[0] not in ('surface', 'inside'):
            continue
        m, n = int(row[1]), int(row[2])
        tolerance, set_up, total, gradients, error, largest = map(float, row[3:])
        one_by_one = m * n / direct[3][0]
        ratios[row[0], n, tolerance] = one_by_one / (set_up + total)
        print('%-8s %8d %8d %9.0e %8.3f %8.3f %8.3f %9.1e %9.1e %9.1f %9.1f' % (
            row[0], m, n, tolerance, set_up, total, gradients, error, largest,
            one_by_one / (set_up + total), one_by_one / total))
        if error > tolerance:
            missed.append('tolerance %g' % tolerance)
            print('the tolerance is MISSED')
    print()
    require('multipole, 1e-6, 100,000 x 100,000 on a surface, with set-up',
            ratios['surface', 100000, 1e-6], LEAST_SURFACE)
    require('multipole, 1e-6, 1,000,000 inside x 100,000, with set-up',
            ratios['inside', 1000000, 1e-6], LEAST_INSIDE)
    return 1 if missed else 0


sys.exit(main())
