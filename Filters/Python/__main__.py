"""The command ``shapemap``: the same filter for many files."""
from __future__ import annotations

import argparse
import csv
import fcntl
import glob
import os
import re
import signal
import sys
import time
import warnings
from collections.abc import Mapping, Sequence
from typing import Any, Optional

import numpy
from vtkmodules.vtkCommonDataModel import vtkDataSet, vtkMultiBlockDataSet

from . import batch, files, pictures, report
from .commands import COMMANDS, Command
from .filters import FILTERS, VERSION
from .properties import Filter, Input, add_properties, option, with_options

_CODES = '''Exit codes: 0 all are done, 1 some failed, 2 wrong usage, 130 stopped by Ctrl+C. The same command goes
on where it stopped.'''


class Usage(Exception):
    """What the user gave cannot be used."""


class Subject:
    """A name and the file of each input."""

    def __init__(self, name: str, given: Mapping[str, str]) -> None:
        self.name = name
        self.given = dict(given)  # a path for each option, such as template, and subject


def main(arguments: Optional[Sequence[str]] = None) -> int:
    """Runs the command. Returns its exit code."""
    given = list(sys.argv[1:] if arguments is None else arguments)
    lines = ''.join('  %-15s %s\n' % (name, each.help) for name, each in COMMANDS.items())
    top = argparse.ArgumentParser(
        'shapemap', formatter_class=argparse.RawDescriptionHelpFormatter,
        description='Runs a filter over many files: meshes, a table, a page of pictures and a log come out.\n\n'
                    'commands:\n' + lines, epilog=_CODES)
    top.add_argument('--version', action='version', version='shapemap ' + VERSION)
    top.add_argument('command', choices=COMMANDS, metavar='command', help='one of the above; '
                     '"shapemap command --help" has its options')
    name = top.parse_args(given[:1]).command
    command, filter = COMMANDS[name], FILTERS[COMMANDS[name].function]
    parser = parser_of(name, command, filter)
    options = parser.parse_intermixed_args(given[1:])
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        return Batch(name, command, filter, options).run()
    except Usage as error:
        parser.error(str(error))


def parser_of(name: str, command: Command, filter: Filter) -> argparse.ArgumentParser:
    """The parser of a subcommand."""
    parser = argparse.ArgumentParser(
        'shapemap ' + name, formatter_class=argparse.RawDescriptionHelpFormatter, allow_abbrev=False,
        description='%s\n\n%s\n%s' % (command.help.capitalize() + '.', 'Files that are read: ' + ', '.join(read_by(command, filter)) + '.',
                                      'Files that are written: ' + ', '.join(files.WRITTEN) + '.'),
        epilog='Example: shapemap %s\n\n%s' % (command.example, _CODES))
    parser.add_argument('inputs', nargs='+', metavar='IN', help='files, folders, patterns, or a table (.csv) with a '
                        'column "subject" and columns named as the options that take files')
    parser.add_argument('output', metavar='OUT', help='the folder of the results')
    general = parser.add_argument_group('for all commands')
    general.add_argument('--format', choices=files.WRITTEN, help='of the main results (default vtp for surfaces, vtu for solids)')
    general.add_argument('--jobs', type=_positive, default=len(os.sched_getaffinity(0)), metavar='N',
                         help='subjects at a time (default: the cores, %(default)s); fewer need less memory')
    general.add_argument('--timeout', type=float, default=0.0, metavar='S', help='seconds after which a subject is stopped')
    general.add_argument('--redo', choices=('failed', 'all'), default='', help='do subjects again that are done or failed')
    general.add_argument('--dry-run', action='store_true', help='tell what would be done')
    general.add_argument('--no-pictures', action='store_true', help='no pictures of the results')
    inputs = parser.add_argument_group('files beside the subjects', 'A file for all subjects, or a folder with a '
                                       'file of the name of each.')
    for each in others(command, filter):
        inputs.add_argument(option(named(command, each)), dest='file_' + each.name, metavar='PATH',
                            action='append' if each.multiple else 'store',
                            help=with_options(each.help, filter).replace('%', '%%') + (' (needed)' if each.required else ''))
    add_properties(parser.add_argument_group('of the filter'), filter)
    return parser


def read_by(command: Command, filter: Filter) -> tuple[str, ...]:
    """The extensions of the subjects."""
    return files.read_by(next(each.types for each in filter.inputs if each.name == command.subject))


def others(command: Command, filter: Filter) -> list[Input]:
    return [each for each in filter.inputs if each.name != command.subject]


def named(command: Command, each: Input) -> str:
    return command.names.get(each.name, each.name)


