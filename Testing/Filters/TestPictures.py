"""What the results of filters and readers look like, pixel by pixel, in the scenes of Utilities/illustrations.py
with small shapes. A table says by how many pixels each picture changes when its scene has a defect, which is
more than compare_picture allows. Noise of two levels passes.

A new baseline is the picture that a run leaves in build/Testing/Temporary/Pictures."""
import contextlib
import math
import os
import sys

import numpy
from paraview.simple import *
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkCellCenters, vtkPolyDataNormals
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkIOImage import vtkPNGWriter

import shapetesting
from shapetesting import copy

sys.path.insert(0, os.path.join(shapetesting.ROOT, 'Utilities'))
import illustrations
import proxies
from illustrations import ABOVE, FRONT, shape, show

SIZE = [400, 300]
FOLDER = os.path.join(shapetesting.BUILD, 'Testing', 'Temporary', 'Pictures')
os.makedirs(FOLDER, exist_ok=True)
SMALL = {'DentedSphere10k.vtp': 'DentedSphere600.vtp', 'Ball.vtu': 'BallSmall.vtu'}
SMALL.update({name + '.vtp': name + 'Small.vtp' for name in ('FigureA', 'FigureB', 'BentBar', 'TwistedBar')})
illustrations.find = lambda name: shapetesting.data_file(SMALL.get(name, name))


def landmark_scene(on_a, on_b):
    """Two figures and the numbered landmarks on both."""
    show(shape('FigureA.vtp'), (-0.62, 0, 0))
    show(shape('FigureB.vtp'), (0.62, 0, 0))
    toward = numpy.array(FRONT[0])
    for source, x in ((on_a, -0.62), (on_b, 0.62)):
        shown = show(source, [x, 0, 0] + toward, array='Number', preset='Turbo', limits=(0, 5))
        shown.Representation, shown.PointSize = 'Points', 16
    return FRONT


def landmarks():
    a, b = (shape(name) for name in ('FigureA.vtp', 'FigureB.vtp'))
    for surface in (a, b):
        surface.UpdatePipeline()
    chosen = [900, 0, 1100, 300, 600]
    on_a, on_b = (shapetesting.points(shapetesting.output(surface))[chosen] for surface in (a, b))
    return ShapeLandmarks(SurfaceA=a, SurfaceB=b, PointsA=on_a.ravel().tolist(), PointsB=on_b.ravel().tolist())


def Landmarks():
    both = landmarks()
    return landmark_scene(OutputPort(both, 0), OutputPort(both, 1))


def LandmarksReader():
    """Pairs of a file, on both figures."""
    path = os.path.join(FOLDER, 'landmarks.csv')
    both = landmarks()
    both.UpdatePipeline()
    on_a, on_b = (shapetesting.points(shapetesting.output(both, port)) for port in (0, 1))
    numpy.savetxt(path, numpy.hstack([on_a, on_b]), delimiter=',', header='x,y,z,tx,ty,tz', comments='')
    read = ShapeLandmarksReader(FileNames=[path])
    return landmark_scene(read, Calculator(Input=read, CoordinateResults=1, Function='TargetPosition'))


def OFFReader():
    """A tetrahedron on a table, in the colours of the file."""
    path = os.path.join(FOLDER, 'colours.off')
    with open(path, 'w') as file:
        file.write('OFF\n8 4 0\n-.8 -.8 0\n.8 -.8 0\n.8 .8 0\n-.8 .8 0\n-.6 -.5 0\n.7 -.4 0\n0 .7 0\n0 0 1.2\n'
                   '4 0 1 2 3 200 200 60\n3 4 5 7 220 40 40\n3 5 6 7 40 160 60\n3 6 4 7 40 60 200\n')
    shown = show(OpenDataFile(path), array='RGB', kind='CELLS')
    shown.MapScalars = 0
    return (0.5, -1.0, 0.8), (0, 0, 1)


def Morph():
    """Of the page's thin arms, an inverted cell is not seen."""
    both = ShapeMorph(Input=shape('FigureA.vtp'))
    for time, x in ((0.0, -1.15), (0.5, 0.0), (1.0, 1.15)):
        still = PassArrays(Input=ForceTime(Input=both, ForcedTime=time))
        show(still, (x, 0, 0), colour=[0.55, 0.74, 0.80] if time in (0, 1) else illustrations.ACCENT)
    return FRONT


