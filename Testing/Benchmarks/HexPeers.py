"""Hexahedra of Shape Hex Remesh beside those of its peers, Gmsh and snappyHexMesh, with about as many
cells, measured in one run by the same functions. Ours are all hexahedra, none inverted, with a larger
least scaled Jacobian than each peer, and nearer to the model than each peer whose cells are hexahedra and
not inverted, either: snappyHexMesh, with polyhedra and inverted cells, is nearer to fandisk.

    Utilities/pvpython.sh Testing/Benchmarks/HexPeers.py [--keep FOLDER] [MODEL ...]

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
import os
import shutil
import subprocess
import tempfile
import time

import sweep

import numpy
import off
import scenes
import shapetesting
from scenes import boundary_distance, skin, triangulated
from shapetesting import points
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOGeometry import vtkOpenFOAMReader, vtkSTLWriter
from vtkmodules.vtkIOLegacy import vtkUnstructuredGridReader

HEXAHEDRON = 12
PLACES = 200000
FEATURE_ANGLE = 40.0  # between normals, in degrees; Shape Hex Remesh's default
CLOSE = 0.1  # how far a peer's number of cells may be from ours
LIMIT = 1200.0  # seconds for one command
COLUMNS = ('model:<10', 'method:<26', 'cells:8d', 'hexahedra:9d', 'share:6.1f', 'least:8.3f',
           'mean:6.3f', 'inverted:8d', 'H:7.3f', 'cpu:8.1f', 'wall:8.1f')

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


def farthest(source, target, random):
    """The greatest distance of a surface's points and random places from another surface."""
    used = points(source)[numpy.unique(shapetesting.triangles(source))]
    places = numpy.concatenate([used, shapetesting.places_on(source, PLACES, random)[0]])
    return boundary_distance(places, target, Signed=False).max()


def measured(solid, model):
    """The columns of a grid."""
    hexahedra = vtk_to_numpy(solid.GetCellTypesArray()) == HEXAHEDRON
    scaled = vtk_to_numpy(scenes.scaled_jacobians(solid).GetCellData().GetArray('Quality'))[hexahedra]
    boundary, random = triangulated(skin(solid)), numpy.random.default_rng(1)
    H = max(farthest(model, boundary, random), farthest(boundary, model, random))
    return dict(cells=solid.GetNumberOfCells(), hexahedra=len(scaled),
                share=100.0 * len(scaled) / solid.GetNumberOfCells(), least=scaled.min(),
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
    watch = Watch()
    solid = scenes.output_of('HexRemesh', model)
    return solid, watch.read()


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
    return places[boundary_distance(places, model).argmin()]


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


def compare(model, stem, folder, table, claims):
    """Prints the rows of a model."""
    solid, took = ours(model)
    own = dict(measured(solid, model), **took)
    table.print(dict(own, model=stem, method='Shape Hex Remesh'))
    claims.at_most(stem, 'inverted', own['inverted'], 0)
    claims.check(stem, 'hexahedra', own['hexahedra'], own['hexahedra'] == own['cells'],
                 'all of %d cells' % own['cells'])
    for number, (name, program, cells, mesh) in enumerate(peers()):
        if not shutil.which(program):
            table.print(dict(model=stem, method=name), 'not installed')
            continue
        place = os.path.join(folder, '%s-%d' % (stem, number))
        os.makedirs(place, exist_ok=True)
        try:
            solid, took = as_many(lambda size: mesh(model, size, place), own['cells'],
                                  (cells * abs(volume(model)) / own['cells']) ** (1.0 / 3.0))
        except (Failure, subprocess.TimeoutExpired) as failure:
            table.print(dict(model=stem, method=name), 'failed: %s' % failure)
            continue
        row = dict(measured(solid, model), **took)
        table.print(dict(row, model=stem, method=name))
        claims.check(stem, 'least scaled Jacobian', '%.3f' % own['least'], own['least'] > row['least'],
                     "more than %s's %.3f" % (name, row['least']))
        if row['hexahedra'] == row['cells'] and not row['inverted']:
            claims.check(stem, 'H', '%.3f' % own['H'], own['H'] < row['H'],
                         "less than %s's %.3f" % (name, row['H']))


def main():
    parser = sweep.parser(__doc__)
    parser.add_argument('--keep', help="a folder for the peers' files")
    options = parser.parse_args()
    claims = sweep.Claims()
    table = sweep.Table(*COLUMNS)
    with tempfile.TemporaryDirectory(prefix='shapemap-peers-') as temporary:
        for name, path in sweep.models(options, ['fandisk', 'bunny00']):
            compare(triangulated(off.read(path)), name, options.keep or temporary, table, claims)
    claims.finish()


if __name__ == '__main__':
    main()
