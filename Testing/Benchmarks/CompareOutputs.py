"""Every filter's outputs before and after a change, compared bit by bit.

    Utilities/pvpython.sh Testing/Benchmarks/CompareOutputs.py write FOLDER [--only REGEX] [--list]
    /usr/bin/python3 Testing/Benchmarks/CompareOutputs.py compare BEFORE AFTER [--all]

`write` runs every filter and writer of the plugin (SHAPEMAP_PREFIX names the build) on generated
shapes, on demo models and on what other filters make of them, with its default options and with each
value of each enumeration and switch, one at a time. FOLDER gets a file for each case, with points,
connectivity, all arrays and field data, or the error messages. Durations are left out. It takes about
four CPU minutes. Set VTK_SMP_MAX_THREADS=1 OMP_NUM_THREADS=1 for both builds: the last bits of Shape
Laplace Spectrum depend on the number of threads. Cases are in FilterCases.py, new names and
differences that are meant in FilterChanges.py.

`compare` prints the cases that differ (with --all: every case), then a row for each filter. Size is
the diagonal of the box for points, half a turn for angles that are small in a good result, and the
largest magnitude for other arrays. It exits with 1 if a
difference exceeds LIMIT of the size, if a number of points, a cell, a word or an array's type differs,
if a case, array or fact is gone, or if only one of both is an error. New cases, arrays and facts, the
wording of errors and what FilterChanges.EXPECTED names are reported only.
"""
import argparse
import glob
import math
import os
import re
import sys

import numpy

import FilterChanges

LIMIT = 1e-10  # largest difference / size
DURATION = re.compile('Seconds|Memory')  # in the name of an array: no result


# What a file of FOLDER holds: a dictionary of arrays.

