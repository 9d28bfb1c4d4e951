"""A sample of Shape Synthesize is saved as a mesh of every solver by its extension alone: its cells have quality
arrays, one of them active, and no regions. As an example: the sample becomes a deck."""
import filecmp
import os
import tempfile

from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid
from paraview import simple

import shapetesting

folder = tempfile.mkdtemp()
ball = simple.XMLPolyDataReader(FileName=[shapetesting.data_file('DentedSphere600.vtp')])
atlas = simple.Calculator(Input=ball, ResultArrayName='SourcePosition', Function='coords')
atlas = simple.Calculator(Input=atlas, ResultArrayName='Mode0', Function='0.1*coordsX^2*iHat')
solid = simple.ShapeHexRemesh(Surface=ball)
simple.Show(solid)
unnamed = simple.PassArrays(Input=solid, CellDataArrays=['ScaledJacobian'])
sample = simple.ShapeSynthesize(Atlas=atlas, Data=unnamed, Weights=[1.5])
simple.SaveData(os.path.join(folder, 'sample.inp'), simple.OutputPort(sample, 1))
assert '*ELSET, ELSET=Region0' in open(os.path.join(folder, 'sample.inp')).read()


def producer(grid, active=None):
    grid.GetCellData().SetActiveScalars(active)
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(grid)
    return source


moved = shapetesting.output(sample, 1)
assert moved.GetCellData().HasArray('Inverted') and not moved.GetCellData().HasArray('RegionId')
bare = vtkUnstructuredGrid()
bare.CopyStructure(moved)
layered = shapetesting.copy(moved)
layers = shapetesting.copy(moved.GetCellData().GetArray('Inverted'))
for cell in range(layers.GetNumberOfTuples()):
    layers.SetValue(cell, cell % 2)
layers.SetName('RegionId')
layered.GetCellData().AddArray(layers)


def save(name, extension, source, **properties):
    path = os.path.join(folder, name, extension, 'mesh.' + extension)
    os.makedirs(os.path.dirname(path))
    simple.SaveData(path, source, **properties)
    return os.path.dirname(path)


def same(first, second):
    """Whether two folders have files of the same bytes."""
    names = sorted(os.path.relpath(os.path.join(at, name), first) for at, _, files in os.walk(first) for name in files)
    assert names, first
    return filecmp.cmpfiles(first, second, names, shallow=False)[0] == names


for extension in ('inp', 'k', 'feb', 'msh', 'mesh', 'exo', 'foam'):
    plain = save('bare', extension, producer(bare))
    for active in ('ScaledJacobian', 'Inverted', None):
        assert same(plain, save(str(active), extension, producer(moved, active))), (extension, active)
    # Regions are still taken by themselves, unless the user wants none.
    regions = save('layered', extension, producer(layered, 'ScaledJacobian'))
    assert same(regions, save('chosen', extension, producer(layered, 'ScaledJacobian'), RegionArray='RegionId'))
    assert not same(regions, plain), extension
    assert same(plain, save('none', extension, producer(layered, 'ScaledJacobian'), RegionArray='None')), extension
print('a sample is saved for every solver')
