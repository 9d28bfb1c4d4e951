"""Offsets a surface inwards and outwards by its signed distance field."""
import os

from paraview.simple import *

data = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'Data', '')

surface = OpenDataFile(data + 'TwoTorusSmall.vtp')
surface.UpdatePipeline()
bounds = surface.GetDataInformation().GetBounds()
grid = Transform(Input=Wavelet(WholeExtent=[-35, 35, -22, 22, -9, 9]))
grid.Transform.Scale = [0.1, 0.1, 0.1]
distance = ShapeBoundaryDistance(Input=grid, Surface=surface)

for offset in (-0.1, 0.0, 0.1):  # negative is inside
    level = Contour(Input=distance, ContourBy=['POINTS', 'BoundaryDistance'], Isosurfaces=[offset])
    level.UpdatePipeline()
    box = level.GetDataInformation().GetBounds()
    area = IntegrateVariables(Input=level)
    area.UpdatePipeline()
    print('at %+.1f: area %.2f, x from %.3f to %.3f' % (
        offset, area.CellData['Area'].GetRange()[0], box[0], box[1]))
    assert abs(box[1] - bounds[1] - offset) < 0.02
