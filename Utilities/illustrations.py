"""Draws the picture of each filter's page from the shapes of the build:
Utilities/pvpython.sh Utilities/illustrations.py [filter ...]

The pictures in Documentation/Pictures are part of the source, because the help window has them as soon
as the plugin is built. Draw one again when its filter's result changes, and look at it."""
import math
import os
import shutil
import subprocess
import sys
import tempfile

import numpy
from paraview.simple import *
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkTable
from vtkmodules.vtkFiltersSources import vtkPlaneSource

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
FOLDER = os.path.join(ROOT, 'Documentation', 'Pictures')
SHAPES = os.path.join(ROOT, 'build', 'Data')
INK, PLAIN, ACCENT = [0.13, 0.16, 0.22], [0.80, 0.82, 0.85], [0.93, 0.55, 0.24]
# From an inverted cell, in red, to a perfect one.
QUALITY = [0.0, 0.75, 0.13, 0.15, 0.25, 0.95, 0.55, 0.25, 0.5, 0.98, 0.86, 0.5,
           0.75, 0.60, 0.80, 0.78, 1.0, 0.22, 0.50, 0.66]
FRONT, ABOVE = ((0.3, -1.0, 0.25), (0.0, 0.0, 1.0)), ((0.6, 0.5, 1.0), (0.0, 1.0, 0.0))

drawings = {}


def drawing(function):
    drawings[function.__name__] = function
    return function


def find(name):
    """The path of a shape. The tests find smaller ones."""
    return os.path.join(SHAPES, name)


def shape(name):
    return OpenDataFile(find(name))


def figures():
    return shape('FigureA.vtp'), shape('FigureB.vtp')


def place(source, shift):
    moved = Transform(Input=source)
    moved.Transform.Translate = shift
    return moved


def show(source, shift=(0, 0, 0), colour=None, array=None, kind='POINTS', part='', limits=None, edges=False,
         preset=None, opacity=1.0, discrete=False):
    """Adds a source to the picture, in one colour or coloured by an array."""
    shown = Show(source, GetActiveView())
    shown.Representation = 'Surface With Edges' if edges else 'Surface'
    shown.EdgeColor, shown.LineWidth, shown.Ambient, shown.Diffuse = INK, 1.0, 0.3, 0.75
    shown.Position, shown.Opacity = list(shift), opacity
    shown.DiffuseColor = shown.AmbientColor = colour or PLAIN
    shown.ColorArrayName = [None, '']
    if array:
        ColorBy(shown, (kind, array, part) if part else (kind, array))
        table = GetColorTransferFunction(array)
        if preset == 'quality':
            table.ColorSpace, table.RGBPoints = 'RGB', QUALITY
        else:
            table.ApplyPreset(preset or 'Viridis (matplotlib)', True)
        if limits:
            table.RescaleTransferFunction(*limits)
        if discrete:
            table.Discretize, table.NumberOfTableValues = 1, discrete
        shown.SetScalarBarVisibility(GetActiveView(), False)
    return shown


def checkered(source, array, size, axes='XZ'):
    """Adds Checker to a source: a wave from -1 to 1 in squares of this size, by the coordinates x and z, or
    x and y, of an array."""
    waves = '*'.join('sin(%g*%s_%s)' % (math.pi / size, array, axis) for axis in axes)
    return Calculator(Input=source, ResultArrayName='Checker', Function=waves)


def named(values, name):
    array = numpy_to_vtk(numpy.asarray(values, float), deep=True)
    array.SetName(name)
    return array


def produced(data):
    """A source that has the data."""
    source = TrivialProducer()
    source.GetClientSideObject().SetOutput(data)
    return source


def cut(source, origin=(0, 0, 0), normal=(0, 1, 0)):
    half = Clip(Input=source, ClipType='Plane', Crinkleclip=1)
    half.ClipType.Origin, half.ClipType.Normal = list(origin), list(normal)
    return half


def horned():
    ball = Sphere(ThetaResolution=80, PhiResolution=80)
    bumped = Calculator(
        Input=ball, CoordinateResults=1,
        Function='coords*(1 + 1.2*max(0, 1 - ((coordsX-0.5)^2 + coordsY^2 + coordsZ^2)/0.05)^3)')
    loop = [part for k in range(40) for part in (
        0.41, 0.28 * math.cos(math.pi * k / 20), 0.28 * math.sin(math.pi * k / 20))]
    return ShapeCutFeature(Input=bumped, LoopPoints=loop)


@drawing
def Solidify():
    """A surface with holes, debris and a sheet, its defects as points, and the solid that it becomes."""
    rest = shape('FigureA.vtp')
    for centre in ((0, 0, 1.0), (0.03, -0.14, 0.68), (-0.15, -0.1, 0.2)):
        rest = Clip(Input=rest, ClipType='Sphere', Crinkleclip=1, Invert=0)
        rest.ClipType.Center, rest.ClipType.Radius = list(centre), 0.1
    debris = [Sphere(Center=[0.3 * k, -0.1, 0.25], Radius=0.02) for k in (-1, 1)]
    damaged = AppendDatasets(Input=[rest] + debris)
    show(damaged, (-0.62, 0, 0))
    defects = OutputPort(ShapeSolidify(Input=damaged, Method='Report', SmallestPiece=0.1), 1)
    # Spheres of triangles: ParaView shifts surfaces against points, and VTK then draws points as flat disks, which the
    # surface that they lie on hides in part.
    spheres = Glyph(Input=defects, GlyphType='Sphere', GlyphMode='All Points', ScaleFactor=0.09)
    spheres.ScaleArray, spheres.OrientationArray = ['POINTS', 'No scale array'], ['POINTS', 'No orientation array']
    show(spheres, (-0.62, 0, 0), colour=ACCENT)
    solid = ShapeSolidify(Input=damaged, SmallestPiece=0.1)
    show(solid, (0.62, 0, 0), array='Origin', kind='CELLS', preset='Cool to Warm')
    return FRONT


@drawing
def FillHoles():
    opened = Clip(Input=shape('FigureA.vtp'), ClipType='Plane')
    opened.ClipType.Origin, opened.ClipType.Normal = [0, 0, 0.86], [0, 0, -1]
    opened.Invert = 0
    surface = Clean(Input=ExtractSurface(Input=opened))
    show(surface, (-0.62, 0, 0))
    show(ShapeFillHoles(Input=surface), (0.62, 0, 0), array='Filled', kind='CELLS', preset='Cool to Warm')
    return (0.3, -1.0, 0.6), FRONT[1]


@drawing
def LabelSurfaces():
    grid = Wavelet(WholeExtent=[-24, 24] * 3)
    # A ball of two halves without a quarter, with a smaller ball inside.
    ball, half = 'coordsX^2 + coordsY^2 + coordsZ^2 < %d', 'if(coordsX + 0.4 * coordsZ > 0, 2, 1)'
    labels = Calculator(
        Input=grid, ResultArrayName='Label', Function='if(%s, 3, if(%s, if(coordsY < 0, %s, %s), 0))' % (
            ball % 81, ball % 400, 'if(coordsZ > 0, 0, %s)' % half, half))
    regions = ShapeLabelSurfaces(Input=labels, LabelArray='Label')
    show(regions, array='Patch', kind='CELLS', preset='Turbo', limits=(0, 5), discrete=6, edges=True)
    return (0.4, -1.0, 0.7), FRONT[1]


