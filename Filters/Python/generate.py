"""Writes the functions of the package shapemap from the XML files of the filters, which have their
ports, properties, defaults and help, and the same as a table. generate.py FOLDER OUTPUT_FOLDER VERSION"""
import glob
import keyword
import os
import re
import sys
import textwrap
from xml.etree import ElementTree

WIDTH = 100
HEADER = '"""%s Made by Filters/Python/generate.py from the XML files of the filters."""\n'


def snake(name):
    """surface_a for SurfaceA, mds for MDS."""
    return re.sub(r'(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])', '_', name).lower()


def words(text):
    return ' '.join((text or '').split())


def wrap(text, indent):
    return textwrap.fill(text, WIDTH, initial_indent=indent, subsequent_indent=indent,
                         break_long_words=False, break_on_hyphens=False)


def number(text, is_integer):
    return repr(int(text)) if is_integer else repr(float(text))


class Parameter:
    """A property as a keyword argument: annotation and default in Python, the kind in numpydoc's words,
    and the statement that passes it on. `default` is None if it must be given."""

    def __init__(self, element):
        self.element = element
        self.label = element.get('label') or element.get('name')
        self.name = snake(element.get('name'))
        if keyword.iskeyword(self.name):
            self.name += '_'
        explained = ['%s: %s' % (each.get('text'), words(each.get('info')))
                     for each in element.iter('Entry') if each.get('info')]
        self.help = ' '.join([words(element.findtext('Documentation')), *explained])
        {'InputProperty': self.read_input, 'StringVectorProperty': self.read_string}.get(
            element.tag, self.read_numbers)()

    def read_input(self):
        types = [each.get('value') for each in self.element.iter('DataType')]
        solid = 'vtkPolyData' not in types
        # A needed input is optional for the window alone, which lets one choose it in the panel.
        optional = self.element.find('Hints/Optional')
        self.required = optional is None or optional.get('needed') == '1'
        command = self.element.get('command')
        port = int(self.element.get('port_index', 0)) if command == 'SetInputConnection' else None
        connect = 'run.connect(%r, %r, %%s, %r, %r)' % (command, port, self.name, solid)
        self.data = ' or '.join(types) + ', or arrays'
        if self.element.get('multiple_input') == '1':
            self.annotation, self.default = 'Sequence[Data]', '()'
            self.kind = 'sequence of (%s), optional' % self.data
            self.body = ['for each in %s:' % self.name, '    ' + connect % 'each']
        elif self.required:
            self.annotation, self.default, self.kind = 'Data', None, self.data
            self.body = [connect % self.name]
        else:
            self.annotation, self.default, self.kind = 'Optional[Data]', 'None', self.data + ', optional'
            self.body = ['if %s is not None:' % self.name, '    ' + connect % self.name]
        self.solid = solid

    def read_string(self):
        if self.element.get('repeatable') == '1':
            self.annotation, self.default, self.kind = 'Sequence[str]', '()', 'sequence of str, optional'
            self.body = ['run.set_rows(%r, %r, %s, 1)' % (
                self.element.get('set_number_command'), self.element.get('command'), self.name)]
            return
        default = self.element.get('default_values', '')
        none = next((each.get('none_string') for each in self.element.iter('ArrayListDomain')), None)
        self.annotation, self.default = 'str', repr(default)
        given = self.name
        if none is not None:
            self.annotation = 'Optional[str]'
            self.default = 'None' if default == none else repr(default)
            given = '%r if %s is None else %s' % (none, self.name, self.name)
        self.kind = 'str%s, default %s' % (' or None' if none is not None else '', self.default)
        self.body = ['run.set(%r, %s)' % (self.element.get('command'), given)]

    def read_numbers(self):
        element, command = self.element, self.element.get('command')
        is_integer = element.tag == 'IntVectorProperty'
        kind = 'int' if is_integer else 'float'
        default = element.get('default_values', '').split()
        entries = {each.get('text'): int(each.get('value')) for each in element.iter('Entry')}
        if element.get('repeatable') == '1':
            width = int(element.get('number_of_elements_per_command', 1))
            self.annotation = 'Sequence[%s]' % ('Sequence[%s]' % kind if width > 1 else kind)
            self.default = '()'
            self.kind = 'sequence of %s, optional' % (kind if width == 1 else '%d %ss' % (width, kind))
            self.body = ['run.set_rows(%r, %r, %s, %d)' % (element.get('set_number_command'), command, self.name, width)]
        elif entries:
            word = next(text for text, value in entries.items() if value == int(default[0]))
            self.annotation, self.default = 'Literal[%s]' % ', '.join(map(repr, entries)), repr(word)
            self.kind = '{%s}, default %r' % (', '.join(map(repr, entries)), word)
            self.body = ['run.choose(%r, %s, %r, %r)' % (command, self.name, entries, self.name)]
        elif element.find('BooleanDomain') is not None:
            self.annotation, self.default = 'bool', str(bool(int(default[0])))
            self.kind = 'bool, default ' + self.default
            self.body = ['run.set(%r, %s)' % (command, self.name)]
        else:
            count = int(element.get('number_of_elements'))
            assert count == len(default), 'the default of %s has %d numbers' % (element.get('name'), len(default))
            numbers = [number(text, is_integer) for text in default]
            self.annotation = kind if count == 1 else 'Sequence[%s]' % kind
            self.default = numbers[0] if count == 1 else '(%s)' % ', '.join(numbers)
            self.kind = ', '.join(filter(None, [
                kind if count == 1 else '%d %ss' % (count, kind), self.limits(is_integer), 'default ' + self.default]))
            self.body = ['run.set(%r, %s%s)' % (command, '' if count == 1 else '*', self.name)]

    def row(self):
        """It in the table, of the classes of properties.py."""
        element = self.element
        if element.tag == 'InputProperty':
            return 'Input(%r, %r, %r, %r, %r, %r)' % (
                self.name, self.label, self.required, element.get('multiple_input') == '1',
                tuple(each.get('value') for each in element.iter('DataType')), self.help)
        words = tuple(each.get('text') for each in element.iter('Entry'))
        kind = {'IntVectorProperty': 'int', 'DoubleVectorProperty': 'float'}.get(element.tag, 'str')
        domain = element.find('IntRangeDomain' if kind == 'int' else 'DoubleRangeDomain')
        bounds = [None if domain is None or domain.get(key) is None else number(domain.get(key), kind == 'int')
                  for key in ('min', 'max')]
        repeatable = element.get('repeatable') == '1'
        return 'Property(%r, %r, %r, %s, %r, %r, %s, %s, %s, %r)' % (
            self.name, self.label,
            'str' if words else 'bool' if element.find('BooleanDomain') is not None else kind,
            element.get('number_of_elements_per_command' if repeatable else 'number_of_elements', '1'),
            repeatable, words, *bounds, self.default, self.help)

    def limits(self, is_integer):
        domain = self.element.find('IntRangeDomain' if is_integer else 'DoubleRangeDomain')
        bounds = [] if domain is None else ['%s %s' % (words, domain.get(key)) for words, key in (
            ('at least', 'min'), ('at most', 'max')) if domain.get(key)]
        return ', '.join(bounds)


