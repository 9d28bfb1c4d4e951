"""The regularisers of the functional map fit of Shape Correspondence, on the pairs of CorrespondencePairs.py:

    PYTHONPATH=Testing Utilities/pvpython.sh Testing/Benchmarks/CorrespondenceFit.py FOLDER [PAIR ...] [--rows WORD]

FOLDER has the pairs already. For each setting, without and with ZoomOut: the mean error, as a distance in
space over the root of the area, times 1000; the share of the area that has a partner; the Dirichlet energy.
Five landmarks. The rows with curves have, besides, the shortest path of edges from each landmark to the next;
those with regions, the cells of the landmarks. Prints a table of means over the pairs, and claims nothing: the
defaults were not chosen here. With --rows, only rows whose names have the word.
A second table is of coupled bases: how much of the map's matrix is on the diagonal."""
import argparse
import os
import time

import numpy
import shapemap
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersModeling import vtkDijkstraGraphGeodesicPath

import PairDeformation
import shapetesting

# A row: its name, what is known besides the landmarks, and the properties.
SETTINGS = [('none', '', {})] + [
    (name + ' %g' % weight, '', {key: weight}) for name, key in (
        ('orthonormality', 'OrthonormalityWeight'), ('inverse', 'InverseWeight')) for weight in (0.1, 1.0, 10.0)] + [
    ('orthonormality 1, inverse 1', '', {'OrthonormalityWeight': 1.0, 'InverseWeight': 1.0}),
    ('resolvent', '', {'Mask': 1}), ('resolvent, weight 0.1', '', {'Mask': 1, 'LaplacianWeight': 0.1}),
    ('Laplacian, weight 0.1', '', {'LaplacianWeight': 0.1}),
    *[('displacement %g, weight %g' % (far, weight), '', {'DisplacementWeight': weight, 'Displacement': far})
      for far in (0.0, 0.01) for weight in (0.01, 0.1)],
    *[('%g samples per eigenfunction' % count, '', {'SamplesPerEigenfunction': count}) for count in (2.0, 4.0)],
    ('regions', 'regions', {'RegionArray': 'Region'}),
    ('curves as landmarks', 'curves', {}), ('curves as descriptors', 'curves', {'CurveDescriptors': 1})] + [
    ('the same, curves %g' % weight, 'curves', {'CurveDescriptors': 1, 'CurveWeight': weight})
    for weight in (0.01, 0.1, 1.0)]


COUPLED = 20  # functions of each coupled basis


def path(points, triangles, start, end):
    """The points of a shortest path along edges."""
    dijkstra = vtkDijkstraGraphGeodesicPath()
    dijkstra.SetInputData(shapemap.mesh(points, triangles))
    dijkstra.SetStartVertex(int(end))
    dijkstra.SetEndVertex(int(start))
    dijkstra.Update()
    ids = dijkstra.GetIdList()
    return [ids.GetId(k) for k in range(ids.GetNumberOfIds())]


class Pair:
    """Two surfaces, the true image of each point of the first one, and what may be known of the map."""

    def __init__(self, folder):
        a, b = (PairDeformation.read(os.path.join(folder, name)) for name in ('A.off', 'B.off'))
        self.truth = numpy.loadtxt(os.path.join(folder, 'truth.txt'))[:, 4:]
        marks = numpy.loadtxt(os.path.join(folder, 'landmarks5.txt'))
        ids, places = marks[:, 0].astype(int), a[0][marks[:, 0].astype(int)]
        # Region: that of the nearest landmark of A, in space; B gets those of the nearest true images.
        regions = numpy.linalg.norm(a[0][:, None] - places, axis=2).argmin(axis=1)
        images = [numpy.linalg.norm(self.truth - place, axis=1).argmin() for place in b[0]]
        self.a = shapemap.mesh(*a, arrays={'Region': regions})
        self.b = shapemap.mesh(*b, arrays={'Region': regions[images]})
        landmarks = shapemap.mesh(places, arrays={'TargetPosition': marks[:, 2:]})
        lines = [path(*a, *ends) for ends in zip(ids, ids[1:])]
        chosen = numpy.concatenate([ids] + lines).astype(int)
        starts = numpy.cumsum([len(ids)] + [len(line) for line in lines])
        curves = shapemap.curves(a[0][chosen], [range(i, i + len(line)) for i, line in zip(starts, lines)],
                                 {'TargetPosition': numpy.vstack([marks[:, 2:]] + [self.truth[x] for x in lines])})
        self.known = {'': landmarks, 'regions': landmarks, 'curves': curves}


def measured(pair, known, settings):
    """Error, coverage, Dirichlet energy and CPU seconds of a map."""
    algorithm = shapetesting.new(shapemap.vtkShapeCorrespondence, pair.a, pair.b, pair.known[known], Method=1, **settings)
    start = time.process_time()
    found = shapetesting.outputs(algorithm)[0]
    spent = time.process_time() - start
    facts = shapemap.facts(algorithm)
    area = 0.5 * numpy.linalg.norm(
        PairDeformation.area_vectors(shapemap.points(pair.b), shapemap.cells(pair.b)), axis=1).sum()
    errors = numpy.linalg.norm(shapemap.point_array(found, 'TargetPosition') - pair.truth, axis=1) / area**0.5
    return 1e3 * errors.mean(), facts['CoverageOfA'], facts['DirichletEnergy'], spent


def diagonal(matrix):
    return numpy.sum(numpy.diag(matrix)**2) / numpy.sum(matrix**2)


def coupled(pair):
    """The share of the map's matrix that is on the diagonal: in eigenfunctions, and in coupled bases."""
    algorithm = shapetesting.new(shapemap.vtkShapeCorrespondence, pair.a, pair.b, pair.known[''], Method=1,
                                 CoupledBasisSize=COUPLED)
    start = time.process_time()
    table = shapetesting.outputs(algorithm)[3]
    matrix = numpy.stack([vtk_to_numpy(table.GetColumn(k)) for k in range(COUPLED)], axis=1)[:COUPLED]
    return diagonal(matrix), shapemap.facts(algorithm)['CoupledDiagonal'], time.process_time() - start


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('folder')
    parser.add_argument('names', nargs='*', metavar='PAIR')
    parser.add_argument('--rows', default='')
    options = parser.parse_args()
    names = options.names or sorted(os.listdir(options.folder))
    pairs = [Pair(os.path.join(options.folder, name)) for name in names]
    print('%d pairs: %s' % (len(pairs), ', '.join(names)))
    print('| setting | error | coverage | Dirichlet energy | error after ZoomOut | coverage | Dirichlet energy | CPU s |')
    print('|---|---|---|---|---|---|---|---|')
    for name, known, settings in (row for row in SETTINGS if options.rows in row[0]):
        fit, refined = (numpy.mean([measured(pair, known, dict(settings, **more)) for pair in pairs], axis=0)
                        for more in ({'ZoomOutStep': 0}, {}))
        print('| %s | %.1f | %.2f | %.2f | %.1f | %.2f | %.2f | %.1f |' % (name, *fit[:3], *refined), flush=True)
    if options.rows in 'coupled bases':
        print('| pair | on the diagonal: of %d eigenfunctions | of coupled bases | CPU s |' % COUPLED)
        print('|---|---|---|---|')
        for name, pair in zip(names, pairs):
            print('| %s | %.2f | %.2f | %.1f |' % (name, *coupled(pair)), flush=True)


main()
