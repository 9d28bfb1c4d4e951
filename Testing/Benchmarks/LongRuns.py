"""How filters on real models report their progress, and how soon they stop.

    Utilities/pvpython.sh Testing/Benchmarks/LongRuns.py [--shares 0.2 0.5 0.8] [CASE ...]

Each case runs once to its end. `deviation` is the greatest difference between the fraction that the filter
reports and the share of the time that has passed; `gap` the longest time between two reports, with the
stage that was reported before it. `work` is as `gap`, in CPU seconds of the filter's thread, which other
programs do not lengthen. `stop` is the longest time from an abort to the end of the filter: a thread sets
AbortExecute at each of the shares of the run; `CPU` is the same in CPU seconds of the filter's
thread. The filter looks for it only when it reports, so whenever it is set, the filter stops at most after
`gap` and `rest` seconds; `rest` is the longest time from the first report after an abort to the end. Claims are
made of cases that take more than a second. The large cases have 100,000 points and more: there, one stage alone
takes longer than a filter may take to stop.

Python runs another thread only while the first one runs Python itself, not while it is inside VTK. So the
thread acts at the next report, and only because an observer in Python is called there.
"""
import argparse
import threading
import time

import sweep  # lets the following be found

from FilterCases import carried, hexahedra, map_of
from FilterInputs import border, extreme, finer, handle, landmarks, lattice, section, seeds, shape, tangled
from FilterRuns import chain, producer, set_property, smproxy_of

LARGEST_DEVIATION = 0.25
LONGEST_STOP = 0.5  # seconds

