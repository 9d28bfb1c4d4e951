"""The command shapemap, without ParaView: TestCommand.py ROOT"""
import csv
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter

import shapemap
import shapemap.files
import shapetesting
from shapemap.commands import COMMANDS
from shapemap.filters import FILTERS, VERSION
from shapemap.properties import option

root = os.path.abspath(sys.argv[1])
folder = tempfile.TemporaryDirectory()
os.chdir(folder.name)


def shapemap_command(*arguments, **more):
    """What the command says, and its exit code."""
    done = subprocess.run([sys.executable, '-m', 'shapemap', *arguments], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, **more)
    assert 'Traceback' not in done.stdout, done.stdout
    return done.stdout, done.returncode


def rows(output):
    """The table without what differs from run to run."""
    with open(output + '/shapemap.csv', newline='') as file:
        return [{key: value for key, value in row.items() if key not in ('seconds', 'peak memory (MiB)')}
                for row in csv.DictReader(file)]


def times(output):
    return {path: os.stat(path).st_mtime_ns for place, _, held in os.walk(output)
            for path in (os.path.join(place, each) for each in held)}


def content(path):
    with open(path, 'rb') as file:
        return file.read()


# Wrong usage is 2, and names the choices.
os.mkdir('surfaces')
shutil.copy(os.path.join(root, 'Data', 'BentBarSmall.vtp'), 'surfaces')
for arguments, words in ((['hex', 'surfaces', 'out', '--method', 'Gird'], ("'Automatic', 'Polycube', 'Grid'",)),
                         (['hex', 'surfaces', 'out', '--cell-size', '-1'], ('--cell-size', 'at least 0')),
                         (['hex', 'surfaces', 'out', '--format', 'doc'], ("'vtu'", "'inp'")),
                         (['hexe'], tuple(COMMANDS)), (['hex', 'nowhere', 'out'], ('nowhere', 'vtp')),
                         (['map', 'surfaces', 'out'], ('--template is needed',)),
                         (['solidify', 'surfaces', 'surfaces'], ('OUT',))):
    said, code = shapemap_command(*arguments)
    assert code == 2 and all(each in said for each in words), (arguments, code, said)
assert os.listdir('.') == ['surfaces'], os.listdir('.')
assert shapemap_command('--version') == ('shapemap %s\n' % VERSION, 0)

# Every property is an option, with the range and the default of its filter.
for name, command in COMMANDS.items():
    said, code = shapemap_command(name, '--help')
    assert code == 0 and 'Example: shapemap ' + command.example in said and 'Exit codes' in said, said
    for each in FILTERS[command.function].properties:
        assert option(each.name) in said, (name, each.name)

# A folder with spheres of radius 0.001, a damaged and an empty file, and a sphere that is too large for the size of
# its tetrahedra.
os.mkdir('in')
points, triangles = (get(shapetesting.read('DentedSphere600.vtp')) for get in (shapemap.points, shapemap.cells))
for k, scale in enumerate((1.0, 1.1, 1.2)):
    shapetesting.write(shapemap.mesh(0.001 * points * [1.0, scale, scale ** 2], triangles), 'in/small%d.vtp' % k)
shapetesting.write(shapemap.mesh(points, triangles), 'in/large.vtp')
with open('in/damaged.vtp', 'wb') as file:
    file.write(content('in/small0.vtp')[:5000])
open('in/empty.stl', 'w').close()
given = ['tetrahedralize', 'in', 'serial', '--maximum-volume', '1e-7', '--timeout', '6', '--jobs', '1']
said, code = shapemap_command(*given)
made = rows('serial')
assert code == 1, said
assert [(row['name'], row['status']) for row in made[:3]] == [
    ('damaged', 'failed'), ('empty', 'failed'), ('large', 'timed out')], made
assert all(row['message'] for row in made[:3]) and not any(row['message'] for row in made[3:])
worst = [float(row['MinimumScaledJacobian']) for row in made[3:]]
assert len(worst) == 3 and worst == sorted(worst) and worst[0] < worst[2], worst
for row in made[3:]:
    grid = shapemap.files.read('serial/%s.vtu' % row['name'])
    assert grid.GetNumberOfCells() == float(row['Tetrahedra'])
