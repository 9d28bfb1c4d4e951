"""A deck is opened, its nodes are moved, and File > Save Data writes the type that is chosen in the dialog: the
deck with other coordinates, of which every other byte is the same, or a new mesh of the same extension."""
import os
import tempfile

import window

TYPE = 'FileSaveDialog/mainSplitter/layoutWidget/EntityType'


def deck(far):
    """The bytes of a deck of one cube between 0 and `far`, whose title has a letter of Latin 1."""
    nodes = ''.join('%8d' % node + ''.join('%16s' % (far if node >> k & 1 else 0) for k in range(3)) + '\r\n'
                    for node in range(1, 9))
    corners = ''.join('%8d' % node for node in (8, 1, 3, 2, 4, 5, 7, 6))
    return ('*KEYWORD\r\n*TITLE\r\nW\u00fcrfel\r\n*NODE\r\n%s*ELEMENT_SOLID\r\n       1       1%s\r\n$ 1, 2, 3\r\n*END' % (
        nodes, corners)).encode('latin-1')


original = os.path.join(tempfile.mkdtemp(), 'cube.k')
with open(original, 'wb') as file:
    file.write(deck('1'))

w = window.Window()
w.open_path(original)
w.python('''
    moved = Calculator(Input=GetActiveSource(), CoordinateResults=1, Function='2*coords')
    moved.UpdatePipeline()
    SetActiveSource(moved)''')
w.select('/0/0/0|0')


def save(kind, extensions):
    """Saves as a type of file, and returns the path."""
    path = w.file(kind.replace(' ', '') + '.k')
    w.menu('menu_File', 'actionFileSaveData')
    w.wait(200)
    # The player of events cannot choose a type in this dialog. The keyboard can: the type comes after the name.
    w.python('''
        import subprocess
        subprocess.check_call(['xdotool', 'key', 'Tab', 'type', '--delay', '20', %r])''' % kind)
    w.wait(200)
    w.check(TYPE, 'currentText', '%s(%s )' % (kind, extensions))
    w.event('FileSaveDialog', 'filesSelected', path)
    w.click('WriterSettingsDialog/widget/OKButton')
    return path


moved = save('Input deck with moved nodes', '*.dyn *.feb *.inp *.k *.key')
new = save('LS-DYNA keyword file', '*.k')
w.python('''
    written = [open(path, 'rb').read() for path in %r]
    assert written[0] == %r, written[0]
    assert written[1].startswith(b'*KEYWORD') and b'Region0' in written[1] and b'*TITLE' not in written[1], written[1]
    assert open(%r, 'rb').read() == %r''' % ([moved, new], deck('2.'), original, deck('1')))
w.run()
