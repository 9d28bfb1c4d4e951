"""Every filter is in an example; each example is short and has the line of README.md that its title is."""
import glob
import os
import re

import filters
import shapetesting

folder = os.path.join(shapetesting.ROOT, 'Examples')
table = open(os.path.join(folder, 'README.md')).read()
used = set()
examples = sorted(glob.glob(os.path.join(folder, '*.py')) +
                  glob.glob(os.path.join(folder, 'CPlusPlus', '*.cxx')))
assert len(examples) >= 18, examples
for path in examples:
    text = open(path).read()
    name = os.path.relpath(path, folder)
    title = text.splitlines()[0].strip('"/ ')
    row = '| [%s](%s) | %s |' % (os.path.splitext(os.path.basename(path))[0], name, title)
    assert row in table, 'Examples/README.md has no row ' + row
    assert 15 <= len(text.splitlines()) <= 40, '%s has %d lines' % (name, len(text.splitlines()))
    used.update(re.findall(r'\bShape\w+(?=\()', text))
for link in re.findall(r'\]\(([^)#:]+)\)', table):
    assert os.path.exists(os.path.join(folder, link)), 'Examples/README.md links to no ' + link
unused = sorted(set(filters.names()) - used)
assert not unused, 'no example uses %s' % unused
print(len(examples), 'examples use every filter')
