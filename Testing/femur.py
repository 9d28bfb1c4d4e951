"""A femur as finite elements: the solid inside a scanned surface, its hexahedra, and the loads that
CalculiX applies. Of Testing/Filters/TestCalculixFemur.py and Testing/Benchmarks/ImageValues.py."""
import os
import sys

import numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPlane
from vtkmodules.vtkFiltersCore import (
    vtkCleanPolyData, vtkClipPolyData, vtkContourFilter, vtkPolyDataNormals, vtkTriangleFilter)
from vtkmodules.vtkFiltersModeling import vtkFillHolesFilter
import shapemap

import calculix
import shapetesting

sys.path.append(os.path.join(shapetesting.ROOT, 'Utilities'))
import off

PATH = os.path.join(shapetesting.MODELS, 'femur.off')
SPACING = 0.02  # of the grid; the bone is 1 long, along z, its head at -0.5
CUT = 0.45
YOUNG, POISSON = 17000.0, 0.3
RADIUS = 0.12  # of a load: a place, and a force
HEAD = numpy.array([0.08, -0.05, -0.5]), numpy.array([-0.3, 0.0, 1.0])


def bone(path=PATH):
    """A closed surface of genus 0 with a plane end."""
    scanned = off.read(path)
    grid, bounds = vtkImageData(), numpy.array(scanned.GetBounds()).reshape(3, 2)
    grid.SetOrigin(bounds[:, 0] - 3.0 * SPACING)
    grid.SetSpacing([SPACING] * 3)
    grid.SetDimensions((numpy.ceil(numpy.ptp(bounds, axis=1) / SPACING) + 7).astype(int))
    distance = shapemap.vtkShapeBoundaryDistance()
    distance.SetInputDataObject(0, grid)
    distance.SetInputDataObject(1, scanned)
    messages = shapetesting.run(distance)
    assert not messages, messages
    distance.GetOutputDataObject(0).GetPointData().SetActiveScalars('BoundaryDistance')
    plane = vtkPlane()
    plane.SetOrigin(0.0, 0.0, CUT)
    plane.SetNormal(0.0, 0.0, -1.0)
    steps = [vtkContourFilter(), vtkClipPolyData(), vtkCleanPolyData(), vtkFillHolesFilter(),
             vtkTriangleFilter(), vtkPolyDataNormals()]
    steps[0].SetInputData(distance.GetOutputDataObject(0))
    steps[0].SetValue(0, 0.0)
    steps[0].ComputeNormalsOff()
    steps[1].SetClipFunction(plane)
    steps[2].SetTolerance(1e-5)
    steps[2].ConvertPolysToLinesOff()
    steps[3].SetHoleSize(10.0)
    steps[5].SplittingOff()
    for before, after in zip(steps, steps[1:]):
        after.SetInputConnection(before.GetOutputPort())
    steps[-1].Update()
    return steps[-1].GetOutput()


def mesh(surface, cell_size):
    remesh = shapemap.vtkShapeHexRemesh()
    remesh.SetInputDataObject(surface)
    remesh.SetMethod(2)  # by a grid
    remesh.SetCellSize(cell_size)
    remesh.SetFeatureAngle(70.0)  # the rim of the cut; the scan's own edges are noise
    messages = shapetesting.run(remesh)
    assert not messages, messages
    return remesh.GetOutputDataObject(0)


class Bone(calculix.Model):
    """The cells, held at the cut."""

    def __init__(self, grid):
        # Cells of any shape pass the patch test as C3D8.
        super().__init__(grid, HexahedronType=0)
        self.end = self.patch_at(2, CUT, 1e-6)
        self.held = self.node_set('Patch' + self.end)
        self.areas = numpy.zeros(len(self.points))
        for key in self.blocks:
            if key.startswith('*NSET, NSET=Patch'):
                for node, area in self.shares(key.rpartition('=Patch')[2]).items():
                    self.areas[node] += area

    def load(self, place, force):
        """Forces (n x 3) at the nodes, with this sum."""
        near = numpy.linalg.norm(self.points - place, axis=1) / RADIUS
        weights = self.areas * numpy.maximum(0.0, 1.0 - near ** 2) ** 2
        return weights[:, None] / weights.sum() * force

    def bear(self, forces, young=YOUNG):
        """young: None if the cells have materials."""
        # CalculiX reads 20 columns of a number.
        lines = ['%d, %d, %.12g' % (node + 1, axis + 1, forces[node, axis])
                 for node, axis in zip(*forces.nonzero())]
        solution = self.analyse(young, POISSON, ['Patch%s, 1, 3' % self.end], ['*CLOAD'] + lines)
        assert 'WARNING' not in solution.Words, solution.Words
        self.check(forces, solution)
        return solution

    def check(self, forces, solution):
        """Equilibrium, and the energy, to the seven digits of what is summed."""
        reactions = solution.Forces[self.held]
        for sums, sizes in (
                (reactions.sum(axis=0) + forces.sum(axis=0), abs(reactions).sum()),
                (numpy.cross(self.points[self.held], reactions).sum(axis=0)
                 + numpy.cross(self.points, forces).sum(axis=0),
                 abs(numpy.cross(self.points[self.held], reactions)).sum())):
            assert abs(sums).max() < 1e-6 * sizes, (sums, sizes)
        print('out of equilibrium by %.1e of the load' % (numpy.linalg.norm(
            reactions.sum(axis=0) + forces.sum(axis=0)) / numpy.linalg.norm(forces.sum(axis=0))))
        free = numpy.setdiff1d(numpy.arange(len(forces)), self.held)
        assert abs(solution.Forces - forces)[free].max() < 1e-6 * abs(reactions).max()
        work = (forces * solution.Displacements).sum()
        assert work > 0.0 and abs(2.0 * solution.Energy / work - 1.0) < 2e-6, (solution.Energy, work)