def image_reader(folder):
    """A segmentation of two regions with oblique axes: its file is read, and its surface extracted."""
    path = os.path.join(folder, 'segmentation.nrrd')
    i, j, k = numpy.indices((24, 20, 10))
    ball = ((i - 11.5) / 10.0) ** 2 + ((j - 9.5) / 8.0) ** 2 + ((k - 4.5) / 4.0) ** 2 < 1.0
    labels = numpy.where(ball, numpy.where(i < 12, 1, 2), 0).astype(numpy.uint8)
    with open(path, 'wb') as file:
        file.write(b'NRRD0004\ntype: uchar\ndimension: 3\nspace: left-posterior-superior\nsizes: 24 20 10\n'
                   b'space directions: (0.8,0,-0.6) (0,1,0) (1.2,0,1.6)\nspace origin: (0,0,0)\n'
                   b'encoding: raw\n\n' + labels.tobytes(order='F'))
    image = ShapeImageReader(FileNames=[path])
    layer = ExtractSurface(Input=ExtractSubset(Input=image, VOI=[0, 23, 0, 19, 5, 5]))
    show(layer, array='ImageScalars', preset='Grayscale')
    surface = ShapeLabelSurfaces(Input=image)
    show(surface, (0, 0, -17), array='Patch', kind='CELLS', preset='Turbo', limits=(0, 3), edges=True)
    return (0.5, -1.0, 0.6), (0, 0, 1)


@drawing
def ImageReader():
    return image_reader(tempfile.mkdtemp())


@drawing
def ImageValues():
    """A layer of a scan, and the moduli of the cells of a bone."""
    bone = shape('Ball.vtu')
    inside = 'coordsX^2 + coordsY^2 + coordsZ^2'
    scan = Calculator(
        Input=ResampleToImage(Input=bone, UseInputBounds=0, SamplingBounds=[-1.3, 1.3] * 3,
                              SamplingDimensions=[40, 40, 40]),
        ResultArrayName='HU', Function='if(%s < 1, 300 + 1100 * (%s)^2 + 200 * coordsX, 0)' % (inside, inside))
    layer = Slice(Input=scan, SliceType='Plane')
    layer.SliceType.Origin, layer.SliceType.Normal = [0, 0, 0], [0, 1, 0]
    show(layer, (-1.3, 0, 0), array='HU', preset='Grayscale')
    cells = ShapeImageValues(Input=bone, Image=scan, ImageArray='HU', Density='0.01 + 0.001 * HU', Materials=12)
    show(cut(cells, (0, 0, 0), (0, -1, 0)), (1.3, 0, 0), array='Modulus', kind='CELLS',
         preset='Viridis (matplotlib)', edges=True)
    return (0.15, -1.0, 0.2), FRONT[1]


@drawing
def Tetrahedralize():
    solid = ShapeTetrahedralize(Input=shape('FigureA.vtp'), PreserveBoundary=0)
    show(cut(solid, (0, 0.02, 0), (0.1, -1, 0)), edges=True, colour=[0.55, 0.74, 0.80])
    return FRONT


@drawing
def Parameterize():
    sphere = ShapeParameterize(Input=shape('FigureA.vtp'), AreaWeight=1.0)
    image = Calculator(Input=OutputPort(sphere, 1), ResultArrayName='TargetPosition', Function='coords')
    surface = checkered(OutputPort(sphere, 0), 'TargetPosition', 0.3)
    shrunk = Transform(Input=checkered(image, 'TargetPosition', 0.3))
    shrunk.Transform.Scale = [0.45] * 3
    show(surface, (-0.5, 0, -0.55), array='Checker', preset='Cool to Warm')
    show(shrunk, (0.62, 0, 0), array='Checker', preset='Cool to Warm')
    return FRONT


@drawing
def Correspondence():
    a, b = figures()
    both = ShapeCorrespondence(SurfaceA=a, SurfaceB=b)
    onto = Calculator(Input=both, ResultArrayName='Position', Function='TargetPosition')
    itself = Calculator(Input=b, ResultArrayName='Position', Function='coords')
    for source, x in ((onto, -0.65), (itself, 0.65)):
        show(checkered(source, 'Position', 0.08), (x, 0, 0), array='Checker', preset='Cool to Warm')
    return FRONT


@drawing
def Coupling():
    figure = shape('FigureA.vtp')
    both = ShapeCoupling(ShapeA=figure, ShapeB=ShapeSkeleton(Input=figure))
    onto = Calculator(Input=both, ResultArrayName='Height', Function='TargetPosition_Z')
    itself = Calculator(Input=OutputPort(both, 1), ResultArrayName='Height', Function='coordsZ')
    show(onto, (-0.65, 0, 0), array='Height', preset='Viridis (matplotlib)', limits=(0, 1))
    show(Tube(Input=itself, Radius=0.012), (0.65, 0, 0), array='Height', preset='Viridis (matplotlib)', limits=(0, 1))
    return FRONT


@drawing
def TransferFields():
    a, b = figures()
    height = Calculator(Input=b, ResultArrayName='Field', Function='sin(14*coordsZ)*cos(9*coordsX)')
    carried = ShapeTransferFields(Input=a, Source=height)
    show(height, (0.65, 0, 0), array='Field', preset='Viridis (matplotlib)')
    show(carried, (-0.65, 0, 0), array='Field', preset='Viridis (matplotlib)')
    return FRONT


@drawing
def ExponentialMap():
    surface = shape('DentedSphere10k.vtp')
    patch = ShapeExponentialMap(Input=surface, Seed=[0.3, 0.2, 1.0], Radius=0.7)
    checker = checkered(Calculator(Input=patch, ResultArrayName='Position',
                                   Function='TargetPosition+0.07*kHat'), 'Position', 0.14, 'XY')
    flat = Calculator(Input=checker, CoordinateResults=1, Function='TargetPosition')
    show(surface, (-0.9, 0, 0))
    lifted = Calculator(Input=checker, CoordinateResults=1, Function='coords*1.003')
    show(lifted, (-0.9, 0, 0), array='Checker', preset='Cool to Warm')
    show(flat, (1.0, 0, 0), array='Checker', preset='Cool to Warm')
    return (0.0, 0.1, 1.0), (0, 1, 0)


@drawing
def LaplaceSpectrum():
    spectrum = ShapeLaplaceSpectrum(Input=shape('FigureA.vtp'), NumberOfEigenpairs=20)
    for number, x in ((2, -1.15), (5, 0.0), (9, 1.15)):
        one = Calculator(Input=spectrum, ResultArrayName='Mode%d' % number,
                         Function='Eigenfunctions_%d' % number)
        show(one, (x, 0, 0), array='Mode%d' % number, preset='Cool to Warm')
    return FRONT


@drawing
def NetworkDescriptors():
    network = os.path.join(ROOT, 'Data', 'RandomFeatures.onnx')
    for figure, x in zip(figures(), (-0.65, 0.65)):
        described = ShapeNetworkDescriptors(Input=figure, FileName=network)
        one = Calculator(Input=described, ResultArrayName='Descriptor', Function='NetworkDescriptors_2')
        show(one, (x, 0, 0), array='Descriptor', preset='Cool to Warm')
    return FRONT


@drawing
def HarmonicVolumeMap():
    ball = shape('Ball.vtu')
    sphere = ShapeParameterize(Input=shape('DentedSphere10k.vtp'))
    moved = ShapeHarmonicVolumeMap(Domain=ball, Boundary=OutputPort(sphere, 1), MapArray='SourcePosition')
    start = Calculator(Input=ball, ResultArrayName='SourcePosition', Function='coords')
    for source, x in ((start, -1.3), (moved, 1.3)):
        show(cut(source, normal=(0.3, 0.2, 1)), (x, 0, 0), array='SourcePosition', part='Magnitude', edges=True)
    return (0.25, 0.2, 1.0), (0, 1, 0)


