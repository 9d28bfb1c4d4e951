"""Makes the pages of the help window and of the documentation site from one source: the Markdown of
Documentation/ and the XML of the filters.

    pages.py help FOLDER    HTML for ParaView's help window, which shows few tags and styles
    pages.py site FOLDER    the site, with a search
    pages.py contents       the help's table of contents, for CMake

It needs python3-markdown and python3-pygments."""
import glob
import html
import json
import os
import re
import shutil
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import documentation
import proxies

ROOT = proxies.ROOT
SITE = os.path.join(ROOT, 'Documentation', 'Site')
# The pages besides those of the filters and the tutorials, in the order of the contents.
FIRST = ['Documentation/Welcome.md', 'Documentation/FirstSteps.md']
LAST = ['Documentation/Command.md', 'Documentation/DataContract.md', 'Documentation/Glossary.md',
        'Documentation/Bibliography.md', 'CHANGELOG.md']
OVERVIEW = 'Documentation/Filters.md'
EFFECTS = 'Small and large values'


def read(path):
    with open(os.path.join(ROOT, path)) as file:
        return file.read()


def title_of(text):
    return re.match(r'# (.+)', text).group(1)


def sections(text):
    """(heading, text) of each part of a page; the first has no heading."""
    parts = re.split(r'(?m)^## (.+)$', text)
    return [('', parts[0])] + list(zip(parts[1::2], parts[2::2]))


def tasks():
    """(task, names of pages without their ending) as the overview groups the filters."""
    for task, text in sections(read(OVERVIEW))[1:]:
        stems = re.findall(r'\]\(Filters/(\w+)\.md\)', text)
        if stems:
            yield task, stems


def tutorials():
    """Their paths, in the order of their overview."""
    return ['Documentation/Tutorials/' + name for name in re.findall(
        r'\]\((\w+\.md)\)', read('Documentation/Tutorials/README.md'))]


