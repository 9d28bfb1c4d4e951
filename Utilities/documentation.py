#!/usr/bin/env python3
"""Writes the parts of Documentation/ that follow from the code: the picture of the rooms in
Architecture.md, from the #includes, and who uses each paper in Bibliography.md, from the comments.
Run with python3 Utilities/documentation.py after kernels were added, moved or renamed;
Testing/Conformance/TestDocumentation.py fails when a part is not up to date."""
import ast
import functools
import os
import re
import textwrap

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.MULTILINE)
YEAR = r'\b(?:19[5-9]\d|20[0-2]\d)\b'


def read(*path):
    with open(os.path.join(ROOT, *path)) as file:
        return file.read()


def files(*folder, ends=('.h', '.cxx')):
    """The paths below a folder, from there."""
    top = os.path.join(ROOT, *folder)
    return sorted(os.path.relpath(os.path.join(path, name), top)
                  for path, _, names in os.walk(top) for name in names if name.endswith(ends))


def rooms():
    """The rooms in their order, which the test of the folders holds."""
    for node in ast.parse(read('Testing', 'Conformance', 'TestFolders.py')).body:
        if isinstance(node, ast.Assign) and getattr(node.targets[0], 'id', '') == 'ORDER':
            return ast.literal_eval(node.value)
    raise AssertionError('TestFolders.py has no ORDER')


def used_rooms():
    """Which top rooms each top room includes directly, without those that follow from others."""
    uses = {room.split('/')[0]: set() for room in rooms()}
    for path in files('Filters', 'Kernels'):
        for include in INCLUDE.findall(read('Filters', 'Kernels', path)):
            if include.split('/')[0] in uses:
                uses[path.split('/')[0]].add(include.split('/')[0])

    def reach(room):
        return uses[room].union(*(reach(other) for other in uses[room] if other != room)) - {room}

    return {room: sorted(other for other in used - {room}
                         if not any(other in reach(third) for third in used - {room, other}))
            for room, used in uses.items()}


def picture():
    """The rooms as a Mermaid diagram: an arrow leads from a room to one that it uses."""
    lines = ['```mermaid', 'flowchart BT']
    for room, used in used_rooms().items():
        inner = ', '.join(other.split('/')[1] for other in rooms() if other.startswith(room + '/'))
        lines.append('  %s["%s"]' % (room, textwrap.fill(room + (': ' + inner if inner else ''), 40)
                                     .replace('\n', '<br/>')))
        lines += ['  %s --> %s' % (room, other) for other in used]
    return '\n'.join(lines + ['```'])


@functools.lru_cache(maxsize=None)
def comments(path):
    """The comments of a C++ file, or all words of an XML, in one line."""
    text = read('Filters', path)
    if not path.endswith('.xml'):
        text = ' '.join(re.findall(r'(?://[/!]*<?|/\*\*?|^\s*\*)(.*)', text, re.MULTILINE))
    return re.sub(r'\s+', ' ', text)


class Paper:
    """An entry of the bibliography: - **Author Year** Authors. "Title." Journal, year."""

    def __init__(self, entry):
        self.key = re.match(r'- \*\*(.+?)\*\*', entry).group(1)
        words = re.sub(r'\s+', ' ', entry)
        self.title = re.search(r'"([^"]+?)[.?]?"', words).group(1)
        self.year = re.search(r'\d{4}', self.key).group(0)
        author = re.match(r'(.+) ' + self.year, self.key).group(1)
        # By the start of its title, or by author and year without another year between. Of two papers of
        # one author and year, the first is meant where no title follows.
        by_author = r'\b%s\b(?:(?!%s).){0,230}?\b%s\b' % (re.escape(author), YEAR, self.year)
        by_title = re.escape(self.title[:40])
        if self.key.endswith('a'):
            by_author += '(?!, ")'
        self.pattern = re.compile(
            by_title if self.key.endswith('b') else by_author + '|' + by_title, re.IGNORECASE)


def papers(text):
    entries = re.findall(r'^- \*\*.*?(?=^\s*$|^  Used in|^- \*\*|\Z)', text, re.MULTILINE | re.DOTALL)
    return [Paper(entry) for entry in entries]


def users(paper):
    """The units (Room/Unit) of kernels and filters that name a paper."""
    found = {re.sub(r'\.(h|cxx|xml)$', '', path).split('/', 1)[1].replace('Private/', '')
             for path in files('Filters', ends=('.h', '.cxx', '.xml'))
             if paper.pattern.search(comments(path))}
    return sorted(found)


def bibliography(text):
    """The entries, each with its users."""
    text = re.sub(r'\n  Used in[^\n]*(\n  (?!Used)[^\n]*)*', '', text)
    parts = re.split(r'(?m)(?=^- \*\*)', text)
    for i, part in enumerate(parts):
        if part.startswith('- **'):
            entry, rest = (part.split('\n\n', 1) + [''])[:2]
            line = 'Used in: ' + ', '.join('`%s`' % user for user in users(Paper(entry))) + '.'
            wrapped = textwrap.fill(line, 108, initial_indent='  ', subsequent_indent='  ',
                                    break_long_words=False, break_on_hyphens=False)
            parts[i] = entry.rstrip() + '\n' + wrapped + '\n' + ('\n' + rest if rest else '')
    return ''.join(parts)


def generated():
    """(path, text) of every page that has a part made here."""
    page = read('Documentation', 'Architecture.md')
    yield 'Documentation/Architecture.md', re.sub(
        r'```mermaid\nflowchart BT\n.*?```', lambda _: picture(), page, flags=re.DOTALL)
    yield 'Documentation/Bibliography.md', bibliography(read('Documentation', 'Bibliography.md'))


if __name__ == '__main__':
    for name, content in generated():
        with open(os.path.join(ROOT, name), 'w') as output:
            output.write(content)
        print('wrote', name)