@drawing
def HarmonicVolumeMapElements():
    # A harmonic motion of a ball with smaller and smaller triangles and tetrahedra: how far the map is from it.
    motion = ('({0}X + 0.3*({0}Y^2 - {0}Z^2))*iHat + ({0}Y + 0.3*{0}X*{0}Z)*jHat'
              ' + ({0}Z + 0.15*({0}X^3 - 3*{0}X*{0}Y^2))*kHat')
    disk = Disk(InnerRadius=0.0, OuterRadius=0.97, RadialResolution=100, CircumferentialResolution=200)
    for level, x in ((1, -2.2), (2, 0.0), (3, 2.2)):
        box = Subdivide(Input=Triangulate(Input=Clean(Input=Box())), NumberofSubdivisions=level + 1)
        ball = Calculator(Input=box, CoordinateResults=1, Function='norm(coords)')
        boundary = Calculator(Input=ball, ResultArrayName='TargetPosition', Function=motion.format('coords'))
        moved = ShapeHarmonicVolumeMap(Domain=disk, Boundary=boundary, Method='FiniteElements',
                                       Tetrahedra=2000 * 8 ** (level - 1))
        error = Calculator(Input=moved, ResultArrayName='Error', Function='log10(mag(coords - (%s)) + 1e-7)'
                           % motion.format('SourcePosition_'))
        show(error, (x, 0, 0), array='Error', limits=(-4.5, -1.5))
    return (0, 0, 1), (0, 1, 0)


@drawing
def ApplyVolumeMap():
    grid = Wavelet(WholeExtent=[-9, 9, -9, 9, 0, 0])
    inside = Transform(Input=grid)
    inside.Transform.Scale = [0.06, 0.06, 1.0]
    plane = Calculator(Input=inside, ResultArrayName='From', Function='coords')
    moved = ShapeApplyVolumeMap(Input=plane, Map=shape('DentedSphereCharges.vtp'))
    kept = Threshold(Input=moved, Scalars=['POINTS', 'OutsideDomain'], ThresholdMethod='Between',
                     LowerThreshold=0, UpperThreshold=0)
    show(plane, (-0.7, 0, 0), array='From', part='X', edges=True)
    show(kept, (0.8, 0, 0), array='From', part='X', edges=True)
    return (0, 0, 1), (0, 1, 0)


@drawing
def Certificate():
    """The map of the ball onto a horse: a cut through the boxes, and those that are inverted."""
    sphere = ShapeParameterize(Input=shape('HorseSmall.vtp'))
    ball = OutputPort(sphere, 1)
    moved = ShapeHarmonicVolumeMap(Domain=ball, Boundary=ball, MapArray='SourcePosition')
    boxes = ShapeCertificate(Map=OutputPort(moved, 1), Tolerance=1.0 / 256.0)
    plane = Slice(Input=boxes)
    plane.SliceType.Origin, plane.SliceType.Normal = [0.0, 0.01, 0.0], [0.0, 1.0, 0.0]
    show(plane, edges=True)
    show(Threshold(Input=boxes, Scalars=['CELLS', 'Certified'], LowerThreshold=-1, UpperThreshold=-1),
         colour=ACCENT)
    show(ball, opacity=0.25)
    return FRONT


@drawing
def MeshMotion():
    """Tetrahedra around a body that turns, cut in the middle."""
    body = Clean(Input=Sphere(Radius=0.25, ThetaResolution=32, PhiResolution=17))
    body = Transform(Input=body)
    body.Transform.Scale = [1.0, 0.4, 0.7]
    box = Subdivide(Input=Triangulate(Input=Clean(Input=Box(XLength=1.2))), NumberofSubdivisions=3)
    mesh = ShapeTetrahedralize(Input=AppendGeometry(Input=[box, body]), MaximumVolume=3e-4)
    turned = Calculator(Input=body, ResultArrayName='TargetPosition', Function=(
        '(cos(0.2)*coordsX-sin(0.2)*coordsY)*iHat+(sin(0.2)*coordsX+cos(0.2)*coordsY)*jHat+coordsZ*kHat'))
    moved = ShapeMeshMotion(Input=mesh, Boundary=turned)
    still = ShapeMeshMotion(Input=mesh, Boundary=Calculator(
        Input=body, ResultArrayName='TargetPosition', Function='coords'))
    for source, x in ((still, -0.65), (moved, 0.65)):
        show(cut(source, (0, 0, 0), (0, 0, 1)), (x, 0, 0), array='ScaledJacobian', kind='CELLS', limits=(0, 1),
             preset='quality', edges=True)
    return (0.0, 0.0, 1.0), (0, 1, 0)


@drawing
def RegisterVolume():
    """A head, the one that it is mapped onto, and the tetrahedra at their images, cut in the middle."""
    head = PassArrays(Input=shape('PhantomHeadSmall.vtp'))
    other = Calculator(Input=head, CoordinateResults=1, Function=(
        'iHat*1.2*coordsX + jHat*(coordsY+0.15*coordsX*coordsX) + kHat*coordsZ*(1+0.2*coordsX)'))
    solid = OutputPort(ShapeRegisterVolume(Input=head, Target=other), 1)
    show(head, (-2.6, 0, 0))
    show(other, colour=ACCENT)
    show(cut(solid, (0, 0, 0), (0, -1, 0)), (2.8, 0, 0), edges=True)
    return FRONT


@drawing
def Untangle():
    ball = shape('BallSmall.vtu')
    folded = Calculator(Input=ball, CoordinateResults=1,
                        Function='coords+iHat*0.6*sin(6*coordsX)*(1-mag(coords))')
    for source, x in ((folded, -1.15), (ShapeUntangle(Input=folded, RestShape=ball), 1.15)):
        measured = MeshQuality(Input=source, HexQualityMeasure='Scaled Jacobian')
        show(cut(measured, normal=(0.2, 0.2, 1)), (x, 0, 0), array='Quality', kind='CELLS', limits=(0, 1),
             preset='quality', edges=True)
    return (0.2, 0.2, 1.0), (0, 1, 0)


@drawing
def HexRemesh():
    surface = shape('FigureA.vtp')
    solid = ShapeHexRemesh(Surface=surface, Method='Grid', CellsOnLongestSide=20)
    show(surface, (-0.62, 0, 0))
    show(cut(solid, (0, 0.02, 0), (0.1, -1, 0)), (0.62, 0, 0), array='ScaledJacobian', kind='CELLS',
         limits=(0, 1), preset='quality', edges=True)
    return FRONT


@drawing
def StructuredBlocks():
    solid = ShapeHexRemesh(Surface=shape('TwistedBar.vtp'), Method='Polycube', CellsOnLongestSide=24)
    blocks = ShapeStructuredBlocks(Input=OutputPort(solid, 2))
    show(OutputPort(solid, 2), (-1.2, 0, 0), array='Block', kind='CELLS', preset='Turbo', edges=True)
    show(MergeBlocks(Input=OutputPort(blocks, 0)), (3.6, 0, 0), array='SplineError', edges=True)
    return (0.5, 0.6, 1.0), (0, 1, 0)


@drawing
def Polycube():
    polycube = ShapePolycube(Input=shape('TwistedBar.vtp'))
    for port, shift in ((0, (-1.2, 0, 0)), (1, (3.6, 0, 0))):
        show(OutputPort(polycube, port), shift, array='Label', kind='CELLS', preset='Turbo', limits=(0, 5),
             discrete=6)
    return (0.5, 0.6, 1.0), (0, 1, 0)


@drawing
def CutFeature():
    feature = horned()
    show(OutputPort(feature, 0), (0.35, 0, 0), colour=ACCENT)
    show(OutputPort(feature, 1), (-0.25, 0, 0))
    return (-0.1, 0.5, 1.0), (0, 1, 0)


@drawing
def PasteFeature():
    planet = Sphere(ThetaResolution=90, PhiResolution=90, Radius=1.2)
    pasted = ShapePasteFeature(Feature=horned(), Target=planet, Seed=[0.5, 1.0, 0.5], Rotation=30.0)
    show(pasted, array='Part', kind='CELLS', preset='Cool to Warm')
    return (-0.4, 0.35, 1.0), (0, 1, 0)


