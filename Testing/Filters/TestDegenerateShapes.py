"""Shapes without an area or a volume, far from the origin, or with points far away: each is refused by a line that
names the fact, before long work; and what has a shape is computed, however its triangles are."""
import time

import numpy
from paraview import simple
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkFiltersSources import vtkSphereSource
import shapemap

import shapetesting
from shapetesting import copy, fact, new, outputs, points, read, refusal

QUICKLY = 10.0 # seconds, on a busy machine; each took more than 25 before it was refused


def refused(words, kind, *inputs, **settings):
    """It is refused soon, by one line with the words."""
    begin = time.time()
    said = refusal(new(kind, *inputs, **settings))
    seconds = time.time() - begin
    assert all(word in said for word in words), said
    assert seconds < QUICKLY, '%s took %.1f s to say: %s' % (kind.__name__, seconds, said)
    print('%5.1f s' % seconds, said[said.index('Shape '):].strip())


def moved(data, change):
    """A copy whose points are the changed ones."""
    result = copy(data)
    shapetesting.set_points(result, change(points(data)))
    return result


def surface(places, triangles):
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    shapetesting.set_points(data, numpy.array(places, dtype=float))
    data.SetPolys(vtkCellArray())
    for corners in triangles:
        data.GetPolys().InsertNextCell(len(corners), corners)
    return data


def outlier(places):
    changed = places.copy()
    changed[0] = 1e9
    return changed


onto = {
    'a position': lambda p: 0.0 * p + 1.0,
    'a line': lambda p: p * [0.0, 0.0, 1.0],
    'a slanted line': lambda p: numpy.outer(p[:, 2], [0.3, 0.7, 1.1]),
    'a plane': lambda p: p * [1.0, 1.0, 0.0],
}
dented, ball = read('DentedSphere600.vtp'), read('BallSmall.vtu')

# Without an area there is nothing to compute.
for what in ('a position', 'a line', 'a slanted line'):
    flat = moved(dented, onto[what])
    for kind in (shapemap.vtkShapeLaplaceSpectrum, shapemap.vtkShapeParameterize, shapemap.vtkShapePolycube,
                 shapemap.vtkShapeHexRemesh, shapemap.vtkShapeTetrahedralize):
        refused(['no area'], kind, flat)
    refused(['no area'], shapemap.vtkShapeGeodesicDistance, flat, dented)
    refused(['Input has no area'], shapemap.vtkShapeMapErrorCurve, flat, dented, dented)
    refused(['Target has no area'], shapemap.vtkShapeMapErrorCurve, dented, flat, dented)
    refused(['SurfaceA has no area'], shapemap.vtkShapeMapDifference, flat, dented)
    refused(['SurfaceB has no area'], shapemap.vtkShapeMapDifference, dented, flat)

# Without a volume there is no solid; and one that is too thin is refused before the work begins.
pillow = surface([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2], [0, 2, 1]])
needle = surface([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1e5]], [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])
for kind in (shapemap.vtkShapePolycube, shapemap.vtkShapeHexRemesh):
    refused(['encloses no volume'], kind, pillow)
    refused(['encloses no volume'], kind, moved(dented, onto['a plane']))
    refused(['too thin for its size'], kind, needle)
    refused(['too thin for its size'], kind, moved(dented, outlier))
    refused(['too thin for its size'], kind, moved(dented, lambda p: p * [1e6, 1.0, 1.0]))

# Cells: the volume that the boundary encloses stays, so that it must be positive.
for what in onto:
    refused(['the Input has no volume'], shapemap.vtkShapeUntangle, moved(ball, onto[what]))
for factor in (1e200, 1e-200):
    refused(['longest side of'], shapemap.vtkShapeUntangle, moved(ball, lambda p: p * factor))
refused(['does not resolve it'], shapemap.vtkShapeUntangle, moved(ball, lambda p: p + 1e15))
refused(['boundary of the Input is inverted', 'Reflect'], shapemap.vtkShapeUntangle,
        moved(ball, lambda p: p * [-1.0, 1.0, 1.0]))

# Coordinates that can be computed with.
for kind, inputs in ((shapemap.vtkShapeFillHoles, [shapetesting.without_cells(dented, [0, 1])]),
                     (shapemap.vtkShapePasteFeature, [shapetesting.without_cells(dented, [0, 1]), dented])):
    refused(['longest side of', 'scale it with Transform'], kind, moved(inputs[0], lambda p: p * 1e200), *inputs[1:])

# Exact distances on triangles that double precision does not resolve end, and say why.
refused(['too thin for double precision'], shapemap.vtkShapeGeodesicDistance, moved(dented, outlier),
        surface([points(dented)[5]], []), Method=1)

# Two ids at one place, joined by an edge of length 0: exact distances are those of the surface without the edge.
sphere = vtkSphereSource()
sphere.SetThetaResolution(24)
sphere.SetPhiResolution(16)
sphere.Update()
clean = copy(sphere.GetOutput())
seed = surface([points(clean)[7]], [])