def Certificate():
    """A stored map with one more charge, beside which it folds. Which boxes of the page's map are inverted depends on
    rounding."""
    places = shapetesting.points(shapetesting.read('DentedSphere600.vtp'))
    top = places[places[:, 2].argmax()]
    outwards = top / numpy.linalg.norm(top)
    source = TrivialProducer()
    source.GetClientSideObject().SetOutput(shapetesting.with_charge(
        shapetesting.read('DentedSphereCharges.vtp'), top + 0.1 * outwards, -4.0 * math.pi * 0.4 ** 2 * outwards))
    boxes = ShapeCertificate(Map=source, Tolerance=1.0 / 64.0)
    folded = Threshold(Input=boxes, Scalars=['CELLS', 'Certified'], LowerThreshold=-1, UpperThreshold=-1)
    show(folded, array='MinimumDeterminant', kind='CELLS', preset='Viridis (matplotlib)', edges=True)
    return (0.5, -1.0, 0.6), (0, 0, 1)


def ImageReader():
    return illustrations.image_reader(FOLDER)


def MeditReader():
    """The solid of the writer's picture, after the file."""
    path = os.path.join(FOLDER, 'solid.mesh')
    solid = ShapeTetrahedralize(Input=shape('PhantomHeadSmall.vtp'), InnerSurfaces=[
        shape('PhantomBrainSmall.vtp')], PreserveBoundary=0)
    SaveData(path, solid)
    read = Threshold(Input=OpenDataFile(path), Scalars=['CELLS', 'Reference'], LowerThreshold=1, UpperThreshold=99)
    show(illustrations.cut(read, (0, 0, 0), (0, -1, 0)), array='Reference', kind='CELLS', preset='Cool to Warm',
         edges=True)
    return (0.2, -1.0, 0.3), (0, 0, 1)


def CommonBase():
    """The same patches on a two-holed torus and on a twisted one, and the paths between them."""
    a = ShapeExample(Shape='Two-Holed Torus')
    b = Calculator(Input=a, CoordinateResults=1, ResultArrayName='Twisted', Function=(
        '1.1*coordsX*iHat+(coordsY*cos(0.5*coordsX)-coordsZ*sin(0.5*coordsX))*jHat'
        '+(coordsY*sin(0.5*coordsX)+coordsZ*cos(0.5*coordsX))*kHat'))
    for surface in (a, b):
        surface.UpdatePipeline()
    places, targets = (shapetesting.points(shapetesting.output(surface)) for surface in (a, b))
    chosen = [int(places[:, 0].argmin())]
    while len(chosen) < 8:
        apart = [numpy.linalg.norm(places - places[point], axis=1) for point in chosen]
        chosen.append(int(numpy.min(apart, axis=0).argmax()))
    marks = vtkPolyData()
    marks.SetPoints(vtkPoints())
    shapetesting.set_points(marks, places[chosen])
    shapetesting.add_array(marks, targets[chosen], 'TargetPosition')
    landmarks = TrivialProducer()
    landmarks.GetClientSideObject().SetOutput(marks)
    both = ShapeCorrespondence(SurfaceA=a, SurfaceB=b, Landmarks=landmarks, Method='CommonBase')
    paths = OutputPort(both, 5)
    carried = Calculator(Input=paths, CoordinateResults=1, Function='TargetPosition')
    half = 0.62 * numpy.ptp(places[:, 1])
    for port, lines, y in ((0, paths, half), (1, carried, -half)):
        # A triangle has the patch of most of its corners.
        numbers = Calculator(Input=OutputPort(both, port), ResultArrayName='Number', Function='Patch')
        patches = PointDatatoCellData(Input=numbers, CategoricalData=1)
        show(patches, (0, y, 0), array='Number', kind='CELLS', preset='Turbo')
        show(Tube(Input=lines, Radius=0.008 * numpy.ptp(places[:, 0]), NumberofSides=12), (0, y, 0))
    return ABOVE


def Example():
    show(ShapeExample(Shape='Two-Holed Torus'))
    return ABOVE


def Symmetry():
    """Of the star only: the middle of a bent figure moves by a triangle with the rounding of another processor."""
    return illustrations.symmetry_of_star(0)


view = illustrations.open_view(SIZE)
scenes = {scene.__name__: scene for scene in (Landmarks, LandmarksReader, OFFReader, ImageReader, MeditReader, Morph, Certificate, Example,
                                              CommonBase, Symmetry)}
# The picture of what Shape Medit Reader and Shape Deck Reader read shows what the writer wrote, too. Others' programs read the files of
# the other writers, or a test does. The web page of Shape HTML Writer
# is tested in a browser.
for name in proxies.proxies():
    stem = name[len('Shape'):]
    if stem not in ('DynaWriter', 'ExodusWriter', 'FebioWriter', 'FoamWriter', 'GmshWriter', 'MeditWriter',
                    'MovedDeckWriter', 'HTMLWriter'):
        scenes.setdefault(stem, illustrations.drawings.get(stem))
