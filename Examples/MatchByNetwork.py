"""Matches two figures by what a neural network says of their points."""
import os

import numpy
from paraview.simple import *
from vtkmodules.numpy_interface.dataset_adapter import WrapDataObject

data = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'Data', '')

# Replace this network, whose weights are random, by one that was trained for shapes like yours.
network = data + 'RandomFeatures.onnx'
a = ShapeNetworkDescriptors(Input=OpenDataFile(data + 'FigureASmall.vtp'), FileName=network)
b = ShapeNetworkDescriptors(Input=OpenDataFile(data + 'FigureBSmall.vtp'), FileName=network)
match = ShapeCorrespondence(
    SurfaceA=a, SurfaceB=b, Method='FunctionalMap', Descriptors='Given', DescriptorArrays=['NetworkDescriptors'])
match.UpdatePipeline()

# The true image of point i of A is point i of B.
found, truth = (WrapDataObject(servermanager.Fetch(source)) for source in (match, b))
errors = numpy.linalg.norm(found.PointData['TargetPosition'] - truth.Points, axis=1)
height = numpy.ptp(truth.Points[:, 1])
print('%d descriptors; half of the images are within %.1f %% of the height' % (
    found.PointData['NetworkDescriptors'].shape[1], 100 * numpy.median(errors) / height))
assert numpy.median(errors) < 0.1 * height
