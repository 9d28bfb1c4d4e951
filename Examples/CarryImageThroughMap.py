"""Transforms an image by a volume map, which vtkImageReslice uses as a transform."""
import os

from paraview.simple import *
from vtkmodules.vtkImagingCore import vtkImageReslice
import shapemap

data = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'Data', '')

# The charges, output 1 of Shape Harmonic Volume Map, store a volume map. This one maps the solid
# of a dented sphere onto the unit ball.
charges = servermanager.Fetch(OpenDataFile(data + 'DentedSphereCharges.vtp'))
transform = shapemap.vtkShapeHarmonicTransform()
transform.SetChargeSetData(charges)
transform.Inverse()  # vtkImageReslice needs the map from the new to the old positions

wavelet = Wavelet(WholeExtent=[-20, 20] * 3)
image = servermanager.Fetch(wavelet)
image.SetSpacing(0.08, 0.08, 0.08)  # from -1.6 to 1.6
reslice = vtkImageReslice()
reslice.SetInputData(image)
reslice.SetResliceTransform(transform)
reslice.SetInterpolationModeToLinear()
reslice.Update()

before, after = (data.GetPointData().GetScalars() for data in (image, reslice.GetOutput()))
for point in ((0.0, 0.0, 0.0), (0.8, 0.0, 0.0), (1.6, 1.6, 1.6)):
    index = image.FindPoint(point)
    source = transform.TransformDoublePoint(point)
    print('%s comes from (%.3f, %.3f, %.3f): value %.2f, before %.2f' % (
        point, *source, after.GetValue(index), before.GetValue(index)))
# Outside the domain of the map the image does not change.
assert abs(after.GetValue(index) - before.GetValue(index)) < 1e-3
assert transform.GetNotInverted() == 0
