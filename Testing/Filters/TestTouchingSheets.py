"""A model whose solids touch each other, in a file without connectivity: Shape Fill Holes gives each sheet its
own points, and each solid then becomes hexahedra."""
import os

import numpy
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkMassProperties

import shapetesting

scan = simple.STLReader(FileNames=[os.path.join(shapetesting.BUILD, 'models', 'pig.stl')])
filled = simple.ShapeFillHoles(Input=scan)
filled.UpdatePipeline()
assert shapetesting.fact(shapetesting.output(filled), 'FillHoles.CopiedPoints') > 100
surface = shapetesting.output(filled)
assert shapetesting.edges(surface, 'Boundary') == shapetesting.edges(surface, 'NonManifold') == 0
solids = simple.Connectivity(Input=filled)

for solid, cells in ((1, 20), (2, 14)):
    part = simple.ExtractSurface(Input=simple.Threshold(
        Input=solids, Scalars=['POINTS', 'RegionId'], LowerThreshold=solid, UpperThreshold=solid))
    remeshed = simple.ShapeHexRemesh(Surface=part, Method='Grid', CellsOnLongestSide=cells)
    remeshed.UpdatePipeline()
    hexahedra = shapetesting.output(remeshed)
    assert hexahedra.GetNumberOfCells() > 100, hexahedra.GetNumberOfCells()
    quality = vtk_to_numpy(hexahedra.GetCellData().GetArray('ScaledJacobian'))
    volume = vtk_to_numpy(hexahedra.GetCellData().GetArray('Volume')).sum()
    enclosed = vtkMassProperties()
    enclosed.SetInputData(shapetesting.output(part))
    enclosed.Update()
    print('solid %d: %d hexahedra, minimum %.2f, volume %.3f of the surface' % (
        solid, len(quality), quality.min(), volume / enclosed.GetVolume()))
    assert quality.min() > 0.0, quality.min()
    assert numpy.isclose(volume, enclosed.GetVolume(), rtol=0.05), (volume, enclosed.GetVolume())
