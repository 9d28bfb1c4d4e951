"""Shape HTML Writer: Chromium shows the page, and its cut and filter show the cells that VTK counts.

As an example: a solid of hexahedra with its quality is saved as a page."""
import os
import re
import subprocess
import tempfile

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader
from paraview import simple
from paraview.modules.vtkRemotingServerManager import vtkSMProxyManager
import shapemap

import shapetesting

folder = tempfile.mkdtemp()
page = os.path.join(folder, 'bar.html')
surface = simple.ShapeExample(Shape='Bent Bar')
hexahedra = simple.ShapeHexRemesh(Surface=surface, Method='Grid', CellsOnLongestSide=16)
simple.SaveData(page, hexahedra, Title='A bent bar')
assert os.path.getsize(page) < 400000, os.path.getsize(page)


def chromium(address, *options):
    """What Chromium prints, with the page drawn in software and without a network."""
    run = subprocess.run(
        ['chromium', '--headless', '--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader',
         '--enable-logging=stderr', '--user-data-dir=' + os.path.join(folder, 'profile'),
         '--host-resolver-rules=MAP * ~NOTFOUND', '--window-size=1000,700', '--force-device-scale-factor=2',
         '--virtual-time-budget=20000', *options, address],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=180)
    assert run.returncode == 0 and 'CONSOLE' not in run.stderr, run.stderr
    return run.stdout


def shown(path, view=''):
    """(cells shown, cells)."""
    found = re.search(r'id="status">(\d+) of (\d+) cells', chromium('file://' + path + view, '--dump-dom'))
    assert found, 'the page did not load'
    return tuple(int(number) for number in found.groups())


def pixels(path, view=''):
    """The colours of the drawing, without the panel."""
    picture = os.path.join(folder, 'page.png')
    chromium('file://' + path + view, '--screenshot=' + picture)
    reader = vtkPNGReader()
    reader.SetFileName(picture)
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    assert width == 2000, 'as fine as the screen'
    colors = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)
    return colors[:, :1380, :3].astype(int)


solid = shapetesting.output(hexahedra)
cells = solid.GetNumberOfCells()
quality = vtk_to_numpy(solid.GetCellData().GetArray('ScaledJacobian')).astype(numpy.float32)
corners = vtk_to_numpy(solid.GetCells().GetConnectivityArray()).reshape(-1, 8)
places = shapetesting.points(solid)
centres = places[corners].mean(axis=1)
assert shown(page) == (cells, cells)
low, high = places.min(axis=0), places.max(axis=0)
for view, expected in (
        ('#axis=+X&cut=0.43', centres[:, 0] <= low[0] + 0.43 * (high[0] - low[0])),
        ('#axis=-Z&cut=0.6', centres[:, 2] >= low[2] + 0.6 * (high[2] - low[2])),
        ('#filter=ScaledJacobian&from=0&to=0.7',
         quality <= quality.min() + 0.7 * (quality.max() - quality.min()))):
    assert 0 < expected.sum() < cells
    assert shown(page, view) == (expected.sum(), cells), (view, shown(page, view), expected.sum())

# The picture: a shape in several colours on white, which the cut and the filter change.
whole = pixels(page)
drawn = (whole < 250).any(axis=2)
assert 0.03 < drawn.mean() < 0.6, drawn.mean()
assert len(numpy.unique(whole[drawn] // 16, axis=0)) > 20
for view in ('#axis=+X&cut=0.43', '#filter=ScaledJacobian&to=0.7', '#edges=0', '#color=Volume'):
    other = pixels(page, view)
    assert (abs(other - whole).max(axis=2) > 30).mean() > 0.002, view

# Surfaces too: polygons, with arrays of points.
path = os.path.join(folder, 'surface.html')
simple.SaveData(path, surface)
assert shown(path, '#color=TargetPosition (X)') == (1296, 1296), shown(path)

# Edges are lines around the cells, and where the cells are too small to be told apart, they do not cover them.
def dark(path, view=''):
    """The share of the drawing that is as dark as edges are."""
    picture = pixels(path, view)
    drawn = (picture < 250).any(axis=2)
    return ((picture.max(axis=2) < 50) & drawn).sum() / drawn.sum()


dense = simple.Sphere(ThetaResolution=200, PhiResolution=200)
path = os.path.join(folder, 'dense.html')
simple.SaveData(path, simple.Elevation(Input=dense, LowPoint=[0, 0, -0.5], HighPoint=[0, 0, 0.5]))
edges, crowded = dark(page) - dark(page, '#edges=0'), dark(path)
print('edges darken %.3f of the bar and %.3f of a dense sphere' % (edges, crowded))
assert 0.02 < edges < 0.06 and crowded < 0.01

# File > Save Data lists it for both, and what it cannot write is said.
factory = vtkSMProxyManager.GetProxyManager().GetWriterFactory()
for source in (surface, hexahedra):
    assert 'ShapeMap web page(*.html )' in factory.GetSupportedFileTypes(source.SMProxy, 0)
messages = []
writer = shapemap.vtkShapeHTMLWriter()
writer.AddObserver('ErrorEvent', lambda *_: messages.append('refused'))
writer.SetInputData(shapetesting.closed_curve([[0, 0, 0], [1, 0, 0], [0, 1, 0]]))
writer.SetFileName(page)
before = os.path.getsize(page)
assert not writer.Write() and messages
print('%d hexahedra in %d bytes' % (cells, before))