CLOSED = shape('bunny00')
FIGURES = [shape('FigureASmall.vtp'), shape('FigureBSmall.vtp')]
FOUND = [shape('cow'), shape('hand')]
CAP = chain('ShapeCutFeature', 0, [shape('hand'), section(shape('hand'), 0.8)])
CASES = {
    'hexahedra': ('ShapeHexRemesh', [shape('bunny00')], {}),
    'hexahedra of a joint': ('ShapeHexRemesh', [shape('joint')], {}),
    'hexahedra of a hand': ('ShapeHexRemesh', [shape('hand')], {}),
    'hexahedra by a grid': ('ShapeHexRemesh', [shape('cow')], {'Method': 2}),
    'hexahedra by a polycube': ('ShapeHexRemesh', [shape('cross')], {'Method': 1}),
    'polycube': ('ShapePolycube', [shape('cross')], {}),
    'tetrahedra': ('ShapeTetrahedralize', [CLOSED], {}),
    'untangled': ('ShapeUntangle', [tangled(hexahedra('cow')), hexahedra('cow')], {}),
    'volume map': ('ShapeHarmonicVolumeMap', [hexahedra('cow'), map_of('cow')], {}),
    'volume map, large': ('ShapeHarmonicVolumeMap', [hexahedra('hand'), map_of('hand')], {}),
    'volume map, single shot': (
        'ShapeHarmonicVolumeMap', [hexahedra('cow'), map_of('cow')], {'Method': 2}),
    'volume map, multi-level': (
        'ShapeHarmonicVolumeMap', [hexahedra('cow'), map_of('cow')], {'Method': 1}),
    'applied': ('ShapeApplyVolumeMap',
                [lattice(shape('hand'), 40), carried(hexahedra('cow'), map_of('cow'), 1)], {}),
    'applied backwards': ('ShapeApplyVolumeMap', [
        shape('BallSmall.vtu'), carried(hexahedra('cow'), map_of('cow'), 1)], {'Inverse': 1}),
    'sphere': ('ShapeParameterize', [CLOSED], {}),
    'sphere by area': ('ShapeParameterize', [CLOSED], {'AreaWeight': 3.0}),
    'orbifold': ('ShapeParameterize', [CLOSED, seeds(CLOSED, 3)], {'Domain': 3}),
    'disk': ('ShapeParameterize', [CAP], {'Domain': 0, 'Refine': 1}),
    'free boundary': ('ShapeParameterize', [CAP], {'Domain': 2}),
    'spectrum': ('ShapeLaplaceSpectrum', [CLOSED], {}),
    'geodesics, exact': ('ShapeGeodesicDistance', [CLOSED, seeds(CLOSED, 2)], {'Method': 1}),
    'geodesics, heat': ('ShapeGeodesicDistance', [CLOSED, seeds(CLOSED, 2)], {'Method': 0}),
    'exponential map': ('ShapeExponentialMap', [CLOSED], {'Seed': extreme(CLOSED, 4)}),
    'distance': ('ShapeBoundaryDistance', [lattice(CLOSED, 40), CLOSED], {}),
    'cut': ('ShapeCutFeature', [CLOSED, section(CLOSED, 0.8)], {}),
    'holes': ('ShapeFillHoles', [shape('head')], {}),
    'paste': ('ShapePasteFeature', [CAP, shape('PhantomHeadSmall.vtp')],
              {'Seed': extreme(shape('PhantomHeadSmall.vtp'), 4), 'Scale': 0.5}),
    'deformed': ('ShapeDeform', [CLOSED, handle(CLOSED)], {}),
    'deformed by its border': ('ShapeDeform', [shape('head'), border(shape('head'))], {}),
    'correspondence': ('ShapeCorrespondence', FOUND, {}),
    'difference': ('ShapeMapDifference', FIGURES, {}),
    'error curve': ('ShapeMapErrorCurve', FIGURES + FIGURES[:1], {}),
    'quality': ('ShapeMapQuality', [map_of('hand')], {}),
    'morph': ('ShapeMorph', [map_of('hand')], {}),
    'transfer': ('ShapeTransferFields', [map_of('cow'), chain('ShapeParameterize', 1, [shape('hand')])], {}),
}
LARGE = finer(CLOSED, 1)  # 150,818 points
LARGE_OPEN = finer(shape('head'), 3)  # 93,633 points
LARGE_CAP = chain('ShapeCutFeature', 0, [LARGE, section(LARGE, 0.8)])
LARGE_MAP = chain('ShapeParameterize', 0, [shape('man')])
CASES.update({
    'large sphere': ('ShapeParameterize', [LARGE], {}),
    'large disk': ('ShapeParameterize', [LARGE_OPEN], {'Domain': 0, 'Refine': 1}),
    'large free boundary': ('ShapeParameterize', [LARGE_OPEN], {'Domain': 2}),
    'large orbifold': ('ShapeParameterize', [LARGE, seeds(LARGE, 3)], {'Domain': 3}),
    'large spectrum': ('ShapeLaplaceSpectrum', [LARGE], {}),
    'large dense spectrum': (
        'ShapeLaplaceSpectrum', [shape('cow')], {'NumberOfEigenpairs': 1000}),
    'large geodesics': ('ShapeGeodesicDistance', [LARGE, seeds(LARGE, 2)], {'Method': 0}),
    'large exact geodesics': ('ShapeGeodesicDistance', [LARGE, seeds(LARGE, 2)], {'Method': 1}),
    'large exponential map': ('ShapeExponentialMap', [LARGE], {'Seed': extreme(LARGE, 4)}),
    'large distance': ('ShapeBoundaryDistance', [lattice(LARGE, 100), LARGE], {}),
    'large cut': ('ShapeCutFeature', [LARGE, section(LARGE, 0.8)], {}),
    'large holes': ('ShapeFillHoles', [LARGE_OPEN], {}),
    'large deformation': ('ShapeDeform', [LARGE, handle(LARGE)], {}),
    'large correspondence': ('ShapeCorrespondence', [shape('man'), shape('camel')], {}),
    'large difference': ('ShapeMapDifference', [finer(each, 3) for each in FIGURES], {}),
    'large error curve': (
        'ShapeMapErrorCurve', [finer(each, 3) for each in FIGURES + FIGURES[:1]], {}),
    'large quality': ('ShapeMapQuality', [finer(LARGE_MAP, 2)], {}),
    'large morph': ('ShapeMorph', [finer(LARGE_MAP, 2)], {}),
    'large transfer': (
        'ShapeTransferFields', [LARGE_MAP, chain('ShapeParameterize', 1, [CLOSED])], {}),
    'large tetrahedra': ('ShapeTetrahedralize', [LARGE], {}),
    'large untangling': ('ShapeUntangle', [
        tangled(chain('ShapeHexRemesh', 0, [shape('hand')], Method=2, CellsOnLongestSide=40)),
        chain('ShapeHexRemesh', 0, [shape('hand')], Method=2, CellsOnLongestSide=40)], {}),
    'large volume map': ('ShapeHarmonicVolumeMap', [
        hexahedra('man'), map_of('man')], {}),
    'large decomposition': ('ShapeHarmonicVolumeMap', [
        hexahedra('man'), map_of('man')], {'Method': 2}),
    'large application': ('ShapeApplyVolumeMap', [
        lattice(shape('hand'), 80), carried(hexahedra('cow'), map_of('cow'), 1)], {}),
})
for number in range(7):
    CASES['correspondence %d' % number] = (
        'ShapeCorrespondence', FIGURES + [landmarks(FIGURES[0], 4 if number == 6 else 5)], {'Method': number})


