"""Shape Hex Remesh's kernel over every closed surface of a folder of OFF files, with one set of
parameters: Automatic for all, and the Polycube method where that was not what came out and the surface
has at most 50,000 vertices and does not cross itself. Prints a table as it goes and a summary, and
exits with 1 where a figure is missed.

    python3 Testing/Benchmarks/HexModels.py [--limit 900] [--jobs 1] [--skip-polycube] [MODEL ...]

Of each surface: no hexahedron is inverted, the boundary has the surface's Euler number and number of
components (where it crosses itself: the table says of what), there are at most 200,000 hexahedra. Of
all of them: see FIGURES.
"""
import argparse
import concurrent.futures
import glob
import os
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
MOST_HEXAHEDRA = 200000
MOST_VERTICES = 50000  # of a surface that the polycube's share is of
# What is wanted of the sweep as a whole: the share of models, in percent.
FIGURES = (
    ('worst scaled Jacobian > 0.2', 100, lambda row: row['min'] > 0.2),
    ('worst scaled Jacobian >= 0.55', 85, lambda row: row['min'] >= 0.55),
    ('distance < 1 % of the diagonal', 95, lambda row: row['distance'] < 1.0),
)
POLYCUBE_SHARE = 60
COLUMNS = ('hexes', 'min', 'mean', 'distance', 'corners', 'cornerskept', 'creases', 'crease',
           'share', 'bound', 'released', 'crossings', 'euler', 'components', 'cpu', 'mib')


def measure(case, path, method, seconds, threads):
    """(row or None, what is wrong). A row is what the case prints; None, '' where the surface is not
    closed."""
    environment = dict(os.environ, VTK_SMP_MAX_THREADS=str(threads))
    try:
        done = subprocess.run([case, path, method], capture_output=True, text=True, timeout=seconds,
                              env=environment)
    except subprocess.TimeoutExpired:
        return None, 'no end after %g s' % seconds
    if done.returncode == 2:
        return None, ''
    if done.returncode != 0:
        return None, done.stderr.strip() or 'crashed with signal %d' % -done.returncode
    line, _, reason = done.stdout.strip().partition(' reason=')
    row = dict(word.split('=', 1) for word in line.split(' '))
    row = {key: value if key == 'method' else float(value) for key, value in row.items()}
    row['reason'] = reason
    return row, ''


def measure_both(case, path, seconds, threads, with_polycube):
    """What Automatic and, where it is wanted and was not what came out, Polycube give."""
    row, wrong = measure(case, path, 'Automatic', seconds, threads)
    if (row is None or row['method'] != 'Grid' or not with_polycube or
            row['vertices'] > MOST_VERTICES or row['crossings'] > 0):
        return row, wrong, None, ''
    return (row, wrong) + measure(case, path, 'Polycube', seconds, threads)


def fault(row):
    """What is wrong with the hexahedra of one surface."""
    if row['inverted'] > 0 or not row['min'] > 0.0:
        return '%d hexahedra are inverted' % row['inverted']
    if row['hexes'] > MOST_HEXAHEDRA:
        return 'too many hexahedra'
    if row['crossings'] == 0 and (row['euler'], row['components']) != (
            row['wantedeuler'], row['wantedcomponents']):
        return 'the Euler number is %g of %g' % (row['euler'], row['wantedeuler'])
    return ''


def show(name, row, note):
    print('%-24s %-9s' % (name, row['method']),
          *['%9.4g' % row[column] for column in COLUMNS], ' ' + note, flush=True)


def is_good_polycube(row):
    return (row['method'] == 'Polycube' and not fault(row) and row['min'] > 0.2 and
            row['mean'] >= 0.93)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('models', nargs='*', metavar='MODEL')
    parser.add_argument('--build', default=os.path.join(ROOT, 'build'))
    parser.add_argument('--folder', default=os.path.join(ROOT, 'build', 'models'))
    parser.add_argument('--case', help='another hex_case than the build\'s')
    parser.add_argument('--limit', type=float, default=900.0, help='seconds for each')
    parser.add_argument('--jobs', type=int, default=1,
                        help='models at once, each with its share of the cores: the results are the '
                        'same bits, the seconds are not')
    parser.add_argument('--skip-polycube', action='store_true', help='only Automatic')
    arguments = parser.parse_args()
    case = arguments.case or os.path.join(arguments.build, 'bin', 'hex_case')
    if not arguments.case:
        subprocess.run(['cmake', '--build', arguments.build, '--target', 'hex_case'], check=True,
                       stdout=subprocess.DEVNULL)
    paths = [os.path.join(arguments.folder, model + '.off') for model in arguments.models]
    paths = paths or sorted(glob.glob(os.path.join(arguments.folder, '*.off')), key=os.path.getsize)
    assert paths, 'there are no models in ' + arguments.folder
    rows, faults, polycubes, others, unfinished = [], [], [], [], 0
    print('%-24s %-9s' % ('model', 'method'), *['%9.9s' % column for column in COLUMNS])
    threads = max(os.cpu_count() // arguments.jobs, 1)
    pool = concurrent.futures.ThreadPoolExecutor(arguments.jobs)
    measured = pool.map(lambda path: measure_both(case, path, arguments.limit, threads,
                                                  not arguments.skip_polycube), paths)
    for path, (row, wrong, polycube, no_polycube) in zip(paths, measured):
        name = os.path.basename(path)[:-len('.off')]
        if row is None and not wrong:
            continue
        wrong = wrong or fault(row)
        if wrong:
            faults.append(name)
        if row is None:
            unfinished += 1
            print('%-24s FAULT %s' % (name, wrong), flush=True)
            continue
        rows.append(dict(row, name=name))
        show(name, row, ('FAULT ' + wrong + ' ' if wrong else '') + row['reason'])
        if row['vertices'] > MOST_VERTICES or row['crossings'] > 0 or arguments.skip_polycube:
            continue
        if row['method'] == 'Grid':
            row = polycube
            if row is None:
                print('%-24s no polycube: %s' % ('', no_polycube), flush=True)
            else:
                show('', row, row['reason'])
        (polycubes if row and is_good_polycube(row) else others).append((name, row))
    print('%d closed surfaces' % (len(rows) + unfinished))
    missed = len(faults)
    print('0 inverted, topology, at most %d hexahedra: all but %d  %s' % (
        MOST_HEXAHEDRA, len(faults), ' '.join(faults)))
    for title, least, holds in FIGURES:
        share = 100.0 * sum(map(holds, rows)) / max(len(rows) + unfinished, 1)
        missed += share < least
        print('%-34s %5.1f %% (at least %g)%s' % (title, share, least, '' if share >= least else '  MISSED'))
        for row in rows:
            if not holds(row):
                print('  not %s: worst scaled Jacobian %.4f (its convex corners allow %.4f), distance %.3f %%'
                      % (row['name'], row['min'], row['bound'], row['distance']))
    if polycubes or others:
        share = 100.0 * len(polycubes) / (len(polycubes) + len(others))
        missed += share < POLYCUBE_SHARE
        print('polycube, min > 0.2 and mean >= 0.93: %.1f %% of %d (at least %g)%s' % (
            share, len(polycubes) + len(others), POLYCUBE_SHARE,
            '' if share >= POLYCUBE_SHARE else '  MISSED'))
        print('  found:', ' '.join(name for name, _ in polycubes))
        print('  not:', ' '.join(name for name, _ in others))
    sys.exit(1 if missed else 0)


if __name__ == '__main__':
    main()
