"""File > Save Data writes a mesh for Abaqus, with the element that the user chooses in the dialog, and one for
OpenFOAM, which is a folder beside the file."""
import window

DIALOG = 'WriterSettingsDialog/'
WIDGETS = DIALOG + 'scrollArea/qt_scrollarea_viewport/Container/ProxyWidget/'

w = window.Window()
w.open('BallSmall.vtu')
w.menu('menu_File', 'actionFileSaveData')
w.event('FileSaveDialog', 'filesSelected', w.file('ball.inp'))
w.choose(WIDGETS + 'HexahedronType/ComboBox', 'C3D8')
w.click(DIALOG + 'widget/OKButton')
w.python('''
    text = open(%r).read()
    assert '*ELEMENT, TYPE=C3D8, ELSET=Hexahedra' in text and 'NSET=Patch0' in text''' % w.file('ball.inp'))

w.menu('menu_File', 'actionFileSaveData')
w.event('FileSaveDialog', 'filesSelected', w.file('ball.foam'))
w.click(DIALOG + 'widget/OKButton')
w.python('''
    owner = open(%r + '/constant/polyMesh/owner').read()
    assert 'nCells:%%d ' %% GetActiveSource().GetDataInformation().GetNumberOfCells() in owner, owner[:300]
    assert open(%r).read() == ""''' % (w.folder, w.file('ball.foam')))

# The array with the regions is chosen from a list.
w.python('''
    layers = ProgrammableFilter(Input=GetActiveSource())
    layers.CopyArrays = 1
    layers.Script = ('import numpy; '
                     'output.CellData.append(numpy.arange(output.GetNumberOfCells()) // 500, "Layer")')
    layers.UpdatePipeline()
    SetActiveSource(layers)''')
w.select('/0/0/0|0')
w.menu('menu_File', 'actionFileSaveData')
w.event('FileSaveDialog', 'filesSelected', w.file('layers.inp'))
w.choose(WIDGETS + 'RegionArray/ComboBox', 'Layer')
w.click(DIALOG + 'widget/OKButton')
w.python("assert 'ELSET=Region1' in open(%r).read()" % w.file('layers.inp'))
w.run()