@drawing
def Deform():
    plane = Plane(Origin=[-1, -1, 0], Point1=[1, -1, 0], Point2=[-1, 1, 0], XResolution=50, YResolution=50)
    bump = Calculator(Input=plane, CoordinateResults=1,
                      Function='coords + 0.5*exp(-12*(coordsX^2 + coordsY^2))*kHat')
    border = FeatureEdges(Input=bump, BoundaryEdges=1, FeatureEdges=0, NonManifoldEdges=0, ManifoldEdges=0)
    handle = Calculator(Input=border, ResultArrayName='SourcePosition', Function='coords')
    saddle = Calculator(Input=handle, CoordinateResults=1,
                        Function='coords + 0.4*(coordsX^2 - coordsY^2)*kHat')
    deformed = ShapeDeform(Input=bump, Boundary=saddle)
    for surface, curve, x in ((bump, border, -1.5), (deformed, saddle, 1.5)):
        show(surface, (x, 0, 0), edges=True)
        show(curve, (x, 0, 0), colour=ACCENT).LineWidth = 5.0
    return (0.3, -1.0, 0.7), (0, 0, 1)


@drawing
def CageDeform():
    figure = shape('FigureA.vtp')
    figure.UpdatePipeline()
    x0, x1, y0, y1, z0, z1 = figure.GetDataInformation().GetBounds()
    box = Box(XLength=1.15 * (x1 - x0), YLength=1.4 * (y1 - y0), ZLength=1.15 * (z1 - z0),
              Center=[(x0 + x1) / 2, (y0 + y1) / 2, (z0 + z1) / 2])
    cage = Subdivide(Input=Triangulate(Input=Clean(Input=box)), NumberofSubdivisions=2)
    bent = Calculator(Input=cage, CoordinateResults=1, Function='coords + 0.7*(coordsZ - %g)^2*iHat' % z0)
    deformed = ShapeCageDeform(Input=figure, Cage=cage, MovedCage=bent)
    for surface, around, x in ((figure, cage, -0.75), (deformed, bent, 0.55)):
        show(surface, (x, 0, 0))
        wires = show(around, (x, 0, 0), colour=ACCENT)
        wires.Representation, wires.LineWidth = 'Wireframe', 2.0
    return FRONT


@drawing
def PaintArray():
    plane = Plane(Origin=[-1, -1, 0], Point1=[1, -1, 0], Point2=[-1, 1, 0], XResolution=100, YResolution=100)
    border = FeatureEdges(Input=plane, BoundaryEdges=1, FeatureEdges=0, NonManifoldEdges=0, ManifoldEdges=0)
    old = Calculator(Input=border, ResultArrayName='SourcePosition', Function='coords')
    saddle = Calculator(Input=old, CoordinateResults=1, Function='coords + 0.5*(coordsX^2 - coordsY^2)*kHat')
    # Two strokes that cross; the second one is less stiff.
    first = [(0.55 * math.cos(t), 0.55 * math.sin(t), 0.0) for t in numpy.linspace(0.0, 2.0 * math.pi, 120)]
    second = [(-0.75 + 0.0125 * k, 0.0, 0.0) for k in range(120)]
    painted = ShapePaintArray(Input=plane, ArrayName='Rigidity', InitialValue=1.0,
                              Strokes=[0, 0.25, 1.0, 8.0, 120, 0, 0.25, 1.0, 4.0, 120],
                              StrokePoints=numpy.ravel(first + second).tolist())
    for surface, x in ((painted, -1.2), (ShapeDeform(Input=painted, Boundary=saddle, RigidityArray='Rigidity'), 1.2)):
        show(surface, (x, 0, 0), array='Rigidity', preset='Viridis (matplotlib)')
    return (0.0, -1.0, 1.1), FRONT[1]


@drawing
def Morph():
    """An arm that bends by 120 degrees, at five times: above rigidly, below straight, where the forearm shrinks."""
    tube = Cylinder(Radius=0.1, Height=2.0, Resolution=32, Capping=0)
    fine = LoopSubdivision(Input=Triangulate(Input=tube), NumberofSubdivisions=4)
    # Above y = 0, the angle grows over a length of 0.3.
    angle = '%r*min(1, max(0, coordsY/0.3))' % (2.0 * math.pi / 3.0)
    radius, beyond = '(%r - coordsX)' % (0.9 / (2.0 * math.pi)), 'max(0, coordsY - 0.3)'
    bent = ('(if(coordsY < 0, coordsX, %s - %s*cos(%s) + %s*sin(%s)))*iHat + '
            '(if(coordsY < 0, coordsY, %s*sin(%s) + %s*cos(%s)))*jHat + coordsZ*kHat') % (
                0.9 / (2.0 * math.pi), radius, angle, beyond, angle, radius, angle, beyond, angle)
    arm = Calculator(Input=fine, ResultArrayName='TargetPosition', Function=bent)
    for path, y in (('Rigid', 0.0), ('Straight', -2.3)):
        for time in (0.0, 0.25, 0.5, 0.75, 1.0):
            frozen = ForceTime(Input=ShapeMorph(Input=arm, Path=path), ForcedTime=time)
            show(PassArrays(Input=frozen), (6.0 * time, y, 0), colour=PLAIN if time in (0, 1) else ACCENT)
    return (0.0, 0.0, 1.0), (0.0, 1.0, 0.0)


@drawing
def Synthesize():
    """Three samples of a bone, whose hexahedra move along: bent either way, longer, and thicker at one end."""
    ball = Clean(Input=Sphere(Radius=1.0, ThetaResolution=48, PhiResolution=48))
    bone = Calculator(Input=ball, CoordinateResults=1, Function='1.8*coordsZ*kHat + '
                      '(0.35 + 0.45*coordsZ^2)*(coordsX*iHat + coordsY*jHat)')
    atlas = Calculator(Input=bone, ResultArrayName='SourcePosition', Function='coords')
    modes = ('0.14*(coordsZ^2*iHat - 2*coordsX*coordsZ*kHat)', '0.12*coordsZ*kHat',
             '0.12*coordsZ*(coordsX*iHat + coordsY*jHat)')
    for k, mode in enumerate(modes):
        atlas = Calculator(Input=atlas, ResultArrayName='Mode%d' % k, Function=mode)
    solid = ShapeHexRemesh(Surface=bone, CellSize=0.13)
    for weights, x in (([-2, 0, 0], -1.9), ([0, 1, -2], 0.0), ([1.5, -1, 2], 1.7)):
        sample = OutputPort(ShapeSynthesize(Atlas=atlas, Data=solid, Weights=weights), 1)
        show(cut(sample, normal=(0, -1, 0)), (x, 0, 0), array='ScaledJacobian', kind='CELLS', preset='quality', limits=(0, 1), edges=True)
    return FRONT


@drawing
def MapQuality():
    a, b = figures()
    quality = ShapeMapQuality(Input=ShapeCorrespondence(SurfaceA=a, SurfaceB=b))
    show(quality, array='SymmetricDirichlet', kind='CELLS', limits=(4, 5))
    return FRONT


@drawing
def MapErrorCurve():
    a, b = shape('FigureASmall.vtp'), shape('FigureBSmall.vtp')
    chart = CreateView('XYChartView')
    SetActiveView(chart)
    chart.LegendLocation, chart.LeftAxisTitle = 'BottomRight', 'share of points'
    chart.BottomAxisTitle = 'error over the root of the area'
    chart.LeftAxisTitleFontSize = chart.BottomAxisTitleFontSize = chart.LegendFontSize = 15
    chart.LeftAxisTitleBold = chart.BottomAxisTitleBold = 0
    chart.LeftAxisLabelFontSize = chart.BottomAxisLabelFontSize = 14
    for method, colour in (('ReversibleHarmonic', INK), ('FunctionalMap', ACCENT)):
        match = ShapeCorrespondence(SurfaceA=a, SurfaceB=b, Method=method)
        shown = Show(ShapeMapErrorCurve(Input=match, Target=b, Truth=a, LargestError=0.1), chart)
        shown.UseIndexForXAxis, shown.XArrayName, shown.SeriesVisibility = 0, 'Error', ['Share']
        shown.SeriesLabel = ['Share', method]
        shown.SeriesColor = ['Share'] + [str(part) for part in colour]
        shown.SeriesLineThickness = ['Share', '3']
    return None


