"""Shape Cage Deform: a data set follows a closed surface around it."""
import numpy
from paraview import simple
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkPlatonicSolidSource
import shapemap

import shapetesting
from shapetesting import array, fact, points

# The example: the solid in a box, which is sheared.
ball = simple.OpenDataFile(shapetesting.data_file('BallSmall.vtu'))
box = simple.Clean(Input=simple.Box(XLength=3.0, YLength=3.0, ZLength=3.0))
sheared = simple.Calculator(Input=box, CoordinateResults=1, Function='coords + 0.5*coordsZ*iHat')
deformed = simple.ShapeCageDeform(Input=ball, Cage=box, MovedCage=sheared, DeformationGradient=1)
deformed.UpdatePipeline()
data = shapetesting.output(deformed)
source = points(shapetesting.read('BallSmall.vtu'))
linear = numpy.array([[1.0, 0.0, 0.5], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
assert abs(points(data) - source @ linear.T).max() < 1e-6  # ParaView's points are floats
assert (array(data, 'SourcePosition') == source).all() and not array(data, 'OutsideDomain').any()
assert abs(array(data, 'DeformationGradient') - linear.ravel()).max() < 1e-6
assert data.GetNumberOfCells() == shapetesting.read('BallSmall.vtu').GetNumberOfCells()

MEAN_VALUE, HARMONIC, GREEN = 0, 1, 2
TURN = numpy.array([[0.6, -0.8, 0.0], [0.8, 0.6, 0.0], [0.0, 0.0, 1.0]])


def cage():
    """A dodecahedron: its faces are pentagons."""
    made = vtkPlatonicSolidSource()
    made.SetSolidTypeToDodecahedron()
    made.Update()
    solid = vtkPolyData()
    solid.ShallowCopy(made.GetOutput())
    solid.GetCellData().Initialize()
    shapetesting.set_points(solid, 2.0 * points(solid).astype(float))
    return solid


def with_points(data, places):
    moved = shapetesting.copy(data)
    shapetesting.set_points(moved, places)
    return moved


def deform(data, before, after, **settings):
    return shapetesting.new(shapemap.vtkShapeCageDeform, data, before, after, **settings)


# A similarity is reproduced by all coordinates, a shear by Green with the option alone.
solid, around = shapetesting.read('BallSmall.vtu'), cage()
for coordinates in (MEAN_VALUE, HARMONIC, GREEN):
    for motion, affine in ((1.5 * TURN, 0), (linear, 1)):
        moved = with_points(around, points(around) @ motion.T + [1.0, 2.0, 3.0])
        settings = dict(Coordinates=coordinates, ReproduceAffine=affine, Tetrahedra=2000)
        result = shapetesting.outputs(deform(solid, around, moved, **settings))
        error = abs(points(result[0]) - (source @ motion.T + [1.0, 2.0, 3.0])).max()
        assert error < 1e-10, (coordinates, affine, error)
        assert fact(result[0], 'CageDeform.OutsidePoints') == 0
        assert (fact(result[0], 'CageDeform.Tetrahedra') > 1000) == (coordinates == HARMONIC)

# Points outside stay with coordinates that are defined inside. All blocks are moved, and counted together.
blocks = vtkMultiBlockDataSet()
far = with_points(shapetesting.read('DentedSphere600.vtp'),
                  points(shapetesting.read('DentedSphere600.vtp')) + [9.0, 0.0, 0.0])
blocks.SetBlock(0, solid)
blocks.SetBlock(1, far)
moved = with_points(around, points(around) * [1.0, 1.0, 1.3])
for coordinates, count in ((GREEN, far.GetNumberOfPoints()), (MEAN_VALUE, 0)):
    result = shapetesting.outputs(deform(blocks, around, moved, Coordinates=coordinates))
    assert fact(result[0], 'CageDeform.OutsidePoints') == count
    assert (points(result[0].GetBlock(1)) == points(far)).all() == (count > 0)
    assert (array(result[0].GetBlock(1), 'OutsideDomain') == (count > 0)).all()
    assert not array(result[0].GetBlock(0), 'OutsideDomain').any()
    assert 'DeformationGradient' not in [result[0].GetBlock(0).GetPointData().GetArrayName(i) for i in range(
        result[0].GetBlock(0).GetPointData().GetNumberOfArrays())]

# The cage follows itself.
bent = with_points(around, points(around) + 0.2 * points(around)[:, [1, 2, 0]] ** 2)
for coordinates in (MEAN_VALUE, HARMONIC):
    result = shapetesting.outputs(deform(around, around, bent, Coordinates=coordinates, Tetrahedra=2000))
    assert abs(points(result[0]) - points(bent)).max() < 1e-12

# Other points, other polygons, and open cages are refused.
shapetesting.check_refused(deform(solid, around, shapetesting.read('DentedSphere600.vtp')), 'points', 'Cage 20',
                           'with its points moved')
shapetesting.check_refused(deform(solid, around, shapetesting.without_cells(around, [3])), '11 polygons',
                           'the Cage 12', 'with its points moved')
other = shapetesting.copy(around)
other.ReverseCell(5)
shapetesting.check_refused(deform(solid, around, other), 'polygon 5', 'with its points moved')
opened = shapetesting.without_cells(around, [3])
shapetesting.check_refused(deform(solid, opened, opened), 'Shape Fill Holes')
