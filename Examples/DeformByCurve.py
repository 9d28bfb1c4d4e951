"""Deforms a surface by moving a curve on it; the surface follows and keeps its detail."""
import shapemap
from paraview.simple import *

# A square with a bump. Its boundary is the handle.
plane = Plane(Origin=[-1, -1, 0], Point1=[1, -1, 0], Point2=[-1, 1, 0], XResolution=40,
              YResolution=40)
bump = Calculator(Input=plane, CoordinateResults=1,
                  Function='coords + 0.5*exp(-12*(coordsX^2 + coordsY^2))*kHat')
border = FeatureEdges(
    Input=bump, BoundaryEdges=1, FeatureEdges=0, NonManifoldEdges=0, ManifoldEdges=0)

# SourcePosition is the old position of the handle, which is bent into a saddle.
handle = Calculator(Input=border, ResultArrayName='SourcePosition', Function='coords')
saddle = Calculator(Input=handle, CoordinateResults=1,
                    Function='coords + 0.4*(coordsX^2 - coordsY^2)*kHat')
deformed = ShapeDeform(Input=bump, Boundary=saddle)

for height in (0.4, 0.2):  # the second time is faster: the weights are reused
    saddle.Function = 'coords + %g*(coordsX^2 - coordsY^2)*kHat' % height
    deformed.UpdatePipeline()
    low, high = deformed.GetDataInformation().GetBounds()[4:]
    print('handle up to z = %.2f: surface from z = %.3f to %.3f, weights computed: %d' % (
        height, low, high, shapemap.facts(deformed)['Prepared']))
    assert abs(low + height) < 1e-5 and high > height
