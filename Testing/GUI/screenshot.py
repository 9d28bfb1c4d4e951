"""Takes a picture of the whole window: a hexahedral ball carried into a dented sphere, cut open, and
the menu Filters > ShapeMap unfolded. screenshot.py OUT.png"""
import os
import sys

import shapetesting
import window

picture = os.path.abspath(sys.argv[1])
w = window.Window()
w.python('''
    surface = XMLPolyDataReader(registrationName='Surface.vtp', FileName=[%r])
    ball = XMLUnstructuredGridReader(registrationName='Ball.vtu', FileName=[%r])
    sphere = ShapeParameterize(registrationName='ShapeParameterize1', Input=surface)
    solid = ShapeHarmonicVolumeMap(
        registrationName='ShapeHarmonicVolumeMap1', Domain=ball, Boundary=OutputPort(sphere, 1),
        MapArray='SourcePosition')
    half = Clip(registrationName='Clip1', Input=solid, ClipType='Plane', Crinkleclip=1)
    half.ClipType.Origin, half.ClipType.Normal = [0, 0, 0], [0.5, 0.2, 1]
    view = GetActiveViewOrCreate('RenderView')
    shown = Show(half, view)
    shown.SetRepresentationType('Surface With Edges')
    shown.EdgeColor = [0.1, 0.1, 0.1]
    ColorBy(shown, ('POINTS', 'SourcePosition', 'Magnitude'))
    shown.SetScalarBarVisibility(view, True)
    Render()  # the first picture of a view resets its camera
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [1.5, 1, 5], [0, 0, 0], [0, 1, 0]
    view.ResetCamera()
    view.GetActiveCamera().Zoom(1.7)''' % (
    shapetesting.data_file('DentedSphere3k.vtp'), shapetesting.data_file('Ball.vtu')))
w.select('/0/0/0/1|0')  # the sphere: an input that suits every filter
w.fill_screen()
w.event('menubar', 'activate', 'menuFilters')
w.event('menubar/menuFilters', 'activate', 'ShapeMap')
w.screenshot(picture)
w.run()