class Source:
    """The pages of Documentation/ as Markdown and their names as HTML."""

    def __init__(self):
        self.proxies = {proxy.stem(): proxy for proxy in proxies.proxies().values()}
        self.pages = {'Documentation/Welcome.md': 'index.html',
                      'Documentation/Tutorials/README.md': 'Tutorials.html'}
        for path in [*FIRST, OVERVIEW, *tutorials(), *LAST]:
            name = os.path.splitext(os.path.basename(path))[0]
            self.pages.setdefault(path, '%s.html' % (name.capitalize() if name.isupper() else name))
        for stem, proxy in self.proxies.items():
            path = 'Documentation/Filters/%s.md' % stem
            if os.path.exists(os.path.join(ROOT, path)):
                self.pages[path] = proxy.page()
        self.pictures = {}
        self.effects = self.all_effects()
        # The pages that use a filter step by step, by the links that they have to its page.
        self.walks = {stem: [path for path in [FIRST[1], *tutorials()] if 'Filters/%s.md)' % stem in read(path)]
                      for stem in self.proxies}

    def all_effects(self):
        """{(proxy that declares a property, its name): (small, large)} from the pages' tables."""
        found = {}
        for stem, proxy in self.proxies.items():
            path = 'Documentation/Filters/%s.md' % stem
            text = dict(sections(read(path))).get(EFFECTS, '') if path in self.pages else ''
            rows = dict((label.strip(), (small.strip(), large.strip())) for label, small, large in re.findall(
                r'(?m)^\| ([^|\n]+) \| ([^|\n]+) \| ([^|\n]+) \|$', text))
            for row in proxy.properties:
                if row.label in rows:
                    found[row.owner, row.name] = rows.pop(row.label)
        return found

    def markdown(self, path):
        """A page as it is written; for a filter, with what its XML says."""
        text = read(path)
        stem = os.path.splitext(os.path.basename(path))[0]
        if path.startswith('Documentation/Filters/'):
            text = self.filter_page(text, self.proxies[stem])
        elif path == FIRST[0]:
            text += ''.join('\n## %s\n\n%s' % (task, body) for task, body in sections(
                read(OVERVIEW))[1:] if '](Filters/' in body)
        return self.links(text, path)

    def filter_page(self, text, proxy):
        # The lines about the class and its XML are for readers of the code.
        text = re.sub(r'\n- Class: .*?\n(?=\n)', '\n', text, flags=re.DOTALL)
        parts = sections(text)
        page = [parts[0][1]]
        # A page without effects has the properties before its limits.
        if EFFECTS not in dict(parts):
            limits = next(i for i, (heading, _) in enumerate(parts) if heading.startswith('Limits'))
            parts.insert(limits, (EFFECTS, ''))
        for heading, body in parts[1:]:
            if heading in ('Outputs and facts', 'What the file holds'):
                page += ['## What it does\n', *('%s\n' % as_code(line) for line in proxy.description)]
                page += ['## Inputs\n', inputs(proxy)] if proxy.inputs else []
                page.append('## %s\n' % heading)
                page += ['Outputs: %s.\n' % ', '.join(proxy.outputs)] if len(proxy.outputs) > 1 else []
            elif heading == EFFECTS:
                body = re.sub(r'(?m)^\|.*\n', '', body)
                page += ['## Properties\n', self.properties(proxy)] if proxy.properties else []
            else:
                page.append('## ' + heading)
            page.append(body)
        page.append('\n## Step by step\n\n' + '\n'.join(
            '- [%s](../../%s)' % (title_of(read(path)), path) for path in self.walks[proxy.stem()]))
        page.append('\n\nClass `vtk%s`, proxy `%s.%s`%s.\n' % (
            proxy.name, proxy.group, proxy.name, '' if proxy.group == 'writers' else
            ', in scripts `%s(...)`' % proxy.label.replace(' ', '')))
        return '\n'.join(page)

    def properties(self, proxy):
        lines = []
        for row in proxy.properties:
            lines.append('### %s\n' % row.label)
            lines.append('*%s%s*\n' % (row.value(), '; advanced' if row.advanced else ''))
            lines.append(as_code(row.help) + '\n')
            if row.entries:
                lines.append('| value | |\n|---|---|')
                lines += ['| `%s` | %s |' % (word, as_code(about)) for word, about in row.entries.items()] + ['']
            small, large = self.effects.get((row.owner, row.name), ('', ''))
            if small:
                lines.append('| small | large |\n|---|---|\n| %s | %s |\n' % (small, large))
        return '\n'.join(lines)

    def links(self, text, path):
        """Links between pages get the names of the HTML files; those to the code become plain words, and
        papers get links to the references."""
        folder = os.path.dirname(path)

        def link(found):
            words, target, anchor = found.group(1), found.group(2), found.group(3) or ''
            target = os.path.normpath(os.path.join(folder, target))
            return '[%s](%s%s)' % (words, self.pages[target], anchor) if target in self.pages else words

        def picture(found):
            target = os.path.normpath(os.path.join(folder, found.group(2)))
            # ParaView packs one folder without those below it.
            name = target.replace('Documentation/', '').replace('/', '.')
            self.pictures[name] = target
            return '![%s](%s)' % (found.group(1), name)

        text = re.sub(r'!\[([^\]]*)\]\(([^)\s]+)\)', picture, text)
        text = re.sub(r'(?<!!)\[([^\]]+)\]\((?!\w+:|[^)]*\.png)([^)#\s]+)(#[^)]*)?\)', link, text)
        if 'Bibliography.md' in path:
            return re.sub(r'(?m)^- \*\*(.+?)\*\*', lambda found: '- <a id="%s"></a>**%s**' % (
                anchor_of(found.group(1)), found.group(1)), re.sub(
                    r'\n  Used in:[^\n]*(\n  [^\n]*)*', '', text))
        return re.sub(r'\[([A-Z][\w ]+\s(?:19|20)\d\d[ab]?)\](?!\()', lambda found: (
            '[%s](Bibliography.html#%s)' % (found.group(1), anchor_of(found.group(1)))), text)

    def contents(self):
        """(title, page, children) of the whole help, as a tree."""
        def entry(path, children=()):
            return title_of(read(path)), self.pages[path], list(children)

        filters = [(task, self.pages[OVERVIEW] + '#' + anchor_of(task),
                    [entry('Documentation/Filters/%s.md' % stem) for stem in stems
                     if 'Documentation/Filters/%s.md' % stem in self.pages]) for task, stems in tasks()]
        return [entry(FIRST[1]), *filters,
                entry('Documentation/Tutorials/README.md', map(entry, tutorials())), *map(entry, LAST)]


