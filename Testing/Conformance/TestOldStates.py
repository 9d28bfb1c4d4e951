"""States that earlier versions saved, as files and as Python scripts, still load: every value and
connection is the saved one, and every filter returns what it returned then.

Where a result changes for good reason, its numbers in the JSON file are changed; the states never are."""
import glob
import json
import os
from xml.etree import ElementTree

from paraview import simple

import shapetesting
import states

DATA = os.path.join(shapetesting.ROOT, 'Data')
# The polycube of these hexahedra ends after a number of Newton steps, before it converges: another order of
# sums changes it by 2e-5, and its hexahedra at most by this, relative to 1 or the number.
APPROXIMATE = {'PolycubeHexahedra': 1e-3}
FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), 'States')


def differences(found, saved, where, bound=1e-6):
    """Where results differ from those saved by more than the bound, relative to 1 or the number. There may be
    more output ports and more arrays now, and another processor rounds differently."""
    if isinstance(saved, dict):
        return [line for key, value in saved.items() for line in (
            differences(found[key], value, '%s, %s' % (where, key), APPROXIMATE.get(key, bound)) if key in found
            else ['%s: %s is missing' % (where, key)])]
    if isinstance(saved, list) and len(found) >= len(saved):
        return [line for k, value in enumerate(saved)
                for line in differences(found[k], value, '%s, %d' % (where, k), bound)]
    if found == saved or (isinstance(saved, float) and abs(found - saved) <= bound * max(1.0, abs(saved))):
        return []
    return ['%s: %s, saved %s' % (where, found, saved)]


def check_results(name, kind):
    states.update_all()
    with open(os.path.join(FOLDER, name + '.json')) as file:
        saved = json.load(file)
    wrong = differences(states.results(), saved, name + '.' + kind)
    assert not wrong, '\n'.join(wrong)
    ports = sum(len(outputs) for outputs in saved.values())
    print('%s.%s: %d sources and filters with %d outputs returned what they did' % (name, kind, len(saved), ports))


def check_values(path):
    """What the file says of the filters' properties is what the loaded filters have."""
    root = ElementTree.parse(path).getroot()
    names = {item.get('id'): item.get('name') for group in root.iter('ProxyCollection')
             if group.get('name') == 'sources' for item in group}
    registered = {proxy.SMProxy: name for name, proxy in states.sources()}
    checked = 0
    for saved in root.iter('Proxy'):
        if saved.get('id') not in names or not saved.get('type', '').startswith('Shape'):
            continue
        name = names[saved.get('id')]
        smproxy = simple.FindSource(name).SMProxy
        for item in saved.findall('Property'):
            property = smproxy.GetProperty(item.get('name'))
            assert property is not None, '%s has no property %s any more' % (saved.get('type'), item.get('name'))
            if property.GetInformationOnly():
                continue
            if property.IsA('vtkSMInputProperty'):
                # Connections are named by proxy and number of the output.
                wanted = [(names[each.get('value')], int(each.get('output_port'))) for each in item.findall('Proxy')]
                found = [(registered[property.GetProxy(k)], property.GetOutputPortForConnection(k))
                         for k in range(property.GetNumberOfProxies())]
            else:
                wanted = [each.get('value') for each in item.findall('Element')]
                found = [property.GetElement(k) for k in range(property.GetNumberOfElements())]
                wanted = [type(b)(a) for a, b in zip(wanted, found)] if len(wanted) == len(found) else wanted
            assert found == wanted, '%s.%s: %s, saved %s' % (name, item.get('name'), found, wanted)
            checked += 1
    assert checked > 100, 'only %d properties were found in %s' % (checked, path)
    print('%s: %d values and connections are those saved' % (os.path.basename(path), checked))


def check_shown():
    """The clipped hexahedra are visible in one view, coloured by the array that was chosen."""
    shown = [each for view in simple.GetViews() for each in view.Representations
             if each.GetProperty('Input') and each.Input.SMProxy is simple.FindSource('Half').SMProxy]
    assert len(shown) == 1 and shown[0].Visibility == 1, shown
    assert list(shown[0].ColorArrayName) == ['CELLS', 'ScaledJacobian'], shown[0].ColorArrayName


paths = sorted(glob.glob(os.path.join(FOLDER, '*.pvsm')))
assert paths
for path in paths:
    name = os.path.splitext(os.path.basename(path))[0]
    simple.ResetSession()
    simple.LoadState(path, data_directory=DATA)
    check_values(path)
    check_results(name, 'pvsm')
    check_shown()

    simple.ResetSession()
    os.chdir(DATA)
    with open(os.path.splitext(path)[0] + '.py') as script:
        exec(compile(script.read(), script.name, 'exec'), {})
    check_results(name, 'py')
    check_shown()
