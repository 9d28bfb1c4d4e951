# state file generated using paraview version 5.11.0
import paraview
paraview.compatibility.major = 5
paraview.compatibility.minor = 11

#### import the simple module from the paraview
from paraview.simple import *
#### disable automatic camera reset on 'Show'
paraview.simple._DisableFirstRenderCameraReset()

# ----------------------------------------------------------------
# setup views used in the visualization
# ----------------------------------------------------------------

# Create a new 'Render View'
hexahedra = CreateView('RenderView')
hexahedra.AxesGrid = 'GridAxes3DActor'
hexahedra.StereoType = 0
hexahedra.CameraFocalDisk = 1.0

# Create a new 'Render View'
image = CreateView('RenderView')
image.AxesGrid = 'GridAxes3DActor'
image.StereoType = 0
image.CameraFocalDisk = 1.0

SetActiveView(None)

# ----------------------------------------------------------------
# restore active view
SetActiveView(image)
# ----------------------------------------------------------------

# ----------------------------------------------------------------
# setup the data processing pipelines
# ----------------------------------------------------------------

# create a new 'XML Unstructured Grid Reader'
cubeSmallvtu = XMLUnstructuredGridReader(registrationName='CubeSmall.vtu', FileName=['CubeSmall.vtu'])

# create a new 'XML PolyData Reader'
dentedSphere600vtp = XMLPolyDataReader(registrationName='DentedSphere600.vtp', FileName=['DentedSphere600.vtp'])
dentedSphere600vtp.PointArrayStatus = ['TargetPosition']

# create a new 'Shape Parameterize'
sphere = ShapeParameterize(registrationName='Sphere', Input=dentedSphere600vtp,
    Landmarks=None)

# create a new 'XML Unstructured Grid Reader'
ballSmallvtu = XMLUnstructuredGridReader(registrationName='BallSmall.vtu', FileName=['BallSmall.vtu'])

# create a new 'Shape Cut Feature'
cut = ShapeCutFeature(registrationName='Cut', Input=dentedSphere600vtp,
    Loop=None,
    Selection=None)
cut.LoopPoints = [0.4, 0.0, 0.9, 0.0, 0.4, 0.9, -0.4, 0.0, 0.9, 0.0, -0.4, 0.9]
cut.FillHole = 0

# create a new 'XML PolyData Reader'
bentBarSmallvtp = XMLPolyDataReader(registrationName='BentBarSmall.vtp', FileName=['BentBarSmall.vtp'])
bentBarSmallvtp.PointArrayStatus = ['TargetPosition']

# create a new 'Shape Boundary Distance'
distance = ShapeBoundaryDistance(registrationName='Distance', Input=ballSmallvtu,
    Surface=dentedSphere600vtp)
distance.Signed = 0

# create a new 'Line'
seeds = Line(registrationName='Seeds')
seeds.Point1 = [0.0, 0.0, 1.0]
seeds.Point2 = [1.0, 0.0, 0.0]
seeds.Resolution = 1

# create a new 'Shape Geodesic Distance'
geodesic = ShapeGeodesicDistance(registrationName='Geodesic', Input=dentedSphere600vtp,
    Seeds=seeds)
geodesic.Method = 'Exact'

# create a new 'XML Unstructured Grid Reader'
bentBarSmallvtu = XMLUnstructuredGridReader(registrationName='BentBarSmall.vtu', FileName=['BentBarSmall.vtu'])
bentBarSmallvtu.PointArrayStatus = ['TargetPosition']

# create a new 'Shape Laplace Spectrum'
spectrum = ShapeLaplaceSpectrum(registrationName='Spectrum', Input=dentedSphere600vtp)
spectrum.NumberOfEigenpairs = 9
spectrum.Embedding = 'MDS'

# create a new 'Shape Polycube'
polycube = ShapePolycube(registrationName='Polycube', Input=bentBarSmallvtp)
polycube.TargetEdgeLength = 0.5

# find source
polycube_1 = FindSource('Polycube')

