"""Shape Exodus Writer: element blocks, side sets and node sets that ParaView's own reader lists.

As an example: a bar of two materials is saved as .exo, and opened again."""
import os
import tempfile

import numpy
from paraview import simple
from paraview.modules.vtkRemotingServerManager import vtkSMProxyManager
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOExodus import vtkExodusIIReader

import calculix
from shapetesting import points

# The example.
bar = calculix.block((4, 2, 2), (2.0, 1.0, 1.0))
corners = vtk_to_numpy(bar.GetCells().GetConnectivityArray()).reshape(-1, 8)
places = points(bar) / 3.0
materials = (points(bar)[corners].mean(axis=1)[:, 0] > 1.0).astype(int)
source = simple.TrivialProducer()
source.GetClientSideObject().SetOutput(calculix.hexahedra(places, corners, materials))
path = os.path.join(tempfile.mkdtemp(), 'bar.exo')
simple.SaveData(path, source, FeatureAngle=45)
listed = vtkSMProxyManager.GetProxyManager().GetWriterFactory().GetSupportedFileTypes(source.SMProxy, 0)
assert listed.count('*.exo ') == 1 and 'Exodus II mesh(*.exo )' in listed, listed
opened = simple.OpenDataFile(path)
opened.UpdatePipeline()
assert opened.GetDataInformation().GetNumberOfCells() == len(corners)

reader = vtkExodusIIReader()
reader.SetFileName(path)
reader.UpdateInformation()
names = {}
for kind in (reader.ELEM_BLOCK, reader.SIDE_SET, reader.NODE_SET):
    count = reader.GetNumberOfObjects(kind)
    names[kind] = {reader.GetObjectName(kind, i): (
        reader.GetObjectId(kind, i), reader.GetNumberOfEntriesInObject(kind, i)) for i in range(count)}
    for i in range(count):
        reader.SetObjectStatus(kind, i, 1)
reader.Update()
assert names[reader.ELEM_BLOCK] == {'Region0': (1, 8), 'Region1': (2, 8)}, names
sets = ['Patch%d' % k for k in range(6)] + ['Interface0_1']
for kind, sizes in ((reader.SIDE_SET, [4, 4, 4, 8, 8, 8, 8]), (reader.NODE_SET, [9, 9, 9, 15, 15, 15, 15])):
    assert [names[kind][name][0] for name in sets] == [1, 2, 3, 4, 5, 6, 7]
    assert sorted(names[kind][name][1] for name in sets) == sizes, names[kind]


def blocks(kind):
    """The data sets of a kind, by name."""
    group = reader.GetOutput().GetBlock({reader.ELEM_BLOCK: 0, reader.SIDE_SET: 4, reader.NODE_SET: 7}[kind])
    return {group.GetMetaData(i).Get(group.NAME()).split()[-1]: group.GetBlock(i)
            for i in range(group.GetNumberOfBlocks())}


# Blocks have the cells of their region, in order. This reader rounds to single precision.
for region in (0, 1):
    block = blocks(reader.ELEM_BLOCK)['Region%d' % region]
    read = points(block)[vtk_to_numpy(block.GetCells().GetConnectivityArray()).reshape(-1, 8)]
    assert (read == places[corners[materials == region]].astype(numpy.float32)).all()

# The side sets of patches enclose the bar, and that of the interface faces out of region 0.
enclosed = 0.0
for name, block in blocks(reader.SIDE_SET).items():
    nodes = points(blocks(reader.NODE_SET)[name])
    assert {tuple(node) for node in nodes} == {tuple(node) for node in points(block)}, name
    a, b, c, d = points(block)[vtk_to_numpy(block.GetCells().GetConnectivityArray()).reshape(-1, 4)].transpose(1, 0, 2)
    if name.startswith('Patch'):
        enclosed += sum((numpy.cross(p - a, q - a) * a).sum() for p, q in ((b, c), (c, d))) / 6.0
    else:
        assert (numpy.cross(b - a, c - a)[:, 0] > 0.0).all()
assert abs(enclosed - 2.0 / 27.0) < 1e-6, enclosed
print('ParaView reads', ', '.join(names[reader.ELEM_BLOCK]), 'and', len(sets), 'sets')
