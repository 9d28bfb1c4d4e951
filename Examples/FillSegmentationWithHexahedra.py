"""Fills the regions of a segmented image with hexahedra that share the points of their interfaces."""
import os
import sys

import shapemap
from paraview.simple import *
from vtkmodules.numpy_interface.dataset_adapter import WrapDataObject

folder = sys.argv[1] if len(sys.argv) > 1 else '.'

# A ball of two halves, as an image of labels. Your own: OpenDataFile('segmentation.nrrd').
image = Calculator(Input=Wavelet(WholeExtent=[-10, 10] * 3), ResultArrayName='Label',
                   Function='if(coordsX^2 + coordsY^2 + coordsZ^2 < 64, if(coordsX > 0.3, 2, 1), 0)')
# Without Surface=None, ParaView would also connect the active source, the image, to Surface.
hexahedra = ShapeHexRemesh(Surface=None, Labels=image, LabelArray='Label', CellSize=2.0)
hexahedra.UpdatePipeline()

facts = shapemap.facts(hexahedra)
cells = WrapDataObject(servermanager.Fetch(hexahedra)).CellData
for label, count, volume in zip(facts['RegionLabels'], facts['RegionHexahedra'], facts['RegionVolumes']):
    print('region %d: %d hexahedra, volume %.1f' % (label, count, volume))
    assert count == (cells['RegionId'] == label).sum()
assert cells['ScaledJacobian'].min() > 0.0

# The deck has a set of elements for each region, and a set of nodes for the interface.
path = os.path.join(folder, 'SegmentationHexahedra.inp')
SaveData(path, hexahedra)
assert all(name in open(path).read() for name in ('Region1', 'Region2', 'Interface1_2'))
