"""Two figures: landmarks picked in the view, a map, a field transferred along it, one figure morphed into the
other, and the animation written as pictures."""
import glob
import os
import tempfile

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

import journey
import window

# Head, hands, belly and a foot of one and the other, where they stand beside each other in the view.
PAIRS = [((0.370, 0.318), (0.635, 0.318)), ((0.266, 0.361), (0.537, 0.337)), ((0.478, 0.361), (0.735, 0.337)),
         ((0.370, 0.467), (0.635, 0.447)), ((0.346, 0.665), (0.606, 0.627))]
LANDMARKS = window.PROPERTIES + 'ShapeLandmarks/Buttons/Pick'

folder = tempfile.TemporaryDirectory()


def read(path):
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(float)


w = journey.Journey('Correspondence')
w.open('FigureBSmall.vtp')
w.open('FigureASmall.vtp')
w.step('opened')
w.filter('Shape Landmarks')
w.choose_inputs(SurfaceB='FigureBSmall.vtp')
w.apply()
w.wait(300)
w.step('beside each other')
w.click('cameraToolbar/actionPositiveY')
w.event(LANDMARKS, 'set_boolean', 'true')
w.step('from the front')
for pair in PAIRS:
    for place in pair:
        w.drag([place])
w.key(window.ESCAPE)
w.step('landmarks picked')
w.python("made = GetActiveSource(); assert len(made.PointsA) == len(made.PointsB) == 15, list(made.PointsB)")

w.select('/0/1|0')
w.filter('Shape Correspondence')
w.choose_inputs(SurfaceB='FigureBSmall.vtp', Landmarks='ShapeLandmarks1: LandmarksA')
w.apply()
w.step('mapped')
w.python('''
    import shapemap
    maps = FindSource('ShapeCorrespondence1')
    assert shapemap.facts(maps)['Landmarks'] == 5
    colored = [GetDisplayProperties(OutputPort(maps, port)).ColorArrayName[1] for port in (0, 1)]
    assert all(colored), colored''')

w.select('/0/0|0')
w.event('menubar', 'activate', 'menuFilters')
w.event('menubar/menuFilters/Alphabetical', 'activate', 'Elevation')
w.apply()
w.step('a field of B')
w.select('/0/3/0|0')
w.filter('Shape Transfer Fields')
w.choose_inputs(Source='Elevation1')
w.apply()
w.step('transferred')
w.python('''
    def shown():
        names = {source.SMProxy: name[0] for name, source in GetSources().items()}
        return sorted((names[display.Input.SMProxy], display.Input.Port, display.ColorArrayName[1])
                      for display in GetActiveView().Representations if hasattr(display, 'Input') and display.Visibility)

    transferred = GetActiveSource()
    assert shown() == [('Elevation1', 0, 'Elevation'), ('ShapeTransferFields1', 0, 'Elevation')], shown()
    positions = [GetDisplayProperties(FindSource(name)).Position[0] for name in ('Elevation1', 'ShapeTransferFields1')]
    assert positions[0] > 0 == positions[1], positions''')

w.filter('Shape Morph')
w.apply()
w.step('morph')
w.click('VCRToolbar/actionVCRPlay')
w.wait(500)
w.step('played')
w.python('''
    import numpy
    from vtkmodules.util.numpy_support import vtk_to_numpy
    assert GetAnimationScene().AnimationTime == 1.0, GetAnimationScene().AnimationTime
    moved, kept = (servermanager.Fetch(source) for source in (FindSource('ShapeMorph1'), transferred))
    ends = vtk_to_numpy(moved.GetPoints().GetData()), vtk_to_numpy(kept.GetPointData().GetArray('TargetPosition'))
    assert abs(ends[0] - ends[1]).max() < 1e-6, abs(ends[0] - ends[1]).max()''')
w.menu('menu_File', 'actionFileSaveAnimation')
w.event('SaveAnimationFileDialog', 'filesSelected', os.path.join(folder.name, 'morph.png'))
w.click('SaveAnimationDialog/widget/OKButton')
w.step('animation written')
w.run(280)

frames = sorted(glob.glob(os.path.join(folder.name, 'morph.*.png')))
assert len(frames) == 41, frames
first, middle, last = (read(frames[i]) for i in (0, 20, 40))
halves, whole = [numpy.linalg.norm(middle - end) for end in (first, last)], numpy.linalg.norm(last - first)
assert 0 < max(halves) < whole, (halves, whole)
