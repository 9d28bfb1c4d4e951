"""View > ShapeMap Views: each layout opens in a tab of its own."""
import window

w = window.Window()


def layout(name, views):
    """The entry is chosen; the active layout then has these views."""
    w.event('menubar', 'activate', 'menuView')
    w.event('menubar/menuView/ShapeMapViews', 'activate', name)
    w.wait(300)
    w.python('''
        found = sorted(view.GetXMLName() for view in GetViewsInLayout())
        assert found == %r, found''' % views)


w.open('DentedSphere600.vtp')
layout('map_quality', ['RenderView', 'RenderView'])
w.python('''
    surface = FindSource('DentedSphere600.vtp')
    SetActiveSource(ShapeHexRemesh(Surface=surface, CellsOnLongestSide=10))''')
layout('hexahedra', ['RenderView', 'XYBarChartView'])
w.python("SetActiveSource(FindSource('ShapeHexRemesh1'))")
layout('deck_check', ['RenderView', 'RenderView'])
w.python('''
    scaled = Transform(Input=surface)
    scaled.Transform.Scale = [1.0, 1.3, 0.8]
    SetActiveSource(ShapeCorrespondence(SurfaceA=surface, SurfaceB=scaled))''')
layout('correspondence', ['RenderView', 'RenderView'])
w.run()
