"""The head-skull-brain phantom (Li et al. 2010, figures 1 and 2) with Exact: what the map leaves over
at each surface, and how continuous it is there. Prints a table and raises where an error inside
triangles is above what piecewise linear data of as many points must be met to, or where the two
sides of a surface are carried more than 1e-6 of the size apart.

    Utilities/pvpython.sh Testing/Benchmarks/Phantom.py [small] [Property=value ...]

small: the phantom of Data/ (2562, 1926 and 1538 points) instead of the large one. Properties are
Shape Harmonic Volume Map's. Errors are root mean squares divided by the longest side of the target's
box; `fitted` is by how much the maps of two layers differ before the skin joins them.
"""
import os
import sys
import time

import numpy
import shapemap
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), '..'))

import shapetesting
from shapetesting import points

# RMSE inside triangles that VolumeMap.py asks for, by points; between them, along the logarithms.
SIZES, LIMITS = (3600, 10100, 37700, 113000), (8e-4, 1.5e-4, 1.2e-4, 1e-4)
LONGEST = 2.0  # side of the target's box
PLACES, STEP = 5000, 1e-9

arguments = sys.argv[1:]
small = 'small' in arguments
names = ('Head', 'Skull', 'Brain')
surfaces = [shapetesting.read('Phantom%s%s.vtp' % (name, 'Small' if small else '')) for name in names]
volume_map = shapemap.vtkShapeHarmonicVolumeMap()
for key, value in (argument.split('=') for argument in arguments if '=' in argument):
    getattr(volume_map, 'Set' + key)(type(getattr(volume_map, 'Get' + key)())(value))
volume_map.SetExact(True)
volume_map.SetInputDataObject(0, surfaces[1])
volume_map.SetInputDataObject(1, surfaces[0])
for surface in surfaces[1:]:
    volume_map.AddInputDataObject(2, surface)
start, cpu = time.time(), time.process_time()
messages = shapetesting.run(volume_map)
assert not messages, messages
seconds, cpu = time.time() - start, time.process_time() - cpu
charges = volume_map.GetOutputDataObject(1)


def by_region(name):
    return vtk_to_numpy(charges.GetFieldData().GetArray('HarmonicVolumeMap.' + name))


def carried(places):
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    shapetesting.set_points(data, places)
    apply = shapemap.vtkShapeApplyVolumeMap()
    apply.SetInputDataObject(0, data)
    apply.SetInputDataObject(1, charges)
    assert not shapetesting.run(apply)
    return points(apply.GetOutputDataObject(0))


random = numpy.random.default_rng(1)
missed = []
print('%-6s %7s %10s %10s %10s %10s %10s %10s' % (
    'border', 'points', 'vertices', 'inside', 'required', 'maximum', 'fitted', 'jump'))
for region, (name, surface) in enumerate(zip(names, surfaces)):
    count = surface.GetNumberOfPoints()
    limit = numpy.exp(numpy.interp(numpy.log(count), numpy.log(SIZES), numpy.log(LIMITS)))
    inside, jump = by_region('BorderRMSEInside')[region], 0.0
    if region:
        places, normals = shapetesting.places_on(surface, PLACES, random)
        sides = [carried(places + step * normals) for step in (STEP, -STEP)]
        jump = numpy.linalg.norm(sides[0] - sides[1], axis=1).max() / LONGEST
    print('%-6s %7d %10.2e %10.2e %10.2e %10.2e %10.2e %10.2e' % (
        name, count, by_region('BorderRMSEVertices')[region], inside, limit,
        by_region('BorderMaximum')[region], by_region('BorderJumpMaximum')[region], jump))
    if inside > limit:
        missed.append('%s: %.2e inside triangles, at most %.2e is required' % (name, inside, limit))
    if jump > 1e-6:
        missed.append('%s: sides %.2e apart' % (name, jump))
print('%.1f CPU seconds, %.1f wall seconds' % (cpu, seconds))
if missed:
    raise AssertionError('; '.join(missed))
