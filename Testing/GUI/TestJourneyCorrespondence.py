"""Two figures: landmarks picked in the view, a map and a field transferred along it."""
import journey
import window

# Head, hands, belly and a foot of one and the other, where they stand beside each other in the view.
PAIRS = [((0.370, 0.318), (0.635, 0.318)), ((0.266, 0.361), (0.537, 0.337)), ((0.478, 0.361), (0.735, 0.337)),
         ((0.370, 0.467), (0.635, 0.447)), ((0.346, 0.665), (0.606, 0.627))]
LANDMARKS = window.PROPERTIES + 'ShapeLandmarks/Buttons/Pick'

w = journey.Journey('Correspondence')
w.open('FigureBSmall.vtp')
w.open('FigureASmall.vtp')
w.step('opened')
w.filter('Shape Landmarks')
w.choose_inputs(SurfaceB='FigureBSmall.vtp')
w.apply()
w.wait(300)
w.step('beside each other')
w.click('cameraToolbar/actionPositiveY')
w.event(LANDMARKS, 'set_boolean', 'true')
w.step('from the front')
for pair in PAIRS:
    for place in pair:
        w.drag([place])
w.key(window.ESCAPE)
w.step('landmarks picked')
w.python("made = GetActiveSource(); assert len(made.PointsA) == len(made.PointsB) == 15, list(made.PointsB)")

w.select('/0/1|0')
w.filter('Shape Correspondence')
w.choose_inputs(SurfaceB='FigureBSmall.vtp', Landmarks='ShapeLandmarks1: LandmarksA')
w.apply()
w.step('mapped')
w.python('''
    import shapemap
    maps = FindSource('ShapeCorrespondence1')
    assert shapemap.facts(maps)['Landmarks'] == 5
    colored = [GetDisplayProperties(OutputPort(maps, port)).ColorArrayName[1] for port in (0, 1)]
    assert all(colored), colored''')

w.select('/0/0|0')
w.event('menubar', 'activate', 'menuFilters')
w.event('menubar/menuFilters/Alphabetical', 'activate', 'Elevation')
w.apply()
w.step('a field of B')
w.select('/0/3/0|0')
w.filter('Shape Transfer Fields')
w.choose_inputs(Source='Elevation1')
w.apply()
w.step('transferred')
w.python('''
    transferred = GetActiveSource()
    assert GetDisplayProperties(transferred).ColorArrayName[1] == 'Elevation' ''')
w.run()
