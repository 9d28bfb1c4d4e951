"""A feature is cut by a drawn loop, pasted on another surface, dragged there with undo and redo, and saved."""
import os
import tempfile

import journey
import window

folder = tempfile.TemporaryDirectory()
result = os.path.join(folder.name, 'result.stl')

w = journey.Journey('CutPaste')
w.open('PhantomHeadSmall.vtp')
w.open('DentedSphere600.vtp')
w.eye('/0/0')
w.step('source and hidden target')
w.filter('Shape Cut Feature')
w.event(window.PROPERTIES + 'ShapeLoop/DrawLoop', 'set_boolean', 'true')
for place in [(0.5, 0.4), (0.45, 0.45), (0.46, 0.52), (0.53, 0.55)]:
    w.drag([place])
w.step('loop drawn')
w.key(window.ENTER)
w.apply()
w.wait(100)
w.step('cut')
w.python('''
    cut = GetActiveSource()
    assert [OutputPort(cut, port).GetDataInformation().GetNumberOfCells() > 0 for port in (0, 1)] == [True, True]
    assert any(GetDisplayProperties(OutputPort(cut, 0)).Position), 'the feature lies in the rest' ''')

w.filter('Shape Paste Feature')
w.choose_inputs(Target='PhantomHeadSmall.vtp')
w.wait(100)
w.step('feature placed')
w.python('''
    import numpy
    from vtkmodules.vtkCommonCore import reference
    from vtkmodules.vtkCommonDataModel import vtkStaticCellLocator
    seed, viewer = (numpy.array(position) for position in
                    (GetActiveSource().Seed, GetActiveView().CameraPosition))
    target = vtkStaticCellLocator()
    target.SetDataSet(servermanager.Fetch(FindSource('PhantomHeadSmall.vtp')))
    target.BuildLocator()
    hit = numpy.zeros(3)
    assert target.IntersectWithLine(viewer, viewer + 1.1 * (seed - viewer), 0, reference(0.0), hit, [0, 0, 0],
                                    reference(0))
    assert numpy.linalg.norm(hit - seed) < 1e-3, ('the feature is not on the side that is seen', hit, seed)''')
w.apply()
w.wait(100)
w.step('pasted')
w.python('''
    made = GetActiveSource()
    assert made.Target == FindSource('PhantomHeadSmall.vtp')
    shown = [display.Input.SMProxy for display in GetActiveView().Representations
             if hasattr(display, 'Input') and display.Visibility]
    assert shown == [made.SMProxy], shown
    assert GetDisplayProperties(made).ColorArrayName[1] == 'Part'

    def seed():
        return numpy.array(made.Seed)

    first = seed()''')
w.drag([(0.5, 0.5), (0.53, 0.5), (0.57, 0.47)])
w.step('dragged')
w.python('second = seed(); assert numpy.linalg.norm(second - first) > 0.01, (first, second)')
w.drag([(0.57, 0.47), (0.5, 0.45), (0.45, 0.45)])
w.undo()
w.step('undone')
w.python('assert (seed() == second).all(), seed()')
w.drag([(0.57, 0.47), (0.5, 0.45), (0.45, 0.45)])
w.undo()
w.redo()
w.step('redone')
w.python('assert numpy.linalg.norm(seed() - second) > 0.01, seed()')
w.menu('menu_File', 'actionFileSaveData')
w.event('FileSaveDialog', 'filesSelected', result)
w.click('WriterSettingsDialog/widget/OKButton')
w.step('saved')
w.python('''
    saved = OpenDataFile(%r)
    saved.UpdatePipeline()
    assert saved.GetDataInformation().GetNumberOfCells() == made.GetDataInformation().GetNumberOfCells() > 0''' % result)
w.run()
