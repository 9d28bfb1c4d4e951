"""A patch deformed by its boundary, beside CGAL's as-rigid-as-possible deformation, on one thread: a pass
in full takes at most 2 iterations of CGAL's, one with multiresolution at most 1/2; the rigid motion is
exact; both resolutions keep the height of the bent shape.

    python3 Testing/Benchmarks/Deform.py [--points 12500] [MODEL ...]
"""
import sweep

EXACT = 1e-12    # of the diagonal: how far a turned shape may be from the rigid motion
HEIGHT = 0.01    # how much the heights of both resolutions may differ
ITERATIONS = {'Full': 2.0, 'Multiresolution': 0.5}  # of CGAL's, at most


def main():
    parser = sweep.parser(__doc__)
    parser.add_argument('--points', type=int, default=12500)
    options = parser.parse_args()
    sweep.use_one_thread()
    program, claims = sweep.Program(options), sweep.Claims()
    table = sweep.Table('model:<16', 'method:<16', 'prepare:9.1f', 'deform:9.2f', 'rigid:9.1e',
                        'height:9.4f')
    for name, path in sweep.models(options, ['bunny00', 'armadillo']):
        found = program.run('deform', path, Points=options.points)
        found.row()
        first, *rest = found.rows
        rows = {row['method']: row for row in rest}
        for row in rest:
            table.print(dict(row, model=name))
        print('%-16s %d points, %d triangles, graph %.1f ms, height at rest %.4f' % (
            '', first['points'], first['triangles'], first['graph'], first['atrest']))
        for method, most in ITERATIONS.items():
            claims.at_most(name, "%s: time of an iteration of CGAL's" % method,
                           rows[method]['deform'] / rows['CGAL']['deform'], most)
            claims.at_most(name, method + ': off the rigid motion', rows[method]['rigid'], EXACT)
        claims.at_most(name, 'difference of heights', abs(
            rows['Multiresolution']['height'] / rows['Full']['height'] - 1.0), HEIGHT)
    claims.finish()


if __name__ == '__main__':
    main()
