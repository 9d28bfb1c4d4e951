"""Draws the results of demo.py: draw(folder)."""
import os

from paraview import simple

INK = [0.13, 0.16, 0.22]
PAPER = [1.0, 1.0, 1.0]
# From an inverted hexahedron, in red, to a perfect cube.
QUALITY = [0.0, 0.75, 0.13, 0.15, 0.25, 0.95, 0.55, 0.25, 0.5, 0.98, 0.86, 0.5,
           0.75, 0.60, 0.80, 0.78, 1.0, 0.22, 0.50, 0.66]
# Towards the viewer, who sees the bunny's left side; and the plane that cuts head, ear and body.
SIDE = [0.68, 0.18, 0.71]
NORMAL = [0.69, 0.0, 0.72]
ORIGIN = [-0.083, 0.0, -0.086]


def draw(folder, say=print):
    """Writes surface.png, hexahedra.png, distance.png, levels.png and overview.png."""
    simple._DisableFirstRenderCameraReset()
    for name, picture in (('surface', surface), ('hexahedra', hexahedra), ('distance', distance),
                          ('levels', levels), ('overview', overview)):
        view = picture(folder)
        simple.SaveScreenshot(os.path.join(folder, name + '.png'), view)
        simple.Delete(view)
        say('drew %s.png' % name)


def read(folder, name):
    reader = simple.XMLPolyDataReader if name.endswith('.vtp') else simple.XMLUnstructuredGridReader
    return reader(FileName=[os.path.join(folder, name)])


def new_view(size=(1200, 900)):
    view = simple.CreateView('RenderView')
    view.ViewSize = list(size)
    view.UseColorPaletteForBackground = 0
    view.Background = PAPER
    view.OrientationAxesVisibility = 0
    view.CameraParallelProjection = 1
    return view


def look(view, centre, height, direction=SIDE, up=(0.0, 1.0, 0.0)):
    view.CameraFocalPoint = centre
    view.CameraPosition = [c + 5.0 * d for c, d in zip(centre, direction)]
    view.CameraViewUp = up
    view.CameraParallelScale = 0.5 * height


def plain(display, colour):
    display.ColorArrayName = [None, '']
    display.DiffuseColor = display.AmbientColor = colour


def colour_by(display, association, array, table, view, title=None, position=None, horizontal=True):
    display.ColorArrayName = [association, array]
    display.LookupTable = table
    if title:
        bar = simple.GetScalarBar(table, view)
        bar.Visibility = 1
        bar.Title, bar.ComponentTitle = title, ''
        bar.WindowLocation = 'Any Location'
        bar.Orientation = 'Horizontal' if horizontal else 'Vertical'
        bar.Position, bar.ScalarBarLength, bar.ScalarBarThickness = position, 0.34, 18
        bar.TitleColor = bar.LabelColor = INK
        bar.TitleFontSize, bar.LabelFontSize = 20, 18
        bar.AutomaticLabelFormat, bar.LabelFormat, bar.RangeLabelFormat = 0, '%.1f', '%.1f'
        bar.UseCustomLabels = 0
        bar.DrawTickMarks = 1


def caption(view, text, position, size=22):
    """Words whose lower left corner is at `position`, in shares of the picture."""
    label = simple.Text(Text=text)
    display = simple.Show(label, view)
    display.WindowLocation = 'Any Location'
    display.Position = position
    display.FontSize, display.Color = size, INK


def beside(display, shift, scale=1.0):
    display.Position = shift
    display.Scale = [scale] * 3


def show_globe(data, array, view, shift=(0.0, 0.0, 0.0), scale=1.0):
    """A surface coloured by the latitude of the sphere position in `array`, with a graticule."""
    x, y, z = ('%s_%s' % (array, axis) for axis in 'XYZ')
    latitude = simple.Calculator(Input=data, ResultArrayName='Latitude',
                                 Function='57.29577951*asin(max(-1,min(1,%s)))' % y)
    # The imaginary part of (x + i z)^6: zero on 12 meridians, and without a seam.
    meridians = simple.Calculator(
        Input=latitude, ResultArrayName='Meridians',
        Function='6*{0}^5*{1}-20*{0}^3*{1}^3+6*{0}*{1}^5'.format(x, z))
    display = simple.Show(meridians, view)
    beside(display, shift, scale)
    table = simple.GetColorTransferFunction('Latitude')
    table.ColorSpace = 'Lab'
    table.RGBPoints = [-90, 0.20, 0.32, 0.55, -30, 0.55, 0.75, 0.82, 0, 0.97, 0.95, 0.88,
                       30, 0.97, 0.76, 0.48, 90, 0.72, 0.28, 0.20]
    colour_by(display, 'POINTS', 'Latitude', table, view)
    for array, values in (('Latitude', [15.0 * k for k in range(-5, 6)]), ('Meridians', [0.0])):
        lines = simple.Contour(Input=meridians, ContourBy=['POINTS', array], Isosurfaces=values,
                               ComputeNormals=0)
        display = simple.Show(lines, view)
        plain(display, INK)
        display.LineWidth = 1.6
        beside(display, shift, scale)


def right(amount):
    """So far to the right as the camera sees it."""
    return [amount * 0.72, 0.0, -amount * 0.69]


def surface(folder):
    view = new_view((1200, 800))
    show_globe(read(folder, 'surface.vtp'), 'TargetPosition', view)
    sphere = simple.Calculator(Input=read(folder, 'sphere.vtp'), Function='coords',
                               ResultArrayName='Place')
    show_globe(sphere, 'Place', view, right(1.06), 0.44)
    look(view, right(0.49), 1.5)
    caption(view, "the bunny's surface", [0.17, 0.06])
    caption(view, 'its image, the unit sphere', [0.64, 0.06])
    return view


