"""The accelerated volume map from 10,000 to 1,000,000 boundary points: the CPU seconds of each stage, peak
memory, errors, the evaluation of ten times as many points inside, and the same map shared by four
processes. The data are those of VolumeMap.py: a known harmonic field (A), or the sphere map (B).

    xvfb-run -a -s "-screen 0 1600x1000x24 -noreset" Utilities/pvpython.sh \\
        Testing/Benchmarks/MillionPoints.py FOLDER [--data A] [--most 1000000] [--rows FILE]

It draws MillionPointsSeconds.png and MillionPointsMemory.png over the number of points. The surfaces are
models of libcgal-demo, made finer by sqrt(3)-subdivision. One thread; the processes take their turns on
the cores that there are. It takes 6 CPU minutes and 6 GiB. --rows keeps the figures, or draws those kept.
"""
import json
import os

import sweep

import charts

SIZES = ('bear_bis.off', 'bear_bis.off@1', 'bunny00.off@1', 'bunny00.off@2', 'bunny00.off@3')
POINTS = (10096, 30284, 113114, 339338, 1018010)
STAGES = (('placing', 'placing the charges'), ('inverting', 'inverting the blocks'),
          ('solving', 'solving'), ('measuring', 'measuring the error'))
PROCESSES = 4
EVALUATIONS = 10  # for each boundary point


def draw(folder, rows):
    for name, title, left, series in (
            ('Seconds', 'Solution, and evaluation of 10 points for each boundary point', 'CPU seconds',
             (('cpu', 'solution'), *STAGES, ('evaluate', 'evaluation'))),
            ('Memory', 'Memory of the solution', 'MiB',
             (('mib', 'one process'), ('processmib', 'each of four processes')))):
        columns = {key: [row[key] for row in rows] for key in ('points', *(key for key, _ in series))}
        charts.lines(os.path.join(folder, 'MillionPoints%s.png' % name), title, columns,
                     [charts.Series(*one) for one in series], 'boundary points', left)


def measure(options, program):
    """The rows of all sizes."""
    models = os.path.join(options.build, 'models')
    cache = os.path.join(options.build, 'benchmarks')
    os.makedirs(cache, exist_ok=True)
    table = sweep.Table('points:8d', 'cpu:8.2f', 'mib:7.0f', *(key + ':9.2f' for key, _ in STAGES),
                        'iterations:10.0f', 'vertices:9.1e', 'inside:9.1e', 'evaluate:8.2f',
                        'evaluatemib:11.0f', 'processcpu:10.2f', 'processmib:10.0f', 'imagesdiffer:12.1e')
    rows = []
    for model, points in zip(SIZES, POINTS):
        if points > 1.1 * options.most:
            continue
        images = os.path.join(cache, model + '.images')
        if os.path.exists(images):
            os.remove(images)
        words = ('volume_map', os.path.join(models, model), options.data, 'Accelerated')
        settings = {'Cache': cache, 'Images': images}
        row = program.run(*words, **settings, Evaluations=EVALUATIONS * points, threads=1).row()
        shared = program.run(*words, **settings, Processes=PROCESSES, threads=1).row()
        row.update({key: shared[key] for key in ('processcpu', 'processmib', 'imagesdiffer')})
        os.remove(images)
        table.print(row)
        rows.append(row)
    return rows


def main():
    parser = sweep.parser(__doc__, models=False)
    parser.add_argument('results', metavar='FOLDER', help='of the picture')
    parser.add_argument('--data', default='A', choices='AB')
    parser.add_argument('--most', type=int, default=1000000, help='boundary points')
    parser.add_argument('--rows', help='a JSON file of the figures')
    options = parser.parse_args()
    if options.rows and os.path.exists(options.rows):
        with open(options.rows) as kept:
            rows = json.load(kept)
    else:
        rows = measure(options, sweep.Program(options))
        if options.rows:
            with open(options.rows, 'w') as kept:
                json.dump(rows, kept)
    os.makedirs(options.results, exist_ok=True)
    draw(options.results, rows)
    claims = sweep.Claims()
    by_points = {row['points']: row for row in rows}
    million, tenth = by_points.get(POINTS[4]), by_points.get(POINTS[2])
    if million:
        claims.at_most('1M', 'CPU seconds of the solution', million['cpu'], 60.0)
        claims.at_most('1M', 'MiB of the solution', million['mib'], 4096.0)
        claims.at_most('1M', 'RMSE inside triangles / that at 100k', million['inside'] / tenth['inside'], 1.0)
        claims.at_most('10M evaluations', 'CPU seconds', million['evaluate'], 60.0)
        claims.at_most('1M over 4 processes', 'memory of each / that of one',
                       million['processmib'] / million['mib'], 0.4)
    for row in rows:
        claims.at_most('%d over 4 processes' % row['points'], 'difference / size', row['imagesdiffer'], 1e-9)
    claims.finish()


if __name__ == '__main__':
    main()