def distances(data, method):
    return shapetesting.array(outputs(new(shapemap.vtkShapeGeodesicDistance, data, seed, Method=method))[0],
                              'GeodesicDistance')


dent = points(clean)
dent[dent[:, 2] > 0.4, 2] -= 0.35 # with saddles, around which paths turn
clean = moved(clean, lambda p: dent)
for every in (1, 3, 7):
    split = with_zero = clean
    places, triangles = points(clean).tolist(), shapetesting.triangles(clean).tolist()
    # Each n-th point gets a copy, and the triangles on one side of two of its edges use the copy.
    for point in range(0, len(points(clean)), every):
        around = [t for t, corners in enumerate(triangles) if point in corners]
        if len(around) < 4:
            continue
        # Triangles around the point, in order.
        after = {}
        for t in around:
            k = triangles[t].index(point)
            after[triangles[t][(k + 1) % 3]] = (triangles[t][(k + 2) % 3], t)
        begin = triangles[around[0]][(triangles[around[0]].index(point) + 1) % 3]
        fan, at = [], begin
        while at in after and len(fan) < len(around) // 2:
            following, t = after[at]
            fan.append(t)
            at = following
        twin = len(places)
        places.append(places[point])
        for t in fan:
            triangles[t][triangles[t].index(point)] = twin
        triangles.append([point, begin, twin])
        triangles.append([point, twin, at])
    doubled = surface(places, triangles)
    assert shapetesting.edges(doubled, 'Boundary') == shapetesting.edges(clean, 'Boundary') == 0
    count = len(points(clean))
    for method, bound in ((1, 1e-9), (2, 1e-12)):
        difference = abs(distances(doubled, method)[:count] - distances(clean, method)).max()
        assert difference < bound, 'method %d, every %d: %g' % (method, every, difference)
    exact, edges = distances(doubled, 1), distances(doubled, 2)
    assert (exact <= edges + 1e-12).all() and (exact[count:] >= 0.0).all()
    shapetesting.add_array(doubled, points(doubled), 'TargetPosition')
    unit = fact(outputs(new(shapemap.vtkShapeMapErrorCurve, doubled, doubled, doubled, Normalisation=2))[0],
                'MapErrorCurve.Unit')
    shapetesting.add_array(clean, points(clean), 'TargetPosition')
    same = fact(outputs(new(shapemap.vtkShapeMapErrorCurve, clean, clean, clean, Normalisation=2))[0],
                'MapErrorCurve.Unit')
    assert abs(unit - same) < 1e-9, (unit, same)

# ParaView's Clip through existing points makes polygons with sides of length 0: their repeated corners are left out,
# and the surface stays connected. It is said.
clip = simple.Clip(Input=simple.Sphere(ThetaResolution=24, PhiResolution=17), ClipType='Plane')
clip.ClipType.Normal = [1.0, 0.0, 0.0]
half = simple.ExtractSurface(Input=clip)
half.UpdatePipeline()
half = shapetesting.output(half)
found_corners = [points(half)[[half.GetCell(i).GetPointId(k) for k in range(half.GetCell(i).GetNumberOfPoints())]]
                 for i in range(half.GetNumberOfCells())]
short = [i for i, corners in enumerate(found_corners) if len(corners) > 3 and (
    numpy.linalg.norm(corners - numpy.roll(corners, 1, axis=0), axis=1) <= 1e-5 * numpy.linalg.norm(
        corners - corners[0], axis=1).max()).any()]
assert short, 'no polygon has a side of length 0'
found = outputs(new(shapemap.vtkShapeBoundaryDistance, half, half, Signed=False))[0]
assert '%d polygons with a side of almost no length (first polygon %d)' % (len(short), short[0]) in fact(
    found, 'BoundaryDistance.Warning'), fact(found, 'BoundaryDistance.Warning')
assert abs(shapetesting.array(found, 'BoundaryDistance')).max() < 1e-12
pole = surface([[numpy.sign(points(half)[:, 0].mean()) * 0.5, 0.0, 0.0]], [])
reached = shapetesting.array(outputs(new(shapemap.vtkShapeGeodesicDistance, half, pole, Method=1))[0],
                             'GeodesicDistance')
assert (reached >= 0.0).all() and 0.7 < reached.max() < 0.8, reached.max()
square = surface([[0, 0, 0], [1, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2, 3], [0, 3, 4]])
flat = outputs(new(shapemap.vtkShapeGeodesicDistance, square, surface([[0, 0, 0]], []), Method=1))[0]
assert abs(shapetesting.array(flat, 'GeodesicDistance') - [0.0, 1.0, 1.0, 2 ** 0.5, 1.0]).max() < 1e-12
bow = surface([[0, 0, 0], [1, 1, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2], [0, 1, 2, 3]])
said = refusal(new(shapemap.vtkShapeGeodesicDistance, bow, bow))
assert not said or '1 polygon that cannot be triangulated (first polygon 1)' in said, said
