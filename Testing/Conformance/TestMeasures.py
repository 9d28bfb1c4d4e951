"""No output shows a measure of another geometry. Each filter is run with inputs that carry every measure
that Verdict or a ShapeMap filter writes, normals and facts, all with a false value. On an output whose
points are not an input's, each of them is gone, or has the value that VTK or the filter itself computes there;
what is no measure is passed on. On an output with an input's points everything stays."""
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkDataSet
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals
from vtkmodules.vtkFiltersVerdict import vtkMeshQuality

import filters
import shapetesting

POINT, CELL, FIELD = vtkDataObject.POINT, vtkDataObject.CELL, vtkDataObject.FIELD
FALSE = 12345.0

# What ShapeMap filters write that is no measure: maps and their errors, ids, labels, materials with the means
# of an image, what a feature stood on, the frames of a handle, and what a user paints.
CONTRACT = {'TargetPosition', 'TargetCell', 'TargetBarycentric', 'SourcePosition', 'OriginalPointId',
            'OriginalCellId', 'OutsideDomain', 'RegionId', 'Regions', 'SurfacePointId', 'Patch', 'Interface', 'Label',
            'Filled', 'Part', 'ExponentialMap', 'LoopCoordinates', 'LoopNormal', 'LoopOrder', 'Charge', 'Name', 'Number',
            'SourceNormal', 'TargetNormal', 'FrameRotation', 'FrameSet', 'Error',
            'MapColors', 'FacePatch', 'Origin', 'Defect', 'Block', 'BlockIndex', 'BranchId', 'TargetBranchId', 'Degree',
            'SourceNormal', 'TargetNormal', 'FrameTurn', 'Painted', 'Grey', 'Coverage', 'Density', 'Modulus',
            'MaterialId', 'MaterialDensity', 'MaterialModulus', 'SampleWeight', 'ImageDistribution',
            'NetworkDescriptors', 'TargetPointId', 'SpherePosition', 'LeftPatch', 'RightPatch', 'IsCurve',
            'HandleLoop', 'MapConfidence', 'Element', 'Orbit', 'Copy', 'Generator1', 'Symmetrized', 'Mode0', 'Mode1'}
# Measures of hexahedra that Shape Hex Remesh writes, by Verdict.
VERDICT = {name[len('SetHexQualityMeasureTo'):]
           for name in dir(vtkMeshQuality) if name.startswith('SetHexQualityMeasureTo')}
OTHERS = {name.split('QualityMeasureTo')[1] for name in dir(vtkMeshQuality) if 'QualityMeasureTo' in name}


def arrays(data, kind):
    attributes = data.GetAttributesAsFieldData(kind)
    if attributes is None:  # of a table
        return {}
    return {attributes.GetArrayName(i): attributes.GetAbstractArray(i) for i in range(attributes.GetNumberOfArrays())}


def values(array):
    return vtk_to_numpy(array) if hasattr(array, 'GetRange') else [
        array.GetValue(i) for i in range(array.GetNumberOfValues())]


def data_sets(outputs):
    return [(port, output) for port, output in enumerate(outputs) if isinstance(output, vtkDataSet)]


def outputs(name, inputs):
    algorithm = filters.quick(name)
    for port, data in inputs.items():
        algorithm.SetInputDataObject(port, data)
    algorithm.UpdateInformation()
    times = algorithm.GetOutputInformation(0)
    if times.Has(vtkStreamingDemandDrivenPipeline.TIME_RANGE()):
        algorithm.UpdateTimeStep(times.Get(vtkStreamingDemandDrivenPipeline.TIME_RANGE(), 1))
    errors = shapetesting.run(algorithm)
    assert not errors, (name, errors)
    return [algorithm.GetOutputDataObject(port) for port in range(algorithm.GetNumberOfOutputPorts())]


def add(data, kind, name, components=1, integers=False):
    """An array with the false value everywhere."""
    count = 1 if kind == FIELD else data.GetNumberOfElements(kind)
    array = numpy_to_vtk(numpy.full((count, components) if components > 1 else count, FALSE).astype(
        numpy.int32 if integers else numpy.float64), deep=True)
    array.SetName(name)
    data.GetAttributesAsFieldData(kind).AddArray(array)


def normals_of(surface, kind):
    algorithm = vtkPolyDataNormals()
    algorithm.SetInputData(surface)
    algorithm.SplittingOff()
    algorithm.ConsistencyOff()
    algorithm.ComputeCellNormalsOn()
    algorithm.Update()
    return vtk_to_numpy(algorithm.GetOutput().GetAttributes(kind).GetNormals())


def add_normals(data, kind):
    """Normals that are right on a surface."""
    add(data, kind, 'Normals', 3)
    if data.IsA('vtkPolyData') and data.GetNumberOfPolys():
        vtk_to_numpy(arrays(data, kind)['Normals'])[:] = normals_of(data, kind)


def are_normals(array, output, kind):
    """Within 18 degrees of the surface's own for nearly all of its points or cells: they need not be
    weighted alike. Those of a solid, which had none to begin with, have changed."""
    normals = vtk_to_numpy(array)
    if not output.IsA('vtkPolyData'):
        return (normals != FALSE).any()
    return numpy.percentile((normals * normals_of(output, kind)).sum(axis=1), 5) > 0.95


def same_points(a, b):
    return (not b.IsA('vtkTable') and a.GetNumberOfPoints() == b.GetNumberOfPoints() and a.GetNumberOfCells() == b.GetNumberOfCells() and
            (shapetesting.points(a) == shapetesting.points(b)).all())


