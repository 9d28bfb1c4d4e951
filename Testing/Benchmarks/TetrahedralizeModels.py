"""Shape Tetrahedralize over every surface of a folder of OFF files: a table of tetrahedra, seconds and
the least scaled Jacobian, or of what is wrong with the surface; then counts. Raises where a surface
gives neither tetrahedra nor an error of the filter's.

    Utilities/pvpython.sh Testing/Benchmarks/TetrahedralizeModels.py [FOLDER [Property=value ...]]
"""
import collections
import glob
import os
import sys
import time

import shapemap

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path += [os.path.join(ROOT, 'Utilities'), os.path.join(ROOT, 'Testing')]

import off
import shapetesting

KINDS = ('open loop', 'no triangles', 'three or more triangles', 'two sheets touch',
         'opposite orientation', 'uses point', 'cannot be triangulated', 'encloses no volume',
         'without area', 'crosses or touches itself', 'TetGen')

folder = sys.argv[1] if len(sys.argv) > 1 else os.path.join(ROOT, 'build', 'models')
settings = [setting.split('=') for setting in sys.argv[2:]]
paths = sorted(glob.glob(os.path.join(folder, '*.off')))
assert paths, 'there are no models in ' + folder
counts = collections.Counter()
unnamed = []
print('%-28s %8s %9s %8s %9s' % ('model', 'points', 'tets', 'seconds', 'quality'))
for path in paths:
    name = os.path.basename(path)
    surface = off.read(path)
    algorithm = shapemap.vtkShapeTetrahedralize()
    for key, value in settings:
        getattr(algorithm, 'Set' + key)(float(value))
    algorithm.SetInputDataObject(surface)
    start = time.time()
    messages = shapetesting.run(algorithm)
    seconds = time.time() - start
    solid = algorithm.GetOutputDataObject(0)
    row = '%-28s %8d' % (name, surface.GetNumberOfPoints())
    named = [message.strip() for message in messages if 'Shape Tetrahedralize: ' in message]
    if named:
        message = named[0].split('Shape Tetrahedralize: ', 1)[1]
        kind = next((kind for kind in KINDS if kind in message), 'other')
        counts[kind] += 1
        print('%s %9s %8.2f %9s %s' % (row, '-', seconds, '-', message), flush=True)
    elif solid.GetNumberOfCells() > 0:
        counts['tetrahedra'] += 1
        print('%s %9d %8.2f %9.2g' % (row, solid.GetNumberOfCells(), seconds, shapetesting.fact(
            solid, 'Tetrahedralize.MinimumScaledJacobian')), flush=True)
    else:
        unnamed.append(name)
        print(row, 'NEITHER', messages, flush=True)
print('%d models:' % len(paths), ', '.join('%d %s' % (n, kind) for kind, n in counts.most_common()))
if unnamed:
    raise AssertionError('neither tetrahedra nor an error: ' + ' '.join(unnamed))