# create a new 'Shape Hex Remesh'
polycubeHexahedra = ShapeHexRemesh(registrationName='PolycubeHexahedra', Surface=bentBarSmallvtp,
    Polycube=OutputPort(polycube_1,1),
    InnerSurfaces=None)
polycubeHexahedra.Method = 'Polycube'

# create a new 'XML PolyData Reader'
figureASmallvtp = XMLPolyDataReader(registrationName='FigureASmall.vtp', FileName=['FigureASmall.vtp'])
figureASmallvtp.PointArrayStatus = ['TargetPosition']

# create a new 'Shape Morph'
between = ShapeMorph(registrationName='Between', Input=figureASmallvtp)

# create a new 'Mask Points'
everyPoint = MaskPoints(registrationName='EveryPoint', Input=figureASmallvtp)
everyPoint.OnRatio = 200
everyPoint.GenerateVertices = 1

# create a new 'XML PolyData Reader'
phantomHeadSmallvtp = XMLPolyDataReader(registrationName='PhantomHeadSmall.vtp', FileName=['PhantomHeadSmall.vtp'])
phantomHeadSmallvtp.PointArrayStatus = ['TargetPosition']

# find source
cut_1 = FindSource('Cut')

# create a new 'Shape Fill Holes'
closed = ShapeFillHoles(registrationName='Closed', Input=OutputPort(cut_1,1))
closed.FillMethod = 'Fair'

# create a new 'XML PolyData Reader'
phantomSkullSmallvtp = XMLPolyDataReader(registrationName='PhantomSkullSmall.vtp', FileName=['PhantomSkullSmall.vtp'])
phantomSkullSmallvtp.PointArrayStatus = ['TargetPosition']

# create a new 'XML PolyData Reader'
figureBSmallvtp = XMLPolyDataReader(registrationName='FigureBSmall.vtp', FileName=['FigureBSmall.vtp'])
figureBSmallvtp.PointArrayStatus = ['SourcePosition']

# create a new 'Elevation'
height = Elevation(registrationName='Height', Input=figureBSmallvtp)
height.LowPoint = [1.0, 1.0, 1.0]
height.HighPoint = [-1.0, -1.0, -1.0]

# create a new 'Shape Transfer Fields'
transferred = ShapeTransferFields(registrationName='Transferred', Input=figureASmallvtp,
    Source=height)

# create a new 'Shape Map Difference'
difference = ShapeMapDifference(registrationName='Difference', SurfaceA=figureASmallvtp,
    SurfaceB=figureBSmallvtp)
difference.NumberOfEigenpairs = 12

# create a new 'Shape Deform'
deformed = ShapeDeform(registrationName='Deformed', Input=figureASmallvtp,
    Boundary=figureBSmallvtp)
deformed.Rigidity = 0.5

# create a new 'Shape Exponential Map'
patch = ShapeExponentialMap(registrationName='Patch', Input=dentedSphere600vtp)
patch.Seed = [0.0, 0.0, 1.0]
patch.Radius = 0.5

# create a new 'Shape Hex Remesh'
gridHexahedra = ShapeHexRemesh(registrationName='GridHexahedra', Surface=dentedSphere600vtp,
    Polycube=None,
    InnerSurfaces=None)
gridHexahedra.Method = 'Grid'
gridHexahedra.CellsOnLongestSide = 6

# find source
gridHexahedra_1 = FindSource('GridHexahedra')

# create a new 'Calculator'
quads = Calculator(registrationName='Quads', Input=OutputPort(gridHexahedra_1,1))
quads.Function = 'coordsX'

# create a new 'XML Unstructured Grid Reader'
twistedBarSmallvtu = XMLUnstructuredGridReader(registrationName='TwistedBarSmall.vtu', FileName=['TwistedBarSmall.vtu'])
twistedBarSmallvtu.PointArrayStatus = ['TargetPosition']

# create a new 'Shape Untangle'
untangled = ShapeUntangle(registrationName='Untangled', Input=twistedBarSmallvtu,
    RestShape=bentBarSmallvtu)
untangled.FixBoundary = 0
untangled.MaximumIterations = 7

