"""Help is written once and in plain words: the XML of a filter holds the user's help, its class the
contract of ports and arrays, and the header of its kernel the options. Run with
python3 TestHelp.py ROOT."""
import glob
import os
import re
import sys
import xml.etree.ElementTree as ElementTree

LONGEST = 30  # words in a sentence
TOOLTIP = 400  # characters; what is longer stands on the page of the filter
# Forbidden words inside these phrases are the field's, or ParaView's.
ALLOWED = re.compile(r'\b(at least|Group Datasets|least[- ]squares|least distortion)\b', re.IGNORECASE)
# An abbreviation or the name of a fact ends no sentence.
ABBREVIATION = re.compile(r'\b(et al|e\.g|i\.e)\.')

root = os.path.abspath(sys.argv[1])
faults = []


def read(path):
    with open(path) as file:
        return file.read()


def paths(*pattern):
    found = sorted(glob.glob(os.path.join(root, *pattern)))
    assert found, 'nothing is called ' + os.path.join(*pattern)
    return found


rows = re.findall(r'^\|[^|]*\|[^|]*\|([^|]*)\|$',
                  read(os.path.join(root, 'Documentation', 'Glossary.md')), re.MULTILINE)
forbidden = sorted({word for row in rows for word in re.findall(r'`([^`]+)`', row)})
assert len(forbidden) > 5, 'the glossary forbids nothing'
FORBIDDEN = re.compile(r'\b(?:%s)s?\b' % '|'.join(map(re.escape, forbidden)), re.IGNORECASE)


def check_words(where, text):
    for found in FORBIDDEN.finditer(ALLOWED.sub(' ', text)):
        faults.append('%s: the glossary has another word for "%s"' % (where, found.group(0)))


def check_prose(where, text):
    """Paragraphs and list items are separated by empty lines."""
    check_words(where, re.sub(r'\s+', ' ', text))
    for paragraph in re.split(r'\n\s*\n', ABBREVIATION.sub(r'\1', text)):
        for sentence in re.split(r'(?<=[.?!])\s+(?![a-z(])', paragraph):
            words = sentence.split()
            if len(words) > LONGEST:
                faults.append('%s: a sentence has %d words: %s ...' % (
                    where, len(words), ' '.join(words[:8])))


def check_property(where, element):
    help = element.find('Documentation')
    text = ' '.join((help.text or '').split()) if help is not None else ''
    if not text:
        faults.append('%s has no help' % where)
    words = [(each.get('text'), ' '.join(each.get('info', '').split())) for each in element.iter('Entry')]
    for name, tooltip in [('', text), *words]:
        if len(tooltip) > TOOLTIP:
            faults.append('%s %s has a tooltip of %d characters' % (where, name, len(tooltip)))
    # What a word means stands on the word. On and Off need no words.
    for name, tooltip in words:
        check_prose('%s %s' % (where, name), tooltip)
        if not tooltip and name not in ('On', 'Off'):
            faults.append('%s does not say what %s means' % (where, name))


def check_brief(path, short):
    """The brief of the class is the short help, as VTK writes it: no capital, no full stop."""
    header = path[:-len('.xml')] + '.h'
    found = re.search(r'@brief\s+(.*?)\n \*\n', read(header), re.DOTALL)
    brief = re.sub(r'\s*\n \*\s*', ' ', found.group(1)).strip() if found else None
    if brief != short[:1].lower() + short[1:].rstrip('.'):
        faults.append('%s has the brief "%s", and its XML the short help "%s"' % (
            os.path.relpath(header, root), brief, short))


def check_class(path, properties):
    """The class refers to the XML and describes no property of it again."""
    where = os.path.relpath(path, root)
    reference = 'The properties. Effects and ranges: %s.xml.' % os.path.basename(path)[:-len('.h')]
    for group in re.findall(r'///@\{\n(.*?)///@\}', read(path), re.DOTALL):
        comment = ' '.join(re.findall(r'///(?!<) ?(.*)', group))
        named = properties & set(re.findall(r'\w+', re.sub(r'///.*|(?:Set|Get)(?:NumberOf)?(?=[A-Z])',
                                                           '', group)))
        if named and not comment.startswith(reference):
            faults.append('%s describes %s; refer with "%s"' % (
                where, ', '.join(sorted(named)), reference))