class Filter:
    def __init__(self, proxy, proxies):
        self.proxy = proxy
        self.name = proxy.get('class')[len('vtkShape'):]
        self.function = snake(self.name)
        elements = []
        while proxy is not None:
            own = [each for each in proxy if each.tag.endswith('Property')]
            # Inputs first, those of a base before the filter's own; a filter's own property takes the
            # place of its base's.
            names = {each.get('name') for each in elements}
            elements = [each for each in own if each.get('name') not in names] + elements
            proxy = proxies.get(proxy.get('base_proxyname'))
        self.timed = any(each.get('name') in ('TimeRange', 'TimestepValues') for each in elements)
        parameters = [Parameter(each) for each in elements
                      if not (each.get('information_only') == '1' or each.get('is_internal') == '1')]
        inputs = [each for each in parameters if each.element.tag == 'InputProperty']
        self.inputs = sorted(inputs, key=lambda each: not each.required)
        self.properties = [each for each in parameters if each not in inputs]
        # Given by position: the required inputs, or the first one if another can take its place.
        self.leading = [each for each in self.inputs if each.required] or self.inputs[:1]
        ports = sorted((int(each.get('index')), each.get('name')) for each in self.proxy.findall('OutputPort'))
        self.outputs = [(index, snake(name)) for index, name in ports if name != 'Facts']

    def cells(self):
        """The name of the parameter for cells, beside a first one with points; only for one input."""
        return ('cells' if self.leading[0].solid else 'triangles') if len(self.leading) == 1 else None

    def help_for_python(self, text, functions):
        """ParaView's help with the words of Python: labels of several words are parameters, names of
        filters are functions."""
        for label, function in sorted(functions.items(), key=lambda each: -len(each[0])):
            text = re.sub(r'\b%s\b' % label, '`%s`' % function, text)
        for each in sorted(self.inputs + self.properties, key=lambda each: -len(each.label)):
            if ' ' in each.label:
                text = re.sub(r'(?<!`)\b(%s|%s)\b(?!`)' % (each.label, each.element.get('name')), '`%s`' % each.name, text)
        return text

    def signature(self):
        lines = ['%s: %s%s' % (each.name, each.annotation, '' if each.default is None else ' = ' + each.default)
                 for each in self.leading]
        if self.cells():
            lines.append('%s: Optional[ArrayLike] = None' % self.cells())
        lines.append('*')
        lines += ['%s: %s = %s' % (each.name, each.annotation, each.default)
                  for each in self.inputs[len(self.leading):] + self.properties]
        lines += ['time: float = 0.0'] if self.timed else []
        lines.append('progress: Optional[Progress] = None')
        return ',\n    '.join(lines)

    def parameters(self, functions):
        rows = [(each.name, each.kind, each.help) for each in self.leading]
        if self.cells():
            rows.append((self.cells(), 'array of int, m x k, optional',
                         'The points of each cell, from 0. Then `%s` is an array of points, n x 3.' % self.leading[0].name))
        rows += [(each.name, each.kind, each.help) for each in self.inputs[len(self.leading):] + self.properties]
        if self.timed:
            rows.append(('time', 'float, at least 0, at most 1, default 0.0', 'The time of the output.'))
        rows.append(('progress', 'callable, optional', 'Called with the share that is done, from 0 to 1.'))
        lines = []
        for name, kind, text in rows:
            lines += ['    %s : %s' % (name, kind), wrap(self.help_for_python(text, functions), ' ' * 8)]
        return '\n'.join(lines)

    def documentation(self, functions):
        help = self.proxy.find('Documentation')
        paragraphs = [words(each) for each in re.split(r'\n\s*\n', help.text)]
        body = '\n\n'.join(wrap(self.help_for_python(each, functions), '    ') for each in paragraphs)
        outputs = ', '.join('`%s`' % name for _, name in self.outputs)
        return '''%s

%s

    Parameters
    ----------
%s

    Returns
    -------
    %sResult
        The outputs %s, and `facts`.

    Raises
    ------
    ShapeError
        If the input cannot be used, or the computation did not succeed.''' % (
            words(help.get('short_help')), body, self.parameters(functions), self.name, outputs)

    def result(self):
        return '''
@dataclass(frozen=True)
class %sResult:
    """What `%s` returns: its outputs, and its facts by name."""
%s
    facts: Facts
''' % (self.name, self.function, '\n'.join('    %s: vtkDataObject' % name for _, name in self.outputs))

    def code(self, functions):
        first = self.leading[0]
        lines = ['run = Run(vtkShapeFilters.vtkShape%s())' % self.name]
        if self.cells():
            first.body[-1] = first.body[-1].replace(
                ', %s, ' % first.name, ', %s if %s is None else (%s, %s), ' % (
                    first.name, self.cells(), first.name, self.cells()), 1)
        for each in self.inputs + self.properties:
            lines += each.body
        lines.append('outputs, facts = run.outputs(%r, progress%s)' % (
            [index for index, _ in self.outputs], ', time' if self.timed else ''))
        lines.append('return %sResult(%s, facts=facts)' % (self.name, ', '.join(
            '%s=outputs[%d]' % (name, k) for k, (_, name) in enumerate(self.outputs))))
        return '''
def %s(
    %s
) -> %sResult:
    """%s
    """
%s
''' % (self.function, self.signature(), self.name, self.documentation(functions), textwrap.indent('\n'.join(lines), '    '))