assert not os.path.exists('serial/large.vtu')
assert not [path for path in times('serial') if 'writing' in path]
picture = shapetesting.read_picture('serial/.shapemap/small0.png')
assert picture.GetScalarRange()[0] < 200 < picture.GetScalarRange()[1]
sheet = shapetesting.read_picture('serial/shapemap.png').GetDimensions()
assert sheet[0] == 6 * picture.GetDimensions()[0], sheet
page = content('serial/shapemap.html').decode()
assert page.count('data:image/png') == 3 and [page.index('<b>%s<' % row['name']) for row in made] == sorted(
    page.index('<b>%s<' % row['name']) for row in made)

# In parallel, the same bits.
said, code = shapemap_command(*given[:2], 'parallel', *given[3:-1], '3')
assert code == 1 and rows('parallel') == made, said
for k in range(3):
    assert content('serial/small%d.vtu' % k) == content('parallel/small%d.vtu' % k)

# Again: nothing is done. Then what changed is, and only that.
before = times('serial')
said, code = shapemap_command(*given)
assert code == 1 and times('serial') == before and '6 subjects, 6 up to date' in said, said
shutil.copy('in/small1.vtp', 'in/small2.vtp')
said, code = shapemap_command(*given, '--dry-run')
assert code == 0 and re.findall('would do (.*)', said) == ['small2'] and times('serial') == before, said
shapemap_command(*given)
after = times('serial')
changed = {path for path in after if before.get(path) != after[path] and path.endswith('.vtu')}
assert changed == {'serial/small2.vtu'} and content('serial/small2.vtu') == content('serial/small1.vtu'), changed
os.remove('serial/small0.vtu')
assert re.findall('would do (.*)', shapemap_command(*given, '--dry-run')[0]) == ['small0']
assert re.findall('would do (.*)', shapemap_command(*given, '--dry-run', '--redo', 'failed')[0]) == [
    'damaged', 'empty', 'large', 'small0']

# The runner is killed while it works: its process ends with it, and the next run completes the table.
os.remove('in/large.vtp')
shapemap_command(*given[:2], 'once', *given[3:])
runner = subprocess.Popen([sys.executable, '-m', 'shapemap', *given[:2], 'killed', *given[3:], '--no-pictures'])
while not os.path.exists('killed/.shapemap/small0.json'):
    assert runner.poll() is None
    time.sleep(0.005)
runner.send_signal(signal.SIGKILL)
runner.wait()
assert not os.path.exists('killed/shapemap.csv')
said, code = shapemap_command(*given[:2], 'killed', *given[3:])
assert code == 1 and rows('killed') == rows('once') and ' 0 up to date' not in said, said
assert not [each for each in os.listdir('killed') if each.startswith('.writing')]

# Ctrl+C ends it, and the rest is done next time.
shapetesting.write(shapemap.mesh(points, triangles), 'in/large.vtp')
runner = subprocess.Popen([sys.executable, '-m', 'shapemap', *given[:2], 'stopped', *given[3:5], '--jobs', '1'])
while not os.path.exists('stopped/.shapemap/large.txt'):
    assert runner.poll() is None
    time.sleep(0.02)
time.sleep(0.5)
runner.send_signal(signal.SIGINT)
assert runner.wait() == 130
assert {row['name']: row['status'] for row in rows('stopped')}['large'] == 'not done'
os.remove('in/large.vtp')
shapemap_command(*given[:2], 'stopped', *given[3:])
assert rows('stopped') == rows('once')

# Another command does not mix with these results; without a display and Xvfb, there are no pictures, and it says so.
said, code = shapemap_command('solidify', 'in', 'once')
assert code == 2 and 'tetrahedralize' in said, said
bare = {key: value for key, value in os.environ.items() if key != 'DISPLAY'}
said, code = shapemap_command('solidify', 'in/small0.vtp', 'bare', env=dict(bare, PATH='/nowhere'))
assert code == 0 and 'no pictures: there is no X display' in said and not os.path.exists('bare/shapemap.png'), said
assert 'there is no X display' in content('bare/shapemap.html').decode()

