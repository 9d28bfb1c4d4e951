"""Fills a head with tetrahedra in three regions: scalp, skull and brain."""
import os
import sys

import numpy
import shapemap
from paraview.simple import *
from vtkmodules.numpy_interface.dataset_adapter import WrapDataObject

folder = sys.argv[1] if len(sys.argv) > 1 else '.'
data = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'Data', 'Phantom%sSmall.vtp')

head, skull, brain = (OpenDataFile(data % name) for name in ('Head', 'Skull', 'Brain'))
solid = ShapeTetrahedralize(Input=head, InnerSurfaces=[skull, brain])
sizes = CellSize(Input=solid)
sizes.UpdatePipeline()

cells = WrapDataObject(servermanager.Fetch(sizes)).CellData
for region, name in enumerate(('scalp', 'skull', 'brain')):
    volumes = cells['Volume'][cells['RegionId'] == region]
    print('%s: %d tetrahedra, volume %.3f' % (name, len(volumes), numpy.sum(volumes)))
    assert volumes.min() > 0.0
total = shapemap.facts(solid)['Volume']
print('all: %d tetrahedra, volume %.3f' % (len(cells['Volume']), total))
assert abs(numpy.sum(cells['Volume']) - total) < 1e-9 * total

# Threshold extracts one region. The file for Gmsh has all regions, with their numbers.
bone = Threshold(Input=solid, Scalars=['CELLS', 'RegionId'], LowerThreshold=1, UpperThreshold=1)
bone.UpdatePipeline()
assert bone.CellData['RegionId'].GetRange() == (1, 1)
SaveData(os.path.join(folder, 'Head.mesh'), solid)
