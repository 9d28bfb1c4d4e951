"""The functions of the Python package, without ParaView: TestFunctions.py ROOT [mypy]"""
import glob
import inspect
import os
import re
import signal
import subprocess
import sys
import tempfile
import threading
import warnings
from xml.etree import ElementTree

import numpy

import shapemap
from shapemap import functions, run
import shapetesting

root = sys.argv[1]
assert 'paraview' not in sys.modules

# Every filter has its function, whose defaults are those of a fresh C++ object.
filters = sorted(proxy.get('class')[len('vtkShape'):]
                 for path in glob.glob(os.path.join(root, 'Filters', 'VTK', '*', '*.xml'))
                 for proxy in ElementTree.parse(path).findall('ProxyGroup[@name="filters"]/SourceProxy'))
by_class = {re.search(r'vtkShapeFilters\.vtkShape(\w+)\(\)', inspect.getsource(each)).group(1): each
            for _, each in inspect.getmembers(functions, inspect.isfunction) if each.__module__ == functions.__name__}
assert filters == sorted(by_class), (filters, sorted(by_class))
compared = 0
for name, function in by_class.items():
    algorithm = getattr(shapemap, 'vtkShape' + name)()
    source = inspect.getsource(function)
    for key, parameter in inspect.signature(function).parameters.items():
        assert re.search(r'^    %s : .+\n        \S' % key, function.__doc__, re.MULTILINE), (name, key)
        getter = 'Get' + ''.join(word.capitalize() for word in key.split('_'))
        if parameter.default in (inspect.Parameter.empty, None, ()) or not hasattr(algorithm, getter):
            continue
        value = getattr(algorithm, getter)()
        if 'Literal' in parameter.annotation:
            words = eval(re.search(r"run\.choose\('\w+', %s, (\{.*?\})" % key, source).group(1))
            value = next(word for word, number in words.items() if number == value)
        assert value == parameter.default, (name, key, value, parameter.default)
        compared += 1
assert compared > 60, compared
print('%d functions; %d defaults are those of C++' % (len(by_class), compared))

# Arrays and VTK data give the same bits, in one call each, and stay as they are.
ball = shapetesting.read('DentedSphere600.vtp')
points, triangles = shapemap.points(ball), shapemap.cells(ball)
assert points.shape == (642, 3) and triangles.shape == (1280, 3)
kept = points.copy(), triangles.copy()
progress = []
from_arrays = shapemap.hex_remesh(points, triangles, method='Grid', cells_on_longest_side=6, progress=progress.append)
from_data = shapemap.hex_remesh(ball, method='Grid', cells_on_longest_side=6)
hexahedra = shapemap.cells(from_arrays.hexahedra)
assert (hexahedra == shapemap.cells(from_data.hexahedra)).all()
assert (shapemap.points(from_arrays.hexahedra) == shapemap.points(from_data.hexahedra)).all()
assert (points == kept[0]).all() and (triangles == kept[1]).all()
assert hexahedra.shape[1] == 8 and shapemap.cells(from_arrays.boundary).shape[1] == 4
quality = shapemap.cell_array(from_arrays.hexahedra, 'ScaledJacobian')
assert len(quality) == len(hexahedra) and quality.min() > 0.0
assert from_arrays.facts['Method'] == 'Grid', from_arrays.facts
assert abs(from_arrays.facts['MinimumScaledJacobian'] - quality.min()) < 1e-12
assert progress[-1] == 1.0 and progress == sorted(progress)

# A box bounded by arrays, mapped by an affine map, which the volume map reproduces.
box = shapetesting.read('BentBarSmall.vtp')
matrix, shift = numpy.array([[1.1, 0.2, 0.0], [0.0, 0.9, 0.1], [0.3, 0.0, 1.2]]), [0.5, -1.0, 2.0]
bounds = shapemap.points(box)
inside = 0.5 * (bounds + bounds.mean(axis=0))[:3] * [0.0, 0.0, 0.1] + [1.5, -0.1, 0.0]
moved = shapemap.harmonic_volume_map(
    inside, (bounds, shapemap.cells(box), {'TargetPosition': bounds @ matrix.T + shift}), method='SingleShot')
assert numpy.abs(shapemap.points(moved.moved) - (inside @ matrix.T + shift)).max() < 1e-9
assert shapemap.cell_array and len(shapemap.column(moved.levels, 'Level')) == moved.levels.GetNumberOfRows() > 0

