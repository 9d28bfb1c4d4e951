"""Every ShapeMap filter (and writer) that the plugin brings, with inputs that each of its ports takes.

A new filter is found by its proxy's name and tested without a line here, as long as a closed
surface with TargetPosition suits every port that it requires; else OTHER_INPUTS says what does."""
import numpy
from paraview import servermanager
from paraview.simple import GetActiveSource  # connects to the built-in server
import shapemap.vtkShapeFilters as module
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkMultiBlockDataSet, vtkUnstructuredGrid
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter

import shapetesting

# What a port that it requires takes in place of the closed surface: (filter, input) -> file of Data/.
OTHER_INPUTS = {
    ('ShapeApplyVolumeMap', 'Map'): 'DentedSphereCharges.vtp',
    ('ShapeCertificate', 'Map'): 'DentedSphereCharges.vtp',
    ('ShapeDeform', 'Input'): 'FigureASmall.vtp',
    ('ShapeImageValues', 'Input'): 'BallSmall.vtu',
    ('ShapeMeshMotion', 'Input'): 'BallSmall.vtu',
    ('ShapeUntangle', 'Input'): 'BallSmall.vtu',
}
# Options with which a filter works on the same inputs in less time: what is checked of every filter
# does not depend on them. The kernels' tests check the other methods.
OPTIONS = {
    'ShapeCorrespondence': {'CoarsePoints': 100},
    'ShapeCoupling': {'Samples': 20, 'Starts': 2},
    'ShapeImageValues': {'Density': '0.01 * Value'},
    'ShapeHexRemesh': {'Method': 2, 'CellsOnLongestSide': 4},
    'ShapeNetworkDescriptors': {'FileName': shapetesting.data_file('RandomFeatures.onnx')},
    'ShapeLandmarks': {'PointsA': [0.0, 0.0, 1.0, 1.0, 0.0, 0.0]},
    'ShapeSynthesize': {'Tetrahedra': 2000},
    # One stroke: Set, radius 0.3, strength 1, value 1, six points.
    'ShapePaintArray': {'Strokes': [(0, 0.3, 1.0, 1.0, 6)],
                        'StrokePoints': [(0.1 * i, 0.0, 1.0) for i in range(6)]},
}


def cap():
    """The part of the closed surface around its point with the greatest x: small and open."""
    surface = shapetesting.read('DentedSphere600.vtp')
    places = shapetesting.points(surface)
    far = numpy.linalg.norm(places - places[places[:, 0].argmax()], axis=1) > 0.35
    return shapetesting.without_cells(
        surface, numpy.flatnonzero(far[shapetesting.triangles(surface)].any(axis=1)).tolist())


def holed():
    """The closed surface without the triangles around its point with the greatest x: one hole."""
    surface = shapetesting.read('DentedSphere600.vtp')
    places = shapetesting.points(surface)
    near = numpy.linalg.norm(places - places[places[:, 0].argmax()], axis=1) < 0.35
    return shapetesting.without_cells(
        surface, numpy.flatnonzero(near[shapetesting.triangles(surface)].all(axis=1)).tolist())


def segmented():
    """An image of two regions that touch."""
    i, j, k = numpy.indices((14, 12, 10))
    inside = (i - 6.4) ** 2 + (j - 5.6) ** 2 + (k - 4.5) ** 2 < 16.0
    image = vtkImageData()
    image.SetDimensions(14, 12, 10)
    labels = numpy_to_vtk((inside * (1 + (i > 6))).ravel(order='F').astype(numpy.int32), deep=True)
    labels.SetName('Label')
    image.GetPointData().SetScalars(labels)
    return image


def scanned():
    """A grey image around the small ball."""
    i, j, k = numpy.indices((9, 9, 9))
    image = vtkImageData()
    image.SetDimensions(9, 9, 9)
    image.SetOrigin(-1.6, -1.6, -1.6)
    image.SetSpacing(0.4, 0.4, 0.4)
    values = numpy_to_vtk((100.0 + 10.0 * i + j * k).ravel(order='F'), deep=True)
    values.SetName('Grey')
    image.GetPointData().SetScalars(values)
    return image