def anchor_of(words):
    return re.sub(r'\W+', '-', words.lower()).strip('-')


def as_code(text):
    """Names of arrays and the like in the help of the XML, which has no marks for them, as code."""
    return re.sub(r'\b(?!%s)[A-Z][a-z]+(?:[A-Z]\w*)+\b' % '|'.join(
        ('ParaView', 'ShapeMap', 'TetGen', 'CalculiX')), lambda found: '`%s`' % found.group(0), text)


def inputs(proxy):
    lines = ['| input | data | | about |\n|---|---|---|---|']
    lines += ['| %s | %s | %s | %s |' % (row.label, row.kind, row.needed(), as_code(row.help)) for row in proxy.inputs]
    return '\n'.join(lines) + '\n'


def body_of(text):
    import markdown
    made = markdown.markdown(text, extensions=['tables', 'fenced_code', 'codehilite', 'toc', 'sane_lists'],
                             extension_configs={'codehilite': {'guess_lang': False},
                                                'toc': {'slugify': lambda words, _: anchor_of(words)}})
    return made.replace('<table>', '<div class="wide"><table>').replace('</table>', '</table></div>')


def plain(body):
    return re.sub(r'\s+', ' ', html.unescape(re.sub(r'<[^>]+>', ' ', body))).strip()


def write(folder, name, text):
    with open(os.path.join(folder, name), 'w') as file:
        file.write(text)


def menu(entries):
    items = ''.join('<li><a href="%s">%s</a>%s</li>' % (page, html.escape(title), menu(children))
                    for title, page, children in entries)
    return '<ul>%s</ul>' % items if items else ''


def make(folder, product):
    """Writes all pages of the help or the site."""
    source = Source()
    os.makedirs(folder, exist_ok=True)
    for old in glob.glob(os.path.join(folder, '*.html')):
        os.remove(old)
    template = read('Documentation/Site/%s.html' % product)
    found = []
    for path, name in source.pages.items():
        body = body_of(source.markdown(path))
        title = title_of(read(path))
        if product == 'help':
            body = body.replace('<div class="wide"><table>', '<table border="1" cellspacing="0" cellpadding="4">')
            body = body.replace('</table></div>', '</table><p></p>').replace('<th>', '<th align="left">')
            body = re.sub(r'<img ', '<img width="560" ', body)
        proxy = source.proxies.get(os.path.splitext(os.path.basename(path))[0])
        found.append({'page': name, 'title': title, 'text': plain(body),
                      'words': proxy.keywords + ' ' + proxy.short if proxy else ''})
        write(folder, name, template.replace('@TITLE@', html.escape(title)).replace('@BODY@', body).replace(
            '@MENU@', menu(source.contents()) if product == 'site' else ''))
    for name, path in source.pictures.items():
        shutil.copy(os.path.join(ROOT, path), os.path.join(folder, name))
    for path in glob.glob(os.path.join(SITE, product + '.*')):
        if not path.endswith('.html'):
            shutil.copy(path, folder)
    if product == 'site':
        write(folder, 'pages.js', 'const pages = %s;\n' % json.dumps(found))
    return source


def section(entry):
    title, page, children = entry
    return '<section title="%s" ref="%s">%s</section>' % (
        html.escape(title), page, ''.join(map(section, children)))


if __name__ == '__main__':
    if sys.argv[1] == 'contents':
        print('<toc>%s</toc>' % section(('ShapeMap', 'index.html', Source().contents())))
    else:
        made = make(sys.argv[2], sys.argv[1])
        print('wrote %d pages to %s' % (len(made.pages), sys.argv[2]))
