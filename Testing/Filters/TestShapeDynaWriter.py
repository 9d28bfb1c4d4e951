"""Shape Dyna Writer: a keyword file with parts and sets, in fixed columns.

As an example: tetrahedra of a box are saved for a model that includes them."""
import os
import tempfile

import numpy
from paraview import simple
from paraview.modules.vtkRemotingServerManager import vtkSMProxyManager
from vtkmodules.vtkFiltersSources import vtkCellTypeSource

import shapetesting

# The example.
box = vtkCellTypeSource()
box.SetCellType(10)
box.SetBlocksDimensions(2, 3, 2)
box.Update()
source = simple.TrivialProducer()
source.GetClientSideObject().SetOutput(box.GetOutput())
path = os.path.join(tempfile.mkdtemp(), 'box.k')
simple.SaveData(path, source, FeatureAngle=45)
listed = vtkSMProxyManager.GetProxyManager().GetWriterFactory().GetSupportedFileTypes(source.SMProxy, 0)
assert 'LS-DYNA keyword file(*.k )' in listed, listed

cards = {}
for line in open(path).read().splitlines():
    if line.startswith('*'):
        keyword = line
        cards.setdefault(keyword, [])
    elif not line.startswith('$'):
        cards[keyword].append(line)
places = numpy.array([[float(line[8 + 16 * k:24 + 16 * k]) for k in range(3)] for line in cards['*NODE']])
assert abs(places - shapetesting.points(box.GetOutput())).max() < 1e-9
solids = numpy.array([[int(line[8 * k:8 * k + 8]) for k in range(10)] for line in cards['*ELEMENT_SOLID']])
assert (solids[:, 0] == numpy.arange(len(solids)) + 1).all() and (solids[:, 1] == 1).all()
assert (solids[:, 5:] == solids[:, 5:6]).all(), 'a tetrahedron repeats its fourth node'
a, b, c, d = places[solids[:, 2:6] - 1].transpose(1, 0, 2)
volumes = (numpy.cross(b - a, c - a) * (d - a)).sum(axis=1) / 6.0
assert volumes.min() > 0.0 and abs(volumes.sum() - 12.0) < 1e-9
assert cards['*PART'] == ['Region0', '         1']

# Six patches, whose segments enclose the box.
lines = cards['*SET_SEGMENT_TITLE']
assert [line for line in lines if line.startswith('Patch')] == ['Patch%d' % n for n in range(6)]
segments = numpy.array([[int(line[10 * k:10 * k + 10]) for k in range(4)] for line in lines if len(line) == 40])
assert (segments[:, 2] == segments[:, 3]).all(), 'a triangle repeats its third node'
a, b, c = places[segments[:, :3] - 1].transpose(1, 0, 2)
assert abs((numpy.cross(b, c) * a).sum() / 6.0 - 12.0) < 1e-9
print('the file has the nodes, solids, parts and sets of the box')
