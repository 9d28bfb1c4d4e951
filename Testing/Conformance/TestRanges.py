"""Each number of the panel has a range, and the filter says so for every number that is not in it, also for one that
its method does not use: no NaN, no infinity, and nothing beyond the range that the panel shows."""
import math

import filters
import shapetesting

# Numbers beyond the range of the panel are valid: more layers are more work, and angles are equal to others.
OPEN = {('ShapeHexRemesh', 'PaddingLayers'), ('ShapePasteFeature', 'Rotation')}


def ranges(name):
    """(name of a property, number of its elements, whether they are integers, minimum or None, maximum or None)"""
    for key, prop in filters.properties(filters.proxy(name)):
        kind = prop.GetClassName()
        if kind not in ('vtkSMDoubleVectorProperty', 'vtkSMIntVectorProperty') or prop.GetRepeatCommand() or prop.GetInformationOnly():
            continue
        domain = prop.FindDomain('vtkSMDoubleRangeDomain') or prop.FindDomain('vtkSMIntRangeDomain')
        if kind == 'vtkSMIntVectorProperty' and not domain:
            continue
        minimum = domain.GetMinimum(0) if domain and domain.GetMinimumExists(0) else None
        maximum = domain.GetMaximum(0) if domain and domain.GetMaximumExists(0) else None
        yield key, prop.GetNumberOfElements(), kind == 'vtkSMIntVectorProperty', minimum, maximum


def wrong_numbers(isInteger, minimum, maximum):
    """Numbers that are in no range."""
    if not isInteger:
        yield from (math.nan, math.inf, -math.inf)
    if minimum is not None:
        yield minimum - 1
    if maximum is not None:
        yield maximum + 1
        if isInteger:
            yield 2 ** 31 - 1
        else:
            yield 1e300


faults = []
for name in filters.names():
    for key, count, isInteger, minimum, maximum in ranges(name):
        for number in wrong_numbers(isInteger, minimum, maximum):
            if (name, key) in OPEN and math.isfinite(number) and number != 0:
                continue
            algorithm = filters.with_good_inputs(name)
            setter = getattr(algorithm, 'Set' + key)
            setter(number) if count == 1 else setter(*([number] + [0.0] * (count - 1)))
            said = shapetesting.refusal(algorithm)
            words = said.lower().replace(' ', '')
            if filters.label(name) + ': ' not in said or key.lower() not in words:
                faults.append('%s, %s = %s: %s' % (name, key, number, said or 'accepted'))
    print(name, 'has its ranges')
assert not faults, '\n'.join(faults)
