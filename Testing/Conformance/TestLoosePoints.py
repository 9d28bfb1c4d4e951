"""A point that no cell uses changes no result at the others, wherever it is: lengths that are relative to the size of
a shape do not count it."""
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

import filters
import shapetesting

# In these inputs, every point counts, whether or not a cell uses it.
POINTS_COUNT = {('ShapeDeform', 'Input'), ('ShapeGeodesicDistance', 'Seeds'), ('ShapeMapErrorCurve', 'Truth'),
                ('ShapeApplyVolumeMap', 'Map'), ('ShapeCertificate', 'Map'), ('ShapeHarmonicVolumeMap', 'Domain'), ('ShapeDeform', 'Boundary'),
                ('ShapeCoupling', 'ShapeA'), ('ShapeCoupling', 'ShapeB')}
# Outputs that have a point for each defect, and a loose point is one.
DEFECTS = {('ShapeSolidify', 1)}


def with_loose_point(data):
    """A copy with one more point, ten sizes away, that has the values of the first point."""
    result = shapetesting.copy(data)
    places = shapetesting.points(data)
    far = places.max(axis=0) + 10.0 * (places.max(axis=0) - places.min(axis=0)).max()
    shapetesting.set_points(result, numpy.vstack([places, far]))
    for i in range(data.GetPointData().GetNumberOfArrays()):
        array = data.GetPointData().GetArray(i)
        values = vtk_to_numpy(array)
        longer = numpy_to_vtk(numpy.concatenate([values, values[:1]]), deep=True, array_type=array.GetDataType())
        longer.SetName(array.GetName())
        result.GetPointData().AddArray(longer)
    return result


def corners(data):
    """The positions of all corners of its cells, in order."""
    ids = [data.GetCell(cell).GetPointId(k) for cell in range(data.GetNumberOfCells())
           for k in range(data.GetCell(cell).GetNumberOfPoints())]
    return shapetesting.points(data)[ids], ids


def compare(what, clean, loose):
    """Both results have the same cells, at the same positions, with the same values."""
    if not clean.IsA('vtkPointSet'):
        return
    assert clean.GetNumberOfCells() == loose.GetNumberOfCells(), \
        '%s: %d cells for %d' % (what, loose.GetNumberOfCells(), clean.GetNumberOfCells())
    if clean.GetNumberOfCells() == 0:
        return
    (places, ids), (others, other_ids) = corners(clean), corners(loose)
    size = numpy.ptp(places, axis=0).max()
    assert places.shape == others.shape and abs(places - others).max() <= 1e-6 * size, \
        '%s: moved by %g' % (what, abs(places - others).max())
    for i in range(clean.GetPointData().GetNumberOfArrays()):
        array = clean.GetPointData().GetArray(i)
        if array is None or array.GetName().startswith('Original') or array.GetName() == 'TargetCell':
            continue
        one, other = vtk_to_numpy(array)[ids], shapetesting.array(loose, array.GetName())[other_ids]
        assert abs(one - other).max() <= 1e-6 * max(1.0, abs(one).max()), '%s: %s differs by %g' % (
            what, array.GetName(), abs(one - other).max())


for name in filters.names():
    for port in filters.required_ports(filters.new(name)):
        key = name, filters.new(name).GetInputName(port)
        good = filters.good_input(name, port)
        if key in POINTS_COUNT or not good.IsA('vtkPointSet') or good.GetNumberOfCells() == 0:
            continue
        algorithm = filters.with_good_inputs(name)
        clean = [shapetesting.copy(output) for output in shapetesting.outputs(algorithm)]
        algorithm = filters.with_good_inputs(name)
        algorithm.SetInputDataObject(port, with_loose_point(good))
        messages = shapetesting.run(algorithm)
        if messages:
            # A refusal must name it.
            assert 'no triangle uses' in messages[0], messages
            print(*key, 'refuses', messages[0])
            continue
        for number, output in enumerate(clean):
            if (name, number) in DEFECTS:
                continue
            compare('%s, %s, output %d' % (*key, number), output, algorithm.GetOutputDataObject(number))
        print(*key, 'does not count a loose point')
