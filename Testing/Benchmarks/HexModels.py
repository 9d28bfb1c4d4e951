"""Shape Hex Remesh's kernel over every closed surface of a folder of OFF files, with one set of
parameters: Automatic for all, and the Polycube method if that was not what came out and the surface
has at most 50,000 vertices and does not cross itself.

    python3 Testing/Benchmarks/HexModels.py [--limit 900] [--jobs 1] [--skip-polycube] [MODEL ...]

Of each surface: no hexahedron is inverted, the boundary has the surface's Euler number and number of
components (if it crosses itself, the table says of what), there are at most 200,000 hexahedra. Of
all of them: see FIGURES.
"""
import concurrent.futures
import os

import sweep

MOST_HEXAHEDRA = 200000
MOST_VERTICES = 50000  # of a surface that the polycube's share is of
# What is wanted of the sweep as a whole: the share of models, in percent.
FIGURES = (
    ('worst scaled Jacobian > 0.2', 100, lambda row: row['min'] > 0.2),
    ('worst scaled Jacobian >= 0.55', 85, lambda row: row['min'] >= 0.55),
    ('distance < 1 % of the diagonal', 95, lambda row: row['distance'] < 1.0),
)
POLYCUBE_SHARE = 60
COLUMNS = ('model:<24', 'method:<9') + tuple(key + ':9.4g' for key in (
    'hexes', 'min', 'mean', 'distance', 'corners', 'cornerskept', 'creases', 'crease', 'share', 'bound',
    'released', 'crossings', 'euler', 'components', 'cpu', 'mib'))


def has_polycube_share(row):
    return row['vertices'] <= MOST_VERTICES and row['crossings'] == 0


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


def is_good_polycube(outcome):
    row = outcome.rows and outcome.row()
    return bool(row) and (row['method'] == 'Polycube' and not fault(row) and row['min'] > 0.2 and
                          row['mean'] >= 0.93)


def main():
    parser = sweep.parser(__doc__)
    parser.add_argument('--limit', type=float, default=900.0, help='seconds for each')
    parser.add_argument('--jobs', type=int, default=1,
                        help='models at once, each with its share of the cores: the results are the '
                        'same bits, the seconds are not')
    parser.add_argument('--skip-polycube', action='store_true', help='only Automatic')
    options = parser.parse_args()
    program, claims, table = sweep.Program(options), sweep.Claims(), sweep.Table(*COLUMNS)
    program.ready()

    def measure(model):
        """What Automatic gives and, if it is wanted and was not what came out, Polycube."""
        def run(method):
            return program.run('hex', model[1], method, seconds=options.limit,
                               threads=max(os.cpu_count() // options.jobs, 1))
        found = run('Automatic')
        row = found.rows and found.row()
        if row and row['method'] == 'Grid' and not options.skip_polycube and has_polycube_share(row):
            return found, run('Polycube')
        return found, found

    models = sweep.models(options)
    rows, faults, polycubes, others, unfinished = [], [], [], [], 0
    pool = concurrent.futures.ThreadPoolExecutor(options.jobs)
    for (name, _), (found, polycube) in zip(models, pool.map(measure, models)):
        if found.code == found.DOES_NOT_APPLY:
            continue  # not a closed surface
        wrong = found.error or fault(found.row())
        if wrong:
            faults.append(name)
        if found.error:
            unfinished += 1
            table.print({'model': name}, 'FAULT ' + wrong)
            continue
        row = found.row()
        rows.append(dict(row, model=name))
        table.print(rows[-1], ('FAULT ' + wrong + ' ' if wrong else '') + row['reason'])
        if options.skip_polycube or not has_polycube_share(row):
            continue
        if polycube is not found:
            if polycube.error:
                print('%-24s no polycube: %s' % ('', polycube.error), flush=True)
            else:
                table.print(polycube.row(), polycube.row()['reason'])
        (polycubes if is_good_polycube(polycube) else others).append(name)

    count = len(rows) + unfinished
    print('%d closed surfaces' % count)
    claims.none('each surface', 'inverted, other topology, more than %d hexahedra, no end' %
                MOST_HEXAHEDRA, faults)
    for title, least, holds in FIGURES:
        claims.at_least('%d surfaces' % count, title + ', %', 100.0 * sum(map(holds, rows)) /
                        max(count, 1), least)
        for row in rows:
            if not holds(row):
                print('  not %s: %s: worst scaled Jacobian %.4f (its convex corners allow %.4f), '
                      'distance %.3f %%' % (title, row['model'], row['min'], row['bound'],
                                            row['distance']))
    if polycubes or others:
        claims.at_least('%d surfaces' % (len(polycubes) + len(others)),
                        'polycube, min > 0.2 and mean >= 0.93, %', 100.0 * len(polycubes) / (
                            len(polycubes) + len(others)), POLYCUBE_SHARE)
        print('polycube found:', ' '.join(polycubes))
        print('not:', ' '.join(others))
    claims.finish()


if __name__ == '__main__':
    main()