def stretched():
    """The surface of the small ball, which stretches."""
    geometry = vtkGeometryFilter()
    geometry.SetInputData(shapetesting.read('BallSmall.vtu'))
    geometry.Update()
    surface = geometry.GetOutput()
    shapetesting.add_array(surface, shapetesting.points(surface) * [1.0, 1.0, 1.2], 'TargetPosition')
    return surface


def divided():
    """A box of 3 x 2 x 2 cells as the grid of hexahedra."""
    image = vtkImageData()
    image.SetDimensions(4, 3, 3)
    places = numpy.array([image.GetPoint(i) for i in range(image.GetNumberOfPoints())])
    i, j, k = (index.ravel(order='F') for index in numpy.indices((3, 2, 2)))
    first = i + 4 * (j + 3 * k)
    corners = first[:, None] + numpy.array([0, 1, 5, 4, 12, 13, 17, 16])
    grid = vtkUnstructuredGrid()
    grid.SetPoints(vtkPoints())
    grid.GetPoints().SetData(numpy_to_vtk(places, deep=True))
    cells = vtkCellArray()
    for cell in corners:
        cells.InsertNextCell(8, cell.tolist())
    grid.SetCells(12, cells)
    for data, name, values in (
            (grid.GetPointData(), 'TargetPosition', places + 0.1 * numpy.sin(places[:, ::-1])),
            (grid.GetCellData(), 'Block', numpy.zeros(12, numpy.int32)),
            (grid.GetCellData(), 'BlockIndex', numpy.stack((i, j, k), axis=1).astype(numpy.int32))):
        array = numpy_to_vtk(values, deep=True)
        array.SetName(name)
        data.AddArray(array)
    return grid


def modes():
    """A mean shape, whose template is the unit sphere, with one mode."""
    mean = shapetesting.read('DentedSphere600.vtp')
    shapetesting.add_array(mean, shapetesting.array(mean, 'TargetPosition'), 'SourcePosition')
    shapetesting.add_array(mean, 0.1 * shapetesting.points(mean) * [1.0, 0.0, -1.0], 'Mode0')
    return mean


def operators():
    """The table of Shape Map Difference of the closed surface and itself."""
    algorithm = module.vtkShapeMapDifference()
    algorithm.SetNumberOfEigenpairs(8)
    for port in range(2):
        algorithm.SetInputDataObject(port, shapetesting.read('DentedSphere600.vtp'))
    algorithm.Update()
    return algorithm.GetOutputDataObject(1)


class Population(module.vtkShapeAtlas):
    """Shape Atlas, which needs three surfaces. Python gives it one, or blocks, and two that are stretched."""

    def SetInputDataObject(self, port, data):
        first = data.GetBlock(0) or data.GetBlock(1) if data.IsA('vtkMultiBlockDataSet') else data
        if port == 0 and first.IsA('vtkPolyData') and first.GetPoints():
            blocks = vtkMultiBlockDataSet()
            if first is data:
                blocks.SetBlock(0, data)
            else:
                blocks.ShallowCopy(data)
            for stretch in ([1.2, 1.0, 1.0], [1.0, 0.9, 1.0]):
                stretched = shapetesting.copy(first)
                shapetesting.set_points(stretched, shapetesting.points(first) * stretch)
                blocks.SetBlock(blocks.GetNumberOfBlocks(), stretched)
            data = blocks
        super().SetInputDataObject(port, data)