# create a new 'XML PolyData Reader'
phantomBrainSmallvtp = XMLPolyDataReader(registrationName='PhantomBrainSmall.vtp', FileName=['PhantomBrainSmall.vtp'])
phantomBrainSmallvtp.PointArrayStatus = ['TargetPosition']

# create a new 'Shape Tetrahedralize'
tetrahedra = ShapeTetrahedralize(registrationName='Tetrahedra', Input=phantomHeadSmallvtp,
    InnerSurfaces=[phantomSkullSmallvtp, phantomBrainSmallvtp])
tetrahedra.MaximumVolume = 0.01

# create a new 'Shape Paste Feature'
pasted = ShapePasteFeature(registrationName='Pasted', Feature=cut,
    Target=phantomHeadSmallvtp)
pasted.Seed = [1.0, 0.0, 0.0]
pasted.Rotation = 30.0
pasted.Scale = 0.6

# find source
sphere_1 = FindSource('Sphere')

# create a new 'Shape Harmonic Volume Map'
solidMap = ShapeHarmonicVolumeMap(registrationName='SolidMap', Domain=ballSmallvtu,
    Boundary=OutputPort(sphere_1,1),
    Features=None,
    TargetFeatures=None,
    Target=None)
solidMap.MapArray = 'SourcePosition'
solidMap.Method = 'SingleShot'

# create a new 'Clip'
half = Clip(registrationName='Half', Input=gridHexahedra)
half.ClipType = 'Plane'
half.HyperTreeGridClipper = 'Plane'
half.Scalars = [None, '']

# create a new 'Shape Harmonic Volume Map'
layers = ShapeHarmonicVolumeMap(registrationName='Layers', Domain=cubeSmallvtu,
    Boundary=phantomHeadSmallvtp,
    Features=[phantomSkullSmallvtp, phantomBrainSmallvtp],
    TargetFeatures=None,
    Target=None)
layers.MaximumLevels = 3

# find source
layers_1 = FindSource('Layers')

# create a new 'Shape Apply Volume Map'
applied = ShapeApplyVolumeMap(registrationName='Applied', Input=phantomBrainSmallvtp,
    Map=OutputPort(layers_1,1))

# create a new 'Clean to Grid'
landmarks = CleantoGrid(registrationName='Landmarks', Input=everyPoint)

# create a new 'Shape Correspondence'
match = ShapeCorrespondence(registrationName='Match', SurfaceA=figureASmallvtp,
    SurfaceB=figureBSmallvtp,
    Landmarks=landmarks)
match.Method = 'CommonSphere'
match.CoarsePoints = 500

# create a new 'Shape Map Error Curve'
errors = ShapeMapErrorCurve(registrationName='Errors', Input=match,
    Target=figureBSmallvtp,
    Truth=figureASmallvtp)
errors.Normalisation = 'GeodesicDiameter'

# create a new 'Shape Map Quality'
quality = ShapeMapQuality(registrationName='Quality', Input=match)

# ----------------------------------------------------------------
# setup the visualization in view 'hexahedra'
# ----------------------------------------------------------------

# show data from half
halfDisplay = Show(half, hexahedra, 'UnstructuredGridRepresentation')

# get 2D transfer function for 'ScaledJacobian'
scaledJacobianTF2D = GetTransferFunction2D('ScaledJacobian')

# get color transfer function/color map for 'ScaledJacobian'
scaledJacobianLUT = GetColorTransferFunction('ScaledJacobian')
scaledJacobianLUT.TransferFunction2D = scaledJacobianTF2D
scaledJacobianLUT.RGBPoints = [0.6724738923613838, 0.231373, 0.298039, 0.752941, 0.8016672534435343, 0.865003, 0.865003, 0.865003, 0.9308606145256849, 0.705882, 0.0156863, 0.14902]
scaledJacobianLUT.ScalarRangeInitialized = 1.0

# get opacity transfer function/opacity map for 'ScaledJacobian'
scaledJacobianPWF = GetOpacityTransferFunction('ScaledJacobian')
scaledJacobianPWF.Points = [0.6724738923613838, 0.0, 0.5, 0.0, 0.9308606145256849, 1.0, 0.5, 0.0]
scaledJacobianPWF.ScalarRangeInitialized = 1

