"""Shape Laplace Spectrum: eigenfunctions of a surface's Laplacian, and what is made of them.

As an example: the tones of a sphere, and a bent surface unbent."""
import numpy
from paraview import simple
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
import shapemap

import shapetesting
from shapetesting import array, copy, points, read


def new(surface, pairs=30):
    return shapetesting.new(shapemap.vtkShapeLaplaceSpectrum, surface, NumberOfEigenpairs=pairs)


def eigenvalues(data):
    values = data.GetFieldData().GetArray('LaplaceSpectrum.Eigenvalues')
    return numpy.array([values.GetValue(i) for i in range(values.GetNumberOfTuples())])


# The example: l (l + 1), 2 l + 1 times, on the unit sphere; all points of it are alike.
sphere = simple.Sphere(Radius=1.0, ThetaResolution=96, PhiResolution=96)
spectrum = simple.ShapeLaplaceSpectrum(Input=sphere, NumberOfEigenpairs=16)
spectrum.UpdatePipeline()
found = shapetesting.output(spectrum)
wanted = numpy.repeat([0, 2, 6, 12], [1, 3, 5, 7])
assert abs(eigenvalues(found) - wanted).max() < 0.01 * wanted.max(), eigenvalues(found)
assert array(found, 'Eigenfunctions').shape[1] == 16
for name in ('HeatKernelSignature', 'WaveKernelSignature'):
    assert abs(array(found, name) - 1).max() < 0.03, name
radii = numpy.linalg.norm(array(found, 'Embedding'), axis=1)
assert abs(radii - numpy.sqrt(3 / (8 * numpy.pi))).max() < 0.01 * radii.max()

# Half a cylinder's wall, of height 1 and length pi: MDS makes it flat.
plane = simple.Plane(Origin=[0, 0, 0], Point1=[numpy.pi, 0, 0], Point2=[0, 0, 1], XResolution=48,
                     YResolution=16)
bent = simple.Calculator(Input=plane, Function='cos(coordsX)*iHat+sin(coordsX)*jHat+coordsZ*kHat',
                         CoordinateResults=1)
flat = simple.ShapeLaplaceSpectrum(Input=bent, Embedding='MDS', EmbeddingDimensions=2)
flat.UpdatePipeline()
unbent = array(shapetesting.output(flat), 'Embedding')
plane.UpdatePipeline()
before = points(shapetesting.output(plane))
pairs = numpy.random.default_rng(1).integers(len(before), size=(2000, 2))
lengths = [numpy.linalg.norm(p[pairs[:, 0]] - p[pairs[:, 1]], axis=1) for p in (before, unbent)]
assert abs(lengths[0] - lengths[1]).max() < 0.04 * numpy.hypot(numpy.pi, 1), abs(
    lengths[0] - lengths[1]).max()

# Two blocks have the eigenvalues of both, and a constant each.
surface = read('DentedSphere600.vtp')
algorithm = new(surface)
assert not shapetesting.run(algorithm)
alone = eigenvalues(algorithm.GetOutputDataObject(0))
far = copy(surface)
shapetesting.set_points(far, 2.0 * points(far) + [10, 0, 0])
tree = vtkMultiBlockDataSet()
tree.SetBlock(0, surface)
tree.SetBlock(2, far)
algorithm = new(tree)
assert not shapetesting.run(algorithm)
both = algorithm.GetOutputDataObject(0)
assert abs(eigenvalues(both) - numpy.sort(numpy.append(alone, alone / 4))[:30]).max() < 1e-6
assert array(both.GetBlock(2), 'Eigenfunctions').shape == (far.GetNumberOfPoints(), 30)

# What cannot be answered is refused with the fact.
for change, fact in ((lambda a: a.SetNumberOfEigenpairs(100000), 'NumberOfEigenpairs is 100000'),
                     (lambda a: a.SetNumberOfEigenpairs(2), 'must be at least 5'),
                     (lambda a: a.SetEmbeddingDimensions(0), 'EmbeddingDimensions is 0'),
                     (lambda a: a.SetEmbedding(1), 'the surface has 2 components')):
    algorithm = new(tree)
    change(algorithm)
    message = ' '.join(shapetesting.run(algorithm))
    assert 'Shape Laplace Spectrum: ' in message and fact in message, message
    assert algorithm.GetOutputDataObject(0).GetNumberOfPoints() == 0
print('eigenvalues are those of spheres, and a bent surface is unbent')
