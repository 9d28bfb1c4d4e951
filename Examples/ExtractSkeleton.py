"""Extracts the skeleton of a figure: its branches, their lengths and radii, and where they meet."""
import os
import sys

from paraview.simple import *

folder = sys.argv[1] if len(sys.argv) > 1 else '.'
data = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'Data', '')

figure = XMLPolyDataReader(FileName=data + 'FigureASmall.vtp')
skeleton = ShapeSkeleton(Input=figure)
skeleton.UpdatePipeline()
found = servermanager.Fetch(skeleton)
for branch in range(found.GetNumberOfCells()):
    points = found.GetCell(branch).GetPointIds()
    radii = [found.GetPointData().GetArray('Radius').GetValue(points.GetId(i))
             for i in range(points.GetNumberOfIds())]
    print('branch %d: %d points, radius %.3f to %.3f' % (branch, len(radii), min(radii), max(radii)))

# Head, hands and feet are ends; the solid has no handle, so that the skeleton is a tree.
degrees = found.GetPointData().GetArray('Degree')
ends = sum(degrees.GetValue(i) == 1 for i in range(found.GetNumberOfPoints()))
print('%d ends' % ends)
assert ends == 5
SaveData(os.path.join(folder, 'skeleton.vtp'), skeleton, DataMode='Binary')
