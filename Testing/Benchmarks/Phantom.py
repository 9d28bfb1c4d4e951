"""The head-skull-brain phantom (Li et al. 2010, figures 1 and 2) with Exact: what the map leaves over
at each surface, and how continuous it is there. An error inside triangles is at most what piecewise
linear data of as many points must be met to, and the two sides of a surface are carried at most 1e-6 of
the size apart.

    Utilities/pvpython.sh Testing/Benchmarks/Phantom.py [--small] [Property=value ...]

--small: the phantom of Data/ (2562, 1926 and 1538 points) instead of the large one. Properties are
Shape Harmonic Volume Map's. Errors are root mean squares divided by the longest side of the target's
box; `fitted` is by how much the maps of two layers differ before the skin joins them.
"""
import time

import sweep

import numpy
import scenes
import shapemap
import shapetesting
from vtkmodules.util.numpy_support import vtk_to_numpy

# RMSE inside triangles that VolumeMap.py asks for, by points; between them, along the logarithms.
SIZES, LIMITS = (3600, 10100, 37700, 113000), (8e-4, 1.5e-4, 1.2e-4, 1e-4)
LONGEST = 2.0  # side of the target's box
PLACES, STEP = 5000, 1e-9
JUMP = 1e-6


def main():
    parser = sweep.parser(__doc__)
    parser.add_argument('--small', action='store_true')
    options = parser.parse_args()
    surfaces = scenes.phantom('Small' if options.small else '')
    volume_map = shapemap.vtkShapeHarmonicVolumeMap()
    sweep.set_properties(volume_map, sweep.properties(options))
    volume_map.SetExact(True)
    volume_map.SetInputDataObject(0, surfaces[1])
    volume_map.SetInputDataObject(1, surfaces[0])
    for surface in surfaces[1:]:
        volume_map.AddInputDataObject(2, surface)
    start, cpu = time.time(), time.process_time()
    charges = scenes.checked(volume_map).GetOutputDataObject(1)
    seconds, cpu = time.time() - start, time.process_time() - cpu

    claims, random = sweep.Claims(), numpy.random.default_rng(1)
    table = sweep.Table('border:<6', 'points:7d', *(key + ':10.2e' for key in (
        'vertices', 'inside', 'maximum', 'fitted', 'jump')))
    for region, (name, surface) in enumerate(zip(('Head', 'Skull', 'Brain'), surfaces)):
        row = dict(border=name, points=surface.GetNumberOfPoints())
        for key, fact in (('vertices', 'RMSEVertices'), ('inside', 'RMSEInside'),
                          ('maximum', 'Maximum'), ('fitted', 'JumpMaximum')):
            row[key] = vtk_to_numpy(shapetesting.facts(charges).GetArray(
                'HarmonicVolumeMap.Border' + fact))[0, region]
        limit = numpy.exp(numpy.interp(numpy.log(row['points']), numpy.log(SIZES), numpy.log(LIMITS)))
        claims.at_most(name, 'RMSE inside triangles', row['inside'], limit)
        if region:
            row['jump'] = scenes.jumps_across(surface, charges, PLACES, STEP, random).max() / LONGEST
            claims.at_most(name, 'sides carried apart', row['jump'], JUMP)
        table.print(row)
    print('%.1f CPU seconds, %.1f wall seconds' % (cpu, seconds))
    claims.finish()


if __name__ == '__main__':
    main()
