"""Shape Tetrahedralize: the solid inside a closed surface as tetrahedra.

As an example: give it a closed surface; surfaces inside it, if there are any, become borders between
regions; Threshold by RegionId takes one of them out."""
import os
import sys

import numpy
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.vtkFiltersGeneral import vtkCellValidator
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
import shapemap

import shapetesting
from shapetesting import array, fact, points, read, triangles

sys.path.append(os.path.join(shapetesting.ROOT, 'Utilities'))
import off


def volumes(solid):
    """Of each tetrahedron, with its sign."""
    assert (vtk_to_numpy(solid.GetCellTypesArray()) == 10).all(), 'there are other cells'
    corners = points(solid)[vtk_to_numpy(solid.GetCells().GetConnectivityArray()).reshape(-1, 4)]
    a, b, c = (corners[:, k] - corners[:, 0] for k in (1, 2, 3))
    return numpy.einsum('ij,ij->i', numpy.cross(a, b), c) / 6.0


def enclosed(surface):
    """The volume that a surface of triangles encloses."""
    a, b, c = (points(surface)[triangles(surface)[:, k]] for k in range(3))
    return numpy.einsum('ij,ij->i', a, numpy.cross(b, c)).sum() / 6.0


def regions(solid):
    return vtk_to_numpy(solid.GetCellData().GetArray('RegionId'))


def scaled(surface, factor):
    smaller = shapetesting.copy(surface)
    shapetesting.set_points(smaller, factor * points(surface))
    return smaller


def made(surface, *inner, **settings):
    """The solid and what the filter said."""
    algorithm = shapetesting.new(shapemap.vtkShapeTetrahedralize, surface, inner, **settings)
    said = shapetesting.refusal(algorithm)
    return algorithm.GetOutputDataObject(0), said


# The example: through ParaView's own proxies, a skull of 2 regions from the phantom head.
skin = simple.XMLPolyDataReader(FileName=[shapetesting.data_file('PhantomHeadSmall.vtp')])
skull = simple.XMLPolyDataReader(FileName=[shapetesting.data_file('PhantomSkullSmall.vtp')])
brain = simple.XMLPolyDataReader(FileName=[shapetesting.data_file('PhantomBrainSmall.vtp')])
solid_filter = simple.ShapeTetrahedralize(Input=skin, InnerSurfaces=[skull, brain])
solid_filter.UpdatePipeline()
head = shapetesting.output(solid_filter)
sizes = [abs(enclosed(shapetesting.output(surface))) for surface in (skin, skull, brain)]
by_region = numpy.bincount(regions(head), volumes(head))
assert volumes(head).min() > 0.0, 'a tetrahedron is turned inside out'
assert numpy.allclose(by_region, [sizes[0] - sizes[1], sizes[1] - sizes[2], sizes[2]], rtol=1e-9), \
    by_region
assert fact(head, 'Tetrahedralize.Regions') == 3
assert fact(head, 'Tetrahedralize.Points') == head.GetNumberOfPoints()
assert fact(head, 'Tetrahedralize.Tetrahedra') == head.GetNumberOfCells()
assert abs(fact(head, 'Tetrahedralize.Volume') / sizes[0] - 1.0) < 1e-9
assert 0.0 < fact(head, 'Tetrahedralize.MinimumScaledJacobian') < 1.0
given = sum(shapetesting.output(s).GetNumberOfPoints() for s in (skin, skull, brain))
assert fact(head, 'Tetrahedralize.SteinerPoints') == head.GetNumberOfPoints() - given

# VTK itself finds nothing wrong with the cells, and their boundary is the surface.
check = vtkCellValidator()
check.SetInputData(head)
check.Update()
assert not vtk_to_numpy(check.GetOutput().GetCellData().GetArray('ValidityState')).any()

# The input's points come first, with their data; a linear field is carried on linearly along the
# surface, so at the closest place it is the field of that place.
dented = read('DentedSphere600.vtp')
shapetesting.add_array(dented, points(dented).copy(), 'Place')
shapetesting.add_array(dented, numpy.arange(dented.GetNumberOfPoints()), 'Number')
ball, messages = made(dented)
assert not messages, messages
count = dented.GetNumberOfPoints()
assert (points(ball)[:count] == points(dented)).all()
assert (array(ball, 'Number')[:count] == numpy.arange(count)).all()
ids = array(ball, 'OriginalPointId')
assert (ids[:count] == numpy.arange(count)).all() and (ids[count:] == -1).all()
assert len(ids) > count, 'no point was added'
away = numpy.linalg.norm(array(ball, 'Place') - points(ball), axis=1)
assert away[:count].max() == 0.0 and away[count:].min() > 0.0
nearest = [numpy.linalg.norm(points(dented) - p, axis=1).min() for p in points(ball)[count:]]
assert (away[count:] <= numpy.array(nearest) + 1e-12).all(), 'not the closest place'
boundary = vtkGeometryFilter()
boundary.SetInputData(ball)
boundary.Update()
assert boundary.GetOutput().GetNumberOfPolys() == dented.GetNumberOfPolys()
assert abs(enclosed(boundary.GetOutput()) - enclosed(dented)) < 1e-9

