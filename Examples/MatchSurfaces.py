"""Finds the correspondence of two figures without landmarks, and transfers a field along it."""
import os
import sys

import numpy
import shapemap
from paraview.simple import *
from vtkmodules.numpy_interface.dataset_adapter import WrapDataObject

folder = sys.argv[1] if len(sys.argv) > 1 else '.'
data = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'Data', '')

# Two poses of a figure. Without landmarks the filter finds its own.
a = OpenDataFile(data + 'FigureASmall.vtp')
b = OpenDataFile(data + 'FigureBSmall.vtp')
match = ShapeCorrespondence(SurfaceA=a, SurfaceB=b, Method='FunctionalMap')
match.UpdatePipeline()

# The true map is known here: it is the array TargetPosition of the file.
a.UpdatePipeline()
found, truth = (numpy.array(WrapDataObject(servermanager.Fetch(proxy)).PointData['TargetPosition'])
                for proxy in (match, a))
error = numpy.linalg.norm(found - truth, axis=1).mean() / numpy.ptp(truth, axis=0).max()
print('landmarks found: %d' % shapemap.facts(match)['Landmarks'])
print('mean error: %.2f %% of the size' % (100 * error))
assert error < 0.03

# Transfer a field of B to A: its height.
height = Calculator(Input=b, ResultArrayName='Height', Function='coordsZ')
coloured = ShapeTransferFields(Input=match, Source=height)
coloured.UpdatePipeline()
print('height on A: %.2f to %.2f' % coloured.PointData['Height'].GetRange())
SaveData(os.path.join(folder, 'Coloured.vtp'), coloured, DataMode='Binary')
