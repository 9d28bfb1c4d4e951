"""README's example, those of the pages and the tutorials run as they stand there, and every filter and
writer has its row in the overview. What the tutorials say about numbers, their scripts assert."""
import glob
import os
import re

from paraview import simple

import filters
import shapemap
import shapetesting


def text_of(*path):
    return open(os.path.join(shapetesting.ROOT, *path)).read()


def examples_of(text):
    return re.findall(r'```python\n(.*?)```', text, re.DOTALL)


def run(name, code):
    """The names that an example defines. A filter that fails prints an error and leaves its output
    empty; an example that prints nothing shows nothing."""
    names = {}
    try:
        exec(code, names)
    except Exception as error:
        raise AssertionError('%s: its example fails: %s' % (name, error)) from error
    assert 'print(' in code, name + ': its example prints nothing'
    for key, source in simple.GetSources().items():
        assert source.GetDataInformation().GetNumberOfPoints() > 0 or (
            source.GetDataInformation().GetNumberOfRows() > 0), '%s: %s is empty' % (name, key[0])
    return names


text = text_of('README.md')
assert not re.search(r'@[A-Z]+@', text), 'README has a place where a figure should be'
overview = text_of('Documentation', 'Filters.md')
for name in filters.names() + filters.writers():
    page = 'Filters/%s.md' % name[len('Shape'):]
    assert '| [%s](%s) |' % (filters.label(name), page) in overview, 'no row for ' + name
    examples = examples_of(text_of('Documentation', page))
    assert len(examples) == 1, '%s has %d examples' % (page, len(examples))
    os.chdir(shapetesting.ROOT)
    assert name in examples[0] or name.endswith('Writer'), page + ' does not use its filter'
    run(page, examples[0])
    simple.ResetSession()

for path in ['Documentation/FirstSteps.md', *sorted(glob.glob('Documentation/Tutorials/[A-Z]*.md'))]:
    examples = examples_of(text_of(path))
    assert len(examples) == (0 if path.endswith('README.md') else 1), path
    for example in examples:
        assert 'assert ' in example, path + ' states no fact'
        run(path, example)
        simple.ResetSession()

examples = examples_of(text)
assert len(examples) == 1
solid = run('README.md', examples[0])['solid']
error = shapemap.facts(solid)['RMSEInside']
assert error < 0.005, error
bounds = solid.GetDataInformation().GetBounds()
sides = [bounds[2 * i + 1] - bounds[2 * i] for i in range(3)]
assert 0.5 < sides[0] < 2.0, 'the image lies within the ellipsoid: %s' % sides
assert sides[0] > max(sides[1:]), 'the image is long where the ellipsoid is: %s' % sides
print("README's example, those of the pages and the tutorials run, and every filter has its page")
