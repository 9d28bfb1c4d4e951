"""Inputs are chosen in the panel: needed ones, optional ones before the first Apply, and repeatable ones."""
import window


def inputs(name, index=0):
    return window.INPUTS + '%s/List%d' % (name, index)


w = window.Window()
w.python('''
    for name, radius in (('A', 1.0), ('B', 2.0)):
        ball = Sphere(registrationName=name, ThetaResolution=24, PhiResolution=24, Radius=radius)
        ball.UpdatePipeline()
    Show(FindSource('B'))
    SetActiveSource(FindSource('A'))''')

# No dialog asks. The only other surface is chosen, and what is needed can be told from what is optional.
w.python('''
    from paraview import smtrace
    smtrace.start_trace()''')
w.filter('Shape Correspondence')
w.check(inputs('SurfaceA'), 'currentText', 'A')
w.check(inputs('SurfaceB'), 'currentText', 'B')
w.check(inputs('Landmarks'), 'currentText', 'none')
w.python('assert GetActiveSource().SurfaceB is None, "it waits for Apply"')
# Its first output is the active one, and stays selected when the pipeline browser moves the filter to its new
# inputs: without a selection, all filters are disabled.
w.select('/0/0/0/0|0')
w.apply()
w.python('''
    selection = servermanager.ProxyManager().GetSelectionModel('ActiveSources')
    assert selection.GetNumberOfSelectedProxies() == 1, selection.GetNumberOfSelectedProxies()
    made = FindSource('ShapeCorrespondence1')
    assert made.SurfaceB == FindSource('B') and made.Landmarks is None, made.SurfaceB
    trace = smtrace.get_current_trace_output()
    smtrace.stop_trace()
    assert 'SurfaceB = ' in trace and 'Landmarks = ' not in trace, trace
    Delete(made)''')

# Inner surfaces before the first Apply; the list follows the pipeline.
w.python('SetActiveSource(FindSource("B"))')
w.filter('Shape Tetrahedralize')
w.check(inputs('InnerSurfaces'), 'currentText', 'none')
w.choose(inputs('InnerSurfaces'), 'A')
w.check(inputs('InnerSurfaces', 1), 'currentText', 'add ...')
w.python('RenameSource("Inside", FindSource("A"))')
w.wait(100)
w.check(inputs('InnerSurfaces'), 'currentText', 'Inside')
w.apply()
w.python('''
    import shapetesting
    made = GetActiveSource()
    assert [port.SMProxy.GetGlobalIDAsString() for port in made.InnerSurfaces] == [
        FindSource('Inside').SMProxy.GetGlobalIDAsString()]
    regions = made.GetCellDataInformation()['RegionId'].GetRange()
    assert regions == (0, 1), regions''')

# None again, which Reset takes back; after Apply, undo does, in the panel, too.
w.choose(inputs('InnerSurfaces'), 'none')
w.click(window.PANEL + 'Reset')
w.check(inputs('InnerSurfaces'), 'currentText', 'Inside')
w.choose(inputs('InnerSurfaces'), 'none')
w.apply()
w.check(inputs('InnerSurfaces'), 'currentText', 'none')
w.undo()
w.check(inputs('InnerSurfaces'), 'currentText', 'Inside')
w.redo()
w.check(inputs('InnerSurfaces'), 'currentText', 'none')
w.python('assert len(GetActiveSource().InnerSurfaces) == 0')

# An output that the filter feeds would close a cycle: it is not offered.
w.python('''
    ExtractSurface(registrationName='Skin', Input=FindSource('ShapeTetrahedralize1')).UpdatePipeline()
    SetActiveSource(FindSource('ShapeTetrahedralize1'))''')
w.wait(100)
w.check(inputs('Input'), 'count', '3')
w.run()
