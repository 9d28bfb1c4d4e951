"""Repair of Shape Harmonic Volume Map on the sphere maps of closed surfaces of genus 0.

Each model is mapped onto the ball, and the ball onto it. `before` and `certified` are the shares of the volume
in which the map is proven to fold nowhere, before and after the repair; `inverted` and `undecided` are what is
left. In the share `core` the map is replaced, in `ring` it is blended. `cpu` is that of map and repair together,
`wrong` counts random positions in the repaired tetrahedra where the derivative of vtkShapeHarmonicTransform has
no positive determinant, if all is certified.

    Utilities/pvpython.sh Testing/Benchmarks/RepairedMaps.py [--direction to|from|both] [MODEL ...] [Property=value ...]

Properties are Shape Harmonic Volume Map's.
"""
import time

import sweep

import numpy
import shapemap
import shapetesting
from Certificate import determinants, sphere_maps
from shapetesting import fact
from vtkmodules.util.numpy_support import vtk_to_numpy

SAMPLES = 2000


def field(data, name):
    array = data.GetFieldData().GetArray(name)
    return vtk_to_numpy(array) if array else None


def samples(charges):
    """Random positions in the tetrahedra of the repair."""
    corners = field(charges, 'RepairTetrahedra')
    if corners is None:
        return numpy.zeros((0, 3))
    random = numpy.random.RandomState(1)
    chosen = corners[random.randint(len(corners), size=SAMPLES)]
    weights = random.dirichlet(numpy.ones(4), SAMPLES)
    return numpy.einsum('ij,ijk->ik', weights, field(charges, 'RepairPoints')[chosen])


def repaired(surface, map_array, settings):
    """The row of a map, or why there is none."""
    algorithm = shapemap.vtkShapeHarmonicVolumeMap()
    algorithm.SetInputDataObject(0, surface)
    algorithm.SetInputDataObject(1, surface)
    algorithm.SetMapArray(map_array)
    algorithm.SetRepair(True)
    sweep.set_properties(algorithm, settings)
    start = time.process_time()
    messages = shapetesting.run(algorithm)
    if messages:
        return {}, messages[0].strip().splitlines()[-1]
    charges = algorithm.GetOutputDataObject(1)
    row = dict(cpu=time.process_time() - start, points=surface.GetNumberOfPoints())
    for column, name in (('before', 'CertifiedBefore'), ('certified', 'CertifiedShare'),
                         ('inverted', 'InvertedShare'), ('undecided', 'UndecidedShare'),
                         ('core', 'CoreShare'), ('ring', 'RingShare')):
        row[column] = fact(charges, 'HarmonicVolumeMap.' + name)
    row['wrong'] = 0
    if row['certified'] == 1.0:
        row['wrong'] = int((determinants(charges, samples(charges)) <= 0.0).sum())
    return row, ''


def main():
    parser = sweep.parser(__doc__)
    parser.add_argument('--direction', default='both', choices=('to', 'from', 'both'), help='the ball')
    options = parser.parse_args()
    claims, wrong, low, maps = sweep.Claims(), [], [], 0
    table = sweep.Table('map:<24', 'points:7d', 'before:9.6f', 'certified:10.7f', 'inverted:9.1e', 'undecided:9.1e',
                        'core:7.4f', 'ring:7.4f', 'wrong:5d', 'cpu:7.1f')
    for label, surface, array in sphere_maps(options, table):
        if options.direction not in ('both', 'from' if label.startswith('ball to ') else 'to'):
            continue
        row, reason = repaired(surface, array, sweep.properties(options))
        row['map'] = label
        if not reason:
            maps += 1
            if row['wrong']:
                wrong.append('%s: %d' % (label, row['wrong']))
            if row['certified'] < 0.99:
                low.append('%s: %.4f' % (label, row['certified']))
        table.print(row, reason)
    claims.none('%d maps' % maps, 'with a determinant that is not positive where it is certified', wrong)
    claims.none('%d maps' % maps, 'with less than 99 % certified', low)
    claims.finish()


if __name__ == '__main__':
    main()
