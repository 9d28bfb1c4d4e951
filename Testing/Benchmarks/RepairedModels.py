"""What filters make of real models with a few defects (Testing/defects.py), against the same models without.

    Utilities/pvpython.sh Testing/Benchmarks/RepairedModels.py [--models 20] [--triangles 8000]

For each model, the largest difference of a value at the points of the model, divided by the largest value, or `refused`
if the filter refuses the model without defects, too. `silent` marks a repair that was not said. The models are those
with the fewest triangles, at least 100 of them."""
import argparse
import glob
import os

import numpy

import sweep  # lets the following be found

import defects
import shapemap
import shapetesting
from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkTriangleFilter

parser = argparse.ArgumentParser()
parser.add_argument('--models', type=int, default=20)
parser.add_argument('--triangles', type=int, default=8000)
arguments = parser.parse_args()


def model(path):
    reader = shapemap.vtkShapeOFFReader()
    reader.SetFileName(path)
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(reader.GetOutputPort())
    clean = vtkCleanPolyData()
    clean.SetInputConnection(triangles.GetOutputPort())
    clean.SetPointMerging(False)  # only points that no cell uses
    clean.Update()
    return clean.GetOutput()


def geodesic(method):
    def make(surface):
        filter = shapetesting.new(shapemap.vtkShapeGeodesicDistance, surface, Method=method)
        filter.SetNumberOfSeedPoints(1)
        filter.SetSeedPoints(0, *surface.GetPoint(0))
        return filter
    return make


CASES = {
    'spectrum': (lambda surface: shapetesting.new(
        shapemap.vtkShapeLaplaceSpectrum, surface, NumberOfEigenpairs=12), 'HeatKernelSignature'),
    'heat': (geodesic(0), 'GeodesicDistance'),
    'exact': (geodesic(1), 'GeodesicDistance'),
    'sphere': (lambda surface: shapetesting.new(shapemap.vtkShapeParameterize, surface), 'TargetPosition'),
    'distance': (lambda surface: shapetesting.new(
        shapemap.vtkShapeBoundaryDistance, points_of(surface), surface), 'BoundaryDistance'),
}


def points_of(surface):
    """The points alone, moved off the surface."""
    moved = shapetesting.copy(surface)
    shapetesting.set_points(moved, 1.01 * shapetesting.points(surface))
    return moved


def compared(make, array, clean, spoiled):
    filters = [make(clean), make(spoiled)]
    messages = [shapetesting.run(filter) for filter in filters]
    if messages[0]:
        return 'refused'
    if messages[1]:
        return 'REFUSED: ' + messages[1][0].strip().splitlines()[-1]
    values = [shapetesting.array(filter.GetOutputDataObject(0), array) for filter in filters]
    worst = abs(values[1][:len(values[0])] - values[0]).max() / abs(values[0]).max()
    facts = shapetesting.facts(filters[1].GetOutputDataObject(0))
    name = filters[1].GetClassName()[len('vtkShape'):]
    said = facts.HasArray(name + '.Warning') and 'repaired' in facts.GetAbstractArray(name + '.Warning').GetValue(0)
    return '%.1e%s' % (worst, '' if said else ' silent')


paths = glob.glob(os.path.join(shapetesting.MODELS, '**', '*.off'), recursive=True)
found = 0
print('%-28s' % 'model', *('%-10s' % name for name in CASES))
for path in sorted(paths, key=os.path.getsize):
    try:
        clean = model(path)
        spoiled = defects.with_defects(clean)
    except (AssertionError, ValueError):
        continue  # no surface
    if not 100 <= clean.GetNumberOfPolys() <= arguments.triangles or \
            shapetesting.edges(clean, 'NonManifold') + shapetesting.edges(clean, 'Boundary'):
        continue
    found += 1
    print('%-28s' % os.path.basename(path)[:-4], *('%-10s' % compared(*case, clean, spoiled)
                                                   for case in CASES.values()), flush=True)
    if found == arguments.models:
        break
