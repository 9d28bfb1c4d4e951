"""Holes filled by each of our methods and by CGAL's triangulate_refine_and_fair_hole.

    python3 Testing/Benchmarks/FillHoles.py [--none] [MODEL ...]

Without a model: caps of a sphere, whose fills are compared with the sphere. Automatic stays below 0.1 %
of the radius (20 degrees), 0.6 % (40) and 4 % (70 and 110), and, up to 70, below five times CGAL's time.
With models: Automatic leaves no hole open, and no more pairs of triangles that meet than CGAL and each of
our methods; with --none, none at all.
"""
import sweep

CAPS = {20: (0.1, 5.0), 40: (0.6, 5.0), 70: (4.0, 5.0), 110: (4.0, 100.0)}  # %, of CGAL's time


def fill_sphere(program, claims):
    table = sweep.Table('degrees:7d', 'method:<12', 'new:8d', 'error:10.4f', 'cpu:10.4f')
    found = program.run('fill_holes')
    found.row()
    rows = {}
    for row in found.rows:
        table.print(row)
        rows[row['degrees'], row['method']] = row
    for degrees, (error, times) in CAPS.items():
        own, cgal = (rows[degrees, method] for method in ('Automatic', 'CGAL'))
        subject = 'cap of %d degrees' % degrees
        claims.at_most(subject, 'error, % of the radius', own['error'], error)
        claims.at_most(subject, "CPU seconds, of CGAL's", own['cpu'] / cgal['cpu'], times)


def main():
    parser = sweep.parser(__doc__)
    parser.add_argument('--none', action='store_true', help='no pair of triangles may meet')
    options = parser.parse_args()
    program, claims = sweep.Program(options), sweep.Claims()
    if not options.words:
        fill_sphere(program, claims)
        claims.finish()
        return
    table = sweep.Table('model:<24', 'method:<12', 'new:8d', 'open:5d', 'across:8.2f', 'crossings:9d',
                        'cpu:10.4f')
    for name, path in sweep.models(options):
        found = program.run('fill_holes', path)
        found.row()
        first, *rows = found.rows
        print('%s: %d triangles, %d loops, %d that do not touch themselves' % (
            name, first['triangles'], first['loops'], first['simple']))
        for row in rows:
            table.print(dict(row, model=name))
        automatic = next(row for row in rows if row['method'] == 'Automatic')
        claims.at_most(name, 'holes left open', automatic['open'], 0)
        claims.at_most(name, 'pairs of triangles that meet', automatic['crossings'],
                       0 if options.none else min(row['crossings'] for row in rows))
    claims.finish()


if __name__ == '__main__':
    main()
