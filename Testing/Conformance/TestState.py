"""A state file saved and loaded gives back every property of every filter."""
import os
import tempfile

from paraview import simple

import filters
import shapetesting


def other_value(property, index):
    """A value that is not the property's current one, and that it can have."""
    value = property.GetElement(index)
    domain = property.FindDomain('vtkSMEnumerationDomain')
    if domain:
        values = [domain.GetEntryValue(i) for i in range(domain.GetNumberOfEntries())]
        return next((v for v in values if v != value), value)
    if property.FindDomain('vtkSMBooleanDomain'):
        return 1 - value
    if property.IsA('vtkSMStringVectorProperty'):
        return 'SourcePosition' if value != 'SourcePosition' else 'TargetPosition'
    return value + 1 if property.IsA('vtkSMIntVectorProperty') else 0.5 * value + 0.125


def is_saved(property):
    return not (property.IsA('vtkSMInputProperty') or property.GetInformationOnly() or
                property.GetIsInternal())


def values_of(smproxy):
    values = {}
    for key, property in filters.properties(smproxy):
        if not is_saved(property):
            continue
        values[key] = [property.GetElement(i) for i in range(property.GetNumberOfElements())]
    return values


def change(smproxy):
    """Gives every saved property other values; returns how many differ."""
    changed = 0
    for key, property in filters.properties(smproxy):
        if not is_saved(property):
            continue
        for i in range(property.GetNumberOfElements()):
            value = other_value(property, i)
            changed += value != property.GetElement(i)
            property.SetElement(i, value)
    smproxy.UpdateVTKObjects()
    return changed


def inputs_of(made):
    """The number of inputs of each port."""
    return {key: property.GetNumberOfProxies() for key, property in filters.properties(made.SMProxy)
            if property.IsA('vtkSMInputProperty')}


# One state with every filter.
source = simple.XMLPolyDataReader(FileName=[shapetesting.data_file('DentedSphere600.vtp')])
changed, before, before_inputs = {}, {}, {}
for name in filters.names():
    inputs = {key: source for key, property in filters.properties(filters.proxy(name))
              if property.IsA('vtkSMInputProperty')}
    made = getattr(simple, name)(registrationName=name, **inputs)
    changed[name] = change(made.SMProxy)
    before[name], before_inputs[name] = values_of(made.SMProxy), inputs_of(made)
with tempfile.TemporaryDirectory() as folder:
    path = os.path.join(folder, 'filters.pvsm')
    simple.SaveState(path)
    simple.ResetSession()
    simple.LoadState(path)
for name in filters.names():
    loaded = simple.FindSource(name)
    assert loaded is not None, name + ' was not in the state file'
    after = values_of(loaded.SMProxy)
    assert before[name] == after, '%s: saved %s, loaded %s' % (name, before[name], after)
    after_inputs = inputs_of(loaded)
    assert before_inputs[name] == after_inputs and all(after_inputs.values()), '%s: inputs %s, %s' % (
        name, before_inputs[name], after_inputs)
    # The object itself must have received them.
    held = loaded.SMProxy.GetClientSideObject()
    for key, saved in before[name].items():
        value = getattr(held, 'Get' + key)()
        value = list(value) if isinstance(value, (tuple, list)) else [value]
        assert all(type(b)(a) == b for a, b in zip(saved, value)), '%s.%s' % (name, key)
    print('%s: %d of %d properties changed, saved and loaded' % (name, changed[name], len(before[name])))
