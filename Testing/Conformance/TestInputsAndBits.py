"""A filter leaves its inputs as they were, passes point and cell data on, gives the same bits run
after run, and nothing that is not finite."""
import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkImageData, vtkMultiBlockDataSet, vtkTable

import filters
import shapetesting


def arrays(data):
    """Every number that a data object holds, by place; run times are not results."""
    found = {}
    if hasattr(data, 'GetPoints') and data.GetPoints():
        found['points'] = vtk_to_numpy(data.GetPoints().GetData()).copy()
    for kind in (vtkDataObject.POINT, vtkDataObject.CELL, vtkDataObject.FIELD, vtkDataObject.ROW):
        attributes = data.GetAttributesAsFieldData(kind)
        for i in range(attributes.GetNumberOfArrays() if attributes else 0):
            values = attributes.GetArray(i)
            if values is not None and values.GetName() != 'Seconds':
                found[kind, values.GetName()] = vtk_to_numpy(values).copy()
    return found


def equal(a, b):
    return a.keys() == b.keys() and all(a[key].tobytes() == b[key].tobytes() for key in a)


for name in filters.names():
    results = []
    for attempt in range(2):
        algorithm = filters.quick(name)
        inputs = []
        for port in filters.required_ports(algorithm):
            data = shapetesting.copy(filters.good_input(name, port))
            if not isinstance(data, vtkTable):
                count = data.GetNumberOfPoints()
                shapetesting.add_array(data, numpy.arange(count, dtype=float), 'PassedPoint')
            inputs.append((data, arrays(data)))
            algorithm.SetInputDataObject(port, data)
        assert not shapetesting.run(algorithm)
        for port, (data, before) in enumerate(inputs):
            assert equal(arrays(data), before), '%s changed its input %d' % (name, port)
        outputs = [arrays(algorithm.GetOutputDataObject(port))
                   for port in range(algorithm.GetNumberOfOutputPorts())]
        for port, output in enumerate(outputs):
            for key, values in output.items():
                assert numpy.isfinite(values).all(), '%s: %s of output %d is not finite' % (
                    name, key, port)
        results.append(outputs)
        output = algorithm.GetOutputDataObject(0)
        if output.IsA('vtkDataSet') and output.GetNumberOfElements(0) == inputs[0][0].GetNumberOfElements(0):
            passed = shapetesting.array(output, 'PassedPoint')
            assert (passed == numpy.arange(len(passed))).all(), \
                name + ' lost a point array'
    assert all(equal(a, b) for a, b in zip(*results)), name + ' gives other bits the second time'
    # Blocks keep their places, and a lattice that reaches far beyond the shape stays finite.
    lattice = vtkImageData()
    lattice.SetDimensions(15, 15, 15)
    lattice.SetOrigin(-2.8, -2.8, -2.8)
    lattice.SetSpacing(0.4, 0.4, 0.4)
    # A map, for filters that need one on any data.
    places = [lattice.GetPoint(i) for i in range(lattice.GetNumberOfPoints())]
    shapetesting.add_array(lattice, 0.3 * numpy.array(places), 'TargetPosition')
    algorithm = filters.with_good_inputs(name)
    takes_any = algorithm.GetInputPortInformation(0).Get(algorithm.INPUT_REQUIRED_DATA_TYPE(), 0)
    blocks = vtkMultiBlockDataSet()
    blocks.SetBlock(1, lattice if takes_any == 'vtkDataSet' else filters.good_input(name, 0))
    algorithm.SetInputDataObject(0, blocks)
    assert not shapetesting.run(algorithm)
    output = algorithm.GetOutputDataObject(0)
    if algorithm.GetOutputPortInformation(0).Get(vtkDataObject.DATA_TYPE_NAME()) == 'vtkDataObject':
        assert output.IsA('vtkMultiBlockDataSet') and output.GetNumberOfBlocks() == 2, name
        assert output.GetBlock(0) is None, name
        output = output.GetBlock(1)
    for key, values in arrays(output).items():
        assert numpy.isfinite(values).all(), '%s: %s of a block is not finite' % (name, key)
    print(name, 'keeps its inputs and repeats its bits')
