"""A few defects change no result at the other points, and every filter says what it repaired: a fin (a triangle on an
edge that has two already), a repeated triangle, triangles with two equal corners, and an edge without length. A surface
may come as an unstructured grid with quads and strips."""
import numpy
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
from vtkmodules.util.numpy_support import vtk_to_numpy

import defects
import filters
import shapetesting

# Of these inputs, a filter uses the points alone, or leaves polygons as they are; or two must have the same cells.
NOT_REPAIRED = {('ShapeSolidify', 'Input'), ('ShapeCageDeform', 'Cage'), ('ShapeCageDeform', 'MovedCage'),
                ('ShapeFillHoles', 'Input'), ('ShapeApplyVolumeMap', 'Map'), ('ShapeCertificate', 'Map'), ('ShapeMeshMotion', 'Boundary'), ('ShapeCutFeature', 'Loop'),
                ('ShapeCutFeature', 'Input'), ('ShapeAtlas', 'Shapes'), ('ShapeCollection', 'Shapes'), ('ShapePasteFeature', 'Feature'), ('ShapePaintArray', 'Input')}


def compare(what, clean, other):
    """Cells at the same positions with the same values; or, if there are more cells, points with the same values."""
    if not clean.IsA('vtkPointSet') or clean.GetNumberOfPoints() == 0:
        return
    rows = other_rows = numpy.arange(clean.GetNumberOfPoints())
    if clean.GetNumberOfCells() == other.GetNumberOfCells() > 0 and not what.startswith('mixed'):
        ids = [[data.GetCell(cell).GetPointId(k) for cell in range(data.GetNumberOfCells())
                for k in range(data.GetCell(cell).GetNumberOfPoints())] for data in (clean, other)]
        rows, other_rows = map(numpy.array, ids)
        assert len(rows) == len(other_rows), what
    places, others = shapetesting.points(clean)[rows], shapetesting.points(other)[other_rows]
    size = numpy.ptp(places, axis=0).max()
    assert abs(places - others).max() <= 1e-6 * size, '%s: moved by %g' % (what, abs(places - others).max())
    for i in range(clean.GetPointData().GetNumberOfArrays()):
        array = clean.GetPointData().GetArray(i)
        if array is None or array.GetName() in ('OriginalPointId', 'TargetCell', 'TargetBarycentric'):
            continue
        one = vtk_to_numpy(array)[rows]
        two = shapetesting.array(other, array.GetName())[other_rows]
        assert abs(one - two).max() <= 1e-6 * max(1.0, abs(one).max()), '%s: %s differs by %g' % (
            what, array.GetName(), abs(one - two).max())


def result(name, port, data):
    algorithm = filters.with_good_inputs(name)
    algorithm.SetInputDataObject(port, data)
    messages = shapetesting.run(algorithm)
    outputs = [shapetesting.copy(output) for output in shapetesting.outputs_of(algorithm)]
    return messages, outputs


def warning(name, outputs):
    facts = shapetesting.facts(outputs[0])
    words = facts.GetAbstractArray('%s.Warning' % name[len('Shape'):])
    return words.GetValue(0) if words else ''


for name in filters.names():
    for port in filters.required_ports(filters.new(name)):
        key = name, filters.new(name).GetInputName(port)
        good = filters.good_input(name, port)
        types = vtkAlgorithm.INPUT_REQUIRED_DATA_TYPE()
        info = filters.new(name).GetInputPortInformation(port)
        takes_all = 'vtkDataSet' in [info.Get(types, i) for i in range(info.Length(types))]
        if key in NOT_REPAIRED or not good.IsA('vtkPolyData') or good.GetNumberOfPolys() == 0 or \
                takes_all and key != ('ShapeHarmonicVolumeMap', 'Boundary'):
            continue
        messages, clean = result(name, port, good)
        assert not messages, (key, messages)
        messages, repaired = result(name, port, defects.with_defects(good))
        assert not messages, (key, messages)
        for number, output in enumerate(clean):
            compare('%s, %s, output %d' % (*key, number), output, repaired[number])
        said = warning(name, repaired)
        assert 'was repaired' in said and '1 edge with three or more triangles' in said, (key, said)
        grid, triangulated = defects.mixed(good)
        messages, clean = result(name, port, triangulated)
        assert not messages, (key, messages)
        messages, others = result(name, port, grid)
        assert not messages and 'was repaired' not in warning(name, others), (key, messages)
        for number, output in enumerate(clean):
            compare('mixed, %s, %s, output %d' % (*key, number), output, others[number])
        print(*key, 'is repaired, and may have any cells')
