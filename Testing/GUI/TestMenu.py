"""Filters > ShapeMap lists every filter under its label, offers it when it can work, and Shape Parameterize
works from there."""
import glob
import os
from xml.etree import ElementTree

import shapetesting
import window

proxies = {proxy.get('name'): proxy for path in glob.glob(os.path.join(shapetesting.ROOT, 'Filters', 'VTK', '*', '*.xml'))
           for proxy in ElementTree.parse(path).iter('SourceProxy')}
filters = [proxy for proxy in proxies.values() if proxy.find('Hints/ShapeMap') is not None]
assert len(filters) >= 2

w = window.Window()


def check(proxy):
    """The filter is made from the menu, shows its inputs on the panel, and is taken back."""
    w.filter(proxy.get('label'))
    for port in proxy.findall('PropertyGroup[@panel_widget="ShapeInputs"]/Property'):
        w.check(window.INPUTS + port.get('name'), 'visible', 'true')
    w.python('''
        made = GetActiveSource()
        assert made.GetXMLName() == %r, made.GetXMLName()''' % proxy.get('name'))
    w.click(window.PANEL + 'Delete')


# What needs a solid is offered when a solid is selected, which users select first. The volume map of
# Shape Apply Volume Map is then another source of the pipeline; Shape Certificate works on it alone.
w.open('DentedSphereCharges.vtp')
check(proxies['ShapeCertificate'])
w.open('BallSmall.vtu')
for name in ('ShapeUntangle', 'ShapeHarmonicVolumeMap', 'ShapeApplyVolumeMap', 'ShapeMeshMotion'):
    check(proxies[name])
w.open('DentedSphere600.vtp')
for proxy in filters:
    if proxy.get('name') not in (
            'ShapeUntangle', 'ShapeLabelSurfaces', 'ShapeImageValues', 'ShapeStructuredBlocks', 'ShapeFromOperators',
            'ShapeCertificate', 'ShapeMeshMotion'):
        check(proxy)
w.python('assert len(GetSources()) == 3, GetSources()')

w.filter('Shape Parameterize')
w.apply()
w.select('/0/2|0')
w.python('assert GetActiveSource().GetXMLName() == "XMLPolyDataReader", GetActiveSource().GetXMLName()')
w.select('/0/2/0|0')
w.python('''
    made = GetActiveSource()
    assert made.GetXMLName() == 'ShapeParameterize', made.GetXMLName()
    names = [key[0] for key in GetSources()]
    assert {'DentedSphere600.vtp', 'ShapeParameterize1'} <= set(names), names
    for name in ('DentedSphereCharges.vtp', 'BallSmall.vtu'):
        Hide(FindSource(name))
    shown = [p.Input.Port for p in GetActiveView().Representations if hasattr(p, 'Input') and p.Visibility]
    assert shown == [1], 'the image: %s' % shown''')
w.picture('GUIParameterize.png')

# What needs a table is offered when the pipeline has one, such as facts.
w.select('/0/2|0')
check(proxies['ShapeFromOperators'])

# What needs an image is offered when an image is selected.
w.python('Show(Wavelet())')
w.wait(100)
for name in ('ShapeLabelSurfaces', 'ShapeImageValues'):
    check(proxies[name])

# What needs a solid with a map is offered when one is selected.
w.python("Show(Calculator(Input=FindSource('BallSmall.vtu'), ResultArrayName='TargetPosition', Function='coords'))")
w.wait(100)
check(proxies['ShapeStructuredBlocks'])
w.run()
