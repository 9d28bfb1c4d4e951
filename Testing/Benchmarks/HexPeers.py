"""Hexahedra of Shape Hex Remesh beside those of its peers, Gmsh and snappyHexMesh, with about as many
cells, measured in one run by the same functions. Raises unless ours are all hexahedra, none inverted,
with a larger least scaled Jacobian than each peer, and nearer to the model than each peer whose cells are
hexahedra and not inverted, either: snappyHexMesh, with polyhedra and inverted cells, is nearer to fandisk.

    Utilities/pvpython.sh Testing/Benchmarks/HexPeers.py [--folder build/models] [--keep FOLDER] [MODEL ...]

The models are fandisk and bunny00 unless others are named. The peers are Debian's packages, gmsh and
openfoam (apt-get install --no-install-recommends openfoam; it is large, so set-up leaves it out). One that
is not installed, or fails, has a row that says so. --keep: the peers' files stay in this folder.

Gmsh: the triangles are cut into patches at the same angle as Shape Hex Remesh's creases, parameterised and
meshed anew; then each tetrahedron becomes four hexahedra (Mesh.SubdivisionAlgorithm = 2), with the new
points of the boundary on the surface, or, "flat", in the middle of edges and triangles, which inverts
less. Its hexahedra by recombination (Mesh.Recombine3DAll) are tried, too: Gmsh 4.8.4 crashes there, even
on a box. snappyHexMesh: blockMesh, surfaceFeatureExtract, castellated and snapped to surface and edges,
no layers, with the quality controls that come with it.

Columns: cells, hexahedra, their share; the least and the mean scaled Jacobian of the hexahedra (Verdict's,
by vtkMeshQuality) and how many are inverted (0 or less); polyhedra of OpenFOAM are no hexahedra. H: the
larger one-sided Hausdorff distance between the model and the boundary of the cells, in % of the diagonal
of the model's box: Shape Boundary Distance at the points and at 200,000 random places of each surface
from the other one. CPU seconds of all processes and threads, and wall seconds, for one run: files, and
the runs that find out which cell size gives so many cells, do not count.
"""
import argparse
import os
import shutil
import subprocess
import sys
import tempfile
import time

import numpy
import shapemap
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.vtkFiltersVerdict import vtkMeshQuality
from vtkmodules.vtkIOGeometry import vtkOpenFOAMReader, vtkSTLWriter
from vtkmodules.vtkIOLegacy import vtkUnstructuredGridReader

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path += [os.path.join(ROOT, 'Utilities'), os.path.join(ROOT, 'Testing')]

import off
import shapetesting
from shapetesting import points

HEXAHEDRON = 12
PLACES = 200000
FEATURE_ANGLE = 40.0  # between normals, in degrees; Shape Hex Remesh's default
CLOSE = 0.1  # how far a peer's number of cells may be from ours
LIMIT = 1200.0  # seconds for one command

GMSH = '''Merge "model.stl";
ClassifySurfaces{%(angle)g * Pi / 180, 1, 1, Pi};
CreateGeometry;
Surface Loop(1) = Surface{:};
Volume(1) = {1};
Physical Volume(1) = {1};
Mesh.MeshSizeMin = %(size).10g;
Mesh.MeshSizeMax = %(size).10g;
Mesh.MeshSizeFromPoints = 0;
Mesh.MeshSizeExtendFromBoundary = 0;
%(how)s
'''
GMSH_METHODS = {
    'Gmsh, tetrahedra in four': 'Mesh.SubdivisionAlgorithm = 2;',
    'Gmsh, the same, flat': 'Mesh.SubdivisionAlgorithm = 2; Mesh.SecondOrderLinear = 1;',
    'Gmsh, recombined': 'Mesh.Recombine3DAll = 1; Mesh.Algorithm3D = 9;'}

