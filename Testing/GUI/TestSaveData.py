"""File > Save Data writes a mesh for Abaqus, with the element that the user chooses in the dialog."""
import window

DIALOG = 'WriterSettingsDialog/'

w = window.Window()
w.open('BallSmall.vtu')
w.event('menubar', 'activate', 'menu_File')
w.event('menubar/menu_File', 'activate', 'actionFileSaveData')
w.event('FileSaveDialog', 'filesSelected', w.file('ball.inp'))
w.choose(DIALOG + 'scrollArea/qt_scrollarea_viewport/Container/ProxyWidget/HexahedronType/ComboBox', 'C3D8')
w.click(DIALOG + 'widget/OKButton')
w.python('''
    text = open(%r).read()
    assert '*ELEMENT, TYPE=C3D8, ELSET=Hexahedra' in text and 'NSET=Patch0' in text''' % w.file('ball.inp'))
w.run()
