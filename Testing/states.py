"""What the pipeline of a state returned, to compare with what it returned when the state was saved."""
from paraview import simple


def sources():
    """(name, proxy) of every source and filter of the pipeline."""
    return sorted((key[0], proxy) for key, proxy in simple.GetSources().items())


def update_all():
    for name, proxy in sources():
        proxy.UpdatePipeline()


def arrays(information):
    """The ranges of the arrays, by their names."""
    found = {}
    for k in range(information.GetNumberOfArrays()):
        array = information.GetArrayInformation(k)
        if array.GetName() == 'Seconds':
            continue
        # -1 is the magnitude of several components.
        component = -1 if array.GetNumberOfComponents() > 1 else 0
        found[array.GetName()] = list(array.GetComponentRange(component))
    return found


def result(information):
    """The sizes, bounds and arrays of an output. Facts and seconds are left out."""
    return {'class': information.GetDataClassName(), 'points': information.GetNumberOfPoints(),
            'cells': information.GetNumberOfCells(), 'rows': information.GetNumberOfRows(),
            'bounds': list(information.GetBounds()) if information.GetNumberOfPoints() else [],
            'point arrays': arrays(information.GetPointDataInformation()),
            'cell arrays': arrays(information.GetCellDataInformation()),
            'columns': arrays(information.GetRowDataInformation())}


def results():
    """For each source and filter, the results of its output ports."""
    return {name: [result(proxy.GetDataInformation(port)) for port in range(proxy.SMProxy.GetNumberOfOutputPorts())]
            for name, proxy in sources()}
