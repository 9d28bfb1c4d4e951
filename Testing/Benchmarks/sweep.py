"""What the benchmarks of this folder share: the program `benchmark` and its figures, models, medians,
tables, and claims that end a script with 1 and are named. A benchmark then only says what it runs and
what it claims:

    import sweep

    options = sweep.parser(__doc__).parse_args()
    program, claims = sweep.Program(options), sweep.Claims()
    table = sweep.Table('model:<20', 'hexes:9.4g', 'min:9.4g')
    for name, path in sweep.models(options):
        row = program.run('hex', path, 'Grid').row()
        table.print(dict(row, model=name))
        claims.at_least(name, 'worst scaled Jacobian', row['min'], 0.2)
    claims.finish()

Scripts that run filters are started by Utilities/pvpython.sh; importing this module lets them import
what Utilities/, Utilities/reproduce and Testing/ hold.
"""
import argparse
import collections
import glob
import json
import math
import os
import re
import statistics
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
BUILD = os.environ.get('SHAPEMAP_BUILD', os.environ.get('SHAPEMAP_PREFIX', os.path.join(ROOT, 'build')))
sys.path += [os.path.join(ROOT, *folder) for folder in (
    ('Utilities',), ('Utilities', 'reproduce'), ('Testing',))]

from claims import Claims  # noqa: E402, F401


def use_one_thread():
    """For this process, before it loads numpy, and for those that it starts."""
    for variable in ('OPENBLAS_NUM_THREADS', 'OMP_NUM_THREADS', 'VTK_SMP_MAX_THREADS'):
        os.environ[variable] = '1'


# Options.

def parser(description, models=True):
    """--build and --program, and with `models` which ones: names or all of a folder."""
    made = argparse.ArgumentParser(
        description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    made.add_argument('--build', default=BUILD)
    made.add_argument('--program', help="another benchmark program than the build's")
    if models:
        made.add_argument('--folder', help="of models; the build's by default")
        made.add_argument('words', nargs='*', metavar='MODEL | Property=value')
    return made


def models(options, usual=(), formats=('.off',)):
    """(name, path) of the models that are named, of the `usual` ones, or of all in the folder and
    below, the small ones first. Only names of OFF files are without their extension."""
    folder = options.folder or os.environ.get('SHAPEMAP_MODELS', os.path.join(options.build, 'models'))
    names = [word for word in options.words if '=' not in word] or usual
    paths = [os.path.join(folder, name if name.endswith(formats) else name + '.off') for name in names]
    paths = paths or sorted(
        (path for path in glob.glob(os.path.join(folder, '**', '*'), recursive=True)
         if path.lower().endswith(formats)), key=lambda path: (os.path.getsize(path), path))
    assert paths, 'there are no models in ' + folder
    for path in paths:
        assert os.path.exists(path), 'there is no model ' + path
    return [(os.path.basename(path).removesuffix('.off'), path) for path in paths]


def properties(options):
    """The words Property=value, as a dictionary."""
    return dict(word.split('=', 1) for word in options.words if '=' in word)


def set_properties(algorithm, settings):
    """Sets those properties of a filter, each as a value of its own type."""
    for name, value in settings.items():
        getattr(algorithm, 'Set' + name)(type(getattr(algorithm, 'Get' + name)())(value))


# Running cases.

class Outcome(collections.namedtuple('Outcome', 'rows code error')):
    """What a run of the program printed, its exit code (None if it took too long) and what went
    wrong, or ''."""

    DOES_NOT_APPLY = 2  # the exit code for a model that the case is not for

    def row(self):
        """The last row. Raises RuntimeError if the run failed."""
        if self.error:
            raise RuntimeError(self.error)
        return self.rows[-1]


class Program:
    """The program `benchmark`, built before its first run unless --program names another one."""

    def __init__(self, options=None):
        self.build = options.build if options else BUILD
        self.path = options.program if options else None

    def ready(self):
        """Its path."""
        if not self.path:
            built = subprocess.run(['cmake', '--build', self.build, '--target', 'benchmark'],
                                   stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
            if built.returncode:
                sys.exit(built.stdout[-2000:] + 'the program benchmark cannot be built')
            self.path = os.path.join(self.build, 'bin', 'benchmark')
        return self.path

    def model(self, name):
        return os.path.join(self.build, 'models', name + '.off')

    def run(self, case, *words, seconds=None, threads=None, **settings):
        """The outcome of a case in a process of its own, with the words and settings KEY=VALUE of
        its command line; of at most so many seconds and on so many threads, if they are given."""
        command = [self.ready(), case, *map(str, words), '--json']
        command += ['%s=%s' % setting for setting in settings.items()]
        environment = dict(os.environ)
        if threads:
            environment['VTK_SMP_MAX_THREADS'] = str(threads)
        try:
            done = subprocess.run(command, capture_output=True, encoding='utf-8', errors='replace',
                                  env=environment, timeout=seconds)
        except subprocess.TimeoutExpired:
            return Outcome([], None, 'no end after %g s' % seconds)
        error = done.stderr.strip() if done.returncode else ''
        if done.returncode and not error:
            error = 'crashed with signal %d' % -done.returncode
        rows = [{key: math.nan if value is None else value for key, value in json.loads(line).items()}
                for line in done.stdout.splitlines()]
        return Outcome(rows, done.returncode, error)


def medians(runs, *measures):
    """The median row of each measurement (a function that returns a row, or None if it failed).
    They are run in turn, so many times, so that what else the machine does falls on all of them."""
    found = [[] for _ in measures]
    for _ in range(runs):
        for rows, measure in zip(found, measures):
            row = measure()
            if row:
                rows.append(row)
    return [rows and {key: statistics.median(row[key] for row in rows)
                      if isinstance(value, (int, float)) else value
                      for key, value in rows[0].items()} or None for rows in found]


class Table:
    """A table that is printed as its rows become known. A column is 'key:format', such as 'cpu:8.2f' or
    'name:<20'; what a row lacks is '-'."""

    def __init__(self, *columns):
        self.columns = [column.rpartition(':')[::2] for column in columns]
        self.print({key: key for key, _ in self.columns})

    def print(self, row, note=''):
        cells = []
        for key, form in self.columns:
            value = row.get(key)
            if value is None or isinstance(value, str):
                # The format without the digits and the type of a number.
                form = re.match(r'[<>]?\d*', form).group()
                form, value = form if form[:1] in '<>' else '>' + form, '-' if value is None else value
            cells.append(format(value, form))
        print(' '.join(cells) + ('  ' + note if note else ''), flush=True)
