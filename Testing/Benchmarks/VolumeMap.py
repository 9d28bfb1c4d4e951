"""The harmonic volume map against what one can do without its method Accelerated, in one table: CPU and
wall seconds, peak memory and errors, medians of several runs, each in a process of its own; then what
is required of them.

    python3 Testing/Benchmarks/VolumeMap.py [--runs 5] [--sizes 3k 10k 38k 100k growth] [--skip SingleShot]

The sizes are models of libcgal-demo (build/models) with 3.6k, 10k and 38k vertices, and 113k: the 38k one
after a step of sqrt(3)-subdivision. growth: the 10k one and 91k vertices, after two steps of it.

Every method is given the values of the map at the vertices of the surface and nothing else. Finite
elements and the kernel's RMSEInside take them as linear in each triangle. Data A: a harmonic field,
known everywhere; the error inside the solid is against the field itself. Data B: the sphere map of the
model, linear in each triangle; the error inside the solid, at 3k and 10k, is against finite elements on
the surface split into four times as many triangles, refined. Errors are root mean squares divided by the
longest side of the target's box. CPU seconds are those of all threads and of TetGen's process. Those of
finite elements are of mesh, assembly, factorisation and solution with the sparse solver that is the
fastest on the model; those of the volume map are of the whole kernel, which also measures its errors.
Evaluation elsewhere counts for neither.
"""
import math
import os

import sweep

SIZES = {'3k': 'retinal.off', '10k': 'bear_bis.off', '38k': 'bunny00.off', '100k': 'bunny00.off@1',
         'growth': 'bear_bis.off@2'}
OFFSETS = (0.01, 0.015, 0.02, 0.03, 0.05, 0.1, 0.15)
SOLVERS = ({'Solver': 'CHOLMOD', 'Ordering': 'AMD'}, {'Solver': 'CHOLMOD', 'Ordering': 'METIS'},
           {'Solver': 'LLT'}, {'Solver': 'LDLT'}, {'Solver': 'CG'})
# As good a mesh as TetGen makes, then smaller and smaller tetrahedra.
REFINEMENTS = [{'RadiusEdgeRatio': 1.414}, {'RadiusEdgeRatio': 1.2}] + [
    {'RadiusEdgeRatio': ratio, 'Refine': refine}
    for refine in (1, 2, 4, 8, 16, 32, 64) for ratio in (2, 1.414)]
REFERENCE = {'3k', '10k'}
INSIDE_B = {'3k': 8e-4, '10k': 1.5e-4, '38k': 1.2e-4, '100k': 1e-4}
AGAINST_ELEMENTS = {'10k': (20, 3.0), '38k': (30, 1.5), '100k': (10, 0.8)}
FACTS = {'charges', 'offset', 'rmseinside', 'nodes', 'tetrahedra', 'mesh', 'factor'}


def words(settings):
    return ' '.join('%s=%s' % setting for setting in settings.items())


