"""File > Open reads .off and .mesh files without asking which reader to take."""
import os

import window

MODELS = os.environ['SHAPEMAP_MODELS']


def open_file(w, path):
    w.click('MainControlsToolbar/actionOpenData')
    w.event('FileOpenDialog', 'filesSelected', path)
    w.apply()


w = window.Window()
open_file(w, os.path.join(MODELS, 'bunny00.off'))
w.python('''
    bunny = GetActiveSource()
    assert bunny.GetXMLName() == 'ShapeOFFReader', bunny.GetXMLName()
    assert bunny.GetDataInformation().GetNumberOfPoints() == 37706
    assert GetDisplayProperties(bunny).Visibility == 1''')
w.filter('Shape Tetrahedralize')
w.apply()
w.python('assert GetActiveSource().GetDataInformation().GetNumberOfCells() > 1000')
w.python('SaveData(%r, GetActiveSource())' % w.file('bunny.mesh'))
open_file(w, w.file('bunny.mesh'))
w.python('''
    mesh = GetActiveSource()
    assert mesh.GetXMLName() == 'ShapeMeditReader', mesh.GetXMLName()
    assert mesh.CellData['Reference'].GetRange()[0] == 1.0''')
w.run()
