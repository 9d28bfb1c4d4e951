"""View > ShapeMap Views: each layout opens in a tab of its own, and undo after it is safe."""
import window

w = window.Window()


def layout(name, views):
    """The entry is chosen; the active layout then has these views."""
    w.event('menubar', 'activate', 'menu_View')
    w.event('menubar/menu_View/ShapeMapViews', 'activate', name)
    w.wait(300)
    w.python('''
        found = sorted(view.GetXMLName() for view in GetViewsInLayout())
        assert found == %r, found''' % views)


w.open('DentedSphere600.vtp')
w.event('menubar', 'activate', 'menu_View')
w.event('menubar/menu_View/ShapeMapViews', 'activate', 'map_quality')
w.wait(300)
w.undo() # there is nothing to undo, and nothing breaks
w.python('assert len(GetSources()) == 5 and len(GetLayouts()) == 2, (GetSources(), GetLayouts())')
w.python('''
    surface = FindSource('DentedSphere600.vtp')
    hexahedra = ShapeHexRemesh(Surface=surface, CellsOnLongestSide=10)
    hexahedra.UpdatePipeline()
    SetActiveSource(hexahedra)''')
layout('hexahedra', ['RenderView', 'XYBarChartView'])
w.python('SetActiveSource(hexahedra)')
layout('deck_check', ['RenderView', 'RenderView'])
w.python('''
    scaled = Transform(Input=surface)
    scaled.Transform.Scale = [1.0, 1.3, 0.8]
    maps = ShapeCorrespondence(SurfaceA=surface, SurfaceB=scaled)
    maps.UpdatePipeline()
    SetActiveSource(maps)''')
layout('correspondence', ['RenderView', 'RenderView'])
w.run(280)
