"""Layouts of views for results of ShapeMap, in the window and in pvpython:

    from shapemap import views
    views.hexahedra(source)

Each function makes a new layout for a source or one of its output ports (the active one if none is
given), shows it and returns it. If the source does not have what the layout needs, the function raises
ValueError and says so. The window has these layouts in View > ShapeMap Views."""
from paraview import print_error, servermanager, simple


def map_quality(source=None, map_array=None, measure='ConformalDistortion', limits=(1.0, 3.0)):
    """The shape and its image, both coloured by a measure of Shape Map Quality, with linked cameras if the
    two have similar bounds. The map is SourcePosition of a shape that was moved, else TargetPosition."""
    port = _port(source)
    arrays = port.PointData.keys()
    if map_array is None:
        map_array = 'SourcePosition' if 'SourcePosition' in arrays else 'TargetPosition'
    if map_array not in arrays:
        raise ValueError('Map Quality needs the point array %s, which Shape Correspondence or Shape Parameterize makes'
                         % map_array)
    titles = ('Image', 'Shape') if map_array == 'SourcePosition' else ('Shape', 'Image')
    if not hasattr(simple, 'ShapeMapQuality'):
        simple._add_functions(vars(simple)) # the plugin was loaded after paraview.simple
    measured = simple.ShapeMapQuality(Input=port, MapArray=map_array)
    image = simple.Calculator(Input=measured, Function=map_array, CoordinateResults=1)
    layout, views = _new_layout('Map Quality', ['RenderView', 'RenderView'])
    for shown, view, title in zip((measured, image), views, titles):
        _show(shown, view, ('CELLS', measure), limits, title)
    _link(views, 'ShapeMap Map Quality')
    return _finish(layout, views, measured)


def hexahedra(source=None, limits=(0.0, 1.0)):
    """The cells on one side of a plane, coloured by their scaled Jacobian, and its histogram."""
    port = _port(source)
    if 'ScaledJacobian' not in port.CellData.keys():
        raise ValueError('Hexahedra needs the cell array ScaledJacobian, which Shape Hex Remesh makes')
    cut = simple.Clip(Input=port, ClipType='Plane', Crinkleclip=1)
    bounds = port.GetDataInformation().GetBounds()
    cut.ClipType.Origin = [(bounds[2 * axis] + bounds[2 * axis + 1]) / 2 for axis in range(3)]
    cut.ClipType.Normal = [1.0, 0.0, 0.0]
    histogram = simple.Histogram(Input=port, SelectInputArray=['CELLS', 'ScaledJacobian'], BinCount=20,
                                 UseCustomBinRanges=1, CustomBinRanges=limits)
    layout, views = _new_layout('Hexahedra', ['RenderView', 'XYBarChartView'])
    _show(cut, views[0], ('CELLS', 'ScaledJacobian'), limits).SetRepresentationType('Surface With Edges')
    _look_from(views[0], (1.0, 0.35, 0.5))
    views[1].LeftAxisTitle, views[1].BottomAxisTitle = 'Cells', 'Scaled Jacobian'
    views[1].ShowLegend = 0
    simple.Show(histogram, views[1])
    return _finish(layout, views, port) # Save Data writes what is active: the whole mesh


def correspondence(source=None):
    """Both surfaces of a Shape Correspondence, where corresponding points have the same colour; its
    landmarks; and the curve of a Shape Map Error Curve of it, if there is one in the pipeline."""
    filter = _port(source)
    if filter.GetXMLName() != 'ShapeCorrespondence':
        raise ValueError('Correspondence needs the output of Shape Correspondence')
    second = filter[1]
    images = simple.Calculator(Input=filter[0], ResultArrayName='PositionOnSurfaceB',
                               Function='TargetPosition')
    positions = simple.Calculator(Input=second, ResultArrayName='PositionOnSurfaceB', Function='coords')
    bounds = second.GetDataInformation().GetBounds()
    extents = [bounds[2 * axis + 1] - bounds[2 * axis] for axis in range(3)]
    axis = extents.index(max(extents))
    curve = next((found for found in simple.GetSources().values()
                  if found.GetXMLName() == 'ShapeMapErrorCurve' and found.Input.SMProxy == filter.SMProxy), None)
    layout, views = _new_layout('Correspondence', ['RenderView', 'RenderView'] + ['XYChartView'] * (curve is not None))
    for shown, view, title in zip((images, positions), views, ('Surface A', 'Surface B')):
        _show(shown, view, ('POINTS', 'PositionOnSurfaceB', 'XYZ'[axis]), bounds[2 * axis:2 * axis + 2], title)
    simple.GetColorTransferFunction('PositionOnSurfaceB').ApplyPreset('Turbo', True)
    if filter.Landmarks is not None:
        moved = simple.Calculator(Input=filter.Landmarks, Function='TargetPosition', CoordinateResults=1)
        for landmarks, view in zip((filter.Landmarks, moved), views):
            display = simple.Show(landmarks, view)
            display.SetRepresentationType('Points')
            display.PointSize, display.RenderPointsAsSpheres = 12.0, 1
            simple.ColorBy(display, None)
            display.AmbientColor = display.DiffuseColor = [1.0, 1.0, 1.0]
    if curve is not None:
        display = simple.Show(curve, views[2])
        display.UseIndexForXAxis, display.XArrayName, display.SeriesVisibility = 0, 'Error', ['Share']
        views[2].LeftAxisTitle, views[2].BottomAxisTitle = 'Share of points', 'Error'
    _link(views[:2], 'ShapeMap Correspondence')
    return _finish(layout, views, filter)


