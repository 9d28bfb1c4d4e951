"""The first Apply shows the result: coloured, and in the view. Later, and for scripts, the view is the user's."""
import window

w = window.Window()
w.python('''
    def shown():
        names = {source.SMProxy: name[0] for name, source in GetSources().items()}
        displays = [display for display in GetActiveView().Representations if hasattr(display, 'Input')]
        return sorted((names[display.Input.SMProxy], display.Input.Port) for display in displays if display.Visibility)

    def colored(source, port=0):
        return GetDisplayProperties(OutputPort(source, port)).ColorArrayName[1]''')

# Hexahedra have edges and a fixed range of colours, in which bad is red.
w.open('DentedSphere600.vtp')
w.filter('Shape Hex Remesh')
w.choose(window.PROPERTIES + 'Method/ComboBox', 'Grid')
w.event(window.PROPERTIES + 'CellSize/DoubleLineEdit0', 'set_string', '0.3')
w.apply()
w.python('''
    made = GetActiveSource()
    display = GetDisplayProperties(made)
    table = GetColorTransferFunction('ScaledJacobian')
    points = list(table.RGBPoints)
    assert display.Representation == 'Surface With Edges', display.Representation
    assert colored(made) == 'ScaledJacobian' and shown() == [('ShapeHexRemesh1', 0)], (colored(made), shown())
    assert points[0] == 0 and points[-4] == 1 and points[1] > points[3] and points[-1] > points[-3], points
    assert table.AutomaticRescaleRangeMode == 'Never'
    ColorBy(display, ('CELLS', 'Volume'))''')
w.event(window.PROPERTIES + 'CellSize/DoubleLineEdit0', 'set_string', '0.35')
w.apply()
w.python('assert colored(made) == "Volume"; Delete(made)')

# Another port than the first is shown, and is the active one.
w.select('/0/0|0')
w.filter('Shape Parameterize')
w.apply()
w.python('''
    made = GetActiveSource()
    assert made.Port == 1 and colored(made, 1) == 'MapColors', made.Port
    assert GetDisplayProperties(OutputPort(made, 1)).MapScalars == 0
    assert shown() == [('ShapeParameterize1', 1)], shown()''')

# What is computed from it does not take its numbers as colours.
w.filter('Shape Laplace Spectrum')
w.apply()
w.python('''
    spectrum = GetActiveSource()
    display = GetDisplayProperties(spectrum)
    assert spectrum.GetXMLName() == 'ShapeLaplaceSpectrum' and display.Visibility == 1, spectrum.GetXMLName()
    assert colored(spectrum) != 'MapColors' and display.MapScalars == 1, (colored(spectrum), display.MapScalars)
    Delete(spectrum)''')

# What is made of it without an array of its own to show keeps its colours.
w.select('/0/0/0/1|0')
w.filter('Shape Harmonic Volume Map')
w.choose_inputs(Boundary='ShapeParameterize1: Surface')
w.apply()
w.python('''
    moved = GetActiveSource()
    display = GetDisplayProperties(moved)
    assert moved.GetXMLName() == 'ShapeHarmonicVolumeMap' and display.Visibility == 1, moved.GetXMLName()
    assert colored(moved) == 'MapColors' and display.MapScalars == 0, (colored(moved), display.MapScalars)
    Delete(moved)
    Delete(made)''')

# In a new view, a polycube is seen obliquely. Numbers that stand for names have a colour each.
w.select('/0/0|0')
w.filter('Shape Polycube')
w.apply()
w.python('''
    view, table = GetActiveView(), GetColorTransferFunction('Label')
    towards = [position - focus for position, focus in zip(view.CameraPosition, view.CameraFocalPoint)]
    assert min(towards) > 0.2 * max(towards), towards
    assert table.InterpretValuesAsCategories == 1 and list(table.Annotations[:4]) == ['0', '+x', '1', '-x'], table.Annotations
    Delete(FindSource('ShapePolycube1'))''')

# Where the filter refuses, its input stays; the next Apply is the first one with a result.
w.select('/0/0|0')
w.filter('Shape Cut Feature')
w.apply()
w.python('''
    assert ('DentedSphere600.vtp', 0) in shown(), shown()
    cut = GetActiveSource()
    cut.LoopPoints = [0.9, 0, 0.5, 0, 0.9, 0.5, -0.9, 0, 0.5, 0, -0.9, 0.5]''')
w.event(window.PROPERTIES + 'Side/ComboBox', 'set_string', 'Larger')
w.apply()
w.python('''
    assert shown() == [('ShapeCutFeature1', 0), ('ShapeCutFeature1', 1)], shown()
    parts = [list(GetDisplayProperties(OutputPort(cut, port)).DiffuseColor) for port in (0, 1)]
    assert parts[0] != parts[1], parts
    Delete(cut)''')

