"""What is known of a filter's inputs and properties, and their arguments of the command line."""
from __future__ import annotations

import argparse
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, Optional, Union


@dataclass(frozen=True)
class Input:
    """An input of a filter. `types`: the VTK classes that it takes."""
    name: str
    label: str
    required: bool
    multiple: bool
    types: tuple[str, ...]
    help: str


@dataclass(frozen=True)
class Property:
    """A property of a filter. It takes `count` values, each a word of `words` if there are any. If it is
    repeatable, it takes any number of rows of `count` values."""
    name: str
    label: str
    kind: str
    count: int
    repeatable: bool
    words: tuple[str, ...]
    minimum: Optional[float]
    maximum: Optional[float]
    default: Any
    help: str


@dataclass(frozen=True)
class Filter:
    """A filter, as its XML describes it."""
    help: str
    inputs: tuple[Input, ...]
    properties: tuple[Property, ...]


def option(name: str) -> str:
    """--cell-size for cell_size."""
    return '--' + name.strip('_').replace('_', '-')


def add_properties(parser: argparse._ArgumentGroup, filter: Filter) -> None:
    """Adds an option for each property. Those that are not given are not in the namespace."""
    for each in filter.properties:
        more: dict[str, Any] = {'dest': each.name, 'default': argparse.SUPPRESS, 'help': _help(each, filter)}
        if each.kind == 'bool':
            parser.add_argument(option(each.name), action=argparse.BooleanOptionalAction, **more)
            continue
        more['metavar'] = each.kind.upper() if each.kind != 'str' else 'NAME'
        if each.words:
            more['metavar'] = None
            more['choices'] = each.words
        else:
            more['type'] = _reader(each)
        if each.count != 1:
            more['nargs'] = each.count
        parser.add_argument(option(each.name), action='append' if each.repeatable else 'store', **more)


def with_options(text: str, filter: Filter) -> str:
    """The help with the options' names in place of ParaView's labels of several words."""
    held: tuple[Union[Input, Property], ...] = (*filter.inputs, *filter.properties)
    for each in sorted(held, key=lambda each: -len(each.label)):
        if ' ' in each.label:
            text = re.sub(r'(?<!-)\b%s\b' % re.escape(each.label), option(each.name), text)
    return text


def _help(each: Property, filter: Filter) -> str:
    bounds = ['%s %s' % (words, bound) for words, bound in (
        ('at least', each.minimum), ('at most', each.maximum)) if bound is not None]
    default = () if each.default in (None, (), '') else (
        'default ' + ' '.join(map(str, each.default if isinstance(each.default, tuple) else (each.default,))),)
    facts = ', '.join((*bounds, *default, *(('may be repeated',) if each.repeatable else ())))
    # argparse formats the help by %.
    return (with_options(each.help, filter) + (' (%s)' % facts if facts else '')).replace('%', '%%')


def _reader(each: Property) -> Callable[[str], Any]:
    kinds: Mapping[str, Callable[[str], Any]] = {'int': int, 'float': float, 'str': str}

    def read(text: str) -> Any:
        value = kinds[each.kind](text)
        if each.minimum is not None and not value >= each.minimum:
            raise argparse.ArgumentTypeError('%s is too small; give at least %s' % (text, each.minimum))
        if each.maximum is not None and not value <= each.maximum:
            raise argparse.ArgumentTypeError('%s is too large; give at most %s' % (text, each.maximum))
        if each.kind == 'float' and value - value != 0.0:
            raise argparse.ArgumentTypeError('%s is not finite; give a number' % text)
        return value

    # argparse names it in "invalid float value".
    read.__name__ = each.kind
    return read
