"""Decks of CalculiX moved by a volume map: what changes, what CalculiX makes of it, and how long it takes.

A deck of 50,000 nodes (two tied blocks with sets, surfaces, an orientation and included files) is bent by a
charge set, checked by Shape Untangle and written again. Only the coordinates may differ, and ccx must run on
both decks. A deck stretched by half must lengthen half as much more under the same stress. Then decks of
growing size are read and written: time and memory must grow like the file. mawk, which does the same line by
line without knowing what a deck is, is the peer. --cells N: cells of the largest deck."""
import argparse
import os
import resource
import subprocess
import sys
import tempfile

import numpy
import shapemap
from paraview import simple

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), '..'))
import decks
import shapetesting
from shapetesting import points

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument('--cells', type=int, default=1000000)
cells = parser.parse_args().cells
folder = tempfile.mkdtemp()
claims = []


def claim(what, value, bound, holds=None):
    holds = value <= bound if holds is None else holds
    claims.append((what, holds))
    print('%-64s %10.4g   bound %8.4g   %s' % (what, value, bound, 'holds' if holds else 'FAILS'), flush=True)


def blocks(count):
    """Cells along the axes of two cubes of about count cells together."""
    return (max(2, round((count / 2.0) ** (1.0 / 3.0))),) * 3


def content(*names):
    with open(os.path.join(folder, *names), 'rb') as file:
        return file.read()


def move(original, name, function):
    deck = simple.ShapeDeckReader(FileNames=[original])
    around = simple.Sphere(Center=[0.5, 0.5, 1.0], Radius=2.0, ThetaResolution=32, PhiResolution=32)
    boundary = simple.Calculator(Input=simple.Clean(Input=around), Function=function,
                                 ResultArrayName='TargetPosition')
    made = simple.ShapeHarmonicVolumeMap(Domain=deck, Boundary=boundary)
    moved = simple.ShapeApplyVolumeMap(Input=deck, Map=simple.OutputPort(made, 1))
    mended = simple.ShapeUntangle(Input=moved, RestShape=deck, FixBoundary=1)
    mended.UpdatePipeline()
    path = os.path.join(folder, name, 'pull.inp')
    os.makedirs(os.path.dirname(path))
    simple.ShapeMovedDeckWriter(Input=mended, FileName=path).UpdatePipeline()
    facts = shapemap.facts(mended)
    print('%s: %d nodes, %d inverted cells before and %d after Shape Untangle' % (
        name, len(points(shapetesting.output(mended))), facts['InvertedBefore'], facts['InvertedAfter']))
    for file in ('pull.inp', 'mesh/upper.inc', 'material.inc'):
        before, after = (decks.without_coordinates(content(which, file)) for which in ('original', name))
        claim('%s/%s: bytes that differ outside of coordinates' % (name, file), float(before != after), 0.0)
    return path


original = decks.write(os.path.join(folder, 'original'), blocks(47000))
nodes = 2 * (blocks(47000)[0] + 1) ** 3 + 1
claim('nodes of the deck (at least)', nodes, 50000, nodes >= 50000)
bent = move(original, 'bent', 'coordsX*iHat + (coordsY + 0.2*coordsZ^2)*jHat + coordsZ*kHat')
stretched = move(original, 'stretched', 'coordsX*iHat + coordsY*jHat + 1.5*coordsZ*kHat')
lengths = {path: numpy.mean([u[2] for u in decks.solve(path).values()]) for path in (original, bent, stretched)}
expected = decks.PULL / decks.YOUNG * decks.SIZE[2]
claim("original: relative error of CalculiX's lengthening", abs(lengths[original] / expected - 1.0), 1e-5)
claim("stretched: the same, of half as much more", abs(lengths[stretched] / (1.5 * expected) - 1.0), 1e-5)
claim('bent: change of the displacement along z (more than)', abs(lengths[bent] / expected - 1.0), 1e-3,
      abs(lengths[bent] / expected - 1.0) > 1e-3)


def measured(work):
    """CPU seconds and the growth of the peak memory in MiB, in a process of its own."""
    read, write = os.pipe()
    child = os.fork()
    if child == 0:
        start, before = os.times(), resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        work()
        end, after = os.times(), resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        os.write(write, ('%r %r' % (end[0] + end[1] - start[0] - start[1], (after - before) / 1024)).encode())
        os._exit(0)
    os.waitpid(child, 0)
    os.close(write)
    return tuple(map(float, os.read(read, 200).split()))


def read_and_write(path):
    reader = shapemap.vtkShapeDeckReader()
    reader.SetFileName(path)
    reader.Update()
    grid = reader.GetOutputDataObject(0)
    shapetesting.set_points(grid, 1.1 * points(grid))
    writer = shapemap.vtkShapeMovedDeckWriter()
    writer.SetInputData(grid)
    writer.SetFileName(os.path.join(os.path.dirname(path), 'out', 'pull.inp'))
    os.makedirs(os.path.dirname(writer.GetFileName()), exist_ok=True)
    assert writer.Write()


AWK = '''FNR == 1 { n = FILENAME ~ /upper/ }
{ if ($0 ~ /^\\*/) { n = ($0 ~ /^\\*[Nn][Oo][Dd][Ee] /) } else if (n) {
$0 = sprintf("%s, %.17g, %.17g, %.17g", $1, 1.1*$2, 1.1*$3, 1.1*$4) } print }'''
rows = []
for count in (cells // 8, cells):
    path = decks.write(os.path.join(folder, 'large%d' % count), blocks(count))
    size = sum(os.path.getsize(os.path.join(os.path.dirname(path), name))
               for name in ('pull.inp', 'mesh/upper.inc')) / 2.0 ** 20
    seconds, memory = measured(lambda: read_and_write(path))
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    with open(os.path.join(folder, 'awk.out'), 'wb') as out:
        subprocess.check_call(['mawk', '-F,', AWK, path, os.path.join(os.path.dirname(path), 'mesh/upper.inc')],
                              stdout=out)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    peer = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    rows.append((size, seconds, memory, peer))
    print('%d cells: %.0f MiB, %.2f s, %.0f MiB of memory; mawk %.2f s' % (2 * blocks(count)[0] ** 3, *rows[-1]))
growth = rows[1][0] / rows[0][0]
claim('growth of the time, divided by that of the file', rows[1][1] / rows[0][1] / growth, 1.5)
claim('memory, divided by the size of the file', rows[1][2] / rows[1][0], 10.0)
claim("reading, reading again and writing, divided by mawk's time", rows[1][1] / rows[1][3], 2.0)
failed = [what for what, holds in claims if not holds]
print('failed: %s' % failed if failed else 'all %d claims hold' % len(claims))
if failed:
    raise SystemExit(1)