def show_cut(folder, view, legend=None, shift=(0.0, 0.0, 0.0)):
    data = read(folder, 'hexahedra.vtu')
    cut = simple.Clip(Input=data, ClipType='Plane', Crinkleclip=1)
    cut.ClipType.Origin, cut.ClipType.Normal = ORIGIN, NORMAL
    display = simple.Show(cut, view)
    display.Representation = 'Surface With Edges'
    display.EdgeColor, display.LineWidth, display.Ambient = INK, 1.0, 0.35
    beside(display, shift)
    table = simple.GetColorTransferFunction('ScaledJacobian')
    table.ColorSpace, table.RGBPoints = 'RGB', QUALITY
    colour_by(display, 'CELLS', 'ScaledJacobian', table, view,
              'Scaled Jacobian' if legend else None, legend)


def hexahedra(folder):
    view = new_view()
    show_cut(folder, view, [0.33, 0.04])
    look(view, [-0.1, -0.06, 0.1], 1.26)
    return view


def show_distance(data, view, origin, legend=None, shift=(0.0, 0.0, 0.0), scale=1.0):
    cut = simple.Slice(Input=data, SliceType='Plane')
    cut.SliceType.Origin, cut.SliceType.Normal = origin, NORMAL
    display = simple.Show(cut, view)
    display.Ambient, display.Diffuse = 1.0, 0.0
    beside(display, shift, scale)
    table = simple.GetColorTransferFunction('BoundaryDistance')
    table.ApplyPreset('Jet', True)
    table.RescaleTransferFunction(0.0, 1.0)
    table.Discretize, table.NumberOfTableValues = 1, 20
    colour_by(display, 'POINTS', 'BoundaryDistance', table, view,
              'Distance to the boundary of the ball' if legend else None, legend)


def show_outline(folder, view, shift=(0.0, 0.0, 0.0)):
    """The curve in which the plane cuts the surface that the hexahedra fill."""
    height = simple.Calculator(
        Input=read(folder, 'surface.vtp'), ResultArrayName='Height',
        Function='+'.join('(%g)*(coords%s-(%g))' % (normal, axis, origin)
                          for normal, axis, origin in zip(NORMAL, 'XYZ', ORIGIN)))
    curve = simple.Contour(Input=height, ContourBy=['POINTS', 'Height'], Isosurfaces=[0.0],
                           ComputeNormals=0)
    display = simple.Show(curve, view)
    plain(display, INK)
    display.LineWidth = 2.0
    beside(display, shift)


def distance(folder):
    view = new_view((1200, 800))
    show_distance(read(folder, 'ball.vtu'), view, [0.0] * 3, None, right(-1.06), 0.45)
    show_distance(read(folder, 'hexahedra.vtu'), view, ORIGIN, [0.33, 0.04])
    show_outline(folder, view)
    look(view, [c - 0.1 * u for c, u in zip(right(-0.53), (0, 1, 0))], 1.4, NORMAL)
    caption(view, 'in the ball', [0.20, 0.93])
    caption(view, 'brought to the bunny', [0.66, 0.93])
    return view


def levels(folder):
    table = simple.CSVReader(FileName=[os.path.join(folder, 'levels.csv')])
    view = simple.CreateView('XYChartView')
    view.ViewSize = [1200, 900]
    names = ['RMSEVertices', 'RMSEInside', 'Maximum']
    labels = ['root mean square at points', 'root mean square inside triangles', 'largest']
    colours = [[0.22, 0.50, 0.66], [0.95, 0.55, 0.25], [0.55, 0.55, 0.60]]
    display = simple.Show(table, view)
    display.UseIndexForXAxis, display.XArrayName = 0, 'Level'
    display.SeriesVisibility = names
    display.SeriesLabel = [text for pair in zip(names, labels) for text in pair]
    display.SeriesColor = [text for name, colour in zip(names, colours)
                           for text in [name] + [str(value) for value in colour]]
    display.SeriesLineThickness = [text for name in names for text in (name, '4')]
    display.SeriesMarkerStyle = [text for name in names for text in (name, '4')]
    display.SeriesMarkerSize = [text for name in names for text in (name, '12')]
    view.ChartTitle = 'Error of the boundary by level'
    view.ChartTitleFontSize, view.LegendFontSize = 26, 20
    view.LeftAxisTitle, view.BottomAxisTitle = "share of the bunny's longest side", 'level'
    view.LeftAxisTitleFontSize = view.BottomAxisTitleFontSize = 22
    view.LeftAxisLabelFontSize = view.BottomAxisLabelFontSize = 18
    view.LeftAxisLogScale = 1
    view.BottomAxisUseCustomLabels = 1
    # Pairs of a place and its label.
    view.BottomAxisLabels = [str(level) for level in range(100) for _ in range(2)]
    return view


def overview(folder):
    view = new_view((1600, 600))
    show_globe(read(folder, 'surface.vtp'), 'TargetPosition', view, right(-1.06))
    show_cut(folder, view)
    show_distance(read(folder, 'hexahedra.vtu'), view, ORIGIN, None, right(1.06))
    show_outline(folder, view, right(1.06))
    look(view, [0.0, -0.04, 0.0], 1.26)
    caption(view, 'its surface, mapped onto a sphere', [0.055, 0.03], 18)
    caption(view, 'its solid, filled with hexahedra', [0.39, 0.03], 18)
    caption(view, "a ball's distance field, mapped into it", [0.70, 0.03], 18)
    return view
