"""View > ShapeMap Views: each layout opens in a tab of its own."""
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
layout('map_quality', ['RenderView', 'RenderView'])
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
w.run()
