"""Maps of collections onto one template, from the surfaces alone, beside the maps of pairs: errors, and what is
left after going round a cycle, at most a third of that of pairs. Then one shape of another kind is put in, which
must be the first outlier.

    Utilities/pvpython.sh Testing/Benchmarks/Collections.py FOLDER OTHER PREFIX...

FOLDER is as for AutomaticMaps.py. A collection has all poses whose names are a PREFIX and a number, whose true
points correspond. OTHER is the name of the shape that is put in."""
import glob
import os
import re
import sys
import time
import numpy
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
import shapemap

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), '..'))
from AutomaticMaps import METHODS, Pose, errors, mapped  # noqa: E402
import shapetesting  # noqa: E402
from shapetesting import fact  # noqa: E402

LARGEST_RATIO = 1 / 3  # of what is left after going round a cycle, to that of pairs
FUNCTIONAL, COMPUTED = METHODS.index('FunctionalMap'), 2


def collect(surfaces):
    """The filter after its run, and its CPU seconds."""
    blocks = vtkMultiBlockDataSet()
    for i, surface in enumerate(surfaces):
        blocks.SetBlock(i, surface)
    algorithm = shapetesting.new(shapemap.vtkShapeCollection, blocks, Correspondence=COMPUTED)
    start = time.process_time()
    outputs = shapetesting.outputs(algorithm)
    return outputs, time.process_time() - start


if __name__ == '__main__':
    folder, other = sys.argv[1:3]
    faults = []
    print('%-12s%8s%12s%12s%12s%12s%8s%12s%10s' % ('collection', 'shapes', 'error x100', 'of pairs', 'cycle x100',
                                                  'of pairs', 'ratio', 's a shape', 'outlier'))
    for prefix in sys.argv[3:]:
        names = sorted(os.path.basename(path)[:-4] for path in glob.glob(os.path.join(folder, prefix + '*.off'))
                       if re.fullmatch(r'\d+', os.path.basename(path)[len(prefix):-4]))
        poses = [Pose(folder, name) for name in names]
        outputs, seconds = collect([pose.surface for pose in poses])
        template = int(fact(outputs[1], 'Collection.Template'))
        means, single = [], []
        for i, pose in enumerate(poses):
            if i == template:
                continue
            true, mirrored = errors(outputs[0].GetBlock(i), pose, poses[template])
            if mirrored < true:
                faults.append('%s: %s is mirrored' % (prefix, names[i]))
            means.append(true)
            pair, _ = mapped(pose.surface, poses[template].surface, FUNCTIONAL)
            single.append(errors(pair, pose, poses[template])[0])
        cycle, of_pairs = (fact(outputs[1], 'Collection.' + name) for name in ('CycleError', 'PairwiseCycleError'))
        odd, _ = collect([pose.surface for pose in poses] + [Pose(folder, other).surface])
        outlier = int(fact(odd[1], 'Collection.Outlier')) == len(poses)
        print('%-12s%8d%12.2f%12.2f%12.2f%12.2f%8.2f%12.1f%10s' % (
            prefix, len(poses), 100 * numpy.mean(means), 100 * numpy.mean(single), 100 * cycle, 100 * of_pairs,
            cycle / of_pairs, seconds / len(poses), 'first' if outlier else 'NOT FIRST'), flush=True)
        if cycle > LARGEST_RATIO * of_pairs:
            faults.append('%s: the ratio of cycle errors is %.2f' % (prefix, cycle / of_pairs))
        if not outlier:
            faults.append('%s: %s is not the first outlier' % (prefix, other))
    assert not faults, '\n'.join(faults)