class Run:
    """One run of a fresh filter; another thread aborts it after `press` seconds."""

    def __init__(self, name, inputs, settings, press=None):
        smproxy = smproxy_of(name)
        for key, value in settings.items():
            set_property(smproxy, key, value() if callable(value) else value)
        smproxy.UpdateVTKObjects()
        algorithm = smproxy.GetClientSideObject()
        producers = [producer(each()) for each in inputs]
        for port, each in enumerate(producers):
            algorithm.AddInputConnection(port, each.GetOutputPort())
            each.Update()
        self.reports = []
        self.clocks = []  # CPU seconds of this thread at each report, and at the beginning and the end
        self.press = press
        self.pressed = None  # CPU seconds of this thread at the abort

        def report(*_):
            now = time.monotonic() - begin
            self.clocks.append(time.thread_time())
            self.reports.append((now, algorithm.GetProgress(), algorithm.GetProgressText() or ''))

        errors = []
        algorithm.AddObserver('ProgressEvent', report)

        def fail(_, event, message):
            errors.append(message.strip().splitlines()[-1])

        fail.CallDataType = 'string0'
        algorithm.AddObserver('ErrorEvent', fail)
        clock = time.pthread_getcpuclockid(threading.get_ident())

        def abort():
            self.pressed = time.clock_gettime(clock)
            algorithm.SetAbortExecute(1)

        timer = threading.Timer(press or 0.0, abort)
        begin = time.monotonic()
        if press is not None:
            timer.start()
        self.clocks.append(time.thread_time())
        algorithm.Update()
        self.seconds = time.monotonic() - begin
        timer.cancel()
        self.clocks.append(time.thread_time())
        self.stop_work = self.clocks[-1] - self.pressed if self.pressed else 0.0
        if errors:
            raise RuntimeError(errors[0])

    def stop(self):
        """Seconds from the abort to the end, or 0 if the run ended before."""
        return max(self.seconds - self.press, 0.0)

    def rest(self):
        """The part of them after the first report that came after the abort."""
        return max((self.seconds - now for now, _, _ in self.reports if now >= self.press), default=0.0)

    def deviation(self):
        """The greatest, and the stage that was reported before it."""
        return max((abs(share - now / self.seconds), stage) for i, (_, share, stage) in enumerate(self.reports)
                   for now in (self.reports[i][0],
                               self.reports[i + 1][0] if i + 1 < len(self.reports) else self.seconds))

    def tenths(self):
        """The progress at each tenth of the time."""
        return [max([share for now, share, _ in self.reports if now <= 0.1 * tenth * self.seconds], default=0.0)
                for tenth in range(1, 10)]

    def gap(self):
        times = [0.0] + [now for now, _, _ in self.reports] + [self.seconds]
        return max(after - before for before, after in zip(times, times[1:]))

    def work(self):
        return max((after - before, self.reports[i - 1][2] if i else '')
                   for i, (before, after) in enumerate(zip(self.clocks, self.clocks[1:])))

    def worst(self):
        """The progress before the longest work."""
        spans = [after - before for before, after in zip(self.clocks, self.clocks[1:])]
        at = spans.index(max(spans))
        return self.reports[at - 1][1] if at else 0.0

    def stages(self):
        """Each with its share of the time and of the progress."""
        shares = {}
        ends = self.reports[1:] + [(self.seconds, 1.0, '')]
        for (now, share, stage), (after, reached, _) in zip(self.reports, ends):
            seconds, progress = shares.get(stage, (0.0, 0.0))
            shares[stage] = seconds + (after - now) / self.seconds, progress + reached - share
        return shares


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--shares', type=float, nargs='*', default=[0.2, 0.5, 0.8])
    parser.add_argument('--stages', action='store_true', help='print those of every run')
    parser.add_argument('case', nargs='*', help='of %s' % ', '.join(CASES))
    options = parser.parse_args()
    claims = sweep.Claims()
    print('%-26s %8s %9s %7s %7s %7s %7s %7s %7s  %s' % (
        'case', 'reports', 'seconds', 'dev.', 'gap', 'work', 'stop', 'CPU', 'rest', 'stage at the longest work'))
    for name in options.case or CASES:
        try:
            whole = Run(*CASES[name])
        except RuntimeError as error:
            print('%-26s %s' % (name, error), flush=True)
            claims.at_most(name, 'errors', 1, 0)
            continue
        aborted = [Run(*CASES[name], press=share * whole.seconds) for share in options.shares]
        (deviation, where), gap, (work, stage) = whole.deviation(), whole.gap(), whole.work()
        stop = max((run.stop() for run in aborted), default=0.0)
        stop_work = max((run.stop_work for run in aborted), default=0.0)
        rest = max((run.rest() for run in aborted), default=0.0)
        print('%-26s %8d %9.2f %7.2f %7.3f %7.3f %7.3f %7.3f %7.3f  %s' % (
            name, len(whole.reports), whole.seconds, deviation, gap, work, stop, stop_work, rest, stage.partition(': ')[2]), flush=True)
        if options.stages:
            print('    deviation at', where)
            print('    longest work after %.3f of the progress' % whole.worst())
            print('    progress at each tenth of the time', ' '.join('%.2f' % share for share in whole.tenths()))
            for stage, (seconds, progress) in whole.stages().items():
                print('    %6.3f of the time, %6.3f of the progress  %s' % (seconds, progress, stage))
        if whole.seconds > 1.0:
            claims.at_most(name, 'deviation of progress', deviation, LARGEST_DEVIATION)
            claims.at_most(name, 'seconds until it stops', max(gap + rest, stop), LONGEST_STOP)
    claims.finish()


if __name__ == '__main__':
    main()
