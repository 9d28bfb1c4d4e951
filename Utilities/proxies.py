"""What the XML files of Filters/VTK say about the filters, readers, sources and writers that ParaView
shows: proxies() returns them by name."""
import glob
import os
import re
import textwrap
from xml.etree import ElementTree

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
KINDS = {'vtkPolyData': 'surface', 'vtkUnstructuredGrid': 'solid', 'vtkDataSet': 'any data set',
         'vtkPointSet': 'points or mesh', 'vtkTable': 'table', 'vtkImageData': 'image',
         'vtkDataObject': 'any data', 'vtkCompositeDataSet': ''}


def words(element, attribute=None):
    text = '' if element is None else (element.get(attribute) if attribute else element.text) or ''
    return re.sub(r'\s+', ' ', text).strip()


def paragraphs(element):
    text = textwrap.dedent((element.text or '') if element is not None else '')
    return [re.sub(r'\s+', ' ', part).strip() for part in re.split(r'\n\s*\n', text) if part.strip()]


class Property:
    """A row of the panel. `owner` is the proxy that declares it."""

    def __init__(self, element, owner):
        self.name, self.owner = element.get('name'), owner
        self.label = element.get('label') or self.name
        self.help = words(element.find('Documentation'))
        self.default = element.get('default_values') or ''
        self.advanced = element.get('panel_visibility') == 'advanced'
        self.hidden = element.get('panel_visibility') == 'never' or element.get('information_only') == '1'
        # What each word of an enumeration means.
        self.entries = {entry.get('text'): words(entry, 'info') for entry in element.iter('Entry')}
        limits = next((child for child in element if child.tag.endswith('RangeDomain')), None)
        self.minimum = limits.get('min') if limits is not None else None
        self.maximum = limits.get('max') if limits is not None else None
        if element.find('BooleanDomain') is not None:
            self.kind = 'switch'
        elif self.entries:
            self.kind = 'choice'
            values = [entry.get('value') for entry in element.iter('Entry')]
            self.default = list(self.entries)[values.index(self.default)]
        elif element.find('ArrayListDomain') is not None:
            self.kind = 'array'
        elif element.tag == 'StringVectorProperty':
            self.kind = 'text'
        elif element.get('number_of_elements') == '3':
            self.kind = 'three numbers'
        elif element.get('repeat_command') == '1' or element.get('repeatable') == '1':
            self.kind = 'list of numbers'
        else:
            self.kind = 'integer' if element.tag.startswith('Int') else 'number'

    def is_number(self):
        return self.kind in ('integer', 'number')

    def value(self):
        """Kind, default and range in a line."""
        parts = [self.kind]
        if self.kind == 'switch':
            parts.append('default ' + ('on' if self.default == '1' else 'off'))
        elif self.default:
            parts.append('default ' + self.default)
        if self.is_number() and self.minimum and self.maximum:
            parts.append('from %s to %s' % (self.minimum, self.maximum))
        elif self.is_number() and self.minimum:
            parts.append('at least ' + self.minimum)
        return ', '.join(parts)


class Input:
    def __init__(self, element):
        self.name, self.label = element.get('name'), element.get('label') or element.get('name')
        self.help = words(element.find('Documentation'))
        # One that is needed is optional for the window alone, which lets one choose it on the panel.
        hint = element.find('Hints/Optional')
        self.optional = hint is not None and hint.get('needed') != '1'
        self.repeatable = element.get('multiple_input') == '1'
        # Those with commands of their own follow.
        self.port = int(element.get('port_index', 0 if 'InputConnection' in element.get('command', '') else 99))
        kinds = [KINDS.get(kind.get('value'), kind.get('value')) for kind in element.iter('DataType')]
        self.kind = ' or '.join(dict.fromkeys(kind for kind in kinds if kind))

    def needed(self):
        return ('optional' if self.optional else 'required') + (', several' if self.repeatable else '')


class Proxy:
    """A filter, reader, source or writer; `bases` are the elements that it inherits from, itself first."""

    def __init__(self, group, element, elements, path):
        self.group, self.name, self.path = group, element.get('name'), path
        self.label = element.get('label') or self.name
        help = element.find('Documentation')
        self.short = words(help, 'short_help')
        self.description = paragraphs(help)
        hints = element.find('Hints')
        hint = hints.find('ShapeMap') if hints is not None else None
        self.task = hint.get('task', '') if hint is not None else ''
        self.keywords = hint.get('keywords', '') if hint is not None else ''
        entry = hints.find('ShowInMenu') if hints is not None else None
        self.icon = entry.get('icon', '') if entry is not None else None
        core = element.find('SubProxy/Proxy')
        shown = [exposed.get('name') for exposed in element.findall('SubProxy/ExposedProperties/Property')]
        chain = lineage(element, elements)
        if core is not None:
            inner = elements.get((core.get('proxygroup'), core.get('proxyname')))
            chain += [base for base in lineage(inner, elements) if base not in chain]
        self.outputs, rows, inputs = [], {}, {}
        for base in chain:
            for child in base:
                if child.tag == 'InputProperty':
                    inputs.setdefault(child.get('name'), Input(child))
                elif child.tag == 'OutputPort' and base is element:
                    self.outputs.append(child.get('name'))
                elif child.tag.endswith('VectorProperty'):
                    rows.setdefault(child.get('name'), Property(child, base.get('name')))
        # The names of the rows that are below a heading.
        self.grouped = {row.get('name') for base in chain for row in base.findall('PropertyGroup/Property')}
        # The first port has no index.
        self.inputs = sorted(inputs.values(), key=lambda row: row.port)
        self.properties = [row for row in rows.values() if not row.hidden and row.help and (
            core is None or row.name in shown)]

    def page(self):
        return '%s.%s.html' % (self.group, self.name)

    def stem(self):
        return self.name[len('Shape'):]


def lineage(element, elements):
    chain = []
    while element is not None:
        chain.append(element)
        element = elements.get((element.get('base_proxygroup'), element.get('base_proxyname')))
    return chain


def proxies():
    """What ParaView shows, by the proxies' names: internal ones are left out."""
    elements, paths = {}, {}
    for path in sorted(glob.glob(os.path.join(ROOT, 'Filters', 'VTK', '*', 'vtkShape*.xml'))):
        for group in ElementTree.parse(path).iter('ProxyGroup'):
            for element in group:
                key = group.get('name'), element.get('name')
                elements[key], paths[key] = element, os.path.relpath(path, ROOT)
    shown = {}
    for (group, name), element in elements.items():
        if any(element.find('Hints/' + hint) is not None
               for hint in ('ShowInMenu', 'WriterFactory', 'ReaderFactory')):
            shown[name] = Proxy(group, element, elements, paths[group, name])
    return shown
