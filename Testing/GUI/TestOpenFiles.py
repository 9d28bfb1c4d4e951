"""File > Open reads .off, .mesh, CAD, .nii and landmark files without asking which reader to take."""
import gzip
import os
import struct
import subprocess

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

script = w.file('box.geo')
with open(script, 'w') as file:
    file.write('SetFactory("OpenCASCADE"); Box(1) = {0, 0, 0, 3, 2, 1};')
subprocess.check_call(['gmsh', script, '-0', '-o', w.file('box.step')], stdout=subprocess.DEVNULL)
open_file(w, w.file('box.step'))
w.python('''
    box = GetActiveSource()
    assert box.GetXMLName() == 'ShapeCADReader', box.GetXMLName()
    assert box.CellData['Patch'].GetRange() == (1.0, 6.0)
    assert GetDisplayProperties(OutputPort(box, 0)).Visibility == 1''')
# A NIfTI file of 2 x 3 x 4 zeros, whose first index goes to the patient's left.
header = bytearray(352)
for offset, form, numbers in ((0, '<i', (348,)), (40, '<8h', (3, 2, 3, 4, 1, 1, 1, 1)), (70, '<2h', (2, 8)),
                              (76, '<5f', (1, 1, 1, 1, 0)), (108, '<2f', (352, 1)), (254, '<h', (1,)),
                              (280, '<12f', (-1, 0, 0, 5, 0, -1, 0, 0, 0, 0, 1, 0)), (344, '<3s', (b'n+1',))):
    struct.pack_into(form, header, offset, *numbers)
with gzip.open(w.file('scan.nii.gz'), 'wb') as file:
    file.write(bytes(header) + bytes(24))
open_file(w, w.file('scan.nii.gz'))
w.python('''
    scan = GetActiveSource()
    assert scan.GetXMLName() == 'ShapeImageReader', scan.GetXMLName()
    assert scan.GetDataInformation().GetBounds() == (-5.0, -4.0, 0.0, 2.0, 0.0, 3.0)''')
with open(w.file('nose.tps'), 'w') as file:
    file.write('LM3=1\n1 2 3\n')
open_file(w, w.file('nose.tps'))
w.python("assert GetActiveSource().GetXMLName() == 'ShapeLandmarksReader'")
w.run()
