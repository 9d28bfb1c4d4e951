"""Fills a model with hexahedra, maps it onto a ball and draws it: pvpython demo.py MODEL.off OUTPUT_FOLDER.

1. The solid inside the model's surface is filled with hexahedra (Shape Hex Remesh).
2. The surface is mapped onto the unit sphere (Shape Parameterize). A conformal map shrinks a protrusion,
   like the bunny's ears, exponentially with its length, to almost nothing. Area Weight keeps it large
   enough.
3. The surface is the boundary of the solid, with the positions on the sphere as map array. Shape Harmonic
   Volume Map moves the hexahedra into the ball, and untangles those that the map inverts (Fold Free). The
   distance field of the ball is transferred back to the model.
4. The results are written and drawn.

An exception is raised if a hexahedron is inverted, a triangle of the sphere is flipped or a filter fails.
"""
import os
import sys
import time

import numpy
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

import off
import pictures
import shapemap

START = time.time()
AREA_WEIGHT = 3.0


def say(text):
    print('%6.1f s  %s' % (time.time() - START, text), flush=True)


def update(filter, what):
    """Runs a filter, with its progress on one line, and returns its outputs. UpdatePipeline does
    not raise where a filter fails, but then the output is empty."""
    algorithm = filter.GetClientSideObject()
    begin = time.time()

    shown = [-1]

    def report(*_):
        percent = int(100.0 * algorithm.GetProgress())
        if percent != shown[0]:
            shown[0] = percent
            print('\r%6.1f s  %s: %3d %%' % (time.time() - START, what, percent), end='', flush=True)

    observer = algorithm.AddObserver('ProgressEvent', report)
    filter.UpdatePipeline()
    algorithm.RemoveObserver(observer)
    outputs = [algorithm.GetOutputDataObject(port)
               for port in range(algorithm.GetNumberOfOutputPorts())]
    print(end='\r')
    if outputs[0].GetNumberOfPoints() == 0:
        raise RuntimeError(what + ' failed')
    seconds = time.time() - begin
    say('%s: done in %.1f s' % (what, seconds))
    return outputs, seconds


def points(data):
    return vtk_to_numpy(data.GetPoints().GetData()).astype(float)


def triangles(surface):
    return vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def area_vectors(coordinates, corners):
    a, b, c = (coordinates[corners[:, k]] for k in range(3))
    return 0.5 * numpy.cross(b - a, c - a)


def write(data, path):
    writer = vtkXMLPolyDataWriter()
    writer.SetInputData(data)
    writer.SetFileName(path)
    writer.SetDataModeToBinary()
    if not writer.Write():
        raise RuntimeError('cannot write ' + path)


def save(proxy, path):
    """Binary is base64: raw appended data, the default, are not XML, and Debian's present expat does
    not let ParaView 5.11 read them."""
    simple.SaveData(path, proxy=proxy, DataMode='Binary')


def smallest_share(model, sphere, corners, share):
    """How much of the sphere the most shrunk triangles get that make up a share of the model."""
    areas = [numpy.linalg.norm(area_vectors(x, corners), axis=1) for x in (model, sphere)]
    areas = [area / area.sum() for area in areas]
    order = numpy.argsort(areas[1] / areas[0])
    last = numpy.searchsorted(numpy.cumsum(areas[0][order]), share)
    return areas[1][order][:last + 1].sum()


def map_to_sphere(reader, area_weight):
    """Shape Parameterize, the image's points, the number of flipped triangles, and seconds."""
    parameterize = simple.ShapeParameterize(Input=reader, AreaWeight=area_weight)
    outputs, seconds = update(parameterize, 'sphere map, area weight %g' % area_weight)
    sphere, corners = points(outputs[1]), triangles(outputs[1])
    volumes = numpy.einsum('ij,ij->i', sphere[corners[:, 0]],
                           numpy.cross(sphere[corners[:, 1]], sphere[corners[:, 2]]))
    flipped = int((volumes <= 0.0).sum())
    if flipped:
        raise RuntimeError('%d triangles of the sphere map are flipped' % flipped)
    return parameterize, sphere, flipped, seconds


