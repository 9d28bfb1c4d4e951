"""The regularisers of the functional map fit of Shape Correspondence, on the pairs of CorrespondencePairs.py:

    Utilities/pvpython.sh Testing/Benchmarks/CorrespondenceFit.py FOLDER [PAIR ...]

FOLDER has the pairs already. For each setting, without and with ZoomOut: the mean error, as a distance in
space over the root of the area, times 1000; the share of the area that has a partner; the Dirichlet energy.
Five landmarks. Prints a table of means over the pairs, and claims nothing: the defaults were not chosen here."""
import os
import sys
import time

import numpy
import shapemap

import PairDeformation
import shapetesting

SETTINGS = [('none', {})] + [
    (name + ' %g' % weight, {key: weight}) for name, key in (
        ('orthonormality', 'OrthonormalityWeight'), ('inverse', 'InverseWeight')) for weight in (0.1, 1.0, 10.0)] + [
    ('orthonormality 1, inverse 1', {'OrthonormalityWeight': 1.0, 'InverseWeight': 1.0}),
    ('resolvent', {'Mask': 1}), ('resolvent, weight 0.1', {'Mask': 1, 'LaplacianWeight': 0.1}),
    ('Laplacian, weight 0.1', {'LaplacianWeight': 0.1})]


def pair_of(folder):
    a, b = (PairDeformation.read(os.path.join(folder, name)) for name in ('A.off', 'B.off'))
    truth = numpy.loadtxt(os.path.join(folder, 'truth.txt'))[:, 4:]
    marks = numpy.loadtxt(os.path.join(folder, 'landmarks5.txt'))
    landmarks = shapemap.mesh(a[0][marks[:, 0].astype(int)], arrays={'TargetPosition': marks[:, 2:]})
    return shapemap.mesh(*a), shapemap.mesh(*b), landmarks, truth


def measured(a, b, landmarks, truth, settings):
    """Error, coverage, Dirichlet energy and CPU seconds of a map."""
    algorithm = shapetesting.new(shapemap.vtkShapeCorrespondence, a, b, landmarks, Method=1, **settings)
    start = time.process_time()
    found = shapetesting.outputs(algorithm)[0]
    spent = time.process_time() - start
    facts = shapemap.facts(algorithm)
    area = 0.5 * numpy.linalg.norm(PairDeformation.area_vectors(shapemap.points(b), shapemap.cells(b)), axis=1).sum()
    errors = numpy.linalg.norm(shapemap.point_array(found, 'TargetPosition') - truth, axis=1) / area**0.5
    return 1e3 * errors.mean(), facts['CoverageOfA'], facts['DirichletEnergy'], spent


def main():
    folder, names = sys.argv[1], sys.argv[2:] or sorted(os.listdir(sys.argv[1]))
    pairs = [pair_of(os.path.join(folder, name)) for name in names]
    print('%d pairs: %s' % (len(pairs), ', '.join(names)))
    print('| setting | error | coverage | Dirichlet energy | error after ZoomOut | coverage | Dirichlet energy | CPU s |')
    print('|---|---|---|---|---|---|---|---|')
    for name, settings in SETTINGS:
        fit, refined = (numpy.mean([measured(*pair, dict(settings, **more)) for pair in pairs], axis=0)
                        for more in ({'ZoomOutStep': 0}, {}))
        print('| %s | %.1f | %.2f | %.2f | %.1f | %.2f | %.2f | %.1f |' % (name, *fit[:3], *refined), flush=True)


main()
