"""Measures distances along a surface from two seeds, and finds the curve at a given distance."""
import math

from paraview.simple import *

sphere = Sphere(Radius=1.0, ThetaResolution=64, PhiResolution=65)
# Seeds are the points of any data set: here the ends of a line, projected to the poles.
poles = Line(Point1=[0, 0, -1.2], Point2=[0, 0, 1.2], Resolution=1)
distance = ShapeGeodesicDistance(Input=sphere, Seeds=poles, Method='Exact')
distance.UpdatePipeline()
farthest = distance.PointData['GeodesicDistance'].GetRange()[1]
print('distance of the equator: %.4f; a quarter of a great circle: %.4f' % (farthest, math.pi / 2))
assert abs(farthest - math.pi / 2) < 2e-3

circles = Contour(
    Input=distance, ContourBy=['POINTS', 'GeodesicDistance'], Isosurfaces=[math.pi / 3])
circles.UpdatePipeline()
low, high = circles.GetDataInformation().GetBounds()[4:]
print('the circles of 60 degrees around the poles lie at z = %.3f and %.3f' % (low, high))
assert abs(low + 0.5) < 2e-3 and abs(high - 0.5) < 2e-3