FOAM_HEAD = 'FoamFile { version 2.0; format ascii; class dictionary; object %s; }\n'
FOAM = {
    'controlDict': '''application snappyHexMesh; startFrom startTime; startTime 0; stopAt endTime;
endTime 1; deltaT 1; writeControl timeStep; writeInterval 1; writeFormat ascii; writePrecision 15;''',
    'fvSchemes': '''ddtSchemes {} gradSchemes {} divSchemes {} laplacianSchemes {}
interpolationSchemes {} snGradSchemes {}''',
    'fvSolution': '',
    'blockMeshDict': '''scale 1;
vertices (%(vertices)s);
blocks (hex (0 1 2 3 4 5 6 7) (%(counts)s) simpleGrading (1 1 1));
edges (); boundary (); mergePatchPairs ();''',
    'surfaceFeatureExtractDict': '''model.stl
{ extractionMethod extractFromSurface; includedAngle %(included)g; geometricTestOnly no; writeObj no; }''',
    'meshQualityDict': '#includeEtc "caseDicts/mesh/generation/meshQualityDict.cfg"',
    'snappyHexMeshDict': '''#includeEtc "caseDicts/mesh/generation/snappyHexMeshDict.cfg"
castellatedMesh on; snap on; addLayers off;
geometry { model.stl { type triSurfaceMesh; name model; } }
castellatedMeshControls
{
  features ( { file "model.eMesh"; level 0; } );
  refinementSurfaces { model { level (0 0); patchInfo { type wall; } } }
  refinementRegions {}
  locationInMesh (%(inside)s);
}
snapControls { explicitFeatureSnap true; implicitFeatureSnap false; }
addLayersControls
{ layers {} relativeSizes true; expansionRatio 1; finalLayerThickness 0.5; minThickness 0.1; }''',
}


class Failure(Exception):
    pass


def boundary_of(solid):
    extract = vtkDataSetSurfaceFilter()
    extract.SetInputData(solid)
    return triangulated(extract)


def triangulated(source):
    cut = vtkTriangleFilter()
    cut.SetInputConnection(source.GetOutputPort())
    cut.PassVertsOff()
    cut.PassLinesOff()
    cut.Update()
    return cut.GetOutput()


def farthest(source, target, random):
    """The greatest distance of a surface's points and random places from another surface."""
    used = points(source)[numpy.unique(shapetesting.triangles(source))]
    places = numpy.concatenate([used, shapetesting.places_on(source, PLACES, random)[0]])
    distance = shapemap.vtkShapeBoundaryDistance()
    distance.SetSigned(False)
    distance.SetInputDataObject(0, off.surface(places, []))
    distance.SetInputDataObject(1, target)
    messages = shapetesting.run(distance)
    assert not messages, messages
    return vtk_to_numpy(distance.GetOutputDataObject(0).GetPointData().GetArray(
        'BoundaryDistance')).max()


def measured(solid, model):
    """The columns of a grid."""
    quality = vtkMeshQuality()
    quality.SetInputData(solid)
    quality.SetHexQualityMeasureToScaledJacobian()
    quality.Update()
    hexahedra = vtk_to_numpy(solid.GetCellTypesArray()) == HEXAHEDRON
    scaled = vtk_to_numpy(quality.GetOutput().GetCellData().GetArray('Quality'))[hexahedra]
    boundary, random = boundary_of(solid), numpy.random.default_rng(1)
    H = max(farthest(model, boundary, random), farthest(boundary, model, random))
    return dict(cells=solid.GetNumberOfCells(), hexahedra=len(scaled), least=scaled.min(),
                mean=scaled.mean(), inverted=int((scaled <= 0.0).sum()),
                H=100.0 * H / model.GetLength())


class Watch:
    """CPU seconds, with those of ended children, and wall seconds."""

    def __init__(self):
        self.Wall, self.CPU = time.time(), sum(os.times()[:4])

    def read(self):
        return dict(cpu=sum(os.times()[:4]) - self.CPU, wall=time.time() - self.Wall)


