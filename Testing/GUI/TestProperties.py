"""Shape Harmonic Volume Map in the window: inputs from the panel, every property under its
label, the words of the enumerations, Apply, undo and redo."""
import os
import re
from xml.etree import ElementTree

import shapetesting
import window

xml = ElementTree.parse(
    os.path.join(shapetesting.ROOT, 'Filters', 'VTK', 'Harmonic', 'vtkShapeHarmonicVolumeMap.xml'))
properties = [item for item in xml.getroot().iter()
              if item.tag.endswith('VectorProperty') and item.get('panel_visibility') != 'never']
assert len(properties) >= 10
METHOD, = [item.get('default_values') for item in properties if item.get('name') == 'Method']


def is_usual(item):
    """Whether the row is there with the default Method."""
    decorator = item.find('Hints//PropertyWidgetDecorator[@property="Method"]')
    return decorator is None or METHOD in (decorator.get('values') or decorator.get('value')).split()


usual = [item for item in properties if is_usual(item)]
assert [item.get('name') for item in properties if item not in usual] == ['Tetrahedra']


def words(value):
    """How the panel shows a value of an enumeration."""
    return re.sub('([a-z])([A-Z])', r'\1 \2', value)


def check_labels(w, shown):
    """The panel has these rows from top to bottom."""
    row = 0
    for item in shown:
        if item.find('BooleanDomain') is None: # a check box is its own label
            w.check(window.PROPERTIES + '1QLabel%d' % row, 'text', '<p>%s</p>' % item.get('label'))
            row += 1
        w.check(window.PROPERTIES + item.get('name'), 'visible', 'true')


w = window.Window()
w.open('DentedSphere600.vtp')
w.filter('Shape Parameterize')
w.apply()
w.open('BallSmall.vtu')

w.filter('Shape Harmonic Volume Map')
w.check(window.INPUTS + 'Domain/List0', 'currentText', 'BallSmall.vtu')
w.choose_inputs(Boundary='ShapeParameterize1: Image')

check_labels(w, [item for item in usual if item.get('panel_visibility') != 'advanced'])
w.event(window.PANEL + 'SearchBox/AdvancedButton', 'set_boolean', 'true')
check_labels(w, usual)
for method, visible in (('Finite Elements', 'true'), ('Accelerated', 'false')):
    w.choose(window.PROPERTIES + 'Method/ComboBox', method)
    w.check(window.PROPERTIES + 'Tetrahedra', 'visible', visible)

for item in properties:
    for entry in sorted(item.iter('Entry'), key=lambda e: e.get('value') == item.get('default_values')):
        w.choose(window.PROPERTIES + item.get('name') + '/ComboBox', words(entry.get('text')))

# Apply: the ball fills the dented sphere.
w.choose(window.PROPERTIES + 'MapArray/ComboBox', 'SourcePosition')
w.apply()
w.python('''
    import numpy
    made = GetActiveSource()
    assert made.GetXMLName() == 'ShapeHarmonicVolumeMap', made.GetXMLName()
    assert made.MapArray == 'SourcePosition' and made.Method == 'Accelerated'
    assert GetRepresentation(made).Visibility == 1
    moved = numpy.array(made.GetDataInformation().GetBounds())
    wanted = numpy.array(FindSource('DentedSphere600.vtp').GetDataInformation().GetBounds())
    assert abs(moved - wanted).max() < 0.05, (moved, wanted)
    render = [view for view in GetViews() if view.GetXMLName() == 'RenderView']
    assert len(render) == 1
    SetActiveView(render[0])
    for port in range(1, 3):
        Hide(OutputPort(made, port))
    Hide(OutputPort(FindSource('ShapeParameterize1'), 0))
    Hide(OutputPort(FindSource('ShapeParameterize1'), 1))''')
w.select('/0/2/0|0')
w.event('variableToolbar/displayColor/Variables', 'activated', 'SourcePosition')
w.event('variableToolbar/displayColor/Components', 'activated', 'X')
w.picture('GUIHarmonicVolumeMap.png')

# Undo and redo.
tolerance = window.PROPERTIES + 'Tolerance/DoubleLineEdit0'
w.check(tolerance, 'text', '0.0001')
w.event(tolerance, 'set_string', '0.02')
w.apply()
w.event('menubar/menu_Edit', 'activate', 'actionEditUndo')
w.check(tolerance, 'text', '0.0001')
w.event('menubar/menu_Edit', 'activate', 'actionEditRedo')
w.check(tolerance, 'text', '0.02')
w.python('''
    tolerance = GetActiveSource().Tolerance
    assert tolerance == 0.02, tolerance''')
w.run()
