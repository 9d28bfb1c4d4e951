"""Shape Moved Deck Writer: only the coordinates of a deck change, and CalculiX computes what follows.

As an example: a deck is stretched by a volume map, checked by Shape Untangle, and written again."""
import os
import tempfile

import numpy
from paraview import simple
from paraview.modules.vtkRemotingServerManager import vtkSMProxyManager
import shapemap

import decks
import shapetesting
from shapetesting import points

FILES = 'pull.inp', 'mesh/upper.inc', 'material.inc'
folder = tempfile.mkdtemp()
original = decks.write(os.path.join(folder, 'original'), (4, 3, 3))


def content(*names):
    with open(os.path.join(folder, *names), 'rb') as file:
        return file.read()


def moved_by(function):
    """The deck moved by the harmonic map whose boundary is a sphere around it, and mended."""
    deck = simple.ShapeDeckReader(FileNames=[original])
    around = simple.Sphere(Center=[0.5, 0.5, 1.0], Radius=2.0, ThetaResolution=24, PhiResolution=24)
    boundary = simple.Calculator(Input=simple.Clean(Input=around), Function=function,
                                 ResultArrayName='TargetPosition')
    made = simple.ShapeHarmonicVolumeMap(Domain=deck, Boundary=boundary)
    moved = simple.ShapeApplyVolumeMap(Input=deck, Map=simple.OutputPort(made, 1))
    mended = simple.ShapeUntangle(Input=moved, RestShape=deck, FixBoundary=1)
    mended.UpdatePipeline()
    assert shapemap.facts(mended)['InvertedAfter'] == 0
    return mended


def save(source, name, **options):
    path = os.path.join(folder, name)
    os.makedirs(os.path.dirname(path), exist_ok=True)
    simple.ShapeMovedDeckWriter(Input=source, FileName=path, **options).UpdatePipeline()
    return path


def check_bytes(name):
    """Everything but the coordinates is as it was, and both files have other coordinates."""
    for file in FILES:
        before, after = content('original', file), content(name, file)
        assert decks.without_coordinates(after) == decks.without_coordinates(before), file
        assert (after == before) == (file == 'material.inc'), file


# The example. Of a stretched bar, the same stress lengthens each part as before: half as much more in all.
stretched = moved_by('coordsX*iHat + coordsY*jHat + 1.5*coordsZ*kHat')
path = save(stretched, 'stretched/pull.inp')
check_bytes('stretched')
expected = decks.PULL / decks.YOUNG * decks.SIZE[2]
for deck, length in ((original, expected), (path, 1.5 * expected)):
    pulled = numpy.array(list(decks.solve(deck).values()))
    assert len(pulled) == 20 and abs(pulled[:, 2] / length - 1.0).max() < 1e-6, (deck, pulled)
    assert abs(pulled[:, :2]).max() < 1e-9

# A map that bends: what is written is read back, within the 20 columns of a number.
bent = moved_by('coordsX*iHat + (coordsY + 0.2*coordsZ^2)*jHat + coordsZ*kHat')
path = save(bent, 'bent/pull.inp')
check_bytes('bent')
again = simple.ShapeDeckReader(FileNames=[path])
again.UpdatePipeline()
found, sent = points(shapetesting.output(again)), points(shapetesting.output(bent))
assert abs(found - sent).max() < 1e-12 and abs(found[:, 1]).max() > 1.5
assert len(decks.solve(path)) == 20

# The identity writes every byte, in each format.
same = simple.ShapeDeckReader(FileNames=[original])
save(same, 'same/pull.inp')
assert all(content('same', file) == content('original', file) for file in FILES)
ball = simple.XMLUnstructuredGridReader(FileName=[shapetesting.data_file('BallSmall.vtu')])
for extension, writer in (('inp', 'Abaqus'), ('k', 'Dyna'), ('feb', 'Febio')):
    name = 'ball.' + extension
    simple.SaveData(os.path.join(folder, name), ball)  # a mesh of its own, also for k and feb
    assert len(content(name)) > 10000, extension
    read = simple.ShapeDeckReader(FileNames=[os.path.join(folder, name)])
    save(read, 'copy.' + extension)
    assert content('copy.' + extension) == content(name), extension
    larger = simple.Calculator(Input=read, CoordinateResults=1, Function='coords*1.1')
    save(larger, 'larger.' + extension)
    again = simple.ShapeDeckReader(FileNames=[os.path.join(folder, 'larger.' + extension)])
    for source in (read, larger, again):
        source.UpdatePipeline()
    wanted = points(shapetesting.output(larger))
    error = abs(points(shapetesting.output(again)) - wanted).max()
    assert error <= (1e-8 if extension == 'k' else 1e-12), (extension, error)
listed = vtkSMProxyManager.GetProxyManager().GetWriterFactory().GetSupportedFileTypes(same.SMProxy, 0)
assert 'Abaqus input(*.inp )' in listed and 'Input deck with moved nodes(' in listed, listed


def refusal(data, name, deck=''):
    """What the writer says, and that it writes nothing."""
    writer, messages = shapemap.vtkShapeMovedDeckWriter(), []

    def note(_, __, message):
        messages.append(message)
    note.CallDataType = 'string0'
    writer.AddObserver('ErrorEvent', note)
    writer.SetInputData(data)
    writer.SetFileName(os.path.join(folder, name))
    writer.SetDeck(deck)
    before = sorted(os.listdir(folder)), content('original', 'pull.inp'), content('original', 'mesh', 'upper.inc')
    assert not writer.Write()
    assert before == (sorted(os.listdir(folder)), content('original', 'pull.inp'),
                      content('original', 'mesh', 'upper.inc'))
    return messages[0]


whole = shapetesting.output(bent)
assert 'another folder' in refusal(whole, 'original/new.inp')
assert 'another folder' in refusal(whole, 'original/pull.inp')
assert 'same extension' in refusal(whole, 'new.k')
ball.UpdatePipeline()
assert 'choose a Deck' in refusal(shapetesting.output(ball), 'new.inp')
assert 'NodeId' in refusal(shapetesting.output(ball), 'new.inp', original)
half = shapetesting.with_cells(whole, range(36))
assert 'missing in the Input: 81 ' in refusal(half, 'new.inp'), 'also the loose node'
print('decks of', len(points(whole)), 'nodes moved')
