"""The panel of Shape Synthesize has a slider for each mode. With Auto Apply, a slider that moves moves the solid."""
import window

w = window.Window()
w.open('DentedSphere600.vtp')
w.open('BallSmall.vtu')
w.python('''
    import time
    mean = FindSource('DentedSphere600.vtp')
    atlas = Calculator(Input=mean, ResultArrayName='SourcePosition', Function='TargetPosition')
    atlas = Calculator(Input=atlas, ResultArrayName='Mode0', Function='0.1*coordsX*iHat')
    atlas = Calculator(registrationName='Atlas', Input=atlas, ResultArrayName='Mode1', Function='0.1*coordsZ*kHat')
    Show(atlas)
    SetActiveSource(atlas)''')
w.wait(300)
w.filter('Shape Synthesize')
w.wait(100)
w.choose_inputs(Data='BallSmall.vtu')
SLIDERS = window.PROPERTIES + 'Weights/'
w.check(SLIDERS + 'Mode1/Slider', 'value', '50')
w.apply()
w.wait(300)
w.python('''
    def widths(port):
        sample = GetActiveSource()
        sample.UpdatePipeline()
        bounds = sample.GetDataInformation(port).GetBounds()
        return [bounds[1] - bounds[0], bounds[5] - bounds[4]]
    assert list(GetActiveSource().Weights) in ([], [0.0, 0.0]), list(GetActiveSource().Weights)
    at_rest = [widths(port) for port in (0, 1)]''')
# Auto Apply: no click is needed.
w.event('MainControlsToolbar/actionAutoApply', 'set_boolean', 'true')
w.event(SLIDERS + 'Mode1/Slider', 'set_int', '100')
w.wait(500)
w.python('''
    assert list(GetActiveSource().Weights) == [0.0, 3.0], list(GetActiveSource().Weights)
    for port in (0, 1):
        now = widths(port)
        assert abs(now[0] - at_rest[port][0]) < 1e-9, (port, now)
        assert abs(now[1] / at_rest[port][1] - 1.3) < 0.01, (port, now, at_rest)''')
w.event(SLIDERS + 'Mode0/DoubleLineEdit', 'set_string', '-1.5')
w.wait(500)
w.python("assert list(GetActiveSource().Weights) == [-1.5, 3.0], list(GetActiveSource().Weights)")
w.event('MainControlsToolbar/actionAutoApply', 'set_boolean', 'false')
w.run()
