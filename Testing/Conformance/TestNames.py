"""A filter or writer is called what its class is called, and everything about it is documented.

ParaView names its Python functions and properties by label, so the label without spaces must be the
name, and the name that of the C++ Set and Get."""
import filters


def check(condition, *words):
    if not condition:
        raise AssertionError(' '.join(str(word) for word in words))


def check_words(name, proxy, fresh):
    """The label and the documentation."""
    check(proxy.GetXMLLabel() == fresh.GetLabel(),
          name, 'is labelled', proxy.GetXMLLabel(), 'instead of', fresh.GetLabel())
    check(proxy.GetXMLLabel().replace(' ', '') == name, 'the label of', name, 'is not its name')
    documentation = proxy.GetDocumentation()
    for part in ('Description', 'ShortHelp', 'LongHelp'):
        text = getattr(documentation, 'Get' + part)()
        check(text and len(text.strip()) > 20, name, 'has no', part)


def check_property(where, key, property):
    check(property.GetXMLLabel().replace(' ', '') == key,
          where, 'is labelled', property.GetXMLLabel())
    text = property.GetDocumentation().GetDescription() if property.GetDocumentation() else None
    check(text and len(text.strip()) > 10, where, 'has no documentation')


def check_value(where, key, property, fresh):
    check(property.GetCommand() == 'Set' + key, where, 'calls', property.GetCommand())
    check(hasattr(fresh, 'Get' + key), where, 'has no Get' + key)


# The menu asks for these inputs, but another one can take their place.
REPLACEABLE = {('ShapeHexRemesh', 'Surface')}

for name in filters.names():
    proxy = filters.proxy(name)
    fresh = filters.new(name)
    check_words(name, proxy, fresh)
    check(proxy.GetVTKClassName() == 'vtk' + name, name, 'makes a', proxy.GetVTKClassName())
    hints = proxy.GetHints()
    menu = hints.FindNestedElementByName('ShowInMenu') if hints else None
    check(menu and menu.GetAttribute('category') == 'ShapeMap',
          name, 'is not in the menu Filters > ShapeMap')
    ports = [proxy.GetOutputPortName(i) for i in range(proxy.GetNumberOfOutputPorts())]
    check(len(ports) == fresh.GetNumberOfOutputPorts(), name, 'names the outputs', ports,
          'but has', fresh.GetNumberOfOutputPorts())
    check(0 in filters.required_ports(fresh), name, 'does not require its first input')
    inputs = 0
    for key, property in filters.properties(proxy):
        if property.GetInformationOnly():
            continue
        where = name + '.' + key
        check_property(where, key, property)
        if property.IsA('vtkSMInputProperty'):
            inputs += 1
            hints = property.GetHints()
            optional = hints.FindNestedElementByName('Optional') if hints is not None else None
            ports = [i for i in range(fresh.GetNumberOfInputPorts()) if fresh.GetInputName(i) == key]
            check(len(ports) == 1, where, 'names no input port')
            own_command = property.GetCommand() != 'SetInputConnection'
            check(own_command or property.GetPortIndex() == ports[0], where, 'fills another port')
            port = fresh.GetInputPortInformation(ports[0])
            check(own_command == bool(port.Get(fresh.INPUT_IS_REPEATABLE())), where,
                  'needs a command of its own exactly where the port is repeatable')
            check(port.Get(fresh.INPUT_IS_OPTIONAL()), where,
                  'is required by VTK, so a process without it would not hear that others lack it')
            asked = ports[0] == 0 and fresh.IsInputRequired(ports[0])
            check((optional is None) == asked, where,
                  'is not asked for in a dialog exactly where it is the first input and needed')
            needed = optional is None or optional.GetAttribute('needed') == '1'
            check(needed == fresh.IsInputRequired(ports[0]) or (name, key) in REPLACEABLE, where,
                  'is needed in XML or in C++, but not in both')
            check(hasattr(fresh, property.GetCommand()), where, 'calls', property.GetCommand())
        else:
            check_value(where, key, property, fresh)
    check(inputs == fresh.GetNumberOfInputPorts(), name, 'has properties for', inputs, 'of',
          fresh.GetNumberOfInputPorts(), 'input ports')
    print(name, 'is named and documented')

for name in filters.writers():
    proxy = filters.proxy(name, 'writers')
    core = filters.proxy(name + 'Core', 'internal_writers')
    fresh = filters.new(name)
    check_words(name, proxy, fresh)
    check(core.GetVTKClassName() == 'vtk' + name, name, 'makes a', core.GetVTKClassName())
    factory = proxy.GetHints().FindNestedElementByName('WriterFactory')
    check(factory and factory.GetAttribute('extensions') and factory.GetAttribute(
        'file_description'), name, 'is not in File > Save Data')
    for key, property in filters.properties(core):
        if property.IsA('vtkSMInputProperty'):  # for the lists of arrays alone
            continue
        where = name + '.' + key
        check(proxy.GetProperty(key), where, 'is not in the dialog')
        check_property(where, key, property)
        check_value(where, key, property, fresh)
    print(name, 'is named and documented')
