"""Makes one harmonic volume map and says what it took: pvpython one_map.py BOUNDARY.vtp OPTIONS,
the filter's properties as JSON, with `features`: a file, or none. Its last line is JSON: what measure()
returns, and the process's peak memory in MiB before and after."""
import json
import os
import resource
import subprocess
import sys
import time

import scenes


def measure(path, features=None, **options):
    """Makes the harmonic volume map of a boundary's file, and of one with features, and returns the table of
    levels as a dictionary of columns, with `wall` and `cpu`: the seconds of the filter alone, with its
    inputs, and `RMSEFeatures`."""
    boundary = scenes.read(path)
    inner = [scenes.read(features)] if features else []
    # The map is made for the boundary; carrying one point costs nothing.
    domain = scenes.point_set([[0.0, 0.0, 0.0]])
    wall, cpu = time.time(), cpu_seconds()
    algorithm = scenes.volume_map(domain, boundary, inner, **options)
    took = dict(wall=time.time() - wall, cpu=cpu_seconds() - cpu,
                RMSEFeatures=scenes.fact(algorithm.GetOutputDataObject(0), 'HarmonicVolumeMap.RMSEFeatures'))
    table = algorithm.GetOutputDataObject(2)
    for c in range(table.GetNumberOfColumns()):
        took[table.GetColumnName(c)] = [
            table.GetColumn(c).GetValue(r) for r in range(table.GetNumberOfRows())]
    return took


def cpu_seconds():
    """Of this process and of those that it has started: large decompositions have a process of their own."""
    return sum(os.times()[:4])


def measure_alone(path, **options):
    """The same in a process of its own, with that process's peak memory in MiB: `before` the filter ran
    and `peak`."""
    run = subprocess.run(
        [os.path.join(scenes.ROOT, 'Utilities', 'pvpython.sh'), os.path.abspath(__file__), path,
         json.dumps(options)], stdout=subprocess.PIPE, universal_newlines=True, check=True)
    return json.loads(run.stdout.splitlines()[-1])


def peak():
    """The larger peak of this process and of those that it has started. Of this one it is VmHWM, not getrusage's
    ru_maxrss: that one remembers the process it was forked from."""
    with open('/proc/self/status') as status:
        line = next(line for line in status if line.startswith('VmHWM:'))
    started = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
    return max(int(line.split()[1]), started) / 1024.0


def main(path, options):
    before = peak()
    took = measure(path, **json.loads(options))
    print(json.dumps(dict(took, before=before, peak=peak())))


if __name__ == '__main__':
    main(*sys.argv[1:])
