"""Writes the state of a session with every filter, as this version saves it: NAME.pvsm and NAME.py in
this folder, and NAME.json with what the filters returned. Files that are there are never written again:
they are what users have. PYTHONPATH=Testing Utilities/pvpython.sh Testing/Conformance/States/make_state.py NAME"""
import json
import os
import re
import sys

from paraview import simple, smstate

folder = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(folder))
import filters
import states

DATA = os.path.normpath(os.path.join(folder, '..', '..', '..', 'Data'))


def read(name):
    reader = simple.XMLPolyDataReader if name.endswith('.vtp') else simple.XMLUnstructuredGridReader
    return reader(registrationName=name, FileName=[os.path.join(DATA, name)])


def landmarks(surface):
    """Five points of figure A, with their images."""
    chosen = simple.MaskPoints(registrationName='EveryPoint', Input=surface, OnRatio=200, GenerateVertices=1)
    return simple.CleantoGrid(registrationName='Landmarks', Input=chosen)


def make_pipeline():
    dented, bent = read('DentedSphere600.vtp'), read('BentBarSmall.vtp')
    a, b = read('FigureASmall.vtp'), read('FigureBSmall.vtp')
    ball, cube = read('BallSmall.vtu'), read('CubeSmall.vtu')
    head, skull, brain = (read('Phantom%sSmall.vtp' % part) for part in ('Head', 'Skull', 'Brain'))

    sphere = simple.ShapeParameterize(registrationName='Sphere', Input=dented)
    simple.ShapeHarmonicVolumeMap(
        registrationName='SolidMap', Domain=ball, Boundary=simple.OutputPort(sphere, 1), Method='SingleShot',
        MapArray='SourcePosition')
    layers = simple.ShapeHarmonicVolumeMap(
        registrationName='Layers', Domain=cube, Boundary=head, Features=[skull, brain], MaximumLevels=3)
    simple.ShapeApplyVolumeMap(
        registrationName='Applied', Input=brain, Map=simple.OutputPort(layers, 1))
    simple.ShapeTetrahedralize(
        registrationName='Tetrahedra', Input=head, InnerSurfaces=[skull, brain], MaximumVolume=0.01)
    grid = simple.ShapeHexRemesh(
        registrationName='GridHexahedra', Surface=dented, Method='Grid', CellsOnLongestSide=6)
    half = simple.Clip(registrationName='Half', Input=grid)
    simple.Calculator(registrationName='Quads', Input=simple.OutputPort(grid, 1), Function='coordsX')
    polycube = simple.ShapePolycube(registrationName='Polycube', Input=bent, TargetEdgeLength=0.5)
    simple.ShapeHexRemesh(
        registrationName='PolycubeHexahedra', Surface=bent, Polycube=simple.OutputPort(polycube, 1),
        Method='Polycube')
    simple.ShapeUntangle(
        registrationName='Untangled', Input=read('TwistedBarSmall.vtu'), RestShape=read('BentBarSmall.vtu'),
        FixBoundary=0, MaximumIterations=7)

    match = simple.ShapeCorrespondence(
        registrationName='Match', SurfaceA=a, SurfaceB=b, Landmarks=landmarks(a), Method='CommonSphere',
        CoarsePoints=500)
    simple.ShapeMapQuality(registrationName='Quality', Input=match)
    simple.ShapeMapErrorCurve(
        registrationName='Errors', Input=match, Target=b, Truth=a, Normalisation='GeodesicDiameter')
    simple.ShapeMapDifference(registrationName='Difference', SurfaceA=a, SurfaceB=b, NumberOfEigenpairs=12)
    simple.ShapeTransferFields(
        registrationName='Transferred', Input=a, Source=simple.Elevation(registrationName='Height', Input=b))
    simple.ShapeMorph(registrationName='Between', Input=a)
    simple.ShapeDeform(registrationName='Deformed', Input=a, Boundary=b, Rigidity=0.5)

    simple.ShapeBoundaryDistance(registrationName='Distance', Input=ball, Surface=dented, Signed=0)
    simple.ShapeExponentialMap(registrationName='Patch', Input=dented, Seed=[0.0, 0.0, 1.0], Radius=0.5)
    seeds = simple.Line(registrationName='Seeds', Point1=[0.0, 0.0, 1.0], Point2=[1.0, 0.0, 0.0], Resolution=1)
    simple.ShapeGeodesicDistance(registrationName='Geodesic', Input=dented, Seeds=seeds, Method='Exact')
    simple.ShapeLaplaceSpectrum(registrationName='Spectrum', Input=dented, NumberOfEigenpairs=9, Embedding='MDS')
    loop = [coordinate for x, y in ((0.4, 0.0), (0.0, 0.4), (-0.4, 0.0), (0.0, -0.4)) for coordinate in (x, y, 0.9)]
    cut = simple.ShapeCutFeature(registrationName='Cut', Input=dented, LoopPoints=loop, FillHole=0)
    simple.ShapeFillHoles(registrationName='Closed', Input=simple.OutputPort(cut, 1), FillMethod='Fair')
    simple.ShapePasteFeature(
        registrationName='Pasted', Feature=cut, Target=head, Seed=[1.0, 0.0, 0.0], Rotation=30.0, Scale=0.6)

    # What a user looks at: two outputs in two views, one of them coloured.
    views = [simple.CreateView('RenderView', registrationName='Hexahedra'),
             simple.CreateView('RenderView', registrationName='Image')]
    simple.ColorBy(simple.Show(half, views[0]), ('CELLS', 'ScaledJacobian'))
    simple.Show(simple.OutputPort(sphere, 1), views[1])


name = sys.argv[1]
paths = [os.path.join(folder, name + '.' + kind) for kind in ('pvsm', 'py', 'json')]
assert not any(os.path.exists(path) for path in paths), 'there is a state %s; give another name' % name
make_pipeline()
states.update_all()
missing = set(filters.names()) - {proxy.SMProxy.GetXMLName() for _, proxy in states.sources()}
assert not missing, 'the state has no %s' % missing
simple.SaveState(paths[0])
with open(paths[1], 'w') as file:
    file.write(smstate.get_state())
for path in paths[:2]:
    text = open(path).read().replace(DATA + os.sep, '')
    with open(path, 'w') as file:
        file.write(re.sub(r'[ \t]+$', '', text, flags=re.MULTILINE))
with open(paths[2], 'w') as file:
    lines = ['%s: %s' % (json.dumps(key), json.dumps(value)) for key, value in states.results().items()]
    file.write('{%s}\n' % ',\n '.join(lines))
