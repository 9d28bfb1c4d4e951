"""What the Python tests share: data, running a filter while its errors are caught, pictures."""
import contextlib
import faulthandler
import os
import socket
import subprocess
import tempfile
import time

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (
    VTK_POLY_LINE, vtkCellArray, vtkPolyData, vtkSelection, vtkSelectionNode)
from vtkmodules.vtkFiltersCore import (
    vtkAppendPolyData, vtkExtractCells, vtkFeatureEdges, vtkImplicitPolyDataDistance)
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter, vtkXMLUnstructuredGridReader
from vtkmodules.vtkParallelCore import vtkMultiProcessController

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
BUILD = os.environ.get('SHAPEMAP_BUILD', os.path.join(ROOT, 'build'))
MODELS = os.environ.get('SHAPEMAP_MODELS', os.path.join(BUILD, 'models'))  # unpacked by Utilities/setup.sh
# Where a test hangs is told before CTest ends it.
faulthandler.dump_traceback_later(570, file=2)


def data_file(name):
    """A file of Data/, or of the larger ones that the build makes."""
    committed = os.path.join(ROOT, 'Data', name)
    return committed if os.path.exists(committed) else os.path.join(BUILD, 'Data', name)


def read(name):
    """A data set of data_file(name)."""
    reader = vtkXMLPolyDataReader() if name.endswith('.vtp') else vtkXMLUnstructuredGridReader()
    reader.SetFileName(data_file(name))
    reader.Update()
    assert reader.GetOutput().GetNumberOfPoints() > 0, 'cannot read ' + data_file(name)
    return reader.GetOutput()


def write(surface, path):
    """Every bit of a surface, for read()."""
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(path)
    writer.SetInputData(surface)
    writer.SetDataModeToBinary()
    assert writer.Write(), 'cannot write ' + path


def output(proxy, port=0):
    """What an updated ParaView filter of the built-in server has on a port: Fetch knows only the
    first one."""
    return outputs_of(proxy.SMProxy.GetClientSideObject())[port]


def outputs_of(algorithm):
    """Its outputs. Each remembers the facts of the first process, for facts()."""
    held = [algorithm.GetOutputDataObject(port) for port in range(algorithm.GetNumberOfOutputPorts())]
    tables = [data for data in held if data.IsA('vtkTable')]
    if algorithm.IsA('vtkShapeAlgorithm') and tables:
        prefix = algorithm.GetClassName()[len('vtkShape'):] + '.'
        table = tables[0].NewInstance()
        # Other processes have no facts, and other tables have none of these columns.
        for each in tables:
            if any(each.GetColumnName(k).startswith(prefix) for k in range(each.GetNumberOfColumns())):
                table.ShallowCopy(each)
        if parallel()[0] > 1:
            vtkMultiProcessController.GetGlobalController().Broadcast(table, 0)
        for data in held:
            data.facts = table.GetRowData()
    algorithm.held = held  # they remember as long as Python knows them
    return held


def copy(data):
    result = data.NewInstance()
    result.DeepCopy(data)
    if hasattr(data, 'facts'):
        result.facts = data.facts
    return result


def points(data):
    return vtk_to_numpy(data.GetPoints().GetData()).astype(float)


def array(data, name):
    values = data.GetPointData().GetArray(name)
    assert values is not None, 'there is no point array ' + name
    return vtk_to_numpy(values)


def facts(data):
    """The arrays that describe how an output was made: what its filter said, else its field data."""
    return getattr(data, 'facts', data.GetFieldData())


def fact(data, name):
    """A number or words of them."""
    values = facts(data).GetAbstractArray(name)
    assert values is not None, 'there is no fact ' + name
    return values.GetValue(0)


def triangles(surface):
    return vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def edges_of(surface, kind):
    """The edges of a kind: Boundary or NonManifold."""
    algorithm = vtkFeatureEdges()
    algorithm.SetInputData(surface)
    for each in ('Boundary', 'NonManifold', 'Feature', 'Manifold'):
        getattr(algorithm, 'Set%sEdges' % each)(each == kind)
    algorithm.Update()
    return algorithm.GetOutput()


def edges(surface, kind):
    """How many there are."""
    return edges_of(surface, kind).GetNumberOfCells()


def euler(surface):
    faces = triangles(surface)
    sides = numpy.sort(numpy.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]))
    return len(numpy.unique(faces)) - len(numpy.unique(sides, axis=0)) + len(faces)


def places_on(surface, count, random):
    """Random places on triangles, evenly over the area, and the unit normals there."""
    corners = points(surface)[triangles(surface)]
    normals = numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    areas = numpy.linalg.norm(normals, axis=1)
    chosen = random.choice(len(areas), count, p=areas / areas.sum())
    shares = random.dirichlet([1.0, 1.0, 1.0], count)
    return numpy.einsum('ik,ikc->ic', shares, corners[chosen]), (
        normals[chosen] / areas[chosen, None])


