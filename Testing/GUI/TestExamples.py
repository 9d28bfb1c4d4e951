"""Sources > ShapeMap > Shape Example: a shape is chosen from the list, and the panel says what to try."""
import window

w = window.Window()
w.event('menubar', 'activate', 'menuSources')
w.event('menubar/menuSources/ShapeMap', 'activate', 'Shape Example')
w.choose(window.PROPERTIES + 'Shape/ComboBox', 'Two-Holed Torus')
w.apply()
w.python('''
    example = GetActiveSource()
    assert example.GetXMLName() == 'ShapeExample', example.GetXMLName()
    assert example.GetDataInformation().GetNumberOfPoints() == 1668
    assert GetDisplayProperties(example).Visibility == 1
    words = example.SMProxy.GetProperty('TryNext').GetElement(0)
    assert words.startswith('Shape Hex Remesh'), words''')
# A solid after a surface, from the same panel.
w.choose(window.PROPERTIES + 'Shape/ComboBox', 'Ball of Hexahedra')
w.apply()
w.python('''
    assert GetActiveSource().GetDataInformation().GetDataSetTypeAsString() == 'vtkUnstructuredGrid'
    assert GetDisplayProperties(GetActiveSource()).Visibility == 1''')
w.run()
