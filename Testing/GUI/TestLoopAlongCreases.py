"""A loop of Shape Cut Feature follows creases while its positions are dragged in the window, and the curve in
the view is the one that is cut."""
import os

import shapetesting
import window

w = window.Window()
w.python('''
    grid = Wavelet(registrationName='Grid', WholeExtent=[0, 12, 0, 12, 0, 12])
    places = Calculator(registrationName='Places', Input=grid, ResultArrayName='Place', Function='coords')
    cells = PointDatatoCellData(registrationName='Cells', Input=places)
    solid = Calculator(registrationName='Solid', Input=cells, AttributeType='Cell Data', ResultArrayName='Solid',
        Function='if(Place_Z < 4, 1, if(abs(Place_X - 6) < 2, if(abs(Place_Y - 6) < 2, 1, 0), 0))')
    inside = Threshold(registrationName='Inside', Input=solid, Scalars=['CELLS', 'Solid'],
                       LowerThreshold=0.5, UpperThreshold=1.5)
    bar = ExtractSurface(registrationName='Bar', Input=inside)
    Show(bar)
    SetActiveSource(bar)''')
w.wait(100)
w.filter('Shape Cut Feature')
w.wait(100)
w.python('''
    made = GetActiveSource()
    made.LoopPoints = [8.5, 6, 4, 6, 8.5, 4, 3.5, 6, 4, 6, 3.5, 4]
    made.CreaseWeight = 10.0''')
w.apply()
w.wait(100)
# From above, 16 units high: the slab is seen beside the foot of the bar.
w.python('''
    import shapemap
    view = GetActiveView()
    Render()  # the first picture of a view resets its camera
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [6, 6, 50], [6, 6, 0], [0, 1, 0]
    view.CameraParallelProjection, view.CameraParallelScale = 1, 8.0
    Render()
    assert abs(shapemap.facts(made)['CutLength'] - 16) < 1e-9, shapemap.facts(made)['CutLength']''')
w.wait(100)
# The position at y = 8.5 is dragged to y = 8.8: the loop stays at the foot, during the drag, too.
w.press((0.5, 0.5 - 2.5 / 16))
w.mouse('Move', (0.5, 0.5 - 2.7 / 16), 0, 1)
w.wait(100)
w.mouse('Move', (0.5, 0.5 - 2.8 / 16), 0, 1)
w.wait(100)
w.python('''
    assert made.SMProxy.GetProperty('Dragging').GetElement(0) == 1
    assert abs(made.LoopPoints[4] - 8.8) < 0.05, list(made.LoopPoints)
    assert abs(shapemap.facts(made)['CutLength'] - 16) < 1e-9, shapemap.facts(made)['CutLength']''')
w.screenshot(os.path.join(shapetesting.BUILD, 'Testing', 'Temporary', 'LoopAlongCreases.png'))
w.mouse('Release', (0.5, 0.5 - 2.8 / 16), 1)
w.wait(100)
w.python('''
    assert made.SMProxy.GetProperty('Dragging').GetElement(0) == 0
    assert abs(shapemap.facts(made)['CutLength'] - 16) < 1e-9, shapemap.facts(made)['CutLength']
    made.CreaseWeight = 0.0
    made.UpdatePipeline()
    assert abs(shapemap.facts(made)['CutLength'] - 16) > 0.1, shapemap.facts(made)['CutLength']''')
w.run()
