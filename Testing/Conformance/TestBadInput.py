"""Input that cannot be used gives an error that names the filter, empty outputs and no crash; and the
same object works again once the input is mended."""
import numpy
from vtkmodules.vtkCommonCore import vtkDataArray, vtkDoubleArray
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkMultiBlockDataSet, vtkPolyData, vtkTable
from vtkmodules.util.numpy_support import vtk_to_numpy

import filters
import shapetesting

# Filters that mend coordinates that are not finite.
MENDING = {'ShapeSolidify'}


def refused(name, algorithm, what, named):
    """Runs; the error must contain `named`, and every output must be empty. Returns all errors."""
    messages = shapetesting.run(algorithm)
    assert any(named in message for message in messages), '%s with %s: errors %s' % (
        name, what, messages)
    for port in range(algorithm.GetNumberOfOutputPorts()):
        output = algorithm.GetOutputDataObject(port)
        assert output is None or filters.size_of(output) == 0, \
            '%s with %s: output %d is not empty' % (name, what, port)
    return messages


def without_good_map(name, spoil):
    """The filter with good inputs but for their map arrays, which `spoil` has worked on."""
    algorithm = filters.quick(name)
    for port in filters.required_ports(algorithm):
        data = shapetesting.copy(filters.good_input(name, port))
        if data.GetPointData().HasArray(algorithm.GetMapArray()):
            spoil(data)
        algorithm.SetInputDataObject(port, data)
    return algorithm