assert None not in scenes.values(), scenes


def shown_in(shot):
    return [each for each in shot.Representations if hasattr(each, 'Input') and each.Visibility]


def is_result(source):
    """Whether data come from a filter or reader of ShapeMap."""
    if source.GetXMLName().startswith('Shape'):
        return True
    above = getattr(source, 'Input', None)
    return above is not None and is_result(above)


def data_of(shown):
    return shapetesting.output(shown.Input, shown.Input.Port)


def array_of(shown, data):
    """The array that colours what is shown, None if none does."""
    if not shown.ColorArrayName[1]:
        return None
    attributes = data.GetPointData() if shown.ColorArrayName[0] == 'POINTS' else data.GetCellData()
    return attributes.GetArray(shown.ColorArrayName[1])


@contextlib.contextmanager
def instead(shown, data):
    """Shows other data in the same way."""
    source, producer = shown.Input, TrivialProducer()
    producer.GetClientSideObject().SetOutput(data)
    shown.Input = producer
    yield
    shown.Input = source
    Delete(producer)


@contextlib.contextmanager
def changed(proxy, name, value):
    before = list(proxy.GetProperty(name))
    setattr(proxy, name, value)
    yield
    setattr(proxy, name, before)


def shifted_colours(shown):
    """By a tenth of the range; a shape of one colour gets darker by 0.15 of the whole brightness."""
    if array_of(shown, data_of(shown)) is None:
        darker = [max(part - 0.15, 0.0) for part in shown.DiffuseColor]
        both = contextlib.ExitStack()
        for name in ('DiffuseColor', 'AmbientColor'):
            both.enter_context(changed(shown, name, darker))
        return both
    if not shown.MapScalars: # colours of the array itself
        data = copy(data_of(shown))
        values = vtk_to_numpy(array_of(shown, data))
        values[...] = numpy.clip(values.astype(int) - 25, 0, 255)
        return instead(shown, data)
    table = shown.LookupTable
    colours = numpy.reshape(table.RGBPoints, (-1, 4))
    colours[:, 0] += 0.1 * (colours[-1, 0] - colours[0, 0])
    return changed(table, 'RGBPoints', colours.ravel().tolist())


def missing_part(shown):
    """The 4 % of the cells that are around the one nearest to the camera."""
    data = data_of(shown)
    centers = vtkCellCenters()
    centers.SetInputData(data)
    centers.Update()
    centers = shapetesting.points(centers.GetOutput())
    front = centers[numpy.argmax(centers @ (numpy.array(view.CameraPosition) - view.CameraFocalPoint))]
    order = numpy.argsort(numpy.linalg.norm(centers - front, axis=1), kind='stable')
    return instead(shown, shapetesting.with_cells(data, numpy.sort(order[math.ceil(0.04 * len(order)):])))


def inverted_cells(shown):
    """Cells that face inwards."""
    data = copy(data_of(shown))
    if not data.IsA('vtkPolyData') or not data.GetNumberOfPolys():
        return None
    for cell in range(data.GetNumberOfCells()):
        data.ReverseCell(cell)
    return instead(shown, data)


def flipped_normals(shown):
    """Normals that point inwards, although the cells face outwards."""
    if shown.Diffuse == 0.0: # colours without light
        return None
    surface = vtkGeometryFilter()
    surface.SetInputData(data_of(shown))
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(surface.GetOutputPort())
    normals.ComputePointNormalsOff()
    normals.ComputeCellNormalsOn()
    normals.SplittingOff()
    normals.ConsistencyOff()
    normals.Update()
    data = copy(normals.GetOutput())
    if not data.GetNumberOfPolys():
        return None
    data.GetPointData().SetNormals(None)
    inwards = -vtk_to_numpy(data.GetCellData().GetNormals())
    array = numpy_to_vtk(inwards, deep=True)
    array.SetName('Normals')
    data.GetCellData().SetNormals(array)
    return instead(shown, data)


def moved_shape(shown):
    """By two pixels to the right."""
    towards = numpy.array(view.CameraPosition) - view.CameraFocalPoint
    right = numpy.cross(view.CameraViewUp, towards)
    pixel = 2.0 * view.CameraParallelScale / SIZE[1]
    return changed(shown, 'Position', (shown.Position + 2.0 * pixel * right / numpy.linalg.norm(right)).tolist())