# trace defaults for the display properties.
halfDisplay.Representation = 'Surface'
halfDisplay.ColorArrayName = ['CELLS', 'ScaledJacobian']
halfDisplay.LookupTable = scaledJacobianLUT
halfDisplay.SelectTCoordArray = 'None'
halfDisplay.SelectNormalArray = 'None'
halfDisplay.SelectTangentArray = 'None'
halfDisplay.OSPRayScaleFunction = 'PiecewiseFunction'
halfDisplay.SelectOrientationVectors = 'None'
halfDisplay.ScaleFactor = 0.20475899194331118
halfDisplay.SelectScaleArray = 'None'
halfDisplay.GlyphType = 'Arrow'
halfDisplay.GlyphTableIndexArray = 'None'
halfDisplay.GaussianRadius = 0.01023794959716556
halfDisplay.SetScaleArray = [None, '']
halfDisplay.ScaleTransferFunction = 'PiecewiseFunction'
halfDisplay.OpacityArray = [None, '']
halfDisplay.OpacityTransferFunction = 'PiecewiseFunction'
halfDisplay.DataAxesGrid = 'GridAxesRepresentation'
halfDisplay.PolarAxes = 'PolarAxesRepresentation'
halfDisplay.ScalarOpacityFunction = scaledJacobianPWF
halfDisplay.ScalarOpacityUnitDistance = 0.5170367047688871
halfDisplay.OpacityArrayName = ['CELLS', 'EdgeRatio']
halfDisplay.SelectInputVectors = [None, '']
halfDisplay.WriteLog = ''

# ----------------------------------------------------------------
# setup the visualization in view 'image'
# ----------------------------------------------------------------

# show data from sphere_1
sphere_1Display = Show(OutputPort(sphere_1, 1), image, 'GeometryRepresentation')

# trace defaults for the display properties.
sphere_1Display.Representation = 'Surface'
sphere_1Display.ColorArrayName = [None, '']
sphere_1Display.SelectTCoordArray = 'None'
sphere_1Display.SelectNormalArray = 'None'
sphere_1Display.SelectTangentArray = 'None'
sphere_1Display.OSPRayScaleArray = 'SourcePosition'
sphere_1Display.OSPRayScaleFunction = 'PiecewiseFunction'
sphere_1Display.SelectOrientationVectors = 'None'
sphere_1Display.ScaleFactor = 0.199941059062753
sphere_1Display.SelectScaleArray = 'None'
sphere_1Display.GlyphType = 'Arrow'
sphere_1Display.GlyphTableIndexArray = 'None'
sphere_1Display.GaussianRadius = 0.00999705295313765
sphere_1Display.SetScaleArray = ['POINTS', 'SourcePosition']
sphere_1Display.ScaleTransferFunction = 'PiecewiseFunction'
sphere_1Display.OpacityArray = ['POINTS', 'SourcePosition']
sphere_1Display.OpacityTransferFunction = 'PiecewiseFunction'
sphere_1Display.DataAxesGrid = 'GridAxesRepresentation'
sphere_1Display.PolarAxes = 'PolarAxesRepresentation'
sphere_1Display.SelectInputVectors = ['POINTS', 'SourcePosition']
sphere_1Display.WriteLog = ''

# init the 'PiecewiseFunction' selected for 'ScaleTransferFunction'
sphere_1Display.ScaleTransferFunction.Points = [-1.1301245660453318, 0.0, 0.5, 0.0, 1.0645820414037326, 1.0, 0.5, 0.0]

# init the 'PiecewiseFunction' selected for 'OpacityTransferFunction'
sphere_1Display.OpacityTransferFunction.Points = [-1.1301245660453318, 0.0, 0.5, 0.0, 1.0645820414037326, 1.0, 0.5, 0.0]

# ----------------------------------------------------------------
# setup color maps and opacity mapes used in the visualization
# note: the Get..() functions create a new object, if needed
# ----------------------------------------------------------------

# ----------------------------------------------------------------
# restore active source
SetActiveSource(pasted)
# ----------------------------------------------------------------