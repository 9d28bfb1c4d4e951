"""Shape Tetrahedralize over every surface of a folder of OFF files: a table of tetrahedra, seconds and
the least scaled Jacobian, or of what is wrong with the surface; then counts. Each surface gives either
tetrahedra or an error of the filter's.

    Utilities/pvpython.sh Testing/Benchmarks/TetrahedralizeModels.py [MODEL ...] [Property=value ...]
"""
import collections
import time

import sweep

import off
import shapemap
import shapetesting

KINDS = ('open loop', 'no triangles', 'three or more triangles', 'two sheets touch',
         'opposite orientation', 'uses point', 'cannot be triangulated', 'encloses no volume',
         'without area', 'crosses or touches itself', 'TetGen')


def main():
    options = sweep.parser(__doc__).parse_args()
    claims, counts, silent = sweep.Claims(), collections.Counter(), []
    table = sweep.Table('model:<28', 'points:8d', 'tetrahedra:10d', 'seconds:8.2f', 'quality:9.2g')
    for name, path in sweep.models(options):
        algorithm = shapemap.vtkShapeTetrahedralize()
        sweep.set_properties(algorithm, sweep.properties(options))
        surface = off.read(path)
        algorithm.SetInputDataObject(surface)
        start = time.time()
        messages = shapetesting.run(algorithm)
        row = dict(model=name, points=surface.GetNumberOfPoints(), seconds=time.time() - start)
        solid = algorithm.GetOutputDataObject(0)
        named = [message.strip() for message in messages if 'Shape Tetrahedralize: ' in message]
        if named:
            message = named[0].split('Shape Tetrahedralize: ', 1)[1]
            counts[next((kind for kind in KINDS if kind in message), 'other')] += 1
            table.print(row, message)
        elif solid.GetNumberOfCells() > 0:
            counts['tetrahedra'] += 1
            table.print(dict(row, tetrahedra=solid.GetNumberOfCells(), quality=shapetesting.fact(
                solid, 'Tetrahedralize.MinimumScaledJacobian')))
        else:
            silent.append(name)
            table.print(row, 'NEITHER %s' % messages)
    for kind, count in counts.most_common():
        claims.note('%d models' % (sum(counts.values()) + len(silent)), kind, count)
    claims.none('each model', 'neither tetrahedra nor an error', silent)
    claims.finish()


if __name__ == '__main__':
    main()
