"""Couples a figure with its skeleton by the distances along both."""
import os

import numpy
from paraview.simple import *
from vtkmodules.numpy_interface.dataset_adapter import WrapDataObject

data = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'Data', '')

figure = OpenDataFile(data + 'FigureASmall.vtp')
skeleton = ShapeSkeleton(Input=figure)
coupled = ShapeCoupling(ShapeA=figure, ShapeB=skeleton)
coupled.UpdatePipeline()
found = WrapDataObject(servermanager.Fetch(coupled))
images = numpy.array(found.PointData['TargetPosition'])

# A limb goes to its own centreline, or to that of the other side: distances do not tell left from right.
sideways = numpy.abs(images[:, [0, 2]]) - numpy.abs(found.Points[:, [0, 2]])
print('%d points of the skeleton are images; mean distance %.3f of a height of %.2f' % (
    len(numpy.unique(images, axis=0)), numpy.linalg.norm(sideways, axis=1).mean(), numpy.ptp(found.Points[:, 2])))
assert numpy.linalg.norm(sideways, axis=1).mean() < 0.1 * numpy.ptp(found.Points[:, 2])
SaveData('coupled.vtp', coupled, DataMode='Binary')
