"""The sums of 1/r: pair by pair against the bound of the processor, and the multipole method against
the sum pair by pair. All times are CPU seconds on one thread, medians of five.

    python3 Testing/Benchmarks/FmmSummation.py
"""
import re
import subprocess

import sweep

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
    options = sweep.parser(__doc__, models=False).parse_args()
    sweep.use_one_thread()
    program, claims = sweep.Program(options), sweep.Claims()
    found = program.run('fmm_summation')
    found.row()
    vector = found.rows[0]
    direct = [row for row in found.rows if 'columns' in row]
    sums = [row for row in found.rows if 'tolerance' in row]

    table = sweep.Table('columns:7d', 'potentials:12.3g', 'gradients:12.3g')
    for row in direct:
        table.print(row)
    pairs_each_second = direct[-1]['potentials']
    loop = innermost_loop(program.path, vector['target'])
    vectors = sum('rsqrt' in line for line in loop)
    arithmetic = sum(bool(ARITHMETIC.search(line + '\t')) for line in loop)
    additions = sum(bool(ADDITION.search(line + '\t')) for line in loop)
    print('%s: %d arithmetic instructions, %d of them additions, for %d vectors of %d pairs' % (
        vector['target'], arithmetic, additions, vectors, vector['lanes']))
    print('a second has %.3g FMAs, or %.3g instructions of which a fifth are additions' % (
        vector['fma'], vector['mixed']))
    for name, key in (('FMAs alone would allow', 'fma'), ('the mixture allows', 'mixed')):
        claims.at_least('pair by pair', 'share of what ' + name, pairs_each_second / (
            vector[key] * vector['lanes'] * vectors / arithmetic), LEAST_OF_BOUND)

    table = sweep.Table('where:<8', 'sources:8d', 'points:8d', 'tolerance:9.0e', 'setup:8.3f', 'sum:8.3f',
                        'gradient:8.3f', 'error:9.1e', 'largest:9.1e', 'faster:9.1f', 'fasterlater:11.1f')
    for row in sums:
        one_by_one = row['sources'] * row['points'] / pairs_each_second
        row['faster'] = one_by_one / (row['setup'] + row['sum'])
        row['fasterlater'] = one_by_one / row['sum']  # than pair by pair, set-up not counted
        table.print(row)
        claims.at_most('multipole, %d points %s' % (row['points'], row['where']),
                       'RMS error', row['error'], row['tolerance'])
    for where, points, least in (('surface', 100000, LEAST_SURFACE), ('inside', 1000000, LEAST_INSIDE)):
        row = next(row for row in sums if (row['where'], row['points'], row['tolerance']) == (
            where, points, 1e-6))
        claims.at_least('multipole, %d points %s' % (points, where),
                        'times faster than pair by pair, with set-up', row['faster'], least)
    claims.finish()


if __name__ == '__main__':
    main()