def nearest_positions(positions, surface):
    """The nearest positions on a surface."""
    distance, found = vtkImplicitPolyDataDistance(), numpy.empty((len(positions), 3))
    distance.SetInput(surface)
    for i, position in enumerate(positions):
        distance.EvaluateFunctionAndGetClosestPoint(position, found[i])
    return found


def set_points(data, coordinates):
    data.GetPoints().SetData(numpy_to_vtk(numpy.ascontiguousarray(coordinates), deep=True))


def add_array(data, values, name):
    values = numpy_to_vtk(numpy.ascontiguousarray(values), deep=True)
    values.SetName(name)
    data.GetPointData().AddArray(values)


def closed_curves(curves):
    """One closed polyline for each list of places."""
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    set_points(data, numpy.vstack(curves).astype(float))
    data.SetLines(vtkCellArray())
    first = 0
    for places in curves:
        count = len(places)
        data.InsertNextCell(VTK_POLY_LINE, count + 1, [first + i % count for i in range(count + 1)])
        first += count
    return data


def closed_curve(places):
    return closed_curves([places])


def torus(major, minor, around, across):
    """A closed surface of genus 1, around the z axis, with as many quadrilaterals, cut into triangles."""
    rows, columns = numpy.divmod(numpy.arange(around * across), across)
    u, v = 2 * numpy.pi * rows / around, 2 * numpy.pi * columns / across
    distance = major + minor * numpy.cos(v)

    def number(row, column):
        return (row % around) * across + column % across

    corners = [number(rows, columns), number(rows + 1, columns), number(rows + 1, columns + 1),
               number(rows, columns + 1)]
    faces = numpy.concatenate([numpy.column_stack([corners[k] for k in each]) for each in ((0, 1, 2), (0, 2, 3))])
    surface, cells = vtkPolyData(), vtkCellArray()
    surface.SetPoints(vtkPoints())
    set_points(surface, numpy.column_stack([distance * numpy.cos(u), distance * numpy.sin(u), minor * numpy.sin(v)]))
    cells.SetData(numpy_to_vtkIdTypeArray(3 * numpy.arange(len(faces) + 1), deep=True),
                  numpy_to_vtkIdTypeArray(faces.ravel(), deep=True))
    surface.SetPolys(cells)
    return surface


def selection_of(ids, kind):
    """A selection of cells or points: of the field type `kind` of vtkSelectionNode."""
    node = vtkSelectionNode()
    node.SetContentType(vtkSelectionNode.INDICES)
    node.SetFieldType(kind)
    node.SetSelectionList(numpy_to_vtkIdTypeArray(numpy.asarray(ids, numpy.int64), deep=True))
    selection = vtkSelection()
    selection.AddNode(node)
    return selection


def without_cells(surface, cells):
    """A copy without some of its cells; every point stays."""
    opened = copy(surface)
    opened.BuildLinks()
    for cell in cells:
        opened.DeleteCell(cell)
    opened.RemoveDeletedCells()
    return opened


def with_cells(data, cells):
    """Some of its cells, in increasing order, and their points, as a surface or a grid, whichever it is."""
    extract = vtkExtractCells()
    extract.SetInputData(data)
    for run in numpy.split(numpy.asarray(cells), numpy.flatnonzero(numpy.diff(cells) != 1) + 1):
        extract.AddCellRange(int(run[0]), int(run[-1]))
    extract.Update()
    if data.IsA('vtkUnstructuredGrid'):
        return extract.GetOutput()
    surface = vtkGeometryFilter()
    surface.SetInputConnection(extract.GetOutputPort())
    surface.Update()
    return surface.GetOutput()


def with_charge(charges, position, charge):
    """The charge set with one more charge."""
    one = vtkPolyData()
    one.SetPoints(vtkPoints())
    one.GetPoints().InsertNextPoint(position)
    add_array(one, numpy.array([charge], float), 'Charge')
    append = vtkAppendPolyData()
    append.AddInputData(charges)
    append.AddInputData(one)
    append.Update()
    result = append.GetOutput()
    result.GetFieldData().ShallowCopy(charges.GetFieldData())
    return result


def errors_of(source, action):
    """What an object says in error events while it acts."""
    from vtkmodules.util.misc import calldata_type
    from vtkmodules.util.vtkConstants import VTK_STRING
    messages = []

    @calldata_type(VTK_STRING)
    def record(caller, event, message):
        messages.append(message)

    tag = source.AddObserver('ErrorEvent', record)
    action()
    source.RemoveObserver(tag)
    return messages


