"""Every default of the XML is the default of a freshly made C++ object: the XML's is pushed onto the
object, so a different one would silently win."""
import filters


def listed(value):
    return list(value) if isinstance(value, (tuple, list)) else [value]


compared = 0
cases = [(name, filters.proxy(name)) for name in filters.names()]
cases += [(name, filters.proxy(name + 'Core', 'internal_writers')) for name in filters.writers()]
for name, proxy in cases:
    fresh = filters.new(name)
    for key, property in filters.properties(proxy):
        if property.IsA('vtkSMInputProperty') or property.GetInformationOnly():
            continue
        xml = [property.GetElement(i) for i in range(property.GetNumberOfElements())]
        cxx = listed(getattr(fresh, 'Get' + key)())
        assert len(xml) == len(cxx) and all(
            type(b)(a) == b for a, b in zip(xml, cxx)), '%s.%s is %s in XML and %s in C++' % (
                name, key, xml, cxx)
        compared += 1
assert compared > 0, 'no property was compared'
print(compared, 'defaults are equal')