class Batch:
    """The subjects of a command, and what becomes of them."""

    def __init__(self, name: str, command: Command, filter: Filter, options: argparse.Namespace) -> None:
        self.name, self.command, self.filter, self.options = name, command, filter, options
        held = vars(options)
        self.properties = {each.name: held[each.name] for each in filter.properties if each.name in held}
        self.folder: str = options.output
        self.subjects = self.find_subjects()
        if os.path.realpath(self.folder) in {os.path.dirname(os.path.realpath(path)) for each in self.subjects
                                             for path in each.given.values()}:
            raise Usage('OUT is a folder of the inputs; give another one')
        self.no_pictures = '--no-pictures'

    def find_subjects(self) -> list[Subject]:
        rows: list[dict[str, str]] = []
        reads = read_by(self.command, self.filter)
        for given in self.options.inputs:
            if os.path.isdir(given):
                found = sorted(os.path.join(given, each) for each in os.listdir(given)
                               if files.extension(each) in reads)
            else:
                found = [given] if os.path.exists(given) else sorted(glob.glob(given))
            if not found:
                raise Usage('there is no file to read at %s; extensions are %s' % (given, ', '.join(reads)))
            for path in found:
                rows += self.rows_of(path) if files.extension(path) == 'csv' else [{'subject': path}]
        stems = [files.stem(row['subject']) for row in rows]
        if len(set(stems)) < len(stems):
            stems = ['-'.join(files.stem(row[each]) for each in row if each != 'name') for row in rows]
        subjects = {}
        for row, stem in zip(rows, stems):
            name = row.pop('name', '') or stem
            if name in subjects:
                raise Usage('two subjects have the name %s; rename one, or give a table with a column "name"' % name)
            subjects[name] = Subject(name, row)
            self.complete(subjects[name])
        found = [subjects[name] for name in sorted(subjects)]
        if self.command.together:
            others = {key: path for key, path in found[0].given.items() if key != 'subject'}
            return [Subject(self.name, {**others, **{'subject %06d' % k: each.given['subject']
                                                     for k, each in enumerate(found)}})]
        return found

    def rows_of(self, path: str) -> list[dict[str, str]]:
        """The rows of a table, whose files are relative to its folder."""
        known = ['name', 'subject', *(named(self.command, each) for each in others(self.command, self.filter)
                                      if not each.multiple)]
        with open(path, newline='') as file:
            rows = [{(key or '').strip().replace('-', '_'): (value or '').strip() for key, value in row.items()
                     if isinstance(value, str)} for row in csv.DictReader(file)]
        for row in rows:
            if 'subject' not in row or set(row) - set(known):
                raise Usage('%s has the columns %s; it needs subject, and may have %s' % (
                    path, ', '.join(row), ', '.join(each for each in known if each != 'subject')))
        return [{key: value if key == 'name' else os.path.join(os.path.dirname(path), value)
                 for key, value in row.items() if value} for row in rows]

    def complete(self, subject: Subject) -> None:
        """Adds the files that options name, and checks that all are there."""
        for each in others(self.command, self.filter):
            name, given = named(self.command, each), getattr(self.options, 'file_' + each.name)
            for k, path in enumerate(given if each.multiple and given else [given] if given else []):
                if os.path.isdir(path):
                    inside = sorted(file for file in os.listdir(path) if files.stem(file) == subject.name and
                                    not file.startswith('.'))
                    if len(inside) != 1:
                        raise Usage('%s: %s has %s files named %s; it needs one' % (
                            option(name), path, len(inside) or 'no', subject.name))
                    path = os.path.join(path, inside[0])
                subject.given.setdefault('%s %d' % (name, k) if each.multiple else name, path)
            if each.required and name not in subject.given:
                raise Usage('%s is needed' % option(name))
        for path in subject.given.values():
            if not os.path.isfile(path):
                raise Usage('there is no file ' + path)

    def task(self, subject: Subject) -> batch.Task:
        key = batch.key_of([VERSION, self.name, self.properties, self.options.format, sorted(subject.given)],
                           [subject.given[each] for each in sorted(subject.given)])
        drawn: list[vtkDataSet] = []
        picture = os.path.join(self.folder, batch.STATE, subject.name + '.png')

        def work() -> tuple[dict[str, Any], dict[str, int]]:
            # For the log, in a process of its own.
            warnings.simplefilter('always')
            warnings.formatwarning = lambda message, *rest, **more: '%s\n' % message
            if os.path.exists(picture):
                os.remove(picture)
            made = self.command.run(self.inputs_of(subject), self.properties)
            sizes = {}
            # The main result comes last: if it is there, all are.
            for k, (name, data) in reversed(list(enumerate(made.outputs.items()))):
                place, _, block = ('', '', '') if k == 0 else name.partition('/')
                for path in files.write(data, os.path.join(self.folder, place), block or subject.name,
                                        self.options.format if k == 0 else None):
                    path = os.path.join(place, path)
                    sizes[path] = os.path.getsize(os.path.join(self.folder, path))
                if k == 0 and isinstance(data, vtkDataSet):
                    drawn.append(data)
            return {name: fact.tolist() if isinstance(fact, numpy.ndarray) else fact
                    for name, fact in made.facts.items()}, sizes

        def draw() -> None:
            if not self.no_pictures and drawn:
                pictures.draw(drawn[0], self.command.shown, self.command.colours, picture)

        return batch.Task(subject.name, key, work, draw)

    def inputs_of(self, subject: Subject) -> dict[str, Any]:
        inputs: dict[str, Any] = {}
        for each in self.filter.inputs:
            name = 'subject' if each.name == self.command.subject else named(self.command, each)
            paths = [path for key, path in subject.given.items() if key == name or key.startswith(name + ' ')]
            data = [files.as_type(files.read(path), each.types) for path in paths]
            if data:
                inputs[each.name] = data if each.multiple else data[0]
            if name == 'subject' and self.command.together:
                inputs[each.name] = vtkMultiBlockDataSet()
                for k, (block, path) in enumerate(zip(data, paths)):
                    inputs[each.name].SetBlock(k, block)
                    inputs[each.name].GetMetaData(k).Set(vtkMultiBlockDataSet.NAME(), files.stem(path))
        return inputs

    def run(self) -> int:
        tasks = [self.task(each) for each in self.subjects]
        records = {each.name: batch.read_record(self.folder, each.name) for each in tasks}
        todo = [each for each in tasks if not batch.up_to_date(
            records[each.name], each, self.folder, self.options.timeout, self.options.redo)]
        print('%d subjects, %d up to date' % (len(tasks), len(tasks) - len(todo)), flush=True)
        if self.options.dry_run:
            for each in todo:
                print('would do ' + each.name)
            return 0
        interrupted = False
        if todo:
            with self.locked(), pictures.display() if not self.options.no_pictures else _none() as reason:
                self.no_pictures = reason
                if reason and not self.options.no_pictures:
                    print('no pictures: ' + reason)
                for each in todo:
                    records[each.name] = batch.Record(each.name)
                try:
                    self.work(todo, records)
                except KeyboardInterrupt:
                    interrupted = True
                report.write(list(records.values()), self.command, 'shapemap ' + self.name, self.folder, reason)
        failed = [each for each in records.values() if each.status != 'done']
        print('%d done, %d not: %s' % (
            len(records) - len(failed), len(failed), os.path.join(self.folder, 'shapemap.csv')))
        return 130 if interrupted else 1 if failed else 0

    def work(self, todo: list[batch.Task], records: dict[str, batch.Record]) -> None:
        with open(os.path.join(self.folder, 'shapemap.log'), 'a') as log:
            def tell(record: batch.Record) -> None:
                records[record.name] = record
                line = '%-9s %7.1f s  %s  %s' % (record.status, record.seconds, record.name,
                                                 record.message or report.told(record, self.command))
                print(line, flush=True)
                log.write(time.strftime('%Y-%m-%d %H:%M:%S ') + line + '\n')
                printed = os.path.join(self.folder, batch.STATE, record.name + '.txt')
                with open(printed, errors='replace') as file:
                    # VTK's own messages have the colours of a terminal.
                    log.writelines('    ' + re.sub(r'\x1b\[[\d;]*m', '', each).rstrip() + '\n' for each in file if each.strip())
                os.remove(printed)
                log.flush()

            batch.run(todo, self.folder, min(self.options.jobs, len(todo)), self.options.timeout, tell)

    def locked(self) -> Any:
        """The output folder, for this command alone."""
        state = os.path.join(self.folder, batch.STATE)
        os.makedirs(state, exist_ok=True)
        lock = open(os.path.join(state, 'lock'), 'a+')
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise Usage('another shapemap works in %s; wait for it' % self.folder) from None
        lock.seek(0)
        owner = lock.read()
        if owner not in ('', self.name):
            raise Usage('%s has results of "shapemap %s"; give another folder' % (self.folder, owner))
        if not owner:
            lock.write(self.name)
            lock.flush()
        return lock


def _none() -> Any:
    import contextlib
    return contextlib.nullcontext('--no-pictures')


def _positive(text: str) -> int:
    if int(text) < 1:
        raise argparse.ArgumentTypeError('%s is too small; give at least 1' % text)
    return int(text)


if __name__ == '__main__':
    sys.exit(main())
