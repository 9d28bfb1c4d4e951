"""Makes one harmonic volume map and says what it took: pvpython one_map.py BOUNDARY.vtp OPTIONS,
the filter's properties as JSON. Its last line is JSON: what common.volume_map returns, and the
process's peak memory in MiB before and after."""
import json
import sys

import common


def peak():
    """VmHWM, not getrusage's ru_maxrss: that one remembers the process it was forked from."""
    with open('/proc/self/status') as status:
        line = next(line for line in status if line.startswith('VmHWM:'))
    return int(line.split()[1]) / 1024.0


def main(path, options):
    before = peak()
    took = common.volume_map(path, **json.loads(options))
    print(json.dumps(dict(took, before=before, peak=peak())))


main(*sys.argv[1:])
