"""Hexahedra of Shape Hex Remesh in CAD parts with curved creases, fillets, holes close to edges and a genus of
0 to 20 (cadparts.py), which Gmsh's OpenCASCADE makes: fifteen to choose parameters with, fifteen of the same
kinds to assert on, and ten of other kinds.

    python3 Testing/Benchmarks/CadParts.py [--half choosing|asserting|unseen|both] [--limit 300]
        [--cells 0] [--keep FOLDER] [--peers] [PART ...]

Of each part: it ends within the limit, no hexahedron is inverted, and the boundary has the part's Euler
number and number of components. Of all of them: see FIGURES. Each part whose creases are not kept, or far,
is named, with its lost creases and where the longest is. The program gmsh is Debian's. --cells: coarse cells
for short runs, of a size that gives about so many before layers; 0: the filter's own size. --peers: also the
rows of HexPeers.py of each part that ends, for which pvpython has to run this script (Utilities/pvpython.sh).

Columns: triangles and genus of the part; hexahedra, least and mean scaled Jacobian, and the largest that
the least could be at the convex corners (bound); the larger one-sided Hausdorff distance between surface and
boundary, and that between their creases, in % of the diagonal; whether creases are kept, how many are lost
and followed, and the share of their length that was looked for; CPU seconds and MiB.
"""
import math
import os
import tempfile

import cadparts
import sweep

# What is wanted of the parts as a whole: the share of them, in percent.
FIGURES = (
    ('creases kept, at most 0.1 % of the diagonal', 90, lambda row: row['creases'] and row['crease'] <= 0.1),
    ('least scaled Jacobian >= 0.3', 90, lambda row: row['min'] >= 0.3),
)
COLUMNS = ('part:<16', 'method:<9', 'triangles:9d', 'genus:5d', 'hexes:7d', 'min:7.3f', 'mean:6.3f',
           'bound:6.3f', 'distance:8.3f', 'creases:7d', 'lost:5d', 'followed:8d', 'crease:7.3f', 'share:6.3f', 'cpu:7.1f', 'mib:6.0f')


def fault(row):
    """What is wrong with the hexahedra of one part."""
    if row['inverted'] > 0 or not row['min'] > 0.0:
        return '%d hexahedra are inverted' % row['inverted']
    if (row['euler'], row['components']) != (row['wantedeuler'], row['wantedcomponents']):
        return 'the Euler number is %g of %g' % (row['euler'], row['wantedeuler'])
    return ''


def cell_size(points, triangles, cells):
    """Of so many cells, in hundredths of the diagonal; 0 if `cells` is 0."""
    diagonal = math.dist(*([bound(coordinates) for coordinates in zip(*points)] for bound in (min, max)))
    return cells and 100.0 * (cadparts.volume(points, triangles) / cells) ** (1.0 / 3.0) / diagonal


def compare_peers(path, name, folder, claims):
    """The rows of HexPeers.py for one part."""
    import HexPeers
    import off
    HexPeers.compare(HexPeers.triangulated(off.read(path)), name, folder,
                     sweep.Table(*HexPeers.COLUMNS), claims)


def measure(options, names, folder, claims):
    """Prints a row for each part. Returns the rows; None for a part without hexahedra."""
    program, table, rows = sweep.Program(options), sweep.Table(*COLUMNS), {}
    program.ready()
    for name in names:
        path, points, triangles = cadparts.write(name, folder)
        found = program.run('hex', path, options.method, seconds=options.limit,
                            CellSize=cell_size(points, triangles, options.cells))
        row = dict(found.row(), part=name, triangles=len(triangles),
                   genus=cadparts.genus(points, triangles)) if not found.error else None
        rows[name] = row
        wrong = found.error or fault(row)
        table.print(row or {'part': name}, wrong and 'FAULT ' + wrong or row['reason'])
        claims.check(name, 'hexahedra', wrong or 'valid', not wrong, 'valid, with the topology')
        if options.peers and row:
            compare_peers(path, name, folder, claims)
    return rows


def main():
    parser = sweep.parser(__doc__)
    parser.add_argument('--half', choices=('choosing', 'asserting', 'unseen', 'both'), default='asserting')
    parser.add_argument('--limit', type=float, default=300.0, help='seconds for each')
    parser.add_argument('--cells', type=float, default=0.0, help='about so many; 0: automatic')
    parser.add_argument('--method', default='Automatic')
    parser.add_argument('--keep', help="a folder for the parts' files")
    parser.add_argument('--peers', action='store_true')
    options = parser.parse_args()
    halves = {'choosing': cadparts.CHOOSING, 'asserting': cadparts.ASSERTING, 'unseen': cadparts.UNSEEN,
              'both': {**cadparts.CHOOSING, **cadparts.ASSERTING}}
    names = options.words or list(halves[options.half])
    claims = sweep.Claims()
    with tempfile.TemporaryDirectory(prefix='shapemap-parts-') as temporary:
        folder = options.keep or temporary
        os.makedirs(folder, exist_ok=True)
        rows = measure(options, names, folder, claims)
    for title, least, holds in FIGURES:
        good = [name for name, row in rows.items() if row and holds(row)]
        claims.at_least('%d parts' % len(rows), title + ', %', 100.0 * len(good) / len(rows), least)
        print('not %s: %s' % (title, ' '.join(sorted(set(rows) - set(good))) or 'none'))
    claims.finish()


if __name__ == '__main__':
    main()
