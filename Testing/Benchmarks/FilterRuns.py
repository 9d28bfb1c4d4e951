"""Runs filters and writers for FilterCases.py, with the defaults of their XML and other values."""
import os
import sys
import tempfile

import sweep

sys.path.append(os.path.join(sweep.ROOT, 'Testing', 'Conformance'))

import FilterChanges
import filters
import shapetesting
from FilterInputs import of, recipe
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer

PRESENT = set(filters.names())
OLD_NAMES = {new: old for renames in (FilterChanges.FILTER_NAMES, FilterChanges.PROPERTY_NAMES)
             for old, new in renames.items()}


def smproxy_of(name):
    """With the defaults of its XML."""
    return filters.proxy(name if name in PRESENT else OLD_NAMES.get(name, name))


def set_property(smproxy, key, value):
    values = value if isinstance(value, list) else [value]
    held = smproxy.GetProperty(key) or smproxy.GetProperty(OLD_NAMES.get(key, key))
    held.SetNumberOfElements(len(values))
    for i, each in enumerate(values):
        held.SetElement(i, each)


def producer(data):
    made = vtkTrivialProducer()
    made.SetOutput(data)
    return made


def execute(name, inputs, settings):
    """The outputs and error messages."""
    settings = {key: value() if callable(value) else value for key, value in settings.items()}
    time_step = settings.pop('time', None)
    smproxy = smproxy_of(name)
    for key, value in settings.items():
        set_property(smproxy, key, value)
    smproxy.UpdateVTKObjects()
    algorithm = smproxy.GetClientSideObject()
    kept = []
    for port, data in enumerate(inputs):
        for each in data if isinstance(data, (list, tuple)) else [data]:
            if each is not None:
                kept.append(producer(each()))
                algorithm.AddInputConnection(port, kept[-1].GetOutputPort())
    messages = shapetesting.run(algorithm)
    if time_step is not None and not messages:
        algorithm.UpdateTimeStep(time_step)
    outputs = [algorithm.GetOutputDataObject(i) for i in range(algorithm.GetNumberOfOutputPorts())]
    return [shapetesting.copy(output) for output in outputs], messages


@recipe
def chained(name, inputs, settings):
    outputs, messages = execute(name, inputs, dict(settings))
    if messages:
        raise RuntimeError('%s in a chain: %s' % (name, ' '.join(messages)))
    return outputs


port_of = of(lambda outputs, port: outputs[port])


def chain(name, port, inputs, **settings):
    """What a filter makes of inputs, as an input."""
    inputs = tuple(tuple(each) if isinstance(each, list) else each for each in inputs)
    return port_of(chained(name, inputs, tuple(sorted(settings.items()))), port)


def file_lines(name, inputs, settings):
    """What a writer writes."""
    smproxy = filters.proxy(name + 'Core', 'internal_writers')
    for key, value in settings.items():
        set_property(smproxy, key, value)
    smproxy.UpdateVTKObjects()
    writer = smproxy.GetClientSideObject()
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, 'file')
        writer.SetFileName(path)
        writer.SetInputDataObject(0, inputs[0]())
        messages = shapetesting.run(writer)
        content = open(path, 'rb').read() if os.path.exists(path) else b''
    return content, messages


def alternatives(smproxy, settings):
    """(property's new name, value) of each other value of its enumerations and switches."""
    for key, held in filters.properties(smproxy):
        key = FilterChanges.PROPERTY_NAMES.get(key, key)
        if key == 'Dragging' or held.GetInformationOnly() or held.IsA('vtkSMInputProperty'):
            continue
        current = settings.get(key, held.GetElement(0) if held.GetNumberOfElements() == 1 else None)
        domains = held.NewDomainIterator()
        domains.Begin()
        while not domains.IsAtEnd():
            domain = domains.GetDomain()
            values = []
            if domain.IsA('vtkSMEnumerationDomain'):
                values = [domain.GetEntryValue(i) for i in range(domain.GetNumberOfEntries())]
            elif domain.IsA('vtkSMBooleanDomain'):
                values = [0, 1]
            for value in values:
                if value != current:
                    yield key, value
            domains.Next()