# Inputs that no file has; also optional ones that others may take the place of, one of which is
# required.
NEEDED_INPUTS = {
    ('ShapeGeodesicDistance', 'Seeds'): lambda: shapetesting.read('DentedSphere600.vtp'),
    ('ShapeHexRemesh', 'Surface'): lambda: shapetesting.read('DentedSphere600.vtp'),
    ('ShapeDeform', 'Boundary'): lambda: shapetesting.read('FigureBSmall.vtp'),
    ('ShapePasteFeature', 'Feature'): cap,
    ('ShapeFromOperators', 'Operators'): operators,
    ('ShapeCutFeature', 'Loop'): lambda: shapetesting.closed_curve(
        [[0.6 * numpy.cos(t), 0.6 * numpy.sin(t), 0.8] for t in 0.26 * numpy.arange(24)]),
    ('ShapeFillHoles', 'Input'): holed,
    ('ShapeLabelSurfaces', 'Input'): segmented,
    ('ShapeImageValues', 'Image'): scanned,
    ('ShapeMeshMotion', 'Boundary'): stretched,
    ('ShapeStructuredBlocks', 'Input'): divided,
    ('ShapeSynthesize', 'Atlas'): modes,
}

GetActiveSource()


def names(group='filters'):
    """The proxies' names: ShapeX."""
    session = servermanager.ActiveConnection.Session
    definitions = session.GetProxyDefinitionManager().NewSingleGroupIterator(group)
    found = []
    definitions.InitTraversal()
    while not definitions.IsDoneWithTraversal():
        if hasattr(module, 'vtk' + definitions.GetProxyName()):
            found.append(definitions.GetProxyName())
        definitions.GoToNextItem()
    assert len(found) >= 2, 'the plugin is not loaded: %s' % found
    return sorted(found)


def writers():
    """The names of the writers' proxies, which ParaView runs: its properties are those of the proxy
    ShapeXCore, in internal_writers, whose class is vtkShapeX."""
    return names('writers')


def proxy(name, group='filters'):
    return servermanager.ProxyManager().NewProxy(group, name)


def properties(smproxy):
    """(name, property) of every property of a server-manager proxy."""
    iterator = smproxy.NewPropertyIterator()
    iterator.Begin()
    while not iterator.IsAtEnd():
        yield iterator.GetKey(), iterator.GetProperty()
        iterator.Next()


def new(name):
    """A fresh C++ object."""
    return Population() if name == 'ShapeAtlas' else getattr(module, 'vtk' + name)()


def quick(name):
    """A fresh C++ object with its OPTIONS."""
    algorithm = new(name)
    for option, value in OPTIONS.get(name, {}).items():
        if isinstance(value, list) and isinstance(value[0], tuple):  # the rows of a list
            getattr(algorithm, 'SetNumberOf' + option)(len(value))
            for index, row in enumerate(value):
                getattr(algorithm, 'Set' + option)(index, *row)
        else:
            getattr(algorithm, 'Set' + option)(value)
    return algorithm


def good_input(name, port):
    """Data that the port of a filter can work on."""
    key = name, new(name).GetInputName(port)
    if key in NEEDED_INPUTS:
        return NEEDED_INPUTS[key]()
    return shapetesting.read(OTHER_INPUTS.get(key, 'DentedSphere600.vtp'))


def required_ports(algorithm):
    """The ports that must be connected, or that stand for those of which one must be."""
    name = algorithm.GetClassName()[len('vtk'):]
    return [port for port in range(algorithm.GetNumberOfInputPorts())
            if (name, algorithm.GetInputName(port)) in NEEDED_INPUTS or
            algorithm.IsInputRequired(port)]


def with_good_inputs(name):
    """A quick C++ object whose required ports are connected to data that it can work on."""
    algorithm = quick(name)
    for port in required_ports(algorithm):
        algorithm.SetInputDataObject(port, good_input(name, port))
    return algorithm


def size_of(output):
    """Points, or a table's rows."""
    return sum(output.GetNumberOfElements(kind) for kind in (output.POINT, output.ROW))


def label(name):
    return new(name).GetLabel()