def run(algorithm):
    """Updates an algorithm; returns its error messages and those of its executive."""
    from vtkmodules.vtkCommonCore import vtkCommand
    from vtkmodules.util.misc import calldata_type
    from vtkmodules.util.vtkConstants import VTK_STRING
    messages = []

    @calldata_type(VTK_STRING)
    def record(caller, event, message):
        messages.append(message)

    tags = [(source, source.AddObserver('ErrorEvent', record))
            for source in (algorithm, algorithm.GetExecutive())]
    algorithm.Update()
    for source, tag in tags:
        source.RemoveObserver(tag)
    outputs_of(algorithm)
    return messages


def new(kind, *inputs, **settings):
    """An algorithm of a class with an input for each port, None for none and a list for several, and
    its settings by name."""
    algorithm = kind()
    for port, data in enumerate(inputs):
        for each in data if isinstance(data, (list, tuple)) else [data]:
            if each is not None:
                algorithm.AddInputDataObject(port, each)
    for name, value in settings.items():
        getattr(algorithm, 'Set' + name)(value)
    return algorithm


def outputs(algorithm):
    """The outputs of an algorithm, which must not fail."""
    messages = run(algorithm)
    assert not messages, messages
    return outputs_of(algorithm)


def refusal(algorithm):
    """What an algorithm says when it fails, which leaves its outputs empty; '' if it does not."""
    messages = run(algorithm)
    for port in range(algorithm.GetNumberOfOutputPorts() if messages else 0):
        output = algorithm.GetOutputDataObject(port)
        assert output.GetNumberOfElements(output.POINT) == 0, 'an error left a part of output %d' % port
        assert output.GetNumberOfElements(output.ROW) == 0, 'an error left a part of output %d' % port
    return ' '.join(messages)


def check_refused(algorithm, *words):
    """It fails with a message that has all of the words: the fact and the remedy."""
    said = refusal(algorithm)
    for word in words:
        assert word in said, said


def parallel():
    """How many processes run this script, and the number of this one."""
    controller = vtkMultiProcessController.GetGlobalController()
    return (controller.GetNumberOfProcesses(), controller.GetLocalProcessId()) if controller else (1, 0)


@contextlib.contextmanager
def server(command):
    """Runs a pvserver, as ['pvserver'] or with mpiexec in front, and gives the port that it waits at."""
    with socket.socket() as free:
        free.bind(('localhost', 0))
        port = free.getsockname()[1]
    # This process is an MPI process itself: what it inherited would make mpiexec refuse.
    environment = {key: value for key, value in os.environ.items()
                   if not key.startswith(('OMPI_', 'PMIX_', 'PRTE_', 'ORTE_'))}
    with tempfile.NamedTemporaryFile('w+') as log:
        process = subprocess.Popen(command + ['--server-port=%d' % port], stdout=log,
                                   stderr=subprocess.STDOUT, env=environment)
        try:
            while 'Accepting connection' not in open(log.name).read():
                assert process.poll() is None, 'the server ended: ' + open(log.name).read()
                time.sleep(0.2)
            yield port
        finally:
            process.kill()


def picture_difference(picture, baseline):
    """How much two images of one size differ, as VTK's own tests measure it: the sum over pixels of what their colours
    differ by beyond 16 of 255 levels, in pixels that are wholly different. Unlike there, an image that is shifted by a
    pixel differs, and pixels are not averaged with their neighbours: both would hide defects."""
    from vtkmodules.vtkImagingCore import vtkImageDifference
    difference = vtkImageDifference()
    difference.SetInputData(picture)
    difference.SetImageData(baseline)
    difference.AllowShiftOff()
    difference.AveragingOff()
    difference.SetThreshold(16)
    difference.Update()
    return difference.GetThresholdedError()


def read_picture(path):
    """The colours of a PNG file, without its opacity."""
    from vtkmodules.vtkIOImage import vtkPNGReader
    from vtkmodules.vtkImagingCore import vtkImageExtractComponents
    assert os.path.exists(path), 'there is no ' + path
    reader = vtkPNGReader()
    reader.SetFileName(path)
    colours = vtkImageExtractComponents()
    colours.SetInputConnection(reader.GetOutputPort())
    colours.SetComponents(0, 1, 2)
    colours.Update()
    return colours.GetOutput()


# The bound of VTK's own tests. Rendering in software gives the same bits on every machine tried.
PICTURE_MARGIN = 10.0


def baseline_difference(picture, baseline):
    """picture_difference of the PNG file `picture` and Testing/Baselines/`baseline`."""
    images = [read_picture(path) for path in (picture, os.path.join(ROOT, 'Testing', 'Baselines', baseline))]
    sizes = [image.GetDimensions() for image in images]
    assert sizes[0] == sizes[1], 'sizes differ: %s and %s' % tuple(sizes)
    return picture_difference(*images)


def compare_picture(picture, baseline):
    """Raises unless the PNG file `picture` shows what Testing/Baselines/`baseline` shows."""
    difference = baseline_difference(picture, baseline)
    assert difference <= PICTURE_MARGIN, '%s differs from its baseline by %.1f pixels' % (picture, difference)
