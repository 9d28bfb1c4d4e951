"""The toolbars have their icons, which ParaView keeps as SVG: Qt draws them only with its SVG module."""
import tempfile

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

import window

TOP, BOTTOM = 22, 62  # pixel rows of the first toolbar, below the menu bar

w = window.Window()
w.fill_screen()
with tempfile.NamedTemporaryFile(suffix='.png') as file:
    w.screenshot(file.name)
    w.run()
    reader = vtkPNGReader()
    reader.SetFileName(file.name)
    reader.Update()
width, height, _ = reader.GetOutput().GetDimensions()
pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(height, width, -1)[::-1, :, :3]
toolbar = pixels[TOP:BOTTOM].astype(int)
coloured = (toolbar.max(axis=2) - toolbar.min(axis=2) > 60).any(axis=0)
icons = (numpy.diff(coloured.astype(int)) == 1).sum()
assert icons >= 15, 'the first toolbar shows %d pieces of colour' % icons
print('%d pieces of colour in the first toolbar' % icons)
