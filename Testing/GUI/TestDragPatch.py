"""Shape Exponential Map's patch follows its handle over the surface, and keys change its radius."""
import window

w = window.Window()
w.open_with('DentedSphere600.vtp', 'Shape Exponential Map')
w.python('''
    import numpy
    import onsurface
    made = GetActiveSource()
    surface = onsurface.Surface(made.Input)
    updates = []
    made.SMProxy.AddObserver('UpdateDataEvent', lambda caller, event: updates.append((list(made.Seed), made.Radius)))
    surface.check_under(made.Seed, (0.5, 0.5))''')
w.drag([(0.5, 0.5), (0.55, 0.45), (0.6, 0.5)])
w.check(window.PANEL + 'Accept', 'enabled', 'false')
w.key(0x2b, '+')
w.wait(600)
w.undo()
w.undo()
w.python('''
    places = [(0.55, 0.45), (0.6, 0.5), (0.6, 0.5), (0.6, 0.5)]
    assert len(updates) >= 6, updates
    for update, pixel in zip(updates, places):
        surface.check_under(update[0], pixel)
    # Undone: the radius, then the seed. A radius of 0 was a tenth of the diagonal.
    surface.check_under(updates[-2][0], (0.6, 0.5))
    surface.check_under(updates[-1][0], (0.5, 0.5))
    bounds = numpy.reshape(made.Input.GetDataInformation().GetBounds(), (3, 2))
    tenth = 0.1 * numpy.linalg.norm(bounds[:, 1] - bounds[:, 0])
    assert abs(updates[-3][1] - 1.05 * tenth) < 1e-9, (updates, tenth)
    assert updates[-2][1] == updates[-1][1] == 0.0, updates''')
w.run()