filters = 0
for path in paths('Filters', 'VTK', '*', 'vtkShape*.xml'):
    name = os.path.basename(path)
    if 'VectorProperty' in read(path):
        check_class(path[:-len('.xml')] + '.h', set(
            re.findall(r'VectorProperty name="(\w+)"', read(path))))
    for proxy in ElementTree.parse(path).iter():
        if not proxy.tag.endswith('Proxy') or not proxy.get('name'):
            continue
        where = '%s, %s' % (name, proxy.get('name'))
        choices = {each.get('text'): (owner.get('name'), each.get('value'))
                   for owner in proxy for each in owner.iter('Entry')}
        for child in proxy:
            # A row for one choice alone, "Disk: ...", is shown with it and hidden with the others.
            start = re.match(r'\s*(\w+)(?: and \w+)*:', child.findtext('Documentation') or '')
            if child.tag.endswith('VectorProperty') and start and start.group(1) in choices:
                owner, value = choices[start.group(1)]
                decorators = child.findall('Hints/PropertyWidgetDecorator')
                if not decorators:
                    faults.append('%s.%s is for %s alone, and is always shown' % (
                        where, child.get('name'), start.group(1)))
                for each in decorators:
                    if each.get('property') == owner and value not in (each.get('values') or each.get('value')).split():
                        faults.append('%s.%s is not shown with %s' % (where, child.get('name'), start.group(1)))
            # Those that a writer shows are documented where they are declared.
            if child.tag.endswith('Property'):
                check_property('%s.%s' % (where, child.get('name')), child)
        help = proxy.find('Documentation')
        if any(proxy.find('Hints/' + hint) is not None for hint in ('ShowInMenu', 'ReaderFactory', 'WriterFactory')):
            filters += 1
            if help is None or not all((help.get('short_help'), help.get('long_help'),
                                        (help.text or '').strip())):
                faults.append(where + ' lacks a short help, a long help or a description')
                continue
            check_brief(path, help.get('short_help'))
        for help in proxy.iter('Documentation'):
            for text in (help.text, help.get('short_help'), help.get('long_help')):
                check_prose(where, text or '')
assert filters > 2, 'no filter was found'

for path in paths('Filters', 'VTK', '*', 'vtkShape*.h'):
    where = os.path.relpath(path, root)
    text = read(path)
    for comment in re.findall(r'/\*\*(.*?)\*/', text, re.DOTALL):
        lines = [re.sub(r'^\s*\* ?', '', line) for line in comment.split('\n')]
        if '@class' in comment:
            # Each list item, and what follows a list, begins anew.
            check_prose(where, '\n'.join(
                ('\n' if re.match(r'\s*- |\S', line) and (line.lstrip().startswith('- ') or (
                    number and lines[number - 1].startswith('  '))) else '') + line
                for number, line in enumerate(lines) if not line.startswith('@')))
        else:
            check_words(where, re.sub(r'\s+', ' ', ' '.join(lines)))
    check_words(where, re.sub(r'\s+', ' ', ' '.join(re.findall(r'///<?(.*)', text))))

# What the window and the errors say: strings of several words.
for path in paths('Filters', 'VTK', '*', '*.cxx') + paths('Plugin', '*.cxx'):
    # A message goes on in the next literal.
    text = re.sub(r'"\s*\n\s*"', '', re.sub(r'^\s*#include.*$|//.*$', '', read(path), flags=re.MULTILINE))
    for literal in re.findall(r'"((?:[^"\\\n]|\\.)*)"', text):
        if len(literal.split()) > 1:
            check_words(os.path.relpath(path, root), literal)

if faults:
    raise AssertionError('\n'.join(faults))
print(filters, 'filters and writers')
