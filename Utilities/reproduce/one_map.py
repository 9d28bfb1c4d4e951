"""Makes one harmonic volume map and says what it took: pvpython one_map.py BOUNDARY.vtp OPTIONS,
the filter's properties as JSON. Its last line is JSON: what measure() returns, and the process's peak
memory in MiB before and after."""
import json
import os
import subprocess
import sys
import time

import scenes


def measure(path, **options):
    """Makes the harmonic volume map of a boundary's file and returns the table of levels as a
    dictionary of columns, with `wall` and `cpu`: the seconds of the filter alone, with its inputs."""
    boundary = scenes.read(path)
    # The map is made for the boundary; carrying one point costs nothing.
    domain = scenes.point_set([[0.0, 0.0, 0.0]])
    wall, cpu = time.time(), time.process_time()
    table = scenes.volume_map(domain, boundary, **options).GetOutputDataObject(2)
    took = dict(wall=time.time() - wall, cpu=time.process_time() - cpu)
    for c in range(table.GetNumberOfColumns()):
        took[table.GetColumnName(c)] = [
            table.GetColumn(c).GetValue(r) for r in range(table.GetNumberOfRows())]
    return took


def measure_alone(path, **options):
    """The same in a process of its own, with that process's peak memory in MiB: `before` the filter ran
    and `peak`."""
    run = subprocess.run(
        [os.path.join(scenes.ROOT, 'Utilities', 'pvpython.sh'), os.path.abspath(__file__), path,
         json.dumps(options)], stdout=subprocess.PIPE, universal_newlines=True, check=True)
    return json.loads(run.stdout.splitlines()[-1])


def peak():
    """VmHWM, not getrusage's ru_maxrss: that one remembers the process it was forked from."""
    with open('/proc/self/status') as status:
        line = next(line for line in status if line.startswith('VmHWM:'))
    return int(line.split()[1]) / 1024.0


def main(path, options):
    before = peak()
    took = measure(path, **json.loads(options))
    print(json.dumps(dict(took, before=before, peak=peak())))


if __name__ == '__main__':
    main(*sys.argv[1:])
