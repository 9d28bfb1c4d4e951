"""The documentation site and the pages of the help window: no dead link, every filter, reader and writer
that ParaView shows has its page with each of its inputs and properties, internal ones have none, every page
is in the contents, and the search knows it. Run with python3 TestSite.py ROOT [HELP]; HELP is the .qch file
of the plugin with a window."""
import html.parser
import json
import os
import re
import sqlite3
import sys
import tempfile

root = os.path.abspath(sys.argv[1])
sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(root, 'Utilities'))
import pages

faults = []


class Page(html.parser.HTMLParser):
    """The targets of a page's links and pictures, and the anchors that it has."""

    def __init__(self, text):
        super().__init__()
        self.targets, self.anchors = set(), set()
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        if 'id' in attributes:
            self.anchors.add(attributes['id'])
        for key in ('href', 'src'):
            if key in attributes:
                self.targets.add(attributes[key])


def check(folder, product):
    source = pages.make(folder, product)
    texts = {name: open(os.path.join(folder, name)).read() for name in os.listdir(folder)
             if name.endswith('.html')}
    found = {name: Page(text) for name, text in texts.items()}
    for name, page in found.items():
        for target in page.targets:
            path, _, anchor = target.partition('#')
            if re.match(r'\w+:', target):
                faults.append('%s %s links to the network: %s' % (product, name, target))
            elif path and not os.path.exists(os.path.join(folder, path)):
                faults.append('%s %s links to no %s' % (product, name, path))
            elif anchor and anchor not in found[path or name].anchors:
                faults.append('%s %s links to no %s' % (product, name, target))
        if re.search(r'\]\([^)]*\)|@[A-Z]+@', texts[name]):
            faults.append('%s %s has Markdown left' % (product, name))
    if sum(part.needed() == 'required' for part in source.proxies['Correspondence'].inputs) != 2:
        faults.append('Shape Correspondence requires both surfaces')
    for proxy in source.proxies.values():
        for part in proxy.inputs + proxy.properties:
            if part.label not in texts.get(proxy.page(), '') or not part.help:
                faults.append('%s %s says nothing about %s' % (product, proxy.page(), part.label))
    return source, texts


with tempfile.TemporaryDirectory() as folder:
    check(folder, 'help')
with tempfile.TemporaryDirectory() as folder:
    source, texts = check(folder, 'site')
    known = json.loads(open(os.path.join(folder, 'pages.js')).read()[len('const pages = '):-2])
    if {page['page'] for page in known} != set(texts):
        faults.append('the search does not know every page')


def flat(entries):
    for _, page, children in entries:
        yield page.partition('#')[0]
        yield from flat(children)


missing = set(texts) - set(flat(source.contents())) - {'index.html'}
if missing:
    faults.append('the contents have no %s' % ', '.join(sorted(missing)))

# What the window finds with '?' is group.name.html in the file that is part of the plugin.
for compiled in sys.argv[2:]:
    with sqlite3.connect('file:%s?mode=ro' % os.path.abspath(compiled), uri=True) as connection:
        names = {name for name, in connection.execute('select Name from FileNameTable')}
    for proxy in source.proxies.values():
        if proxy.page() not in names:
            faults.append('the help has no ' + proxy.page())
    faults += ['the help has the internal ' + name for name in names if name.startswith('internal')]

if faults:
    raise AssertionError('\n'.join(sorted(set(faults))))
print(len(texts), 'pages,', len(source.proxies), 'of filters, readers and writers')