def command(words, folder, environment=None):
    with open(os.path.join(folder, words[0] + '.log'), 'w') as log:
        done = subprocess.run(words, cwd=folder, stdout=log, stderr=subprocess.STDOUT,
                              env=environment, timeout=LIMIT)
    if done.returncode < 0:
        raise Failure('%s ended with signal %d' % (words[0], -done.returncode))
    if done.returncode > 0:
        raise Failure('%s ended with %d' % (words[0], done.returncode))


def write_model(model, folder):
    writer = vtkSTLWriter()
    writer.SetInputData(model)
    writer.SetFileTypeToASCII()
    writer.SetFileName(os.path.join(folder, 'model.stl'))
    assert writer.Write()


def ours(model):
    algorithm = shapemap.vtkShapeHexRemesh()
    algorithm.SetInputDataObject(model)
    watch = Watch()
    messages = shapetesting.run(algorithm)
    took = watch.read()
    assert not messages, messages
    return algorithm.GetOutputDataObject(0), took


def with_gmsh(model, size, folder, how):
    write_model(model, folder)
    with open(os.path.join(folder, 'model.geo'), 'w') as file:
        file.write(GMSH % dict(size=size, how=how, angle=FEATURE_ANGLE))
    watch = Watch()
    command(['gmsh', 'model.geo', '-3', '-format', 'vtk', '-o', 'mesh.vtk'], folder)
    took = watch.read()
    reader = vtkUnstructuredGridReader()
    reader.SetFileName(os.path.join(folder, 'mesh.vtk'))
    reader.Update()
    return reader.GetOutput(), took


def place_inside(model, size):
    """A place within the model, far from its surface and on no plane of a grid of this size."""
    random = numpy.random.default_rng(1)
    bounds = numpy.array(model.GetBounds()).reshape(3, 2)
    places = bounds[:, 0] + random.random((20000, 3)) * numpy.ptp(bounds, axis=1)
    distance = shapemap.vtkShapeBoundaryDistance()
    distance.SetInputDataObject(0, off.surface(places, []))
    distance.SetInputDataObject(1, model)
    assert not shapetesting.run(distance)
    return places[vtk_to_numpy(distance.GetOutputDataObject(0).GetPointData().GetArray(
        'BoundaryDistance')).argmin()]


def with_snappy(model, size, folder):
    for name in ('system', 'constant/triSurface'):
        os.makedirs(os.path.join(folder, name), exist_ok=True)
    write_model(model, os.path.join(folder, 'constant/triSurface'))
    bounds = numpy.array(model.GetBounds()).reshape(3, 2)
    counts = numpy.ceil(numpy.ptp(bounds, axis=1) / size).astype(int) + 2
    corners = [bounds.mean(axis=1) + 0.5 * size * counts * signs for signs in (
        (-1, -1, -1), (1, -1, -1), (1, 1, -1), (-1, 1, -1), (-1, -1, 1), (1, -1, 1), (1, 1, 1), (-1, 1, 1))]
    values = dict(
        vertices=' '.join('(%.15g %.15g %.15g)' % tuple(corner) for corner in corners),
        counts='%d %d %d' % tuple(counts), included=180.0 - FEATURE_ANGLE,
        inside='%.15g %.15g %.15g' % tuple(place_inside(model, size)))
    for name, text in FOAM.items():
        with open(os.path.join(folder, 'system', name), 'w') as file:
            file.write(FOAM_HEAD % name + (text % values if '%(' in text else text) + '\n')
    open(os.path.join(folder, 'case.foam'), 'w').close()
    environment = dict({'WM_PROJECT_DIR': '/usr/share/openfoam'}, **os.environ)
    watch = Watch()
    for words in (['blockMesh'], ['surfaceFeatureExtract'], ['snappyHexMesh', '-overwrite']):
        command(words, folder, environment)
    took = watch.read()
    reader = vtkOpenFOAMReader()
    reader.SetFileName(os.path.join(folder, 'case.foam'))
    reader.DecomposePolyhedraOff()
    reader.Update()
    return reader.GetOutput().GetBlock(0), took


