"""Two sources that are selected in the pipeline browser become the two inputs of a filter."""
import window

w = window.Window()
w.open('FigureBSmall.vtp')
w.open('FigureASmall.vtp')


def select_both(first, second):
    w.select('/0/%d|0' % first)
    w.python('''
        from paraview import servermanager
        model = servermanager.ProxyManager().GetSelectionModel('ActiveSources')
        names = ['FigureBSmall.vtp', 'FigureASmall.vtp']
        model.Clear()
        for index in (%d, %d):
            model.Select(FindSource(names[index]).SMProxy, model.SELECT)''' % (first, second))


for first, second in ((1, 0), (0, 1)):
    select_both(first, second)
    w.filter('Shape Correspondence')
    w.wait(100)
    w.python('''
        made = GetActiveSource()
        assert made.GetXMLName() == 'ShapeCorrespondence', made.GetXMLName()
        wanted = [FindSource(names[index]) for index in (%d, %d)]
        assert [made.SurfaceA.SMProxy, made.SurfaceB.SMProxy] == [each.SMProxy for each in wanted]''' % (first, second))
    w.check(window.INPUTS + 'SurfaceB/List0', 'currentText', ('FigureBSmall.vtp', 'FigureASmall.vtp')[second])
    w.click(window.PANEL + 'Delete')

w.run()
