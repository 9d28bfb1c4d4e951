"""The pages say what is there: no dead link, a page and a row for every filter, source,
reader and writer, every
benchmark on its page, the rooms of the code in their order, an entry for every paper that a comment
cites, the effect of small and large values of every number, generated parts that are up to date, and none
of the words that the glossary forbids. Run with python3 TestDocumentation.py ROOT."""
import glob
import os
import re
import sys

root = os.path.abspath(sys.argv[1])
sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(root, 'Utilities'))
import documentation
import pages as pages_of

LONGEST = 110  # characters in a line
ONE_SCREEN = 64  # lines
# Forbidden words inside these phrases are the field's, or ParaView's.
ALLOWED = ['at least', 'Group Datasets', 'Least Gain', 'least squares', 'least-squares']
CITATION = re.compile(r'(?:[A-Z][a-z]+(?: et al\.| and others)?,? \(?|", |\()(%s)' % documentation.YEAR)

faults = []
pages = ['README.md', 'CONTRIBUTING.md', 'CHANGELOG.md', 'Data/README.md', 'Testing/Benchmarks/README.md'] + [
    os.path.relpath(path, root)
    for path in sorted(glob.glob(os.path.join(root, 'Documentation', '**', '*.md'), recursive=True))]
texts = {page: documentation.read(page) for page in pages}


def prose(text):
    """Without blocks of code, code in a line, and the targets of links."""
    text = re.sub(r'```.*?```', '', text, flags=re.DOTALL)
    text = re.sub(r'^    .*$', '', text, flags=re.MULTILINE)
    return re.sub(r'`[^`]*`|\]\([^)]*\)', ' ', text)


for page, text in texts.items():
    for link in re.findall(r'\]\(([^)#:\s]+)(?:#[^)]*)?\)', text):
        if not os.path.exists(os.path.join(root, os.path.dirname(page), link)):
            faults.append('%s links to no %s' % (page, link))
    drawn = re.sub(r'```mermaid.*?```', lambda found: '\n' * found.group(0).count('\n'), text,
                   flags=re.DOTALL)
    for number, line in enumerate(drawn.split('\n'), 1):
        if len(line) > LONGEST:
            faults.append('%s:%d has %d characters' % (page, number, len(line)))
if texts['README.md'].count('\n') > ONE_SCREEN:
    faults.append('README.md has %d lines, more than a screen' % texts['README.md'].count('\n'))

# The page of the benchmarks names each script and each case of the program.
benchmarks = 'Testing/Benchmarks/README.md'
for path in documentation.files('Testing', 'Benchmarks', ends='.py'):
    if '`%s`' % os.path.basename(path) not in texts[benchmarks]:
        faults.append('%s has no `%s`' % (benchmarks, os.path.basename(path)))
for path in documentation.files('Testing', 'Benchmarks', 'Cases', ends='.cxx'):
    for case in re.findall(r'benchmark::Entry \w+\("(\w+)"', documentation.read(
            'Testing', 'Benchmarks', 'Cases', path)):
        if '`%s`' % case not in texts[benchmarks]:
            faults.append('%s has no `%s`' % (benchmarks, case))

# Filters and sources are what a menu shows; readers and writers are what a factory names. Every page has a
# picture, limits and an example. The page of a filter also says when to use it and has the effect of values, and
# that of a file format says what the file holds.
FILE, SOURCE, FILTER = ['\n## What the file holds'], ['\n## Outputs and facts'], [
    '\n## When to use', '\n## Outputs and facts', '\n## Small and large values']
names = {}
for path in documentation.files('Filters', 'VTK', ends='.xml'):
    text = documentation.read('Filters', 'VTK', path)
    parts = (FILE if '<ReaderFactory' in text or '<WriterFactory' in text else
             None if '<ShowInMenu' not in text else
             SOURCE if '<ProxyGroup name="sources">' in text else FILTER)
    if parts:
        names[os.path.basename(path)[len('vtkShape'):-len('.xml')]] = os.path.dirname(path), parts
