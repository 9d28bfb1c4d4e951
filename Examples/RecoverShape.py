"""Recovers a shape from another one and the operators by which the two differ."""
import numpy
from paraview.simple import *
from vtkmodules.numpy_interface.dataset_adapter import WrapDataObject

# A sphere, and the same sphere stretched along x.
stretch = '1.3*coordsX*iHat + coordsY*jHat + coordsZ*kHat'
sphere = LoopSubdivision(Input=ShapeParameterize(Input=Sphere(Radius=1.0, ThetaResolution=20, PhiResolution=20)),
                         NumberofSubdivisions=1)
ellipsoid = Calculator(Input=sphere, CoordinateResults=1, Function=stretch)
mapped = Calculator(Input=sphere, ResultArrayName='TargetPosition', Function=stretch)

# The operators alone: a table of numbers, which has forgotten the positions of the ellipsoid.
difference = ShapeMapDifference(SurfaceA=mapped, SurfaceB=ellipsoid, Products='Triangles', NumberOfEigenpairs=100)
recovered = ShapeFromOperators(Input=mapped, Operators=OutputPort(difference, 1))
recovered.UpdatePipeline()

surfaces = [WrapDataObject(servermanager.Fetch(source)) for source in (recovered, ellipsoid)]
corners = numpy.array(surfaces[0].Polygons).reshape(-1, 4)[:, 1:]
lengths = [numpy.linalg.norm(surface.Points[corners] - surface.Points[numpy.roll(corners, 1, axis=1)], axis=2)
           for surface in surfaces]
error = abs(lengths[0] / lengths[1] - 1.0).mean()
print('edge lengths: mean error %.2f %%' % (100 * error))
assert error < 0.01
