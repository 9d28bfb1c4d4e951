"""Filters > ShapeMap lists every filter under its label, and Shape Parameterize works from there."""
import glob
import os
from xml.etree import ElementTree

import shapetesting
import window

proxies = {proxy.get('name'): proxy for path in glob.glob(os.path.join(shapetesting.ROOT, 'Filters', 'VTK', '*', '*.xml'))
           for proxy in ElementTree.parse(path).iter('SourceProxy')}
filters = [proxy for proxy in proxies.values() if proxy.find('Hints/ShowInMenu') is not None]
assert len(filters) >= 2


w = window.Window()

# With a solid selected, which is what users have, the volume map is offered.
w.open('BallSmall.vtu')
w.filter('Shape Harmonic Volume Map')
w.check(window.INPUTS + 'Domain/List0', 'currentText', 'BallSmall.vtu')
w.click(window.PANEL + 'Delete')
w.select('/0/0|0')
w.click(window.PANEL + 'Delete')

w.open('DentedSphere600.vtp')
for proxy in filters:
    w.filter(proxy.get('label'))
    for port in proxy.findall('PropertyGroup[@panel_widget="ShapeInputs"]/Property'):
        w.check(window.INPUTS + port.get('name'), 'visible', 'true')
    w.python('''
        made = GetActiveSource()
        assert made.GetXMLName() == %r, made.GetXMLName()''' % proxy.get('name'))
    w.click(window.PANEL + 'Delete')
w.python('assert len(GetSources()) == 1, GetSources()')

w.filter('Shape Parameterize')
w.apply()
w.select('/0/0|0')
w.python('assert GetActiveSource().GetXMLName() == "XMLPolyDataReader", GetActiveSource().GetXMLName()')
w.select('/0/0/0|0')
w.python('''
    made = GetActiveSource()
    assert made.GetXMLName() == 'ShapeParameterize', made.GetXMLName()
    shown = [p.Input.Port for p in GetActiveView().Representations if hasattr(p, 'Input') and p.Visibility]
    assert shown == [1], 'the image: %s' % shown
    names = [key[0] for key in GetSources()]
    assert sorted(names) == ['DentedSphere600.vtp', 'ShapeParameterize1'], names''')
w.picture('GUIParameterize.png')
w.run()