@drawing
def MapErrorCurveErrors():
    """Where a functional map is wrong."""
    a, b = figures()
    match = ShapeCorrespondence(SurfaceA=a, SurfaceB=b, Method='FunctionalMap')
    curve = ShapeMapErrorCurve(Input=match, Target=b, Truth=a)
    show(OutputPort(curve, 1), array='Error', preset='Viridis (matplotlib)')
    return FRONT


@drawing
def MapDifference():
    a, b = figures()
    show(ShapeMapDifference(SurfaceA=a, SurfaceB=b), array='AreaDifference', preset='Cool to Warm',
         limits=(0.5, 1.5))
    return FRONT


@drawing
def FromOperators():
    plate = Plane(XResolution=24, YResolution=24)
    roll = '0.4*sin(coordsX/0.4)*iHat + coordsY*jHat + 0.4*cos(coordsX/0.4)*kHat'
    rolled = Calculator(Input=plate, CoordinateResults=1, Function=roll)
    mapped = Calculator(Input=plate, ResultArrayName='TargetPosition', Function=roll)
    difference = ShapeMapDifference(SurfaceA=mapped, SurfaceB=rolled, Products='Triangles', OffsetDistance=0.1,
                                    NumberOfEigenpairs=100)
    show(plate, shift=(-0.65, 0, 0), edges=True)
    show(ShapeFromOperators(Input=plate, Operators=OutputPort(difference, 1)), shift=(0.65, 0, 0), edges=True,
         array='SourcePosition', part='Y', preset='Cool to Warm')
    return (0.3, -1.0, 0.6), FRONT[1]


@drawing
def Atlas():
    """The mean of ellipsoids with a horn, two standard deviations of the first two modes, and the p-values of two
    groups, with short and with long horns."""
    ball = Clean(Input=Sphere(Radius=0.5, ThetaResolution=48, PhiResolution=48))
    grown = '%g*coordsX*iHat + coordsY*%g*jHat + coordsZ*%g*kHat + %g*exp(20*(coordsX - 0.5))*iHat'
    made = [Calculator(Input=ball, CoordinateResults=1, Function=grown % (
        1 + 0.05 * math.sin(5 * a + 3 * b), 0.8, 0.8 + 0.2 * a, 0.4 + 0.25 * b)) for a in (-1, 0, 1) for b in (-1, 0, 1)]
    groups = vtkTable()
    groups.AddColumn(named([0.0, 0.0, 1.0] * 3, 'Group'))
    atlas = ShapeAtlas(Shapes=GroupDatasets(Input=made), Table=produced(groups), Groups='Group')
    show(atlas, (0, 0, 0), array='PositionDeviation', preset='Viridis (matplotlib)')
    for mode, (x, z) in enumerate(((1.5, 0), (0, 1.2))):
        for sign in (-1, 1):
            at = Calculator(Input=atlas, CoordinateResults=1, Function='coords + %d*Mode%d' % (2 * sign, mode))
            show(at, (sign * x, 0, sign * z), colour=ACCENT if mode else PLAIN)
    at = Calculator(Input=atlas, CoordinateResults=1, Function='coords')
    show(at, (1.4, 0, -1.2), array='PValue', preset='Cool to Warm', limits=(0, 0.3))
    return (0.0, -1.0, 0.0), FRONT[1]


def square_of(values, size):
    """A square of cells in the plane y = 0, each with its entry as Distance."""
    square = vtkPlaneSource()
    square.SetResolution(len(values), len(values))
    square.SetOrigin(0, 0, 0)
    square.SetPoint1(0, 0, -size)
    square.SetPoint2(size, 0, 0)
    square.Update()
    square.GetOutput().GetCellData().AddArray(named(values.ravel(), 'Distance'))
    return produced(square.GetOutput())


@drawing
def Collection():
    """Balls whose horns grow, at their coordinates, and one whose horn is elsewhere; their matrix of distances."""
    ball = Clean(Input=Sphere(Radius=0.5, ThetaResolution=48, PhiResolution=48))
    horn = 'coords*(1 + %g*exp(8*(2*%s - 1)))'
    functions = [horn % (0.2 * k, 'coordsX') for k in range(6)] + [horn % (0.6, 'coordsZ')]
    made = [Calculator(Input=ball, CoordinateResults=1, Function=each) for each in functions]
    compared = ShapeCollection(Shapes=GroupDatasets(Input=made))
    compared.UpdatePipeline()
    table = servermanager.Fetch(compared, idx=3)
    places = numpy.array([[table.GetColumnByName('Embedding%d' % k).GetTuple1(i) for k in range(2)]
                          for i in range(len(made))])
    places *= 7.0 / numpy.ptp(places, axis=0).max()
    for number, (each, (x, z)) in enumerate(zip(made, places)):
        show(each, (x, 0, z), colour=ACCENT if table.GetColumnByName('Rank').GetValue(number) == 0 else PLAIN)
    distances = servermanager.Fetch(compared, idx=2)
    leaves = numpy.argsort([table.GetColumnByName('Leaf').GetValue(i) for i in range(len(made))])
    values = numpy.array([[distances.GetColumn(int(j)).GetValue(int(i)) for j in leaves] for i in leaves])
    show(square_of(values, 2.2), (0.2, 0, 3.0), array='Distance', kind='CELLS')
    return (0.0, -1.0, 0.0), FRONT[1]


def symmetry(surface, x, name):
    """The surface at x in the colours of its copies, under that name. Returns the filter."""
    found = ShapeSymmetry(Input=surface)
    part = Calculator(Input=found, AttributeType='Cell Data', Function='Copy', ResultArrayName=name)
    part = PassArrays(Input=part, CellDataArrays=[name], PointDataArrays=['Normals'])
    show(part, (x, 0, 0), array=name, kind='CELLS', preset='Viridis (matplotlib)')
    return found


def symmetry_of_star(x):
    """A star of five arms with the curves that reflections keep."""
    ball = Clean(Input=Sphere(Radius=0.42, ThetaResolution=72, PhiResolution=72))
    wave = '(1 + 0.45*cos(5*atan(coordsX/coordsZ) + 5*3.14159265*(coordsZ < 0))*((coordsX^2 + coordsZ^2)/0.1764)^2)'
    star = Calculator(Input=ball, CoordinateResults=1,
                      Function='coordsX*%s*iHat + 0.4*coordsY*jHat + (coordsZ*%s + 0.5)*kHat' % (wave, wave))
    found = symmetry(star, x, 'CopyOfStar')
    show(Tube(Input=OutputPort(found, 1), Radius=0.02), (x, 0, 0), colour=ACCENT)
    return FRONT


@drawing
def Symmetry():
    symmetry(shape('FigureB.vtp'), -0.75, 'CopyOfFigure')
    return symmetry_of_star(0.75)


@drawing
def GeodesicDistance():
    surface = shape('FigureA.vtp')
    seed = PointSource(Center=[0.508, 0.017, 0.792], NumberOfPoints=1, Radius=0.0)
    distance = ShapeGeodesicDistance(Input=surface, Seeds=seed)
    show(distance, array='GeodesicDistance', preset='Viridis (matplotlib)', discrete=16)
    return FRONT


@drawing
def Skeleton():
    surface = shape('FigureA.vtp')
    skeleton = ShapeSkeleton(Input=surface)
    show(Tube(Input=ExtractSurface(Input=skeleton), Radius=0.012), array='Radius', preset='Viridis (matplotlib)')
    show(surface, opacity=0.25)
    return FRONT


