"""Features of real models set down on others, drawn with a fixed seed: every result must be a manifold,
watertight where both were, with the Euler number that gluing gives, in its old position when dropped
there, and meet the target smoothly; and features of 10,000 triangles dragged over a target of 75,000.

    /usr/bin/python3 Testing/Benchmarks/PasteFeatures.py [--count 20]
"""
import random

import sweep

sweep.use_one_thread()  # before numpy is loaded

import numpy  # noqa: E402

MODELS = ['armadillo', 'bear', 'bull', 'bunny00', 'camel', 'cow', 'elephant', 'femur', 'hand',
          'homer', 'lion-head', 'man', 'mannequin-devil', 'pig', 'triceratops']


def is_right(row):
    """Whether a result is a manifold, as open as the target, with the Euler number of gluing."""
    return (row['nonmanifold'] == 0 and row['openbefore'] == row['openafter'] and
            row['result'] == row['target'] - 1 + row['euler'])


def drop(program, count):
    """Rows of features set down, how many were refused, and what is wrong."""
    table = sweep.Table('on:<28', 'triangles:9d', 'inplace:9.2g', 'conformal:9d', 'layout:6d', *(
        key + ':8.1f' for key in ('before', 'before95', 'after', 'after95')))
    draw = random.Random(2010)
    rows, refused, wrong = [], 0, []
    for index in range(count):
        feature, target = draw.sample(MODELS, 2)
        found = program.run('paste_feature', program.model(feature), program.model(target),
                            draw.randrange(1000), seconds=600)
        name = '%d %s on %s' % (index, feature, target)
        if found.error:
            wrong.append(name + ': ' + found.error)
            table.print({'on': name}, found.error)
            continue
        row = found.row()
        shown = dict(row, on=name, before=None, after=None)
        if 'refused' in row:
            refused += 1
            table.print(shown, 'refused: ' + row['refused'])
            continue
        for key in ('before', 'after'):
            shown[key], shown[key + '95'] = numpy.percentile(row[key], [50, 95])
        if not is_right(row):
            wrong.append(name)
        rows.append(row)
        table.print(shown, '' if is_right(row) else 'WRONG')
    return rows, refused, wrong


def main():
    parser = sweep.parser(__doc__, models=False)
    parser.add_argument('--count', type=int, default=20)
    options = parser.parse_args()
    program, claims = sweep.Program(options), sweep.Claims()
    rows, refused, wrong = drop(program, options.count)
    seconds = []
    table = sweep.Table('feature:7d', 'target:7d', 'updates:7d', 'refused:7d', 'cpu:8.4f', 'wall:8.4f')
    for feature in ('refined_elephant', 'armadillo'):
        row = program.run('drag_feature', program.model(feature), program.model('bunny00'), 10000, 300,
                          seconds=600).row()
        table.print(row, feature)
        seconds.append(row['cpu'])
    before, after = (numpy.concatenate([row[key] for row in rows]) for key in ('before', 'after'))
    claims.at_most('%d features' % options.count, 'refused', refused, 0.15 * options.count)
    claims.none('%d features' % options.count, 'wrong results', wrong)
    claims.at_most('in place', 'farthest off, over the diagonal', max(
        row['inplace'] for row in rows), 1e-6)
    for name, share, most in (('median', 50, 3.0), ('95th percentile', 95, 10.0)):
        first, last = numpy.percentile(before, share), numpy.percentile(after, share)
        claims.at_most('angles at the joins', name + ', degrees', last, most)
        claims.at_most('angles at the joins', name + ', of that before', last / first, 1.0 / 3.0)
    claims.at_least('while dragging', 'updates a second', 1.0 / max(seconds), 15.0)
    claims.finish()


if __name__ == '__main__':
    main()
