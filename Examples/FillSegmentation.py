"""Fills the regions of a segmented image with tetrahedra that share the points of their interfaces."""
import os
import sys

import numpy
import shapemap
from paraview.simple import *
from vtkmodules.numpy_interface.dataset_adapter import WrapDataObject

folder = sys.argv[1] if len(sys.argv) > 1 else '.'

# A ball of two halves, as an image of labels. Your own: OpenDataFile('segmentation.nrrd').
image = Calculator(Input=Wavelet(WholeExtent=[-14, 14] * 3), ResultArrayName='Label',
                   Function='if(coordsX^2 + coordsY^2 + coordsZ^2 < 121, if(coordsX + 0.4 * coordsZ > 0, 2, 1), 0)')
surfaces = ShapeLabelSurfaces(Input=image, LabelArray='Label')
solid = ShapeTetrahedralize(Input=surfaces)
sizes = CellSize(Input=solid)
sizes.UpdatePipeline()

facts = shapemap.facts(surfaces)
cells = WrapDataObject(servermanager.Fetch(sizes)).CellData
for label, enclosed, voxels in zip(facts['Labels'], facts['Volumes'], facts['VoxelVolumes']):
    volumes = cells['Volume'][cells['RegionId'] == label]
    print('region %d: %d tetrahedra, volume %.1f' % (label, len(volumes), numpy.sum(volumes)))
    assert volumes.min() > 0.0 and abs(numpy.sum(volumes) - enclosed) < 1e-9 * enclosed
    assert abs(enclosed - voxels) < 1e-3 * voxels

# The regions and the faces between them are named groups of the mesh.
SaveData(os.path.join(folder, 'Segmentation.msh'), solid)