assert [parts for _, parts in names.values()].count(FILTER) > 2, 'no filter was found'
overview = texts['Documentation/Filters.md']
for name, (room, own) in sorted(names.items()):
    label = 'Shape ' + re.sub(r'(?<=[a-z])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])', ' ', name)
    page = 'Documentation/Filters/%s.md' % name
    if '| [%s](Filters/%s.md) |' % (label, name) not in overview:
        faults.append('Documentation/Filters.md has no row [%s](Filters/%s.md)' % (label, name))
    if page not in texts:
        faults.append('there is no ' + page)
        continue
    for part in ('# %s\n' % label, '../../Filters/VTK/%s/vtkShape%s.h' % (room, name), '](../Pictures/', *own,
                 '\n## Limits', '\n## Example', '```python\n'):
        # A picture of several filters is in the root folder.
        if part not in texts[page].replace('](../../Correspondence.png', '](../Pictures/'):
            faults.append('%s has no %s' % (page, part.strip()))

# The effect of small and large values of every number; the overview groups filters as the menu does.
source = pages_of.Source()
menu = {stem: task for task, stems in pages_of.tasks() for stem in stems}
for stem, proxy in source.proxies.items():
    for row in proxy.properties:
        if row.is_number() and (row.owner, row.name) not in source.effects:
            faults.append('no page has the effect of small and large values of %s.%s' % (row.owner, row.name))
    if not source.walks[stem]:
        faults.append('neither the first steps nor a tutorial links to the page of ' + proxy.label)
    if proxy.task and menu.get(stem) != proxy.task:
        faults.append('Documentation/Filters.md has %s under %s, and its XML under %s' % (
            proxy.label, menu.get(stem), proxy.task))
for page in texts:
    stem = os.path.basename(page)[:-len('.md')]
    if page.startswith('Documentation/Filters/') and stem not in names:
        faults.append('%s is about no filter' % page)

described = re.findall(r'^\| `([\w/]+)` \|', texts['Documentation/Architecture.md'], re.MULTILINE)
if described != documentation.rooms():
    faults.append('Architecture.md and TestFolders.py list different rooms: %s' % (
        sorted(set(described) ^ set(documentation.rooms())) or 'in another order'))

rows = re.findall(r'^\|[^|]*\|[^|]*\|([^|]*)\|$', texts['Documentation/Glossary.md'], re.MULTILINE)
forbidden = sorted({word for row in rows for word in re.findall(r'`([^`]+)`', row)})
assert len(forbidden) > 5, 'the glossary forbids nothing'
for page, text in texts.items():
    if page in ('Documentation/Glossary.md', 'Documentation/Bibliography.md'):
        continue
    words = re.sub('|'.join(ALLOWED), ' ', re.sub(r'\s+', ' ', prose(text)), flags=re.IGNORECASE)
    for word in forbidden:
        for found in re.finditer(r'\b%ss?\b' % re.escape(word), words, re.IGNORECASE):
            faults.append('%s: the glossary has another word for "%s": ...%s...' % (
                page, word, words[max(0, found.start() - 30):found.end() + 30]))

papers = documentation.papers(texts['Documentation/Bibliography.md'])
keys = {paper.key for paper in papers}
for page, text in texts.items():
    for key in re.findall(r'\[([A-Z][\w ]+\s(?:19|20)\d\d[ab]?)\](?!\()', text):
        if re.sub(r'\s+', ' ', key) not in keys:
            faults.append('%s cites [%s], which the bibliography does not have' % (page, key))
for path in documentation.files('Filters', ends=('.h', '.cxx', '.xml')):
    comments = documentation.comments(path)
    known = [found.span() for paper in papers for found in paper.pattern.finditer(comments)]
    for found in CITATION.finditer(comments):
        # A title may follow the year.
        if not any(first - 40 <= found.start(1) <= last for first, last in known):
            faults.append('Filters/%s cites what the bibliography does not have: %s' % (
                path, comments[max(0, found.start() - 60):found.end()]))
for name, text in documentation.generated():
    if text != texts[name]:
        faults.append('%s is out of date; run python3 Utilities/documentation.py' % name)

if faults:
    raise AssertionError('\n'.join(faults))
print(len(pages), 'pages,', len(names), 'filters, sources, readers and writers,', len(papers), 'papers,',
      len(forbidden), 'words that are not used')