# The examples of the help, in their order, and pairs from a table.
for name in ('FigureASmall', 'FigureBSmall'):
    shutil.copy(os.path.join(root, 'Data', name + '.vtp'), 'surfaces')
shutil.copy('surfaces/FigureASmall.vtp', 'template.vtp')
os.remove('surfaces/BentBarSmall.vtp')
figure = shapemap.files.read('surfaces/FigureBSmall.vtp')
shapetesting.write(shapemap.mesh(shapemap.points(figure) * [1.0, 1.0, 1.1], shapemap.cells(figure)), 'surfaces/Tall.vtp')
os.mkdir('segmentations')
# A ball in two halves, whose first index goes to the patient's right; its name has two endings.
i, j, k = numpy.indices((9, 9, 9))
labels = (((i - 4.0) ** 2 + (j - 4.0) ** 2 + (k - 4.0) ** 2 < 12.0) * numpy.where(i < 4.0, 1, 2)).astype(numpy.uint8)
with open('segmentations/ball.seg.nrrd', 'wb') as file:
    file.write(b'NRRD0004\ntype: unsigned char\ndimension: 3\nspace: left-posterior-superior\nsizes: 9 9 9\n'
               b'space directions: (-2,0,0) (0,2,0) (0,0,2)\nkinds: domain domain domain\nencoding: raw\n'
               b'space origin: (10,0,0)\n\n' + labels.tobytes(order='F'))
image = vtkImageData()
image.SetDimensions(9, 9, 9)
image.GetPointData().SetScalars(numpy_to_vtk(labels.ravel(order='F')))
writer = vtkXMLImageDataWriter()
writer.SetFileName('segmentations/other.vti')
writer.SetInputData(image)
writer.Write()
for name, command in COMMANDS.items():
    said, code = shapemap_command(*command.example.split())
    given, output = command.example.split()[1:3]
    count = 1 if command.together else 2 if given == 'segmentations' else 3
    assert code == 0 and len(rows(output)) == count and os.path.exists(output + '/shapemap.png'), said
    assert command.measure in rows(output)[0] or command.together, command.measure
assert [float(row['Shapes']) for row in rows('compared')] == [float(row['Shapes']) for row in rows('average')] == [3.0]
for made in ('compared/shapes', 'average/aligned'):
    assert sorted(os.listdir(made)) == ['FigureASmall.vtp', 'FigureBSmall.vtp', 'Tall.vtp'], os.listdir(made)
ball = shapemap.files.read('regions/ball.vtp')
assert abs(numpy.array(ball.GetBounds()).reshape(3, 2).mean(axis=1) - [2.0, 8.0, 8.0]).max() < 0.5, ball.GetBounds()
left, right = (shapemap.points(ball)[shapemap.cells(ball)[shapemap.cell_array(ball, 'Regions')[:, 0] == label]]
               for label in (1, 2))
assert left[..., 0].mean() > 2.0 > right[..., 0].mean()
said, code = shapemap_command('hex', 'segmentations/other.vti', 'boxes', '--no-pictures')
assert code == 1 and 'shapemap surfaces' in said, said
with open('pairs.csv', 'w') as file:
    file.write('subject,template\nsurfaces/FigureBSmall.vtp,template.vtp\nsurfaces/FigureBSmall.vtp,surfaces/FigureBSmall.vtp\n')
said, code = shapemap_command('map', 'pairs.csv', 'pairs')
found = {row['name']: row for row in rows('pairs')}
assert code == 0 and sorted(found) == ['FigureBSmall-FigureBSmall', 'FigureBSmall-template'], said
alone = {row['name']: row for row in rows('maps')}['FigureBSmall']
assert {**alone, 'name': ''} == {**found['FigureBSmall-template'], 'name': ''}
mapped = shapemap.files.read('pairs/FigureBSmall-FigureBSmall.vtp')
error = numpy.linalg.norm(shapemap.point_array(mapped, 'TargetPosition') - shapemap.points(mapped), axis=1)
assert numpy.median(error) < 0.02 * numpy.ptp(shapemap.points(mapped), axis=0).max(), numpy.median(error)
print('%d commands; damaged, empty and late subjects do not stop the others' % len(COMMANDS))