# Tetrahedra as arrays; a polyline as a loop; time.
tetrahedra = shapemap.tetrahedralize(points, triangles).tetrahedra
again = shapemap.untangle(shapemap.points(tetrahedra), shapemap.cells(tetrahedra)).untangled
assert (shapemap.cells(again) == shapemap.cells(tetrahedra)).all()
circle = numpy.array([[0.4 * numpy.cos(t), 0.4 * numpy.sin(t), 0.95] for t in 0.3 * numpy.arange(20)])
cut = shapemap.cut_feature(ball, loop=shapemap.curves(circle, [[*range(20), 0]]))
assert 0 < cut.feature.GetNumberOfPoints() < cut.rest.GetNumberOfPoints()
drawn = shapemap.cut_feature(ball, loop_points=circle[::5])
assert 0 < drawn.feature.GetNumberOfPoints() < drawn.rest.GetNumberOfPoints()
target = shapemap.point_array(ball, 'TargetPosition')
half = shapemap.points(shapemap.morph(ball, time=0.5).moved)
assert numpy.abs(half - 0.5 * (points + target)).max() < 1e-12


# What cannot be used is refused in the filter's own words; what the function itself sees, before.
def refused(kind, words, function, *arguments, **options):
    try:
        function(*arguments, **options)
    except kind as error:
        text = str(error)
        assert all(word in text for word in words) and '\n' not in text and '0x' not in text, text
        return
    raise AssertionError('not refused: %s' % (words,))


refused(shapemap.ShapeError, ['Shape Hex Remesh: ', 'open loop'], shapemap.hex_remesh, points, triangles[1:])
refused(shapemap.ShapeError, ['Shape Morph: '], shapemap.morph, points, triangles)
refused(ValueError, ['method', 'Gird', 'Automatic, Polycube, Grid'], shapemap.hex_remesh, ball, method='Gird')
refused(ValueError, ['642', '0 to 641'], shapemap.hex_remesh, points, triangles + 1)
refused(ValueError, ['n x 3'], shapemap.hex_remesh, points[:, :2], triangles)
refused(TypeError, ['surface', 'str'], shapemap.hex_remesh, 'bunny.stl')
refused(KeyError, ['Label', 'TargetPosition'], shapemap.point_array, ball, 'Label')

# Warnings are Python's.
warned = run.Run(shapemap.vtkShapeMorph())
warned.connect('SetInputConnection', 0, ball, 'input', True)
with warnings.catch_warnings(record=True) as caught:
    warnings.simplefilter('always')
    warned.outputs([0], lambda done: warned.algorithm.InvokeEvent(
        'WarningEvent', 'Warning: In x.cxx, line 1\nvtkShapeMorph (0x1234): Shape Morph: beware\n'))
assert caught and caught[0].category is shapemap.ShapeWarning
assert str(caught[0].message) == 'Shape Morph: beware', caught[0].message


# What the callback raises, and Ctrl+C, stop the filter before its end.
class Enough(Exception):
    pass


def stop(done):
    reports.append(done)
    raise Enough


large = shapetesting.read('DentedSphere10k.vtp')
reports = []
try:
    shapemap.hex_remesh(large, progress=stop)
    raise AssertionError('it was not stopped')
except Enough:
    assert len(reports) == 1 and reports[0] < 1.0, reports
reports = []
threading.Timer(1.0, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
try:
    shapemap.hex_remesh(large, progress=reports.append)
    raise AssertionError('it was not interrupted')
except KeyboardInterrupt:
    assert reports and reports[-1] < 1.0, reports
assert signal.getsignal(signal.SIGINT) is signal.default_int_handler

# The example of its page runs as it stands.
page = open(os.path.join(root, 'Documentation', 'Python.md')).read()
exec(re.search(r'```python\n(.*?)```', page, re.DOTALL).group(1), {})

# The types: the package itself, and a script that uses it well and one that does not.
if len(sys.argv) > 2:
    with tempfile.TemporaryDirectory() as folder:
        def mypy(*arguments):
            done = subprocess.run(
                [sys.argv[2], '--strict', '--cache-dir', folder, '--python-version', '3.11', '--config-file', config,
                 *arguments], stdout=subprocess.PIPE, text=True, cwd=folder,
                env=dict(os.environ, MYPYPATH=os.path.dirname(os.path.dirname(shapemap.__file__))))
            return done.returncode, done.stdout

        config = os.path.join(folder, 'mypy.ini')
        with open(config, 'w') as file:
            file.write('[mypy]\nexclude = views.py\n[mypy-vtkmodules.*,paraview.*]\nignore_missing_imports = True\n')
        script = os.path.join(folder, 'script.py')
        with open(script, 'w') as file:
            file.write('import shapemap\n'
                       'made = shapemap.hex_remesh([[0.0, 0.0, 0.0]], [[0, 0, 0]], method="Grid")\n'
                       'print(shapemap.points(made.hexahedra).shape, made.facts["Method"])\n')
        for checked in ([script], ['-p', 'shapemap']):
            status, printed = mypy(*checked)
            assert status == 0, printed
        with open(script, 'w') as file:
            file.write('import shapemap\n'
                       'made = shapemap.hex_remesh([[0.0, 0.0, 0.0]], method="Gird", cellsize=1)\n'
                       'print(made.tetrahedra)\n')
        status, printed = mypy(script)
        assert status == 1 and len(re.findall('error:', printed)) == 3, printed
        print('mypy --strict finds no fault in the package, and three in a script that has three')