def wrong_array(shown):
    """Numbers of another array, or else a coordinate, in the range of the right one."""
    data = copy(data_of(shown))
    right = array_of(shown, data)
    if right is None:
        return None
    on_points = shown.ColorArrayName[0] == 'POINTS'
    attributes = data.GetPointData() if on_points else data.GetCellData()
    values = vtk_to_numpy(right)
    others = [vtk_to_numpy(attributes.GetArray(k)) for k in range(attributes.GetNumberOfArrays())
              if attributes.GetArray(k) and attributes.GetArrayName(k) not in (right.GetName(), 'Normals')]
    others = [other.reshape(len(other), -1)[:, 0].astype(float) for other in others]
    others = [other for other in others if 0.0 < other.max() - other.min() < 1e9]
    if not others:
        centers = vtkCellCenters()
        centers.SetInputData(data)
        centers.Update()
        others = [shapetesting.points(data if on_points else centers.GetOutput())[:, 2]]
    other = others[0]
    share = (other - other.min()) / (other.max() - other.min())
    wrong = values.min() + share * (values.max() - values.min())
    values[...] = wrong if values.ndim == 1 else wrong[:, None]
    return instead(shown, data)


DEFECTS = [shifted_colours, missing_part, flipped_normals, inverted_cells, moved_shape, wrong_array]


# The same for a curve in a chart, which has no normals.
def curve_colours(shown):
    return changed(shown, 'SeriesColor', [shown.SeriesColor[0]] + [
        str(float(part) + 0.1) for part in shown.SeriesColor[1:]])


def curve_part(shown):
    """The first tenth of its rows."""
    data = copy(data_of(shown))
    for row in range(data.GetNumberOfRows() // 10):
        data.RemoveRow(0)
    return instead(shown, data)


def moved_curve(shown):
    """By two pixels of 300."""
    data = copy(data_of(shown))
    vtk_to_numpy(data.GetColumnByName('Share'))[...] += 2.0 / SIZE[1]
    return instead(shown, data)


def wrong_column(shown):
    return changed(shown, 'SeriesVisibility', ['Error'])


CURVE_DEFECTS = [curve_colours, curve_part, None, None, moved_curve, wrong_column]


def take(shot, name):
    path = os.path.join(FOLDER, name + '.png')
    SaveScreenshot(path, shot, ImageResolution=SIZE)
    return path


def with_noise(path):
    """The picture with each colour changed by up to two levels."""
    picture = shapetesting.read_picture(path)
    values = vtk_to_numpy(picture.GetPointData().GetScalars())
    noise = numpy.random.default_rng(1).integers(-2, 3, values.shape)
    values[...] = numpy.clip(values.astype(int) + noise, 0, 255)
    noisy = os.path.join(FOLDER, 'Defect.png')
    writer = vtkPNGWriter()
    writer.SetFileName(noisy)
    writer.SetInputData(picture)
    writer.Write()
    return noisy


def clear(shot):
    if shot != view:
        Delete(shot)
    for group in ('sources', 'lookup_tables', 'piecewise_functions'):
        for each in servermanager.ProxyManager().GetProxiesInGroup(group).values():
            Delete(each)
    assert not shown_in(view), 'an empty view for the next scene'
    SetActiveView(view)


wrong = []
print('%-18s%10s' % ('pixels', 'as it is'), *['%16s' % defect.__name__ for defect in DEFECTS])
for name in sys.argv[1:] or sorted(scenes):
    shot, baseline = illustrations.compose(scenes[name], view), name + '.png'
    for shown in shown_in(view):
        # Holes and inverted cells are seen because back sides are not drawn, colours because edges do not cover them.
        shown.BackfaceRepresentation = 'Cull Backface'
        if shown.Representation == 'Surface With Edges' and data_of(shown).GetNumberOfCells() > 1000:
            shown.Representation = 'Surface'
    path = take(shot, name)
    try:
        row = [shapetesting.baseline_difference(path, baseline)]
        shapetesting.compare_picture(path, baseline)
        shapetesting.compare_picture(with_noise(path), baseline)
    except AssertionError as error:
        wrong.append(str(error))
        clear(shot)
        continue
    # Of the shapes in the picture, the one whose defect changes it least.
    for defect in DEFECTS if shot == view else CURVE_DEFECTS:
        differences = []
        for shown in (each for each in shown_in(shot) if is_result(each.Input)):
            planted = defect and defect(shown)
            if planted:
                with planted:
                    defective = take(shot, 'Defect')
                differences.append(shapetesting.baseline_difference(defective, baseline))
                if differences[-1] <= shapetesting.PICTURE_MARGIN:
                    wrong.append('%s: %s is not seen' % (name, defect.__name__))
        row.append(min(differences, default=None))
    print('%-18s%10.1f' % (name, row[0]), *['%16s' % ('-' if x is None else '%.0f' % x) for x in row[1:]], flush=True)
    clear(shot)
assert not wrong, '\n'.join(wrong)
assert sys.argv[1:] or len(scenes) >= 27
