"""Cells that are selected in the view are cut from their surface by Shape Cut Feature."""
import window

select = window.VIEW.split('/CentralWidgetFrame')[0] + '/TitleBar/ToolBar/1QToolButton8'

w = window.Window()
w.open('DentedSphere600.vtp')
w.check(select, 'toolTip', 'Select Cells On (s)')
w.event(select, 'set_boolean', 'true')
w.drag([(0.45, 0.45), (0.5, 0.5), (0.55, 0.55)])
w.filter('Shape Cut Feature')
w.wait(100)
w.click(window.PROPERTIES + 'Selection/Selection/pushButtonCopySelection')
w.apply()
w.wait(100)
w.python('''
    made = GetActiveSource()
    assert made.SMProxy.GetXMLName() == 'ShapeCutFeature'
    feature = servermanager.Fetch(made)
    assert 1 < feature.GetNumberOfCells() < 200, feature.GetNumberOfCells()
    assert feature.GetPointData().HasArray('LoopNormal')
    rest = OutputPort(made, 1).GetDataInformation()
    assert rest.GetNumberOfCells() > 1280 - feature.GetNumberOfCells()''')
w.run()