@drawing
def SkeletonMatched():
    """Left: without features; right: with the skeleton as a feature."""
    a, b = figures()
    bones = ShapeSkeleton(Input=a, Target=b, Ambiguous='First')
    wanted = Tube(Input=ExtractSurface(Input=ShapeSkeleton(Input=b)), Radius=0.008)
    points = MaskPoints(Input=bones, OnRatio=1, MaximumNumberofPoints=100000, GenerateVertices=1,
                        SingleVertexPerCell=1)
    ends = Threshold(Input=points, Scalars=['POINTS', 'Degree'], LowerThreshold=1, UpperThreshold=1)
    match = ShapeCorrespondence(SurfaceA=a, SurfaceB=b, Landmarks=ExtractSurface(Input=ends),
                                Method='ReversibleHarmonic')
    for shift, features in ((-0.75, []), (0.75, [bones])):
        mapped = ShapeHarmonicVolumeMap(Domain=bones, Boundary=match, MapArray='TargetPosition',
                                        Features=features)
        show(place(wanted, (shift, 0, 0)), colour=[0.2, 0.65, 0.3])
        show(Glyph(Input=mapped, GlyphType='Sphere', GlyphMode='All Points', ScaleFactor=0.026,
                   ScaleArray=['POINTS', 'No scale array']), (shift, 0, 0), [0.85, 0.15, 0.12])
        show(place(b, (shift, 0, 0)), opacity=0.2)
    return FRONT


@drawing
def BoundaryDistance():
    surface = shape('FigureA.vtp')
    grid = Plane(Origin=[-0.7, 0.02, -0.1], Point1=[0.7, 0.02, -0.1], Point2=[-0.7, 0.02, 1.2],
                 XResolution=280, YResolution=260)
    distance = ShapeBoundaryDistance(Input=grid, Surface=surface)
    shown = show(distance, array='BoundaryDistance', preset='Cool to Warm', limits=(-0.12, 0.12), discrete=24)
    shown.Ambient, shown.Diffuse = 1.0, 0.0
    return (0, -1, 0), (0, 0, 1)


@drawing
def AbaqusWriter():
    solid = ShapeHexRemesh(Surface=shape('BentBar.vtp'), CellsOnLongestSide=16)
    show(OutputPort(solid, 1), array='Patch', kind='CELLS', preset='Turbo', limits=(0, 5), discrete=6,
         edges=True)
    return (0.5, 0.6, 1.0), (0, 1, 0)


@drawing
def DeckReader():
    """The mesh of a deck, and the same deck moved."""
    path = os.path.join(tempfile.mkdtemp(), 'bar.inp')
    SaveData(path, ShapeHexRemesh(Surface=shape('BentBar.vtp'), CellsOnLongestSide=16))
    deck = ShapeDeckReader(FileNames=[path])
    deck.UpdatePipeline()
    low, high = (numpy.array(deck.GetDataInformation().GetBounds())[k::2] for k in (0, 1))
    size = (high - low).max()
    wave = 'coords + %g*sin(6*(coordsX - %g)/%g)*kHat' % (0.12 * size, low[0], size)
    show(deck, (0, 0.4 * size, 0), edges=True)
    show(Calculator(Input=deck, CoordinateResults=1, Function=wave), (0, -0.4 * size, 0), array='NodeId', edges=True)
    return (0.5, 0.6, 1.0), (0, 1, 0)


@drawing
def MeditWriter():
    solid = ShapeTetrahedralize(Input=shape('PhantomHeadSmall.vtp'), InnerSurfaces=[
        shape('PhantomBrainSmall.vtp')], PreserveBoundary=0)
    show(cut(solid, (0, 0, 0), (0, -1, 0)), array='RegionId', kind='CELLS', preset='Cool to Warm', edges=True)
    return (0.2, -1.0, 0.3), (0, 0, 1)


@drawing
def Landmarks():
    a, b = figures()
    ends = [0.0, 0.0, 1.12, 0.51, 0.0, 0.8, -0.51, 0.0, 0.8]
    pairs = ShapeLandmarks(SurfaceA=place(a, (-0.62, 0, 0)), SurfaceB=place(b, (0.62, 0, 0)), MaximumDistance=1.0)
    bodies = [servermanager.Fetch(source) for source in (a, b)]
    near = [bodies[0].FindPoint(ends[i:i + 3]) for i in range(0, len(ends), 3)]
    for body, name, x in zip(bodies, ('PointsA', 'PointsB'), (-0.62, 0.62)):
        positions = [body.GetPoint(point) for point in near]
        setattr(pairs, name, [value for p in positions for value in (p[0] + x, p[1], p[2])])
    show(a, (-0.62, 0, 0))
    show(b, (0.62, 0, 0))
    for port in (0, 1):
        show(Glyph(Input=OutputPort(pairs, port), GlyphType='Sphere', ScaleFactor=0.05, ScaleArray=[
            'POINTS', 'No scale array'], GlyphMode='All Points'), colour=ACCENT)
    show(OutputPort(pairs, 2), colour=ACCENT).LineWidth = 3.0
    return FRONT


@drawing
def Example():
    for name, x, turn in (('Figure', -1.8, (0, 0, 0)), ('Two-Holed Torus', -0.6, (70, 0, 0)),
                          ('Twisted Bar', 0.6, (60, 60, 0)), ('Bunny', 1.8, (90, 0, 0))):
        source = ShapeExample(Shape=name)
        source.UpdatePipeline()
        size = source.GetDataInformation().GetBounds()
        middle = Transform(Input=source)
        middle.Transform.Translate = [-0.5 * (size[k] + size[k + 1]) for k in (0, 2, 4)]
        shown = show(middle, (x, 0, 0), colour=[0.55, 0.74, 0.80])
        shown.Scale = [1.0 / max(size[k + 1] - size[k] for k in (0, 2, 4))] * 3
        shown.Orientation = list(turn)
    return FRONT


@drawing
def OFFReader():
    show(OpenDataFile(os.path.join(ROOT, 'build', 'models', 'bunny00.off')), colour=[0.55, 0.74, 0.80])
    return (0.3, 0.3, 1.0), (0, 1, 0)


@drawing
def CADReader():
    """A bracket that Gmsh's OpenCASCADE models: its faces and edges."""
    folder = tempfile.mkdtemp()
    script, step = os.path.join(folder, 'bracket.geo'), os.path.join(folder, 'bracket.step')
    with open(script, 'w') as file:  # Gmsh skips a last line that does not end
        file.write('SetFactory("OpenCASCADE");'
                   'Box(1) = {-3, -2, 0, 6, 4, 1}; Cylinder(2) = {0, 0, 1, 0, 0, 2, 1.4};'
                   'BooleanUnion(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };'
                   'Cylinder(4) = {0, 0, -1, 0, 0, 5, 0.8}; Cylinder(5) = {-2.2, -1.2, -1, 0, 0, 5, 0.4};'
                   'Cylinder(6) = {2.2, 1.2, -1, 0, 0, 5, 0.4}; Sphere(7) = {2.2, -1.2, 1, 0.5};'
                   'BooleanDifference{ Volume{3}; Delete; }{ Volume{4:7}; Delete; }\n')
    subprocess.run(['gmsh', script, '-0', '-o', step], check=True, stdout=subprocess.DEVNULL)
    bracket = ShapeCADReader(FileName=step)
    show(bracket, array='Patch', kind='CELLS', preset='Turbo')
    lines = show(OutputPort(bracket, 1), colour=INK)
    lines.LineWidth = 5
    return (0.5, -1.0, 0.9), (0, 0, 1)


@drawing
def HTMLWriter():
    """The page in Chromium."""
    solid = ShapeHexRemesh(Surface=shape('BentBar.vtp'), CellsOnLongestSide=16)
    folder = tempfile.mkdtemp()
    page, picture = os.path.join(folder, 'bar.html'), os.path.join(folder, 'page.png')
    SaveData(page, solid, Title='A bent bar')
    subprocess.run(['chromium', '--headless', '--no-sandbox', '--use-angle=swiftshader',
                    '--enable-unsafe-swiftshader', '--user-data-dir=' + os.path.join(folder, 'profile'),
                    '--window-size=1000,680', '--virtual-time-budget=20000', '--screenshot=' + picture,
                    'file://%s#axis=-Z&cut=0.4&color=ScaledJacobian' % page],
                   check=True, stderr=subprocess.DEVNULL, timeout=180)
    return picture


