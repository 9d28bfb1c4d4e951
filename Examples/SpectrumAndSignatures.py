"""Computes the Laplace spectrum of a figure, and signatures that distinguish its parts."""
import os

import numpy
from paraview.simple import *
from vtkmodules.numpy_interface.dataset_adapter import WrapDataObject

data = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'Data', '')

figure = OpenDataFile(data + 'FigureASmall.vtp')
spectrum = ShapeLaplaceSpectrum(Input=figure, NumberOfEigenpairs=30)
spectrum.UpdatePipeline()
found = WrapDataObject(servermanager.Fetch(spectrum))

values = numpy.array(found.FieldData['LaplaceSpectrum.Eigenvalues'])
print('eigenvalues:', ' '.join('%.2f' % value for value in values[:6]), '...')
assert len(values) == 30 and abs(values[0]) < 1e-6 and (numpy.diff(values) >= 0.0).all()

# The first eigenfunction that is not constant has its extremes at opposite ends of the figure.
first = numpy.array(found.PointData['Eigenfunctions'])[:, 1]
ends = found.Points[first.argmin()], found.Points[first.argmax()]
print('its minimum is at %s, its maximum at %s' % ends)

# Heat stays longest at the ends of protrusions, so the heat kernel signature has its maxima there.
heat = numpy.array(found.PointData['HeatKernelSignature'])[:, 50]
print('heat kernel signature: %.2f to %.2f, its maximum at %s' % (
    heat.min(), heat.max(), found.Points[heat.argmax()]))
assert heat.min() > 0.0 and heat.max() > 1.5
