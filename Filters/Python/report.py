"""What is told of many subjects: the table, and the page and the picture of all results."""
from __future__ import annotations

import base64
import csv
import html
import io
import os
from collections.abc import Sequence
from typing import Any

import numpy

from .batch import STATE, Record
from .commands import Command
from .files import replace
from .pictures import sheet

_PAGE = '''<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>%(title)s</title><style>
body { font-family: sans-serif; margin: 2em } img, .none { width: 240px; height: 240px; display: block }
.none { background: #e1e1e1 } figure { display: inline-block; width: 240px; margin: 0 1em 1.5em 0; vertical-align: top }
figcaption { overflow-wrap: anywhere } .failed { color: #a00 }
</style></head><body><h1>%(title)s</h1><p>%(told)s</p>
%(figures)s
</body></html>
'''


def in_order(records: Sequence[Record], command: Command) -> list[Record]:
    """Worst first: those that failed, then by the measure."""
    def place(record: Record) -> tuple[Any, ...]:
        if record.status != 'done' or command.measure not in record.facts:
            return record.status == 'done', False, 0.0, record.name
        value = record.facts[command.measure]
        return True, True, -value if command.high else value, record.name

    return sorted(records, key=place)


def table(records: Sequence[Record]) -> bytes:
    """A row for each subject, as CSV."""
    facts = list(dict.fromkeys(name for record in records for name in record.facts))
    made = io.StringIO()
    writer = csv.writer(made, lineterminator='\n')
    writer.writerow(['name', 'status', 'seconds', 'peak memory (MiB)', *facts, 'message'])
    for record in records:
        writer.writerow([record.name, record.status, record.seconds, record.peak,
                         *(_cell(record.facts.get(name, '')) for name in facts), record.message])
    return made.getvalue().encode()


def write(records: Sequence[Record], command: Command, title: str, folder: str, no_pictures: str) -> None:
    """Writes shapemap.csv, shapemap.html and shapemap.png, those that change."""
    ordered = in_order(records, command)
    content = table(ordered)
    path = os.path.join(folder, 'shapemap.csv')
    replace(path, content)
    pictures = [os.path.join(folder, STATE, record.name + '.png') for record in ordered]
    below = [told(record, command) for record in ordered]
    done = sum(record.status == 'done' for record in records)
    line = '%d of %d are done; worst first. ' % (done, len(records))
    if command.shown:
        line += 'Colours: %s from %g (blue) to %g (red). ' % (command.shown, *command.colours)
    line += 'No pictures: %s.' % no_pictures if no_pictures else ''
    figures = '\n'.join(_figure(record, picture, words) for record, picture, words in zip(ordered, pictures, below))
    replace(os.path.join(folder, 'shapemap.html'), (
        _PAGE % {'title': html.escape(title), 'told': html.escape(line), 'figures': figures}).encode())
    if any(map(os.path.exists, pictures)):
        sheet([(picture, record.name, words) for record, picture, words in zip(ordered, pictures, below)],
              os.path.join(folder, 'shapemap.png'))


def told(record: Record, command: Command) -> str:
    """The measure of a subject, or its status."""
    value = record.facts.get(command.measure)
    return record.status if record.status != 'done' or value is None else '%s %.4g' % (command.measure, value)


def _figure(record: Record, picture: str, words: str) -> str:
    image = '<div class="none"></div>'
    if os.path.exists(picture):
        with open(picture, 'rb') as file:
            image = '<img alt="" src="data:image/png;base64,%s">' % base64.b64encode(file.read()).decode()
    message = '<br><span class="failed">%s</span>' % html.escape(record.message) if record.message else ''
    return '<figure>%s<figcaption><b>%s</b><br>%s%s</figcaption></figure>' % (
        image, html.escape(record.name), html.escape(words), message)


def _cell(fact: Any) -> Any:
    return ' '.join(map(str, fact)) if isinstance(fact, (list, numpy.ndarray)) else fact
