"""Drafts of Shape Hex Remesh beside its full runs. A draft has the topology, no inverted hexahedron, and
takes at most a third of the CPU seconds of the full run of the same model.

    python3 Testing/Benchmarks/HexDraft.py [--limit 900] [MODEL ...]

The default models did not choose what a draft leaves out: fandisk, femur, bunny00 and anchor did.
"""
import sweep

MODELS = ('joint', 'hand', 'elephant')
SHARE = 1.0 / 3.0
COLUMNS = ('model:<12', 'run:<6') + tuple(key + ':9.4g' for key in (
    'hexes', 'min', 'mean', 'inverted', 'distance', 'creases', 'lost', 'cpu', 'wall'))


def main():
    parser = sweep.parser(__doc__)
    parser.add_argument('--limit', type=float, default=900.0, help='seconds for each run')
    options = parser.parse_args()
    program, claims, table = sweep.Program(options), sweep.Claims(), sweep.Table(*COLUMNS)
    for name, path in sweep.models(options, MODELS):
        rows = {}
        for run, draft in (('draft', 1), ('full', 0)):
            found = program.run('hex', path, 'Automatic', seconds=options.limit, Draft=draft)
            claims.none('%s, %s' % (name, run), 'errors', [found.error] if found.error else [])
            if not found.error:
                rows[run] = found.row()
                table.print(dict(rows[run], model=name, run=run))
        if 'draft' in rows:
            row = rows['draft']
            claims.at_most(name, 'inverted', row['inverted'], 0)
            topology = (row['euler'], row['components'])
            claims.check(name, 'topology', topology,
                         topology == (row['wantedeuler'], row['wantedcomponents']), "the surface's")
        if len(rows) == 2:
            claims.at_most(name, 'CPU seconds of the full run', rows['draft']['cpu'] / rows['full']['cpu'],
                           SHARE)
    claims.finish()


if __name__ == '__main__':
    main()