@drawing
def HexRemeshCells():
    """Cells On Longest Side 10 and 24."""
    for number, x in ((10, -0.62), (24, 0.62)):
        solid = ShapeHexRemesh(Surface=shape('FigureA.vtp'), Method='Grid', CellsOnLongestSide=number)
        show(OutputPort(solid, 1), (x, 0, 0), colour=[0.55, 0.74, 0.80], edges=True)
    return FRONT


@drawing
def ParameterizeAreaWeight():
    """Area Weight 0 and 1: the image of a figure."""
    for weight, x in ((0.0, -1.1), (1.0, 1.1)):
        sphere = ShapeParameterize(Input=shape('FigureA.vtp'), AreaWeight=weight)
        show(checkered(OutputPort(sphere, 1), 'SourcePosition', 0.06), (x, 0, 0), array='Checker',
             preset='Cool to Warm')
    return FRONT


@drawing
def ExponentialMapPoints():
    """The points of a bumpy surface, and a patch of them on it and in the plane."""
    surface = shape('DentedSphere10k.vtp')
    alone = Calculator(Input=MaskPoints(Input=surface, OnRatio=1, MaximumNumberofPoints=1000000,
                                        GenerateVertices=1, SingleVertexPerCell=1),
                       ResultArrayName='Samples', Function='1')
    patch = ShapeExponentialMap(Input=alone, Seed=[0.3, 0.2, 1.0], Radius=0.7)
    checker = checkered(Calculator(Input=patch, ResultArrayName='Position',
                                   Function='TargetPosition+0.07*kHat'), 'Position', 0.14, 'XY')
    flat = Calculator(Input=checker, CoordinateResults=1, Function='TargetPosition')
    show(alone, (-0.9, 0, 0)).PointSize = 3
    lifted = Calculator(Input=checker, CoordinateResults=1, Function='coords*1.02')
    show(lifted, (-0.9, 0, 0), array='Checker', preset='Cool to Warm').PointSize = 7
    show(flat, (1.0, 0, 0), array='Checker', preset='Cool to Warm').PointSize = 7
    return (0.0, 0.1, 1.0), (0, 1, 0)


def horned_points():
    """The points of a ball with a horn, cut: the horn, and the rest with the hole filled."""
    even = Calculator(Input=Subdivide(Input=Triangulate(Input=Clean(Input=Box())), NumberofSubdivisions=5),
                      CoordinateResults=1, Function='0.5*norm(coords)')
    bumped = Calculator(
        Input=even, CoordinateResults=1,
        Function='coords*(1 + 0.7*max(0, 1 - ((coordsX-0.5)^2 + coordsY^2 + coordsZ^2)/0.08)^2)')
    loop = [part for k in range(40) for part in (
        0.41, 0.28 * math.cos(math.pi * k / 20), 0.28 * math.sin(math.pi * k / 20))]
    return ShapeCutFeature(Input=points_of(bumped), LoopPoints=loop)


def points_of(surface):
    """The points alone, without normals."""
    points = MaskPoints(Input=surface, OnRatio=1, MaximumNumberofPoints=1000000, GenerateVertices=1,
                        SingleVertexPerCell=1)
    return PassArrays(Input=Calculator(Input=points, ResultArrayName='Samples', Function='1'),
                      PointDataArrays=['Samples'])


@drawing
def CutFeaturePoints():
    """Points without their horn, with the points of the fill, and the horn."""
    cut_points = horned_points()
    core = Sphere(Radius=0.48, ThetaResolution=60, PhiResolution=60)
    show(core, colour=[0.95, 0.95, 0.95])
    show(OutputPort(cut_points, 0), (0.6, 0, 0), colour=ACCENT).PointSize = 4
    show(OutputPort(cut_points, 1), array='Filled', kind='CELLS', preset='Cool to Warm').PointSize = 4
    return (0.7, 0.4, 1.0), (0, 1, 0)


@drawing
def PasteFeaturePoints():
    """The horn's points on a planet of points, with the points that were added at the seam."""
    planet = Calculator(Input=Subdivide(Input=Triangulate(Input=Clean(Input=Box())), NumberofSubdivisions=6),
                        CoordinateResults=1, Function='0.9*norm(coords)')
    pasted = ShapePasteFeature(Feature=horned_points(), Target=points_of(planet), Seed=[0.4, 1.0, 0.7], Rotation=30.0)
    show(Sphere(Radius=0.87, ThetaResolution=60, PhiResolution=60), colour=[0.95, 0.95, 0.95])
    show(pasted, array='Part', kind='CELLS', preset='Cool to Warm').PointSize = 4
    return (-0.7, 0.5, 0.9), (0, 1, 0)


@drawing
def StructuredBlocksSurface():
    """How far the splines are off, without and with Surface, on one logarithmic scale."""
    surface = shape('TwistedBar.vtp')
    solid = ShapeHexRemesh(Surface=surface, Method='Polycube', CellsOnLongestSide=24)
    for given, x in (({}, -2.4), ({'Surface': surface}, 2.4)):
        blocks = ShapeStructuredBlocks(Input=OutputPort(solid, 2), NodesPerControl=4.0, **given)
        error = Calculator(Input=MergeBlocks(Input=OutputPort(blocks, 0)), ResultArrayName='LogError',
                           Function='log10(SplineError + 1e-7)')
        show(error, (x, 0, 0), array='LogError', limits=(-5.0, -2.0), edges=True)
    return (0.5, 0.6, 1.0), (0, 1, 0)


def hood():
    """Six panels with slots between them."""
    panels = [Plane(Origin=[1.02 * i - 1.5, 1.02 * j - 1.0, 0], Point1=[1.02 * i - 0.5, 1.02 * j - 1.0, 0],
                    Point2=[1.02 * i - 1.5, 1.02 * j, 0], XResolution=10, YResolution=10)
              for i in range(3) for j in range(2)]
    return Calculator(Input=AppendGeometry(Input=panels), CoordinateResults=1,
                      Function='coords + (0.5 - 0.1*coordsX^2 - 0.2*coordsY^2)*kHat')


@drawing
def CutFeatureGaps():
    """A bump across the slots between the panels, and the panels with the hole filled."""
    bumped = Calculator(Input=hood(), CoordinateResults=1,
                        Function='coords + 0.6*max(0, 1 - ((coordsX-0.52)^2 + coordsY^2)/0.4)^2*kHat')
    loop = [part for k in range(40) for part in (
        0.52 + 0.7 * math.cos(math.pi * k / 20), 0.7 * math.sin(math.pi * k / 20), 0.4)]
    feature = ShapeCutFeature(Input=bumped, LoopPoints=loop)
    show(OutputPort(feature, 0), (0, 0, 0.7), colour=ACCENT, edges=True)
    show(OutputPort(feature, 1), array='Filled', kind='CELLS', preset='Cool to Warm', edges=True)
    return (0.3, -1.0, 0.9), (0, 0, 1)


@drawing
def PasteFeatureSoup():
    """A horn across the slots between six panels."""
    pasted = ShapePasteFeature(Feature=horned(), Target=hood(), Seed=[0.52, 0.0, 0.4], BridgeGaps=1)
    show(pasted, array='Part', kind='CELLS', preset='Cool to Warm', edges=True)
    return (0.3, -1.0, 0.9), (0, 0, 1)