def spoiled(name, port, value):
    """The good input with one coordinate that is not finite, of a point that cells use, or one label of an
    image, or one number of a table."""
    data = shapetesting.copy(filters.good_input(name, port))
    if isinstance(data, vtkTable):
        data.GetColumn(1).SetComponent(2, 0, value)
        return data
    if isinstance(data, vtkImageData):
        labels = vtk_to_numpy(data.GetPointData().GetScalars()).astype(float)
        labels[len(labels) // 2] = value
        shapetesting.add_array(data, labels, data.GetPointData().GetScalars().GetName())
        return data
    coordinates = shapetesting.points(data)
    coordinates[data.GetCell(data.GetNumberOfCells() // 2).GetPointId(0), 1] = value
    shapetesting.set_points(data, coordinates)
    return data


def with_flat_triangles(name, port):
    """The good input with two neighbouring points at one place: two triangles without area."""
    data = shapetesting.copy(filters.good_input(name, port))
    coordinates = shapetesting.points(data)
    cell = data.GetCell(data.GetNumberOfCells() // 2)
    a, b = cell.GetPointId(0), cell.GetPointId(1)
    coordinates[a] = coordinates[b]
    shapetesting.set_points(data, coordinates)
    return data


def with_short_array(data, attributes):
    """The data with an array that has one tuple too few, which is invalid in VTK."""
    result = shapetesting.copy(data)
    group = result.GetPointData() if attributes == 'point' else result.GetCellData()
    count = data.GetNumberOfPoints() if attributes == 'point' else data.GetNumberOfCells()
    values = vtkDoubleArray()
    values.SetName('Short')
    values.SetNumberOfTuples(count - 1)
    values.Fill(1.0)
    group.AddArray(values)
    return result


def all_finite(data):
    """Whether every number of a data object is finite."""
    groups = [data.GetPointData(), data.GetCellData()] if hasattr(data, 'GetPointData') else []
    arrays = [group.GetArray(i) for group in groups + [data.GetFieldData()]
              for i in range(group.GetNumberOfArrays())]
    if isinstance(data, vtkTable):
        arrays += [data.GetColumn(i) for i in range(data.GetNumberOfColumns())]
    if hasattr(data, 'GetPoints') and data.GetPoints():
        arrays.append(data.GetPoints().GetData())
    return all(numpy.isfinite(vtk_to_numpy(values)).all() for values in arrays
               if isinstance(values, vtkDataArray) and values.GetNumberOfTuples())


for name in filters.names():
    for port in filters.required_ports(filters.new(name)):
        label = filters.label(name)

        missing = filters.with_good_inputs(name)
        missing.RemoveAllInputConnections(port)
        refused(name, missing, 'nothing on port %d' % port, 'vtk' + name)

        is_table = isinstance(filters.good_input(name, port), vtkTable)
        wrong = filters.with_good_inputs(name)
        wrong.SetInputDataObject(port, vtkImageData() if is_table else vtkTable())
        refused(name, wrong, 'another kind of data on port %d' % port, 'vtk' + name)

        for attributes in () if is_table else ('point', 'cell'):
            short = filters.with_good_inputs(name)
            short.SetInputDataObject(port, with_short_array(filters.good_input(name, port), attributes))
            refused(name, short, 'a short array', "the %s array 'Short' of the input '%s' has" % (
                attributes, short.GetInputName(port)))

        # One object meets all of them, and works each time that the input is mended.
        bad = filters.with_good_inputs(name)
        for what, data in (('nothing in it', filters.good_input(name, port).NewInstance()),
                           ('a NaN', spoiled(name, port, numpy.nan)),
                           ('an infinity', spoiled(name, port, numpy.inf))):
            bad.SetInputDataObject(port, data)
            if name in MENDING and filters.size_of(data) > 0:
                assert not shapetesting.run(bad) and all_finite(bad.GetOutputDataObject(0)), \
                    '%s does not mend %s' % (name, what)
                continue
            messages = refused(name, bad, '%s on port %d' % (what, port), label + ': ')
            # The executive does not add that the request failed.
            assert len(messages) == 1, messages
            again = shapetesting.run(bad)
            assert not any(label + ': ' in message for message in again), \
                '%s computes and complains again although nothing changed' % name
            bad.SetInputDataObject(port, filters.good_input(name, port))
            messages = shapetesting.run(bad)
            assert not messages, '%s after %s on port %d: %s' % (name, what, port, messages)
            assert filters.size_of(bad.GetOutputDataObject(0)) > 0
    for port in filters.required_ports(filters.new(name)):
        if isinstance(filters.good_input(name, port), (vtkImageData, vtkTable)):
            continue  # it has no triangles
        flat = filters.with_good_inputs(name)
        flat.SetInputDataObject(port, with_flat_triangles(name, port))
        messages = shapetesting.run(flat)
        outputs = [flat.GetOutputDataObject(i) for i in range(flat.GetNumberOfOutputPorts())]
        if messages:
            assert any(label + ': ' in message for message in messages), messages
            assert all(filters.size_of(o) == 0 for o in outputs), name
        else:
            assert filters.size_of(outputs[0]) > 0 and all(map(all_finite, outputs)), \
                '%s with flat triangles on port %d: not finite' % (name, port)
        print(name, 'with flat triangles on port', port, *(messages or ['is finite']))

    # A bad block spoils the whole, whichever comes first: no part of an output may be left.
    # A table is met only when the blocks before it are done.
    good, bad = filters.good_input(name, 0), spoiled(name, 0, numpy.nan)
    for order in ((good, bad), (bad, good), (good, vtkTable())):
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, order[0])
        blocks.SetBlock(1, order[1])
        half = filters.with_good_inputs(name)
        half.SetInputDataObject(0, blocks)
        if name in MENDING and bad in order:
            assert not shapetesting.run(half) and all_finite(half.GetOutputDataObject(0)), name
            continue
        refused(name, half, 'a bad block', label + ': ')
    if hasattr(filters.new(name), 'GetMapArray'):
        array = filters.new(name).GetMapArray()

        def spoil(data):
            values = shapetesting.array(data, array).copy()
            values[17, 1] = numpy.nan
            shapetesting.add_array(data, values, array)

        refused(name, without_good_map(name, spoil), 'a NaN in the map array', 'first at point 17')
        missing = without_good_map(name, lambda data: data.GetPointData().RemoveArray(array))
        refused(name, missing, 'no map array', "no point array '%s'" % array)
    print(name, 'refuses bad input')