class Bench:
    def __init__(self, options):
        self.options = options
        self.program, self.claims = sweep.Program(options), sweep.Claims()
        self.models = options.folder or os.path.join(options.build, 'models')
        self.cache = os.path.join(options.build, 'benchmarks')
        os.makedirs(self.cache, exist_ok=True)
        self.table = sweep.Table('size:<6', 'points:7d', 'data:<4', 'name:<42', 'cpu:9.2f', 'wall:9.2f',
                                 'mib:8.0f', 'vertices:10.2e', 'inside:10.2e', 'interior:10.2e')

    def once(self, size, data, method, settings, seconds=None):
        """The row of one measurement, or None if it fails or takes longer than it may."""
        if data == 'B' and size in REFERENCE:
            settings = dict(settings, Reference=os.path.join(self.cache, SIZES[size] + '.reference'))
        found = self.program.run(
            'volume_map', os.path.join(self.models, SIZES[size]), data, method, seconds=seconds,
            threads=self.options.threads, Cache=self.cache, **settings)
        if found.error:
            if found.code is not None:
                print('    %s %s %s %s: %s' % (size, data, method, words(settings),
                                               found.error[:160]), flush=True)
            return None
        return found.row()

    def row(self, name, size, data, method, settings={}, runs=None):
        """Prints and returns the medians of several measurements."""
        median, = sweep.medians(runs or self.options.runs,
                                lambda: self.once(size, data, method, settings))
        if median:
            self.table.print(dict(median, size=size, name=name), ','.join(
                '%s:%g' % (key, median[key]) for key in median if key in FACTS))
        return median

    def elements(self, size, accelerated):
        """Finite elements for data A: at TetGen's default and refined, by the best solver; and the
        best of them that takes no longer than `accelerated`. The solvers are tried on the finest
        mesh that one of them solves in ten times as long."""
        limit = accelerated['cpu'] if accelerated else 10.0
        for refine in ({'Refine': 4}, {'Refine': 1}, {}):
            trials = [(self.once(size, 'A', 'FEM', {**refine, **solver}, 10.0 * limit + 5.0), solver)
                      for solver in SOLVERS]
            trials = [(trial['cpu'], index) for index, (trial, _) in enumerate(trials) if trial]
            if trials:
                break
        solver = SOLVERS[min(trials)[1]]
        name = 'FEM %s ' % '+'.join(solver.values())
        default = self.row(name + 'default', size, 'A', 'FEM', solver)
        best = (default['interior'], default, {})
        for settings in REFINEMENTS:
            refined = self.row(name + words(settings), size, 'A', 'FEM', {**solver, **settings}, 1)
            if not refined or refined['cpu'] > 4.0 * limit:
                break
            if refined['cpu'] <= limit and refined['interior'] < best[0]:
                best = (refined['interior'], refined, settings)
        equal = self.row(name + 'best for equal time', size, 'A', 'FEM', {**solver, **best[2]})
        if accelerated:
            print('    against the best finite elements of no more CPU time (%s): error %.3g times, '
                  'time %.2f times' % (words(best[2]) or 'default', accelerated['interior'] / equal[
                      'interior'], accelerated['cpu'] / equal['cpu']), flush=True)
        return default, solver

    def single_shot(self, size, data):
        """SingleShot at its default and at its best offset."""
        self.row('SingleShot default', size, data, 'SingleShot', runs=1)
        trials = [(self.once(size, data, 'SingleShot', {'OffsetDistance': offset}), offset)
                  for offset in OFFSETS]
        trials = [(trial['inside'], offset) for trial, offset in trials if trial]
        if not trials:
            return None
        return self.row('SingleShot OffsetDistance=%g (best)' % min(trials)[1], size, data,
                        'SingleShot', {'OffsetDistance': min(trials)[1]})

    def size(self, size):
        skip, at_most = self.options.skip, self.claims.at_most
        ours = {data: self.row('Accelerated', size, data, 'Accelerated') for data in 'AB'}
        if 'MultiLevel' not in skip and size in ('3k', '10k', '38k'):
            for data in 'AB':
                self.row('MultiLevel', size, data, 'MultiLevel',
                         runs=self.options.runs if size != '38k' else 1)
        if 'FEM' not in skip:
            default, solver = self.elements(size, ours['A'])
            self.row('FEM default', size, 'B', 'FEM', solver)
            if ours['A'] and size in AGAINST_ELEMENTS:
                times, longer = AGAINST_ELEMENTS[size]
                at_most(size + ' A', 'interior error / that of default FEM',
                        ours['A']['interior'] / default['interior'], 1.0 / times)
                at_most(size + ' A', 'CPU / that of default FEM',
                        ours['A']['cpu'] / default['cpu'], longer)
        if 'SingleShot' not in skip and size in ('3k', '10k'):
            for data in 'AB':
                single = self.single_shot(size, data)
                if single and ours[data] and size == '10k' and data == 'B':
                    at_most('10k B', 'CPU / that of SingleShot at its best offset',
                            ours['B']['cpu'] / single['cpu'], 1.0 / 25.0)
                    at_most('10k B', 'RMSE inside triangles / that of SingleShot',
                            ours['B']['inside'] / single['inside'], 1.0 / 2.5)
        if ours['B']:
            at_most(size + ' B', 'RMSE inside triangles', ours['B']['inside'], INSIDE_B[size])
        if size == '100k':
            for data in 'AB':
                if ours[data]:
                    at_most('100k ' + data, 'CPU seconds', ours[data]['cpu'], 30.0)
                    at_most('100k ' + data, 'peak MiB', ours[data]['mib'], 512.0)
        return ours

    def growth(self, large, small, name):
        """The factor per tenfold of the points."""
        for data in 'AB':
            if large.get(data) and small.get(data):
                decades = math.log10(large[data]['points'] / small[data]['points'])
                self.claims.at_most('%s %s' % (name, data), 'growth of CPU for 10 times the points', (
                    large[data]['cpu'] / small[data]['cpu'])**(1.0 / decades), 13.0)


def main():
    parser = sweep.parser(__doc__, models=False)
    parser.add_argument('--folder', help="of OFF files; the build's models by default")
    parser.add_argument('--runs', type=int, default=5)
    parser.add_argument('--threads', type=int, default=0,
                        help='of the volume map; finite elements use one. Default: every core')
    parser.add_argument('--sizes', nargs='+', default=list(SIZES), choices=list(SIZES))
    parser.add_argument('--skip', nargs='+', default=[],
                        choices=['SingleShot', 'MultiLevel', 'FEM'])
    bench = Bench(parser.parse_args())
    sizes = bench.options.sizes
    ours = {size: bench.size(size) for size in sizes if size != 'growth'}
    if 'growth' in sizes:
        ours['growth'] = {data: bench.row('Accelerated', 'growth', data, 'Accelerated')
                          for data in 'AB'}
    for large, name in (('100k', 'other shapes'), ('growth', 'one shape')):
        if large in ours and '10k' in ours:
            bench.growth(ours[large], ours['10k'], name)
    bench.claims.finish()


if __name__ == '__main__':
    main()