def as_many(mesh, count, size):
    """The mesh of about so many cells, by a few trials of the size."""
    for _ in range(6):
        solid, took = mesh(size)
        cells = solid.GetNumberOfCells()
        if cells == 0:
            raise Failure('no cells')
        if abs(cells / count - 1.0) <= CLOSE:
            break
        size *= (cells / count) ** (1.0 / 3.0)
    return solid, took


def volume(surface):
    return numpy.linalg.det(points(surface)[shapetesting.triangles(surface)]).sum() / 6.0


def peers():
    """Of each peer: its program, and the function of a model, a size and a folder."""
    for name, how in GMSH_METHODS.items():
        yield name, 'gmsh', 20.0, lambda *arguments, how=how: with_gmsh(*arguments, how)
    yield 'snappyHexMesh', 'snappyHexMesh', 1.0, with_snappy


def show(name, row):
    print('  %-26s %8d %8d %6.1f %8.3f %6.3f %8d %7.3f %8.1f %8.1f' % (
        name, row['cells'], row['hexahedra'], 100.0 * row['hexahedra'] / row['cells'], row['least'],
        row['mean'], row['inverted'], row['H'], row['cpu'], row['wall']), flush=True)


def compare(path, folder):
    """Prints the rows of a model; returns the claims that do not hold."""
    source = vtkTriangleFilter()
    source.SetInputData(off.read(path))
    source.Update()
    model, stem = source.GetOutput(), os.path.splitext(os.path.basename(path))[0]
    print(stem, flush=True)
    solid, took = ours(model)
    own = dict(measured(solid, model), **took)
    show('Shape Hex Remesh', own)
    claims = [('Shape Hex Remesh has 0 inverted', own['inverted'] == 0),
              ('Shape Hex Remesh has hexahedra only', own['hexahedra'] == own['cells'])]
    for number, (name, program, cells, mesh) in enumerate(peers()):
        if not shutil.which(program):
            print('  %-26s not installed' % name, flush=True)
            continue
        place = os.path.join(folder, '%s-%d' % (stem, number))
        os.makedirs(place, exist_ok=True)
        try:
            solid, took = as_many(lambda size: mesh(model, size, place), own['cells'],
                                  (cells * abs(volume(model)) / own['cells']) ** (1.0 / 3.0))
        except (Failure, subprocess.TimeoutExpired) as failure:
            print('  %-26s failed: %s' % (name, failure), flush=True)
            continue
        row = dict(measured(solid, model), **took)
        show(name, row)
        claims.append(('a larger least scaled Jacobian than ' + name, own['least'] > row['least']))
        if row['hexahedra'] == row['cells'] and not row['inverted']:
            claims.append(('a smaller H than ' + name, own['H'] < row['H']))
    return ['%s: %s' % (stem, words) for words, held in claims if not held]


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('models', nargs='*', default=['fandisk', 'bunny00'], metavar='MODEL')
    parser.add_argument('--folder', default=os.path.join(ROOT, 'build', 'models'))
    parser.add_argument('--keep', help="a folder for the peers' files")
    arguments = parser.parse_args()
    print('  %-26s %8s %8s %6s %8s %6s %8s %7s %8s %8s' % (
        '', 'cells', 'hexes', '%', 'least SJ', 'mean', 'inverted', 'H %', 'CPU s', 'wall s'))
    missed = []
    with tempfile.TemporaryDirectory(prefix='shapemap-peers-') as temporary:
        for model in arguments.models:
            missed += compare(os.path.join(arguments.folder, model + '.off'),
                              arguments.keep or temporary)
    assert not missed, 'does not hold: ' + '; '.join(missed)
    print('every claim holds')


if __name__ == '__main__':
    main()