def deck_check(source=None):
    """The regions of the cells and, for Shape Hex Remesh, the patches of their boundary, with the number
    of cells or faces of each: the sets of an input file of a solver."""
    port = _port(source)
    if 'RegionId' not in port.CellData.keys():
        raise ValueError('Deck Check needs the cell array RegionId, which Shape Hex Remesh and Shape Tetrahedralize make')
    parts = [(port, 'RegionId', 'Region')]
    if port.GetXMLName() == 'ShapeHexRemesh':
        parts.append((port[1], 'Patch', 'Patch'))
    layout, views = _new_layout('Deck Check', ['RenderView'] * len(parts))
    for (shown, array, word), view in zip(parts, views):
        counts = _count(shown, array)
        lines = ['%s %d: %d %s' % (word, value, count, 'cells' if word == 'Region' else 'faces')
                 for value, count in counts]
        table = simple.GetColorTransferFunction(array)
        table.InterpretValuesAsCategories = 1
        table.Annotations = [text for value, _ in counts for text in ('%d' % value, '%s %d' % (word, value))]
        palette = ((0.22, 0.49, 0.72), (0.9, 0.5, 0.1), (0.3, 0.69, 0.29), (0.6, 0.31, 0.64), (0.89, 0.1, 0.11),
                   (0.65, 0.34, 0.16), (0.97, 0.51, 0.75), (0.6, 0.6, 0.6))
        table.IndexedColors = [part for i in range(len(counts)) for part in palette[i % len(palette)]]
        _show(shown, view, ('CELLS', array), None, '\n'.join(lines[:20] + ['...'] * (len(lines) > 20)))
    if len(views) == 2:
        _link(views, 'ShapeMap Deck Check')
    return _finish(layout, views, port)


def show(name):
    """What the menu calls: the layout for the active source, or its error in the message area."""
    try:
        globals()[name]()
    except ValueError as error:
        print_error(str(error))


def _port(source):
    """The output that a layout is for, with its data up to date."""
    source = simple.GetActiveSource() if source is None else source
    if source is None:
        raise ValueError('there is no active source: select one in the pipeline')
    source.UpdatePipeline()
    return source


def _new_layout(name, types):
    """A layout with views side by side, of equal width."""
    layout = simple.CreateLayout(name)
    views = [simple.CreateView(view) for view in types]
    cell = 0
    for remaining, view in zip(range(len(views), 0, -1), views):
        if remaining > 1:
            left = layout.SplitHorizontal(cell, 1.0 / remaining)
            simple.AssignViewToLayout(view, layout, left)
            cell = left + 1
        else:
            simple.AssignViewToLayout(view, layout, cell)
    return layout, views


def _show(source, view, array, limits, title=''):
    """Shows a source coloured by an array: its association, its name and perhaps a component."""
    source.UpdatePipeline()
    display = simple.Show(source, view)
    display.SetRepresentationType('Surface')
    simple.ColorBy(display, array)
    if limits is not None:
        simple.GetColorTransferFunction(array[1]).RescaleTransferFunction(*limits)
    display.SetScalarBarVisibility(view, True)
    if title:
        simple.Show(simple.Text(Text=title), view).WindowLocation = 'Upper Left Corner'
    simple.ResetCamera(view)
    return display


def _look_from(view, direction):
    view.CameraPosition = [view.CameraFocalPoint[axis] + direction[axis] for axis in range(3)]
    view.CameraViewUp = [0.0, 1.0, 0.0]
    simple.ResetCamera(view)


def _link(views, name):
    """The cameras of two views move together. Each view shows its own shape from the same direction, so
    they are linked only if one camera can show both shapes."""
    first, second = ([*view.CameraFocalPoint, view.CameraParallelScale] for view in views)
    size = max(first[3], second[3])
    if max(abs(a - b) for a, b in zip(first, second)) <= 0.5 * size:
        simple.AddCameraLink(*views, name)


def _count(port, array):
    """The values of an integer cell array, each with the number of its cells."""
    low, high = (int(limit) for limit in port.CellData.GetArray(array).GetRange(0))
    histogram = simple.Histogram(Input=port, SelectInputArray=['CELLS', array], BinCount=high - low + 1,
                                 UseCustomBinRanges=1, CustomBinRanges=[low - 0.5, high + 0.5])
    values = servermanager.Fetch(histogram).GetRowData().GetArray('bin_values')
    simple.Delete(histogram)
    counts = [(low + row, int(values.GetTuple1(row))) for row in range(high - low + 1)]
    return [(value, count) for value, count in counts if count]


def _finish(layout, views, source):
    simple.SetActiveView(views[0])
    if source.SMProxy.GetNumberOfOutputPorts() > 1: # the toolbars are those of one output
        selection = servermanager.ProxyManager().GetSelectionModel('ActiveSources')
        selection.SetCurrentProxy(source.SMProxy.GetOutputPort(source.Port), selection.CLEAR_AND_SELECT)
    else:
        simple.SetActiveSource(source)
    for view in views:
        simple.Render(view)
    return layout