# The size of the tetrahedra, and a boundary that may be split.
fine, _ = made(dented, MaximumVolume=1e-3)
assert (volumes(fine) <= 1e-3).mean() > 0.99 and volumes(fine).max() < 0.1 * volumes(ball).max()
fine, _ = made(dented, MaximumVolume=1e-3, PreserveBoundary=False)
assert volumes(fine).max() <= 1.1e-3
split, _ = made(dented, PreserveBoundary=False, MaximumRadiusEdgeRatio=1.2)
assert abs(volumes(split).sum() - enclosed(dented)) < 1e-9
assert (points(split)[:count] == points(dented)).all()

# A surface inside another of the same input bounds a void, given in two blocks, too.
blocks = vtkMultiBlockDataSet()
blocks.SetBlock(0, dented)
blocks.SetBlock(1, scaled(dented, 0.5))
shell, messages = made(blocks)
assert not messages and abs(volumes(shell).sum() - 0.875 * enclosed(dented)) < 1e-9, messages

# What cannot be filled is refused with the fact, the place and the remedy.
opened = shapetesting.copy(dented)
opened.BuildLinks()
opened.DeleteCell(11)
opened.RemoveDeletedCells()
assert 'Shape Tetrahedralize: the Input has 1 open loop' in made(opened)[1]
crossing = scaled(dented, 0.9)
shapetesting.set_points(crossing, points(crossing) + [0.5, 0.0, 0.0])
message = made(dented, crossing)[1]
assert 'inner surface 0 crosses or touches the Input at ' in message, message
outside = scaled(dented, 0.1)
shapetesting.set_points(outside, points(outside) + [5.0, 0.0, 0.0])
assert 'inner surface 0 lies outside the solid' in made(dented, outside)[1]
assert 'MaximumRadiusEdgeRatio is 0.5' in made(dented, MaximumRadiusEdgeRatio=0.5)[1]

# With points added on its triangles, a torus may get tetrahedra without a volume: they are counted in a warning.
across, around = numpy.meshgrid(2 * numpy.pi * numpy.arange(20) / 20, 2 * numpy.pi * numpy.arange(40) / 40)
ring = (1.0 + 0.4 * numpy.cos(across)).ravel()
places = numpy.column_stack([ring * numpy.cos(around).ravel(), ring * numpy.sin(around).ravel(),
                             0.4 * numpy.sin(across).ravel()])
corner = [[(20 * ((i + a) % 40) + (j + b) % 20) for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
          for i in range(40) for j in range(20)]
torus = vtkPolyData()
torus.SetPoints(vtkPoints())
shapetesting.set_points(torus, places)
torus.SetPolys(vtkCellArray())
for a, b, c, d in corner:
    torus.GetPolys().InsertNextCell(3, [a, b, c])
    torus.GetPolys().InsertNextCell(3, [a, c, d])
for bound in (0.005, 0.01, 0.02):
    solid, messages = made(torus, PreserveBoundary=False, MaximumVolume=bound)
    assert not messages and volumes(solid).max() < 1.1 * bound, (bound, messages)
    flat, warning = (volumes(solid) < 1e-12).sum(), 'Tetrahedralize.Warning'
    assert shapetesting.facts(solid).HasArray(warning) == (flat > 0), (bound, flat)
    assert flat == 0 or fact(solid, warning).startswith('%d tetrahedra are flat' % flat), fact(solid, warning)
# Millions of cells are announced before they are made.
stages = []
algorithm = shapetesting.new(shapemap.vtkShapeTetrahedralize, dented, MaximumVolume=1e-6)


def stop_at_work(*_):
    stages.append(algorithm.GetProgressText() or '')
    algorithm.SetAbortExecute('million' in stages[-1])


algorithm.AddObserver('ProgressEvent', stop_at_work)
assert not shapetesting.run(algorithm)
assert any('more than a million tetrahedra' in stage for stage in stages), stages

# Real models: one that crosses itself is refused, with the place.
for name, closed in (('eight', True), ('hand', True), ('torus_quad', True), ('bull', False)):
    solid, messages = made(off.read(os.path.join(shapetesting.MODELS, name + '.off')))
    if closed:
        assert not messages and volumes(solid).min() > 0.0, (name, messages)
    else:
        assert 'crosses or touches itself at 3 pairs of triangles (966 and 987 near' in messages
print('solids are filled, in regions, and what crosses itself is refused')
