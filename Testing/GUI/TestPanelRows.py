"""The rows of the panel: enumerations in words, what 0 means, rows that a method does not use, and a selection
that is missing."""
import window

w = window.Window()
w.open('DentedSphere600.vtp')

# 0 has a word beside it, other values have none.
w.filter('Shape Hex Remesh')
w.check(window.PROPERTIES + 'CellSize/Zero', 'text', 'automatic')
w.check(window.PROPERTIES + 'CellSize/Zero', 'visible', 'true')
w.event(window.PROPERTIES + 'CellSize/DoubleLineEdit0', 'set_string', '0.4')
w.check(window.PROPERTIES + 'CellSize/Zero', 'visible', 'false')
# Before the first Apply, the number of cells is estimated.
w.check(window.PROPERTIES + 'CellSize/CellCount', 'visible', 'true')
w.check(window.PROPERTIES + 'CellSize/CellCount', 'text', '\u2248 160 cells')
w.event(window.PROPERTIES + 'CellSize/DoubleLineEdit0', 'set_string', '0.1')
w.check(window.PROPERTIES + 'CellSize/CellCount', 'text', '\u2248 5,700 cells')
w.event(window.PROPERTIES + 'CellSize/DoubleLineEdit0', 'set_string', '0')
w.check(window.PROPERTIES + 'CellSize/CellCount', 'visible', 'false')
w.check(window.PROPERTIES + 'CellSize/Zero', 'visible', 'true')
w.event(window.PROPERTIES + 'CellsOnLongestSide/LineEdit0', 'set_string', '20')
w.check(window.PROPERTIES + 'CellsOnLongestSide/CellCount', 'text', '\u2248 4,400 cells')
w.event(window.PROPERTIES + 'CellsOnLongestSide/LineEdit0', 'set_string', '0')
w.check(window.PROPERTIES + 'CellsOnLongestSide/Zero', 'text', 'not used')
w.click(window.PANEL + 'Delete')

# The words are shown; the property, and with it scripts, keep the value.
w.filter('Shape Correspondence')
w.check(window.PROPERTIES + 'Method/ComboBox', 'currentText', 'Reversible Harmonic')
w.choose(window.PROPERTIES + 'Start/ComboBox', 'Landmark Cells')
w.check(window.PROPERTIES + 'Part', 'visible', 'true')
w.choose(window.PROPERTIES + 'Method/ComboBox', 'Gromov Wasserstein')
w.check(window.PROPERTIES + 'Part', 'visible', 'false')
w.check(window.PROPERTIES + 'Samples', 'visible', 'true')
w.check(window.PROPERTIES + 'Start', 'visible', 'false')
w.click(window.PANEL + 'Delete')
w.filter('Shape Parameterize')
w.choose(window.PROPERTIES + 'Domain/ComboBox', 'Free Boundary')
w.choose(window.PROPERTIES + 'Domain/ComboBox', 'Sphere')
w.apply()
w.python("assert GetActiveSource().Domain == 'Sphere', GetActiveSource().Domain")
w.click(window.PANEL + 'Delete')

# Copy Active Selection without a selection says what is missing.
w.filter('Shape Cut Feature')
w.wait(100)
w.check(window.PROPERTIES + 'Selection/NothingSelected', 'visible', 'false')
w.click(window.PROPERTIES + 'Selection/Selection/pushButtonCopySelection')
w.check(window.PROPERTIES + 'Selection/NothingSelected', 'visible', 'true')

# Draw Loop shows the surface to draw on.
w.python('''
    surface = FindSource('DentedSphere600.vtp')
    Hide(surface)''')
w.event(window.PROPERTIES + 'ShapeLoop/DrawLoop', 'set_boolean', 'true')
w.wait(100)
w.python('assert GetDisplayProperties(surface).Visibility == 1')
w.run()
