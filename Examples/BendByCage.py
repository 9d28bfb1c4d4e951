"""Bends a figure by moving the points of a box around it."""
import os

from paraview.simple import *

data = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'Data', '')

figure = XMLPolyDataReader(FileName=data + 'FigureASmall.vtp')
figure.UpdatePipeline()
x0, x1, y0, y1, z0, z1 = figure.GetDataInformation().GetBounds()
box = Box(XLength=1.2 * (x1 - x0), YLength=1.2 * (y1 - y0), ZLength=1.4 * (z1 - z0),
          Center=[(x0 + x1) / 2, (y0 + y1) / 2, (z0 + z1) / 2])

# The cage is a closed surface; the moved cage has the same points and triangles.
cage = Subdivide(Input=Triangulate(Input=Clean(Input=box)), NumberofSubdivisions=2)
moved = Calculator(Input=cage, CoordinateResults=1, Function='coords+iHat*0.5*coordsZ^2')
bent = ShapeCageDeform(Input=figure, Cage=cage, MovedCage=moved)
bent.UpdatePipeline()
before, after = (shape.GetDataInformation().GetBounds() for shape in (figure, bent))
print('x from %.2f to %.2f becomes %.2f to %.2f' % (before[:2] + after[:2]))
assert after[1] > before[1] and abs(after[4] - before[4]) < 0.2 * (before[5] - before[4])