def read_filters(folder):
    """Every filter of the XML files below a folder, in the order of their names."""
    proxies = {}
    for path in glob.glob(os.path.join(folder, '*', '*.xml')):
        for group in ElementTree.parse(path).getroot():
            if group.get('name') in ('filters', 'internal_filters'):
                proxies.update((proxy.get('name'), proxy) for proxy in group)
    found = [Filter(proxy, proxies) for proxy in proxies.values()
             if proxy.get('class', '').startswith('vtkShape') and proxy.find('InputProperty') is not None or
             proxy.get('base_proxyname') in proxies]
    assert found, 'there is no filter below ' + folder
    return sorted(found, key=lambda each: each.name)


def main(folder, output, version):
    filters = read_filters(folder)
    functions = {'Shape ' + ' '.join(re.findall('[A-Z][a-z]*', each.name)): each.function for each in filters}
    os.makedirs(output, exist_ok=True)
    with open(os.path.join(output, 'functions.py'), 'w') as file:
        file.write(HEADER % 'A function for each filter.')
        file.write('''from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal, Optional

from numpy.typing import ArrayLike
from vtkmodules.vtkCommonDataModel import vtkDataObject

from . import vtkShapeFilters
from .data import Data
from .run import Facts, Progress, Run

__all__ = [
%s]
''' % ''.join('    %r,\n    %r,\n' % (each.function, each.name + 'Result') for each in filters))
        for each in filters:
            file.write('\n' + each.result() + '\n' + each.code(functions))
    with open(os.path.join(output, 'filters.py'), 'w') as file:
        file.write(HEADER % 'What the functions take, as a table.')
        file.write('from .properties import Filter, Input, Property\n\nVERSION = %r\n\nFILTERS = {\n' % version)
        for each in filters:
            file.write('    %r: Filter(\n        %r,\n        (%s),\n        (%s)),\n' % (
                each.function, words(each.proxy.find('Documentation').get('short_help')),
                *(''.join('\n            %s,' % row.row() for row in rows) for rows in (each.inputs, each.properties))))
        file.write('}\n')
    # For type checkers: the extension itself tells them nothing.
    with open(os.path.join(output, 'vtkShapeFilters.pyi'), 'w') as file:
        file.write('from typing import Any\n\n')
        for path in sorted(glob.glob(os.path.join(folder, '*', 'vtkShape*.xml')), key=os.path.basename):
            file.write('%s: Any\n' % os.path.splitext(os.path.basename(path))[0])


if __name__ == '__main__':
    main(*sys.argv[1:])
