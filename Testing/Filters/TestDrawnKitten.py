"""A solid of genus 1 and the polycube drawn by hand for it, a grid of hexahedra: Shape Correspondence takes the grid's
boundary, Shape Hex Remesh takes the output as it is, and the grid itself is a Boundary of a volume map."""
import shapemap
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import VTK_QUAD, vtkMultiBlockDataSet
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter

import polycubes
import shapetesting
from shapetesting import array, new, points, read


def skin_of(grid):
    skin = vtkDataSetSurfaceFilter()
    skin.SetInputData(grid)
    skin.Update()
    return skin.GetOutput()


kitten = polycubes.Drawn(read('KittenSmall.vtp'), read('KittenPolycube.vtu'), 2, polycubes.LOOPS['Kitten'])
kitten.check(1)

# The boundary: as many quads as the grid's surface has, with their points alone.
boundary, skin = kitten.Boundary, skin_of(kitten.Grid)
assert boundary.GetNumberOfCells() == skin.GetNumberOfCells()
assert boundary.GetNumberOfPoints() == skin.GetNumberOfPoints() < kitten.Grid.GetNumberOfPoints()
assert {boundary.GetCellType(i) for i in range(boundary.GetNumberOfCells())} == {VTK_QUAD}

# Its quads with TargetPosition are a Polycube of Shape Hex Remesh.
hexahedra = shapetesting.outputs(new(shapemap.vtkShapeHexRemesh, kitten.Surface, boundary, Method=1, CellSize=0.06))[0]
scaled = vtk_to_numpy(hexahedra.GetCellData().GetArray('ScaledJacobian'))
assert len(scaled) > 500 and scaled.min() > 0.0, (len(scaled), scaled.min())

# The solid itself is the Boundary of a volume map, as its surface is.
grid = kitten.Grid
shapetesting.add_array(grid, 2.0 * points(grid) + [1.0, 0.0, 0.0], 'TargetPosition')
moved = [shapetesting.outputs(new(shapemap.vtkShapeHarmonicVolumeMap, grid, surface))[0]
         for surface in (grid, skin_of(grid))]
for solid in moved:
    assert abs(points(solid) - array(grid, 'TargetPosition')).max() < 1e-9

# In several blocks, faces between them would be taken for the boundary: that is said.
blocks = vtkMultiBlockDataSet()
for i in range(2):
    blocks.SetBlock(i, grid)
message = shapetesting.refusal(new(shapemap.vtkShapeCorrespondence, blocks, kitten.Surface))
assert 'solid cells in several blocks' in message and 'Merge Blocks' in message, message
