"""The quick search (Ctrl+Space) finds each filter by every search word of its XML, and offers it exactly
when the pipeline has what the filter needs."""
import glob
import os
from xml.etree import ElementTree

import shapetesting
import window

DIALOG = 'QuickLaunchDialog'
# What a solid without a map can be an input of, or a grid of polygons, which has the same type.
SOLID = ['Shape Apply Volume Map', 'Shape Boundary Distance', 'Shape Cage Deform', 'Shape Correspondence',
         'Shape Coupling', 'Shape Deform',
         'Shape Harmonic Volume Map', 'Shape Mesh Motion', 'Shape Solidify', 'Shape Transfer Fields', 'Shape Untangle']
# What needs a solid, or a table, beside a surface.
NOT_HERE = ['Shape Untangle', 'Shape From Operators']
# What needs an image or a charge set, and the active source that offers it.
ACTIVE = {'Shape Label Surfaces': 'Wavelet1', 'Shape Image Values': 'BallSmall.vtu',
          'Shape Certificate': 'DentedSphereCharges.vtp'}
hints = {}
for path in glob.glob(os.path.join(shapetesting.ROOT, 'Filters', 'VTK', '*', '*.xml')):
    for proxy in ElementTree.parse(path).iter('SourceProxy'):
        if proxy.find('Hints/ShapeMap') is not None:
            hints[proxy.get('label')] = proxy.find('Hints/ShapeMap')
assert len(hints) >= 20, sorted(hints)


def search(w, text):
    """Opens the dialog and types. All letters are one key event: the dialog searches after each event."""
    w.event('menubar', 'activate', 'menuFilters')
    w.event('menubar/menuFilters', 'activate', 'Search...\tCtrl+Space')
    w.event(DIALOG, 'keyEvent', '6:%d:0:%s:0:1' % (ord(text[0].upper()), text.lower()))


def check(w, text, offered):
    """Enter would apply the filter with this label, or none if it is empty."""
    search(w, text)
    w.check(DIALOG + '/selection', 'text', offered)
    for escape in range(2):
        w.event(DIALOG, 'keyEvent', '6:%d:0::0:1' % window.ESCAPE)


# The pipeline has what each filter needs beside the active source: a surface with a map, a solid and
# a charge set.
w = window.Window()
w.open('DentedSphereCharges.vtp')
w.open('BallSmall.vtu')
for label in hints:
    if label not in ACTIVE:
        check(w, label, label if label in SOLID else '')
w.python('Show(Wavelet())')
for label, active in ACTIVE.items():
    w.python("SetActiveSource(FindSource('%s'))" % active)
    w.wait(100)
    for word in hints.pop(label).get('keywords').split(', '):
        check(w, word, label)
w.python("Show(Calculator(Input=FindSource('BallSmall.vtu'), ResultArrayName='TargetPosition', Function='coords'))")
w.wait(100)
for word in hints.pop('Shape Structured Blocks').get('keywords').split(', '):  # needs a solid with a map
    check(w, word, 'Shape Structured Blocks')
w.open('DentedSphere600.vtp')
for label, hint in hints.items():
    for word in hint.get('keywords').split(', '):
        check(w, word, '' if label in NOT_HERE else label)
search(w, 'hex mesh')
w.event(DIALOG, 'keyEvent', '6:%d:0::0:1' % window.ENTER)
w.python('''
    made = GetActiveSource()
    assert made.GetXMLName() == 'ShapeHexRemesh', made.GetXMLName()''')
w.run(280)
