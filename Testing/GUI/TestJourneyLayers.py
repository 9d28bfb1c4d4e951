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
w.filter('Shape Harmonic Volume Map')
w.choose_inputs(Boundary='PhantomHeadSmall.vtp')
w.choose(window.INPUTS + 'Features/List0', 'PhantomSkullSmall.vtp')
w.choose(window.INPUTS + 'Features/List1', 'PhantomBrainSmall.vtp')
w.choose(window.PROPERTIES + 'Method/ComboBox', 'SingleShot')
w.apply()
w.step('mapped')
w.check(window.PANEL + 'ShapeResult', 'visible', 'true')
w.python('''
    import shapemap
    made = GetActiveSource()
    assert made.MapArray == 'TargetPosition' and len(made.Features) == 2
    assert GetDisplayProperties(OutputPort(made, 0)).Visibility == 1
    shown = GetDisplayProperties(OutputPort(made, 0)).ColorArrayName[1]
    facts = shapemap.facts(made)
    print(facts)
    assert shown, 'grey' ''')
w.event('menubar', 'activate', 'menu_View')
w.event('menubar/menu_View/ShapeMapViews', 'activate', 'map_quality')
w.step('map quality')
w.python('''
    assert GetActiveSource().GetXMLName() == 'ShapeMapQuality', GetActiveSource().GetXMLName()
    assert len(GetLayouts()) == 2''')
w.run()