# The patch around a seed shows its distance from the seed. A deformed shape keeps the colours of its input,
# and a pasted feature is told from its target.
w.select('/0/0|0')
w.filter('Shape Exponential Map')
w.apply()
w.python('''
    patch = GetActiveSource()
    assert colored(patch) == 'GeodesicDistance' and shown() == [('ShapeExponentialMap1', 0)], (colored(patch), shown())
    Delete(patch)
    import math
    hemisphere = [value for k in range(12) for value in (0.3 * math.cos(k * math.pi / 6), 0.3 * math.sin(k * math.pi / 6), 0.4)]
    ball = Sphere(registrationName='Ball', ThetaResolution=30, PhiResolution=30)
    cap = ShapeCutFeature(registrationName='Cap', Input=ball, LoopPoints=hemisphere)
    planet = Sphere(registrationName='Planet', ThetaResolution=30, PhiResolution=30, Radius=1.5)
    for source in GetSources().values():
        Hide(source)
    Show(planet)
    SetActiveSource(cap)''')
w.filter('Shape Paste Feature')
w.choose_inputs(Target='Planet')
w.apply()
w.python('''
    pasted = GetActiveSource()
    assert colored(pasted) == 'Part' and ('ShapePasteFeature1', 0) in shown(), (colored(pasted), shown())
    ring = Slice(registrationName='Ring', Input=planet)
    ring.SliceType.Normal = [0, 0, 1]
    old = Calculator(registrationName='Old', Input=ring, ResultArrayName='SourcePosition', Function='coords')
    handle = Calculator(registrationName='Handle', Input=old, CoordinateResults=1, Function='coords+iHat*0.3*coordsX')
    height = Elevation(registrationName='Height', Input=planet)
    ColorBy(Show(height), ('POINTS', 'Elevation'))
    SetActiveSource(height)''')
w.filter('Shape Deform')
w.choose_inputs(Boundary='Handle')
w.apply()
w.python('''
    deformed = GetActiveSource()
    assert colored(deformed) == 'Elevation' and ('ShapeDeform1', 0) in shown(), (colored(deformed), shown())
    for source in (deformed, height, handle, old, ring, pasted, cap, planet, ball):
        Delete(source)''')

# A script in the window's shell decides by itself.
w.python('''
    hexahedra = ShapeHexRemesh(Surface=FindSource('DentedSphere600.vtp'), Method='Grid', CellSize=0.35)
    display = Show(hexahedra)
    display.ColorArrayName = ['POINTS', '']
    hexahedra.CellSize = 0.4
    Render()
    assert not colored(hexahedra), colored(hexahedra)
    Delete(hexahedra)''')

# Two shapes in one place are drawn beside each other, and the camera sees both.
w.open('FigureBSmall.vtp')
w.open('FigureASmall.vtp')
w.filter('Shape Correspondence')
w.choose_inputs(SurfaceB='FigureBSmall.vtp')
w.apply()
w.python('''
    import numpy
    maps = GetActiveSource()
    bounds = [numpy.reshape(OutputPort(maps, port).GetDataInformation().GetBounds(), (3, 2)) for port in (0, 1)]
    shift = GetDisplayProperties(OutputPort(maps, 1)).Position
    assert bounds[1][0, 0] + shift[0] > bounds[0][0, 1], (bounds, shift)
    assert shown() == [('ShapeCorrespondence1', 0), ('ShapeCorrespondence1', 1)], shown()
    for port in (0, 1):
        display = GetDisplayProperties(OutputPort(maps, port))
        assert colored(maps, port) == 'MapColors' and display.MapScalars == 0, (port, colored(maps, port), display.MapScalars)''')

# What ParaView's filters make of one of them is drawn there, with its colours.
w.python('''
    selection = servermanager.ProxyManager().GetSelectionModel('ActiveSources')
    selection.SetCurrentProxy(maps.SMProxy.GetOutputPort(1), selection.CLEAR_AND_SELECT)''')
w.event('menubar', 'activate', 'menuFilters')
w.event('menubar/menuFilters/Alphabetical', 'activate', 'Clip')
w.apply()
w.python('''
    clip = FindSource('Clip1')
    display = GetDisplayProperties(clip)
    assert list(display.Position) == list(shift) and colored(clip) == 'MapColors' and display.MapScalars == 0, display.Position
    Delete(clip)
    Show(OutputPort(maps, 1))''')

# The giver stays, and the receiver has its colours.
w.python('''
    for other in GetSources().values():
        if other != maps:
            Hide(other)
    elevation = Elevation(registrationName='Height', Input=OutputPort(maps, 1), LowPoint=[0, -1, 0], HighPoint=[0, 1, 0])
    Hide(OutputPort(maps, 1))
    ColorBy(Show(elevation), ('POINTS', 'Elevation'))
    SetActiveSource(OutputPort(maps, 0))''')
w.filter('Shape Transfer Fields')
w.choose_inputs(Source='Height')
w.apply()
w.python('''
    assert shown() == [('Height', 0), ('ShapeTransferFields1', 0)], shown()
    assert colored(GetActiveSource()) == 'Elevation', colored(GetActiveSource())''')
w.run(200)
