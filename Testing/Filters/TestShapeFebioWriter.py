"""Shape Febio Writer: the mesh section of a model, with parts, surfaces and node sets.

As an example: a bar of two materials is saved for a model that includes it."""
import os
import tempfile
from xml.etree import ElementTree

import numpy
from paraview import simple
from paraview.modules.vtkRemotingServerManager import vtkSMProxyManager
from vtkmodules.util.numpy_support import vtk_to_numpy

import calculix
from shapetesting import points

# The example.
bar = calculix.block((4, 2, 2), (2.0, 1.0, 1.0))
corners = vtk_to_numpy(bar.GetCells().GetConnectivityArray()).reshape(-1, 8)
places = points(bar) / 3.0
materials = (points(bar)[corners].mean(axis=1)[:, 0] > 1.0).astype(int)
source = simple.TrivialProducer()
source.GetClientSideObject().SetOutput(calculix.hexahedra(places, corners, materials))
path = os.path.join(tempfile.mkdtemp(), 'bar.feb')
simple.SaveData(path, source, FeatureAngle=45)
listed = vtkSMProxyManager.GetProxyManager().GetWriterFactory().GetSupportedFileTypes(source.SMProxy, 0)
assert 'FEBio mesh(*.feb )' in listed, listed

root = ElementTree.parse(path).getroot()
assert root.tag == 'febio_spec' and root.get('version') == '4.0'
mesh = root.find('Mesh')


def numbers(element, kind=int):
    return [kind(word) for word in element.text.split(',')]


nodes = mesh.find('Nodes')
assert [int(node.get('id')) for node in nodes] == list(range(1, len(places) + 1))
assert (numpy.array([numbers(node, float) for node in nodes]) == places).all()
for material in (0, 1):
    part = mesh.find("Elements[@name='Region%d']" % material)
    assert part.get('type') == 'hex8'
    cells = numpy.flatnonzero(materials == material)
    assert [int(element.get('id')) for element in part] == list(cells + 1)
    assert (numpy.array([numbers(element) for element in part]) == corners[cells] + 1).all()

# The surfaces enclose the bar; their node sets have their nodes.
enclosed = 0.0
for surface in mesh.findall('Surface'):
    quads = numpy.array([numbers(face) for face in surface]) - 1
    nodes = mesh.find("NodeSet[@name='%s']" % surface.get('name'))
    assert sorted(set(quads.ravel() + 1)) == numbers(nodes)
    a, b, c, d = places[quads].transpose(1, 0, 2)
    if surface.get('name').startswith('Patch'):
        enclosed += sum((numpy.cross(p - a, q - a) * a).sum() for p, q in ((b, c), (c, d))) / 6.0
    else:
        assert surface.get('name') == 'Interface0_1' and len(quads) == 4
        assert (numpy.cross(b - a, c - a)[:, 0] > 0.0).all(), 'faces out of region 0'
assert abs(enclosed - 2.0 / 27.0) < 1e-12
print('the file has the nodes, parts, surfaces and node sets of the bar')
