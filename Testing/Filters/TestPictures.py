"""What the filters' results look like: a surface and its sphere coloured by the same positions, a
hexahedral ball carried into a dented sphere, cut open, and the errors of two maps in a line chart. Each
picture is compared pixel by pixel."""
import os

from paraview.simple import *

import shapetesting

FOLDER = os.path.join(shapetesting.BUILD, 'Testing', 'Temporary')
os.makedirs(FOLDER, exist_ok=True)
view = CreateRenderView(ViewSize=[400, 300], OrientationAxesVisibility=0, UseColorPaletteForBackground=0,
                        Background=[1, 1, 1])


def show(source, array, component, style='Surface'):
    shown = Show(source, view)
    shown.SetRepresentationType(style)
    ColorBy(shown, ('POINTS', array, component))
    GetColorTransferFunction(array).RescaleTransferFunction(-1, 1)
    shown.SetScalarBarVisibility(view, False)
    return shown


def compare(position, baseline):
    Render(view)
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = position, [0, 0, 0], [0, 1, 0]
    ResetCamera(view)
    view.GetActiveCamera().Zoom(1.3)
    picture = os.path.join(FOLDER, baseline)
    SaveScreenshot(picture, view, ImageResolution=[400, 300])
    shapetesting.compare_picture(picture, baseline)
    HideAll(view)


# The surface by where its points go, beside the sphere by where its points are.
surface = XMLPolyDataReader(FileName=[shapetesting.data_file('DentedSphere600.vtp')])
sphere = ShapeParameterize(Input=surface)
image = Calculator(Input=OutputPort(sphere, 1), ResultArrayName='TargetPosition', Function='coords')
show(OutputPort(sphere, 0), 'TargetPosition', 'X').Position = [-1.2, 0, 0]
show(image, 'TargetPosition', 'X').Position = [1.2, 0, 0]
compare([2, 3, 6], 'ShapeParameterize.png')

# The ball in the dented sphere, by where its points came from.
ball = XMLUnstructuredGridReader(FileName=[shapetesting.data_file('BallSmall.vtu')])
solid = ShapeHarmonicVolumeMap(
    Domain=ball, Boundary=OutputPort(sphere, 1), MapArray='SourcePosition')
half = Clip(Input=solid, ClipType='Plane', Crinkleclip=1)
half.ClipType.Origin, half.ClipType.Normal = [0, 0, 0], [0.5, 0.2, 1]
show(half, 'SourcePosition', 'X', 'Surface With Edges')
compare([1.5, 1, 5], 'ShapeHarmonicVolumeMap.png')

# The share of places below each error, for two maps of a sphere to itself: turned a little, and more.
chart = CreateView('XYChartView')
chart.ViewSize, chart.LegendLocation = [400, 300], 'BottomRight'
chart.LeftAxisTitle, chart.BottomAxisTitle = 'share of places', 'error over the root of the area'
chart.LeftAxisUseCustomRange, chart.LeftAxisRangeMinimum, chart.LeftAxisRangeMaximum = 1, 0.0, 1.0
ball = Sphere(Radius=1.0, ThetaResolution=24, PhiResolution=24)
truth = Calculator(Input=ball, ResultArrayName='TargetPosition', Function='coords')
turn = 'iHat*(coordsX*cos({0})-coordsY*sin({0}))+jHat*(coordsX*sin({0})+coordsY*cos({0}))+kHat*coordsZ'
for angle, colour in ((0.1, ['0.1', '0.4', '0.8']), (0.3, ['0.9', '0.5', '0.1'])):
    turned = Calculator(Input=ball, ResultArrayName='TargetPosition', Function=turn.format(angle))
    curve = ShapeMapErrorCurve(Input=turned, Target=ball, Truth=truth)
    shown = Show(curve, chart)
    shown.UseIndexForXAxis, shown.XArrayName, shown.SeriesVisibility = 0, 'Error', ['Share']
    shown.SeriesLabel = ['Share', 'turned by %g' % angle]
    shown.SeriesColor = ['Share'] + colour
Render(chart)
picture = os.path.join(FOLDER, 'ShapeMapErrorCurve.png')
SaveScreenshot(picture, chart, ImageResolution=[400, 300])
shapetesting.compare_picture(picture, 'ShapeMapErrorCurve.png')
