"""A head is registered with a ball in layers: skull and brain, chosen on the panel, meet their targets, too."""
import journey
import window

w = journey.Journey('Layers')
for part in ('Brain', 'Skull', 'Head'):
    w.open('Phantom%sSmall.vtp' % part)
w.step('opened')
w.filter('Shape Tetrahedralize')
w.choose(window.INPUTS + 'InnerSurfaces/List0', 'PhantomSkullSmall.vtp')
w.choose(window.INPUTS + 'InnerSurfaces/List1', 'PhantomBrainSmall.vtp')
w.apply()
w.step('solid with layers')
w.python('''
    import itertools, numpy
    renderer = GetActiveView().GetRenderer()
    bounds = numpy.reshape(GetActiveSource().GetDataInformation().GetBounds(), (3, 2))
    for corner in itertools.product(*bounds):
        renderer.SetWorldPoint(*corner, 1.0)
        renderer.WorldToView()
        assert max(map(abs, renderer.GetViewPoint()[:2])) < 1.0, (corner, renderer.GetViewPoint())''')
w.filter('Shape Harmonic Volume Map')
w.choose_inputs(Boundary='PhantomHeadSmall.vtp')
w.choose(window.INPUTS + 'Features/List0', 'PhantomSkullSmall.vtp')
w.choose(window.INPUTS + 'Features/List1', 'PhantomBrainSmall.vtp')
w.apply()
w.step('mapped fast')
w.check(window.PANEL + 'ShapeResult/Warnings', 'visible', 'true')
w.event(window.PROPERTIES + 'Exact/CheckBox', 'set_boolean', 'true')
w.event(window.PROPERTIES + 'Tolerance/DoubleLineEdit0', 'set_string', '1e-3')
w.apply()
w.step('mapped exactly')
w.check(window.PANEL + 'ShapeResult/Warnings', 'visible', 'false')
w.python('''
    import shapemap
    made = GetActiveSource()
    display = GetDisplayProperties(OutputPort(made, 0))
    assert made.MapArray == 'TargetPosition' and len(made.Features) == 2
    assert display.Visibility == 1 and display.ColorArrayName[1] == 'RegionId', display.ColorArrayName
    assert max(shapemap.facts(made)['BorderRMSEVertices']) < 0.03''')
w.event('menubar', 'activate', 'menu_View')
w.event('menubar/menu_View/ShapeMapViews', 'activate', 'map_quality')
w.step('map quality')
w.python('''
    quality = GetActiveSource()
    assert quality.GetXMLName() == 'ShapeMapQuality' and quality.MapArray == 'SourcePosition', quality.MapArray
    assert len(GetLayouts()) == 2''')
w.run()
