"""Every ShapeMap filter (and writer) that the plugin brings, with inputs that each of its ports takes.

A new filter is found by its proxy's name and tested without a line here, as long as a closed
surface with TargetPosition suits every port that it requires; else OTHER_INPUTS says what does."""
from paraview import servermanager
from paraview.simple import GetActiveSource  # connects to the built-in server
import shapemap.vtkShapeFilters as module

import shapetesting

# What a port that it requires takes in place of the closed surface: (filter, input) -> file of Data/.
OTHER_INPUTS = {
    ('ShapeApplyVolumeMap', 'Map'): 'DentedSphereCharges.vtp',
    ('ShapeUntangle', 'Input'): 'BallSmall.vtu',
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
    return getattr(module, 'vtk' + name)()


def good_input(name, port):
    """Data that the port of a filter can work on."""
    key = name, new(name).GetInputName(port)
    return shapetesting.read(OTHER_INPUTS.get(key, 'DentedSphere600.vtp'))


def required_ports(algorithm):
    """The ports that must be connected."""
    return [port for port in range(algorithm.GetNumberOfInputPorts())
            if not algorithm.GetInputPortInformation(port).Get(algorithm.INPUT_IS_OPTIONAL())]


def with_good_inputs(name):
    """A fresh C++ object whose required ports are connected to data that it can work on."""
    algorithm = new(name)
    for port in required_ports(algorithm):
        algorithm.SetInputDataObject(port, good_input(name, port))
    return algorithm


def size_of(output):
    """Points, or a table's rows."""
    return sum(output.GetNumberOfElements(kind) for kind in (output.POINT, output.ROW))


def label(name):
    return new(name).GetLabel()
