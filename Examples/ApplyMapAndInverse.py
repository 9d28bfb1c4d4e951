"""Saves a volume map, applies it to other data, and moves these back by its inverse."""
import os
import sys

import shapemap
from paraview.simple import *
from vtkmodules.numpy_interface.dataset_adapter import WrapDataObject

folder = sys.argv[1] if len(sys.argv) > 1 else '.'
data = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'Data', '')

# The solid of a dented sphere, mapped to the unit ball by the map of its boundary.
dented = OpenDataFile(data + 'DentedSphere600.vtp')
solid = ShapeTetrahedralize(Input=dented)
made = ShapeHarmonicVolumeMap(Domain=solid, Boundary=dented, MapArray='TargetPosition')
# The charges store the map. It can be loaded from their file later, without computing it again.
SaveData(os.path.join(folder, 'Map.vtp'), OutputPort(made, 1), DataMode='Binary')
charges = OpenDataFile(os.path.join(folder, 'Map.vtp'))

line = Line(Point1=[-0.5, 0, 0], Point2=[0.5, 0.2, 0.1], Resolution=100)
there = ShapeApplyVolumeMap(Input=line, Map=charges)
back = ShapeApplyVolumeMap(Input=there, Map=charges, Inverse=1)
lengths = [IntegrateVariables(Input=proxy) for proxy in (line, there, back)]
for name, proxy in zip(('line', 'mapped', 'back'), lengths):
    proxy.UpdatePipeline()
    print('%s: %.4f long' % (name, proxy.CellData['Length'].GetRange()[0]))

start, end = (WrapDataObject(servermanager.Fetch(proxy)).Points for proxy in (line, back))
print('the inverse moves points back to the start within %.1e' % abs(start - end).max())
assert abs(start - end).max() < 1e-6
assert shapemap.facts(there)['OutsidePoints'] == 0