def numbers_of(data, prefix=''):
    """Everything that a data object holds, by name."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkCommonDataModel import vtkDataObject
    found = {prefix + 'class': numpy.array(data.GetClassName())}
    if data.IsA('vtkMultiBlockDataSet'):
        for i in range(data.GetNumberOfBlocks()):
            if data.GetBlock(i):
                found.update(numbers_of(data.GetBlock(i), '%sblock %d ' % (prefix, i)))
    if data.IsA('vtkPointSet') and data.GetPoints():
        found[prefix + 'points'] = vtk_to_numpy(data.GetPoints().GetData())
    elif data.IsA('vtkImageData'):
        found[prefix + 'grid'] = numpy.array(
            data.GetOrigin() + data.GetSpacing() + data.GetExtent(), float)
    cells = []
    if data.IsA('vtkPolyData'):
        cells = [(kind, getattr(data, 'Get' + kind)()) for kind in ('Verts', 'Lines', 'Polys', 'Strips')]
    elif data.IsA('vtkUnstructuredGrid') and data.GetNumberOfCells():
        cells = [('Cells', data.GetCells())]
        found[prefix + 'Cells types'] = vtk_to_numpy(data.GetCellTypesArray())
    for kind, array in cells:
        found['%s%s offsets' % (prefix, kind)] = vtk_to_numpy(array.GetOffsetsArray())
        found['%s%s connectivity' % (prefix, kind)] = vtk_to_numpy(array.GetConnectivityArray())
    for word, kind in (('point', vtkDataObject.POINT), ('cell', vtkDataObject.CELL),
                       ('row', vtkDataObject.ROW), ('field', vtkDataObject.FIELD)):
        attributes = data.GetAttributesAsFieldData(kind)
        for i in range(attributes.GetNumberOfArrays() if attributes else 0):
            values = attributes.GetAbstractArray(i)
            key = '%s%s %s' % (prefix, word, values.GetName())
            if DURATION.search(key):
                continue
            if values.IsA('vtkStringArray'):
                found[key] = numpy.array([values.GetValue(k) for k in range(values.GetNumberOfValues())],
                                         str)
            else:
                found[key] = vtk_to_numpy(values)
        for role in ('Scalars', 'Vectors', 'Normals', 'TCoords', 'GlobalIds'):
            if attributes and word in ('point', 'cell') and getattr(attributes, 'Get' + role)():
                found['%s%s active %s' % (prefix, word, role)] = numpy.array(
                    getattr(attributes, 'Get' + role)().GetName() or '')
    return found


def cpu_time():
    """Of this process and of those that ran for it."""
    return sum(os.times()[:4])


def write_outputs(arguments):
    """Runs the cases; plugin and ParaView are needed only here."""
    from FilterCases import all_cases
    every = list(all_cases())
    names = [case[:2] for case in every]
    assert len(set(names)) == len(names), {name for name in names if names.count(name) > 1}
    chosen, counts = [], {}
    for case in every:
        number = counts[case[0]] = counts.get(case[0], 0) + 1
        if re.search(arguments.only, ': '.join(case[:2])):
            chosen.append((os.path.join(arguments.folder, '%s-%03d.npz' % (case[0], number)),) + case)
    if arguments.list:
        print('\n'.join(': '.join(each[1:3]) for each in chosen))
        return 0
    os.makedirs(arguments.folder, exist_ok=True)
    for path, *_ in chosen:
        if os.path.exists(path):
            sys.exit(path + ' exists: give a new folder')
    seconds = {}
    for number, (path, name, case, run) in enumerate(chosen):
        print('%4d/%d  %-24s %-60s' % (number + 1, len(chosen), name, case), end=' ', flush=True)
        begin = cpu_time()
        kept = {'filter': numpy.array(name), 'case': numpy.array(case)}
        try:
            outputs, messages = run()
        except Exception as error:  # of an input that another filter makes: this case's outcome
            outputs, messages = [], ['%s: %s' % (type(error).__name__, error)]
        if isinstance(outputs, bytes):
            kept['content'] = numpy.array(outputs.decode())
        elif not messages:
            for port, output in enumerate(outputs):
                kept.update(numbers_of(output, '%d: ' % port))
        # Messages begin with where in the code they come from.
        text = ' '.join(re.sub(r'(?s)^.*?\(0x[0-9a-f]+\): ', '', each).strip() for each in messages
                        if 'returned failure for request' not in each)
        if messages:
            kept['error'] = numpy.array(text)
        spent = cpu_time() - begin
        seconds[name] = seconds.get(name, 0.0) + spent
        print('%7.2f s  %s' % (spent, text[:150]), flush=True)
        numpy.savez(path, **kept)
    for name, spent in sorted(seconds.items(), key=lambda item: -item[1]):
        print('%8.1f s  %s' % (spent, name))
    print('%8.1f s  %d cases of %d filters and writers' % (
        sum(seconds.values()), len(chosen), len(seconds)))
    return 0


# Comparing.

def renamed(text, renames):
    """A text with new names, where words begin with old ones."""
    for old, new in renames.items():
        text = re.sub(r'(?<= )' + re.escape(old), new, text)
    return text


def text_difference(before, after):
    """(largest difference of numbers with a point, their size), or None if anything else differs."""
    number = r'[-+]?(?:\d+\.\d*|\.\d+)(?:[eE][-+]?\d+)?'
    if re.sub(number, '#', before) != re.sub(number, '#', after):
        return None
    a, b = (numpy.array(re.findall(number, text), float) for text in (before, after))
    return (abs(a - b).max(), abs(a).max()) if a.size else (0.0, 1.0)


def array_difference(key, before, after):
    """(largest difference, size, what else differs)."""
    if key == 'content':
        found = text_difference(str(before), str(after))
        return found + ('',) if found else (math.inf, 1.0, 'other words')
    if before.dtype.kind != after.dtype.kind or (
            before.dtype != after.dtype and before.dtype.kind not in 'U'):
        return math.inf, 1.0, '%s became %s' % (before.dtype, after.dtype)
    if before.shape != after.shape:
        return math.inf, 1.0, '%s became %s' % (before.shape, after.shape)
    if before.tobytes() == after.tobytes():
        return 0.0, 1.0, ''
    if before.dtype.kind == 'U':
        return math.inf, 1.0, '%s became %s' % (before, after)
    a, b = before.astype(float), after.astype(float)
    same = (a == b) | (numpy.isnan(a) & numpy.isnan(b))
    difference = numpy.where(same, 0.0, abs(a - b)).max()
    finite = a[numpy.isfinite(a)]
    size = abs(finite).max() if finite.size else 0.0
    if key.endswith('points') and len(a):
        size = numpy.linalg.norm(numpy.ptp(a, axis=0))
    if key in FilterChanges.DEGREES:
        size = 180.0
    if math.isnan(difference):
        return math.inf, size, 'not a number'
    return difference, size, '%d of %d values' % ((~same).sum(), same.size)


def reason(names, key):
    """Why an array is meant to be gone or to differ, or None."""
    for case, array, why in FilterChanges.EXPECTED:
        if re.search(case, ': '.join(names)) and re.search(array, key):
            return why
    return None


def case_difference(names, before, after):
    """(number of arrays, largest difference / size, whether the bits are the same, remarks, failed)."""
    remarks, worst, failed, same = [], 0.0, False, True
    if ('error' in before) != ('error' in after):
        message = str((before.get('error') if 'error' in before else after['error']))
        return 0, math.inf, False, [('error before: ' if 'error' in before else 'error now: ') +
                                    message[:200]], True
    if 'error' in before and str(before['error']) != str(after['error']):
        remarks.append('the message was: %s; is: %s' % (before['error'], after['error']))
    skipped = {'filter', 'case', 'error'}
    keys = before.keys() - skipped
    for key in sorted(keys - after.keys()):
        why = reason(names, key)
        remarks.append('gone: ' + key + (' (%s)' % why if why else ''))
        failed, same = failed or not why, False
    for key in sorted(after.keys() - skipped - keys):
        remarks.append('new: ' + key)
    for key in sorted(keys & after.keys()):
        difference, size, words = array_difference(key, before[key], after[key])
        if difference == 0.0 and not words:
            continue
        same = False
        ratio = difference / size if size else (math.inf if difference else 0.0)
        why = reason(names, key)
        if not why:
            worst = max(worst, ratio)
        remarks.append('%s: %.3g / %.3g = %.1e %s%s' % (
            key, difference, size, ratio, words, ' (%s)' % why if why else ''))
    return len(keys), worst, same, remarks, failed or worst > LIMIT


def read_folder(folder):
    """The cases by filter and name."""
    found = {}
    for path in sorted(glob.glob(os.path.join(folder, '*.npz'))):
        with numpy.load(path) as held:
            name, case = str(held['filter']), str(held['case'])
        name = FilterChanges.FILTER_NAMES.get(name, name)
        found[name, renamed(case, FilterChanges.PROPERTY_NAMES)] = path
    assert found, 'there are no outputs in ' + folder
    return found


def load(path):
    with numpy.load(path) as held:
        return {renamed(key, FilterChanges.ARRAY_NAMES): held[key] for key in held.files}


def compare_outputs(arguments):
    before, after = read_folder(arguments.before), read_folder(arguments.after)
    rows = {}
    form = '%-24s %-60s %6s %10s  %-5s %s'
    print(form % ('filter', 'case', 'arrays', 'difference', 'bits', ''))
    for names in sorted(before.keys() | after.keys()):
        row = rows.setdefault(names[0], {'cases': 0, 'errors': 0, 'arrays': 0, 'same': 0, 'worst': 0.0,
                                         'failed': 0, 'gone': {}, 'new': {}})
        if names not in after or names not in before:
            gone = names not in after
            print(form % (names + ('', '', '', 'GONE' if gone else 'new')))
            row['failed'] += gone
            continue
        old, new = load(before[names]), load(after[names])
        arrays, worst, same, remarks, failed = case_difference(names, old, new)
        row['cases'] += 1
        row['errors'] += 'error' in new
        row['arrays'] += arrays
        row['same'] += same
        row['worst'] = max(row['worst'], worst)
        row['failed'] += failed
        for remark in remarks:
            kind, _, key = remark.partition(': ')
            if kind in ('gone', 'new'):
                row[kind][key] = row[kind].get(key, 0) + 1
        if arguments.all or remarks:
            print(form % (names + (arrays, '%.1e' % worst if worst else '0', 'same' if same else 'other',
                                   'FAILED' if failed else '')))
            for remark in remarks:
                print(' ' * 8 + remark)
    form = '%-24s %6s %7s %7s %6s %11s %7s'
    print('\n' + form % ('filter', 'cases', 'errors', 'arrays', 'same', 'difference', 'failed'))
    for name, row in sorted(rows.items()):
        print(form % (name, row['cases'], row['errors'], row['arrays'], row['same'],
                      '%.1e' % row['worst'] if row['worst'] else '0', row['failed']))
    for kind in ('gone', 'new'):
        for name, row in sorted(rows.items()):
            for key, count in sorted(row[kind].items()):
                print('%s: %s, %s, %d cases' % (kind, name, key, count))
    total = {key: sum(row[key] for row in rows.values())
             for key in ('cases', 'arrays', 'same', 'failed')}
    print('%(cases)d cases, %(arrays)d arrays; %(same)d cases have the same bits, %(failed)d failed' %
          total)
    return 1 if total['failed'] else 0


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    commands = parser.add_subparsers(dest='command', required=True)
    write = commands.add_parser('write')
    write.add_argument('folder')
    write.add_argument('--only', default='', help='a regular expression: "FILTER: CASE"')
    write.add_argument('--list', action='store_true', help='names the cases, runs nothing')
    compare = commands.add_parser('compare')
    compare.add_argument('before')
    compare.add_argument('after')
    compare.add_argument('--all', action='store_true', help='also lists cases that are the same')
    arguments = parser.parse_args()
    return write_outputs(arguments) if arguments.command == 'write' else compare_outputs(arguments)


if __name__ == '__main__':
    sys.exit(main())
