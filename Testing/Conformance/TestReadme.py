"""README's example runs as it stands there, and it names every filter and writer."""
import os
import re

import filters
import shapetesting

text = open(os.path.join(shapetesting.ROOT, 'README.md')).read()
for name in filters.names() + filters.writers():
    row = '[%s](Filters/VTK/vtk%s.h)' % (filters.label(name), name)
    assert row in text, 'README has no row ' + row
for link in re.findall(r'\]\(([^)#:]+)\)', text):
    assert os.path.exists(os.path.join(shapetesting.ROOT, link)), 'README links to no ' + link

assert not re.search(r'@[A-Z]+@', text), 'README has a place where a figure should be'

examples = re.findall(r'```python\n(.*?)```', text, re.DOTALL)
assert len(examples) == 1
names = {}
exec(examples[0], names)
solid = names['solid']
error = solid.FieldData['HarmonicVolumeMap.RMSEInside'].GetRange()[0]
assert error < 0.005, error
bounds = solid.GetDataInformation().GetBounds()
sides = [bounds[2 * i + 1] - bounds[2 * i] for i in range(3)]
assert 0.5 < sides[0] < 2.0, 'the image lies within the ellipsoid: %s' % sides
assert sides[0] > max(sides[1:]), 'the image is long where the ellipsoid is: %s' % sides
print("README's example runs, and names every filter")
