"""A deck is opened, its nodes are moved, and File > Save Data writes it as the chosen file type: a deck with
moved nodes, or a new mesh of the same extension."""
import os
import tempfile

import window

DIALOG = 'WriterSettingsDialog/'
TYPE = 'FileSaveDialog/FileType'
folder = tempfile.mkdtemp()
DECK = '*KEYWORD\n*TITLE\nKeep this\n*NODE\n' + ''.join(
    '%8d%16d%16d%16d\n' % (node, node % 2, node // 2 % 2, node // 4) for node in range(1, 9)) + (
    '*ELEMENT_SOLID\n       1       1' + ''.join('%8d' % node for node in (8, 1, 3, 2, 4, 5, 7, 6)) + '\n*END\n')
path = os.path.join(folder, 'cube.k')
with open(path, 'w') as file:
    file.write(DECK)

w = window.Window()
w.open_path(path)
w.python('''
    deck = GetActiveSource()
    assert deck.GetXMLName() == 'ShapeDeckReader', deck.GetXMLName()
    moved = Calculator(Input=deck, CoordinateResults=1, Function='2*coords')
    moved.UpdatePipeline()
    SetActiveSource(moved)''')
w.select('/0/0/0|0')
for name, words in (('Input deck with moved nodes', 'Keep this'), ('LS-DYNA keyword file', 'ShapeMap')):
    w.menu('menu_File', 'actionFileSaveData')
    w.event(TYPE, 'set_string', name)
    w.event('FileSaveDialog', 'filesSelected', w.file('moved.k'))
    w.click(DIALOG + 'widget/OKButton')
    w.python('assert %r in open(%r).read(), open(%r).read()' % (words, w.file('moved.k'), w.file('moved.k')))
w.run()