def main(model_path, folder):
    def path(name):
        return os.path.join(folder, name)

    os.makedirs(folder, exist_ok=True)
    surface = off.read(model_path)
    model, corners = points(surface), triangles(surface)
    write(surface, path('model.vtp'))
    reader = simple.XMLPolyDataReader(FileName=[path('model.vtp')])
    say('read %d points and %d triangles' % (len(model), len(corners)))

    # The solid as hexahedra.
    remesh = simple.ShapeHexRemesh(Surface=reader)
    outputs, remesh_seconds = update(remesh, 'hexahedra')
    solid = outputs[0]
    jacobians = vtk_to_numpy(solid.GetCellData().GetArray('ScaledJacobian'))
    if jacobians.min() <= 0.0:
        raise RuntimeError('%d hexahedra are inverted' % (jacobians <= 0.0).sum())

    _, conformal, _, _ = map_to_sphere(reader, 0.0)
    conformal_share = smallest_share(model, conformal, corners, 0.05)
    parameterize, sphere, flipped, sphere_seconds = map_to_sphere(reader, AREA_WEIGHT)
    share = smallest_share(model, sphere, corners, 0.05)
    save(parameterize, path('surface.vtp'))
    save(simple.OutputPort(parameterize, 1), path('sphere.vtp'))

    # The solid into the ball.
    harmonic = simple.ShapeHarmonicVolumeMap(Domain=remesh, Boundary=parameterize, FoldFree=1)
    outputs, map_seconds = update(harmonic, 'harmonic map into the ball')
    facts = shapemap.facts(harmonic)
    errors = [facts[name] for name in ('RMSEVertices', 'RMSEInside', 'Maximum')]
    if facts['OutsidePoints']:
        raise RuntimeError('%d points of the hexahedra are not in the map\'s domain' % facts['OutsidePoints'])

    in_ball = vtk_to_numpy(outputs[0].GetCellData().GetArray('ScaledJacobian'))
    by_map = simple.ShapeApplyVolumeMap(Input=remesh, Map=simple.OutputPort(harmonic, 1))
    folded = update(by_map, 'the map alone')[0][0].GetCellData().GetArray('ScaledJacobian')
    folded = vtk_to_numpy(folded)
    if in_ball.min() <= 0.0:
        raise RuntimeError('%d hexahedra of the ball are inverted' % (in_ball <= 0.0).sum())

    # The ball's distance field, and the model's hexahedra with it: the points are the same ones.
    ball = simple.Calculator(Input=harmonic, Function='1 - mag(coords)', ResultArrayName='BoundaryDistance')
    field = simple.PassArrays(Input=ball, PointDataArrays=['BoundaryDistance'], CellDataArrays=[])
    back = simple.AppendAttributes(Input=[remesh, field])
    save(ball, path('ball.vtu'))
    save(back, path('hexahedra.vtu'))
    save(simple.OutputPort(harmonic, 1), path('charges.vtp'))
    simple.SaveData(path('levels.csv'), proxy=simple.OutputPort(harmonic, 2))
    say('wrote the results')

    begin = time.time()
    pictures.draw(folder, say)
    picture_seconds = time.time() - begin

    moves = numpy.abs(vtk_to_numpy(outputs[1].GetPointData().GetArray('Charge'))).max(axis=1)
    charges = int((moves > 0.0).sum())
    print('''
Model        %d points, %d triangles
Hexahedra    %d, by method %s; minimum scaled Jacobian %.2f, mean %.3f, none inverted;
             boundary within %.2f %% of the diagonal of the surface
Sphere map   %d triangles flipped; the 5 %% of the surface that shrinks most covers %.1e of the sphere
             (%.1e in the conformal map, with area weight 0)
Ball         by the map alone: minimum scaled Jacobian %.3f, mean %.3f, %d inverted;
             with Fold Free: minimum %.1e, mean %.3f, %d inverted
Volume map   error on the sphere: root mean square %.2e at points and %.2e inside triangles, maximum %.2e
             (divided by the longest edge of the bounding box)
Charges      %d in %d levels
Seconds      hexahedra %.1f, sphere map %.1f, volume map %.1f, pictures %.1f, all %.1f
Results      %s''' % (
        len(model), len(corners), len(jacobians), shapemap.facts(remesh)['Method'], jacobians.min(),
        jacobians.mean(), 100.0 * shapemap.facts(remesh)['Distance'] / surface.GetLength(),
        flipped, share, conformal_share, folded.min(), folded.mean(), (folded <= 0.0).sum(),
        in_ball.min(), in_ball.mean(), (in_ball <= 0.0).sum(), *errors, charges, outputs[2].GetNumberOfRows() - 1,
        remesh_seconds, sphere_seconds, map_seconds, picture_seconds, time.time() - START, folder),
        flush=True)


main(*sys.argv[1:])