@drawing
def PasteFeatureLoops():
    """The handle of a cup is cut off along two loops, and pasted on a planet."""
    ball = '(sqrt(coordsX^2+coordsY^2+coordsZ^2)/20-1)'
    ring = '(sqrt((sqrt((coordsX-20)^2+coordsZ^2)-12)^2+coordsY^2)/20-0.17)'
    values = Calculator(Input=Wavelet(WholeExtent=[-24, 38, -24, 24, -24, 24]), ResultArrayName='Cup',
                        Function='ln(exp(-20*%s)+exp(-20*%s))' % (ball, ring))
    contour = Contour(Input=values, ContourBy=['POINTS', 'Cup'], Isosurfaces=[0.0])
    cup = Calculator(Input=contour, CoordinateResults=1, Function='coords/20')
    feet = []
    for side in (1.0, -1.0):
        axis, across = (0.82, 0.0, 0.572 * side), (0.572 * side, 0.0, -0.82)
        turns = [2 * math.pi * k / 40 for k in range(40)]
        feet.append(PolyLineSource(Closed=1, Points=[
            value for t in turns for value in (
                0.936 * axis[0] + 0.352 * math.cos(t) * across[0], 0.352 * math.sin(t),
                0.936 * axis[2] + 0.352 * math.cos(t) * across[2])]))
    handle = ShapeCutFeature(Input=cup, Loop=AppendGeometry(Input=feet))
    planet = Sphere(ThetaResolution=90, PhiResolution=90, Radius=1.4)
    pasted = ShapePasteFeature(Feature=handle, Target=planet, Seed=[-0.6, -1.0, 0.9], Rotation=30.0, Loops='All')
    show(OutputPort(handle, 0), (-2.6, 0, 0), colour=ACCENT)
    show(OutputPort(handle, 1), (-2.9, 0, 0))
    show(pasted, (1.2, 0, 0), array='Part', kind='CELLS', preset='Cool to Warm')
    return (0.0, -1.0, 0.5), (0, 0, 1)


@drawing
def CutFeatureCreases():
    """The loop through five clicks around a bump: shortest paths, and paths along the crease."""
    ball = Sphere(ThetaResolution=160, PhiResolution=160)
    clicks = []
    for k in range(5):
        around, away = 2 * math.pi * (k + 0.3) / 5, math.radians(28.4 + (5 if k % 2 else -5))
        side = math.sin(away)
        click = 0.5 * numpy.array([math.cos(away), side * math.cos(around), side * math.sin(around)])
        clicks.append(click * (1 + 8 * max(0, 0.06 - sum((click - [0.5, 0, 0]) ** 2))))
    for weight, y in ((0.0, -0.6), (10.0, 0.6)):
        bumped = Calculator(Input=ball, CoordinateResults=1,
                            Function='coords*(1 + 8*max(0, 0.06 - (coordsX-0.5)^2 - coordsY^2 - coordsZ^2))')
        show(bumped, (0, y, 0))
        feature = ShapeCutFeature(Input=bumped, LoopPoints=numpy.ravel(clicks).tolist(), CreaseWeight=weight,
                                  FillHole=0)
        loop = FeatureEdges(Input=feature, FeatureEdges=0, NonManifoldEdges=0, ManifoldEdges=0)
        show(Tube(Input=loop, Radius=0.006), (0, y, 0), colour=ACCENT)
        for click in clicks:
            show(Sphere(Center=click.tolist(), Radius=0.02), (0, y, 0), colour=ACCENT)
    return (1.0, 0.0, 0.25), (0, 0, 1)


@drawing
def DeformRigidity():
    """Rigidity 0.5, 1 and 3: the boundary of a square with a bump is bent."""
    plane = Plane(Origin=[-1, -1, 0], Point1=[1, -1, 0], Point2=[-1, 1, 0], XResolution=50, YResolution=50)
    bump = Calculator(Input=plane, CoordinateResults=1,
                      Function='coords + 0.5*exp(-12*(coordsX^2 + coordsY^2))*kHat')
    border = FeatureEdges(Input=bump, BoundaryEdges=1, FeatureEdges=0, NonManifoldEdges=0, ManifoldEdges=0)
    handle = Calculator(Input=border, ResultArrayName='SourcePosition', Function='coords')
    saddle = Calculator(Input=handle, CoordinateResults=1,
                        Function='coords + 0.4*(coordsX^2 - coordsY^2)*kHat')
    for rigidity, x in ((0.5, -2.4), (1.0, 0.0), (3.0, 2.4)):
        show(ShapeDeform(Input=bump, Boundary=saddle, Rigidity=rigidity), (x, 0, 0))
    return (0.3, -1.0, 0.5), (0, 0, 1)


@drawing
def DeformFrames():
    """A frame at one corner of a square is rotated, and those at the two corners beside it hold."""
    plane = Plane(Origin=[-1, -1, 0], Point1=[1, -1, 0], Point2=[-1, 1, 0], XResolution=50, YResolution=50)
    bump = Calculator(Input=plane, CoordinateResults=1,
                      Function='coords + 0.5*exp(-12*(coordsX^2 + coordsY^2))*kHat')
    peeled = ShapeDeform(Input=bump, FrameRotations=[
        1, -1, 0, 64, 64, 0, 1, 1, 0, 0, 0, 0, -1, -1, 0, 0, 0, 0])
    normals = Glyph(Input=peeled[1], GlyphType='Arrow', OrientationArray=['POINTS', 'TargetNormal'],
                    ScaleArray=['POINTS', 'No scale array'], ScaleFactor=0.25, GlyphMode='Every Nth Point', Stride=5)
    for surface, x in ((bump, -1.5), (peeled, 1.5)):
        show(surface, (x, 0, 0), edges=True)
    show(peeled[1], (1.5, 0, 0), colour=ACCENT).LineWidth = 5.0
    show(normals, (1.5, 0, 0), colour=ACCENT).LineWidth = 3.0
    return (0.3, -1.0, 0.7), (0, 0, 1)


@drawing
def FillHolesEdgeGrowth():
    """Edge Growth 0 and 0.5: the fill of half a sphere."""
    dome = Clean(Input=Sphere(ThetaResolution=50, PhiResolution=50, EndPhi=90.0))
    for growth, x in ((0.0, -0.6), (0.5, 0.6)):
        show(ShapeFillHoles(Input=dome, EdgeGrowth=growth), (x, 0, 0), array='Filled', kind='CELLS',
             preset='Cool to Warm', edges=True)
    return (0.1, -0.6, -1.0), (0, 0, 1)


def open_view(size):
    view = CreateRenderView(ViewSize=size, OrientationAxesVisibility=0, UseColorPaletteForBackground=0,
                            Background=[1, 1, 1], CameraParallelProjection=1)
    SetActiveView(view)
    return view


def compose(function, view):
    """Adds what a drawing shows to the empty active view. Returns the view, the chart that is drawn instead, or the path
    of a picture that another program made."""
    made = function()
    if isinstance(made, str):
        return made
    if made:
        # The camera's position and upward direction.
        view.CameraFocalPoint, view.CameraPosition, view.CameraViewUp = [0, 0, 0], made[0], made[1]
        ResetCamera(view)
        view.GetActiveCamera().Zoom(1.25)
    return GetActiveView()


def draw(name):
    size = [1120, 760]
    path = os.path.join(FOLDER, name + '.png')
    made = compose(drawings[name], open_view(size))
    if isinstance(made, str):
        shutil.copy(made, path)
    else:
        SaveScreenshot(path, made, ImageResolution=size)
    subprocess.check_call(['convert', path, '-trim', '+repage', '-bordercolor', 'white', '-border', '12',
                           '-resize', '560x380', '-colors', '96', '-strip', '-define',
                           'png:compression-level=9', path])
    print(name, os.path.getsize(path), flush=True)


if __name__ == '__main__':
    os.makedirs(FOLDER, exist_ok=True)
    for chosen in sys.argv[1:] or sorted(drawings):
        try:
            draw(chosen)
        except Exception as error:
            print(chosen, 'FAILED', error, flush=True)
        ResetSession()
