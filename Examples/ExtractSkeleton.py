"""Extracts the skeleton of a figure: its branches, their lengths and radii, and where they meet."""
import shapemap
from paraview.simple import *

figure = XMLPolyDataReader(FileName='Data/FigureASmall.vtp')
skeleton = ShapeSkeleton(Input=figure)
skeleton.UpdatePipeline()
data = servermanager.Fetch(skeleton)
for branch in range(data.GetNumberOfCells()):
    points = data.GetCell(branch).GetPointIds()
    radii = [data.GetPointData().GetArray('Radius').GetValue(points.GetId(i))
             for i in range(points.GetNumberOfIds())]
    print('branch %d: %d points, radius %.3f to %.3f' % (branch, len(radii), min(radii), max(radii)))

# Head, hands and feet are ends; the solid has no handle, so that the skeleton is a tree.
degrees = data.GetPointData().GetArray('Degree')
ends = sum(degrees.GetValue(i) == 1 for i in range(data.GetNumberOfPoints()))
print('%d ends' % ends)
assert ends == 5
SaveData('skeleton.vtp', skeleton, DataMode='Binary')