def cases():
    """Filters with inputs: the usual ones, and hexahedra if the first port takes any data set."""
    for name in filters.names():
        algorithm = filters.new(name)
        inputs = {port: filters.good_input(name, port) for port in filters.required_ports(algorithm)}
        yield name, inputs
        types = algorithm.GetInputPortInformation(0).Get(algorithm.INPUT_REQUIRED_DATA_TYPE(), 0)
        if types == 'vtkDataSet' and not inputs[0].IsA('vtkUnstructuredGrid'):
            ball = shapetesting.read('BallSmall.vtu')
            shapetesting.add_array(ball, shapetesting.points(ball) * [1.0, 0.8, 1.3], 'TargetPosition')
            yield name, {**inputs, 0: ball}


# What is written: each array that an output has and no input of its filter.
written = {POINT: {}, CELL: {}}
references = []
for name, inputs in cases():
    made = outputs(name, inputs)
    references.append((name, inputs, made))
    for port, output in data_sets(made):
        for kind in written:
            given = set().union(*(arrays(data, kind) for data in inputs.values()))
            for array_name, array in arrays(output, kind).items():
                array_name = array_name.removeprefix('Receiver')  # of Shape Transfer Fields, where both have one
                if array_name not in given | CONTRACT:
                    written[kind][array_name] = (
                        array.GetNumberOfComponents(), array.GetDataTypeAsString() == 'int')
for measure in OTHERS | {'Quality', 'CellQuality', 'Length'}:
    written[CELL].setdefault(measure, (1, False))
print('measures of points: %s\nmeasures of cells: %s' % (sorted(written[POINT]), sorted(written[CELL])))
assert {'GeodesicDistance', 'BoundaryDistance', 'Eigenfunctions'} <= set(written[POINT])
assert {'ScaledJacobian', 'Volume', 'ARAP', 'Distance', 'Flipped', 'Inverted'} <= set(written[CELL])

moving, renewed, faults = set(), set(), []
for name, inputs, reference in references:
    carrying = {}
    for port, data in inputs.items():
        carrying[port] = shapetesting.copy(data)
        if data.IsA('vtkTable'):
            continue
        for kind, measures in written.items():
            for measure, (components, integers) in measures.items():
                add(carrying[port], kind, measure, components, integers)
            add_normals(carrying[port], kind)
            add(carrying[port], kind, 'Temperature')
            add(carrying[port], kind, 'Material', integers=True)
            add(carrying[port], kind, 'Shape' if kind == POINT else 'Batch', integers=True)  # a label
        for other in filters.names():
            add(carrying[port], FIELD, other[len('Shape'):] + '.Stale')
        for fact in ('Study.Dose', 'Dose', 'Mesh Hexahedron Quality'):
            add(carrying[port], FIELD, fact)
    made = outputs(name, carrying)
    for port, output in data_sets(made):
        # Moved points have SourcePosition, also if they have come to lie where they were.
        kept = None if 'SourcePosition' in arrays(output, POINT) else next(
            (data for data in carrying.values() if same_points(output, data)), None)
        place = '%s, output %d' % (name, port)
        own = reference[port]
        for kind, measures in written.items():
            found = arrays(output, kind)
            if kept:
                lost = set(arrays(kept, kind)) - set(found)
                assert not lost, '%s has its input\'s points and lost %s' % (place, lost)
                continue
            for measure in measures:
                if measure not in found:
                    continue
                fresh = arrays(own, kind).get(measure)
                if fresh is None and kind == CELL and measure in VERDICT:
                    quality = vtkMeshQuality()
                    quality.SetInputData(output)
                    getattr(quality, 'SetHexQualityMeasureTo' + measure)()
                    quality.Update()
                    fresh = quality.GetOutput().GetCellData().GetArray('Quality')
                    renewed.add(name)
                if fresh is None:
                    faults.append('%s: %s' % (place, measure))
                elif values(fresh).tobytes() != values(found[measure]).tobytes():
                    faults.append('%s: %s is not that of the output' % (place, measure))
            normals = found.get('Normals')
            if normals and not kept and not are_normals(normals, output, kind):
                faults.append('%s: Normals' % place)
        if not kept:
            moving.add(name)
            faults += ['%s: the fact %s' % (place, fact) for fact in arrays(output, FIELD)
                       if fact.endswith('.Stale') or fact.startswith('Mesh ')]
            if 'SourcePosition' in arrays(output, POINT):
                assert {'Study.Dose', 'Dose'} <= set(arrays(output, FIELD)), place
                # New hexahedra lead back into their own grid; the loop of a pasted feature is a curve of its own.
                if name != 'ShapeHexRemesh' and place != 'ShapePasteFeature, output 1':
                    assert {'Temperature', 'Material', 'Shape'} <= set(arrays(output, POINT)), place
                    # The edges of a handle and the tetrahedra of a surface's solid are new.
                    if (name, port) not in {('ShapeDeform', 1), ('ShapeRegisterVolume', 1)}:
                        assert {'Temperature', 'Material', 'Batch'} <= set(arrays(output, CELL)), place
    print(name, 'done')
print('filters with outputs that have points of their own:', sorted(moving))
print('measures of hexahedra computed again by:', sorted(renewed))
assert {'ShapeHarmonicVolumeMap', 'ShapeApplyVolumeMap', 'ShapeMorph', 'ShapeDeform', 'ShapeUntangle', 'ShapeParameterize',
        'ShapePolycube', 'ShapeHexRemesh', 'ShapePasteFeature', 'ShapeFillHoles', 'ShapeCutFeature'} <= moving
assert not faults, '%d measures of another geometry:\n%s' % (len(faults), '\n'.join(faults))
