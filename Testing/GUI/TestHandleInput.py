"""A handle lies on its filter's input as it is now, wherever that is, whatever else is seen, and in the view that
is active."""
import window

w = window.Window()
w.python('''
    import numpy
    import onsurface

    ball = Sphere(registrationName='Ball', ThetaResolution=64, PhiResolution=64, Radius=1.0)
    part = Threshold(registrationName='Part', Input=ball, Scalars=['POINTS', 'Normals'], ThresholdMethod='Between',
                     LowerThreshold=-2.0, UpperThreshold=2.0)
    shell = ExtractSurface(registrationName='Shell', Input=part)
    patch = ShapeExponentialMap(registrationName='Patch', Input=shell, Seed=[0, 0, 1], Radius=0.3)
    cut = ShapeCutFeature(registrationName='Cut', Input=shell,
                          LoopPoints=[0.4, 0, 0.9, 0, 0.4, 0.9, -0.4, 0, 0.9, 0, -0.4, 0.9])
    view = GetActiveViewOrCreate('RenderView')
    Show(patch, view)
    Render()

    def actors(balls):
        """What only the window draws: balls and knobs, or else rings, curves and marks."""
        every = [actor for renderer in view.GetRenderWindow().GetRenderers() for actor in renderer.GetActors()]
        lines = [actor for actor in every if actor.GetProperty().GetRenderPointsAsSpheres()]
        sources = [(actor, actor.GetMapper() and actor.GetMapper().GetInputAlgorithm()) for actor in every]
        return [actor for actor, source in sources if source and source.IsA('vtkSphereSource')] if balls else lines

    def check_radius(radius):
        """The handle is on the ball, which is round but for its facets."""
        place = actors(balls=True)[0].GetPosition()
        assert abs(numpy.linalg.norm(place) - radius) < 0.01 * radius, place

    def update(source, **properties):
        for name, value in properties.items():
            source.SetPropertyWithName(name, value)
        shell.UpdatePipeline()
        view.SMProxy.StillRender()

    SetActiveSource(patch)''')
w.wait(300)

# It goes with an input that changes, goes where there is none, and comes again.
w.python('check_radius(1.0); update(ball, Radius=1.5)')
w.wait(300)
w.python('check_radius(1.5); update(part, LowerThreshold=1.9)')
w.wait(300)
w.python('assert not actors(balls=True); update(part, LowerThreshold=-2.0)')
w.wait(300)
w.python('check_radius(1.5); update(ball, Radius=1.0)')
w.wait(300)
w.python('check_radius(1.0)')

# An animation that has kept what it shows says nothing when that comes again.
w.python('''
    settings = GetSettingsProxy('GeneralSettings')
    settings.CacheGeometryForAnimation = 1
    scene = GetAnimationScene()
    track = GetAnimationTrack('Radius', index=0, proxy=ball)
    track.KeyFrames = [CompositeKeyFrame(KeyTime=time, KeyValues=[1.0 + time]) for time in (0.0, 1.0)]''')
for time in (0.0, 1.0, 0.0, 1.0):
    w.python('scene.AnimationTime = %g' % time)
    w.wait(300)
    w.python('check_radius(1.0 + %g)' % time)
w.python('Delete(track); settings.CacheGeometryForAnimation = 0; update(ball, Radius=1.0)')
w.wait(300)

# A comparative view has no handle; the usual one has its handle back when it is active again.
w.python('''
    other = CreateView('ComparativeRenderView')
    AssignViewToLayout(other)
    SetActiveView(other)''')
w.wait(300)
w.python('assert not actors(balls=True); SetActiveView(view)')
w.wait(300)
w.python('check_radius(1.0); Delete(other)')
w.wait(300)

# The ball finds the surface where nothing of it is seen: the camera is set to show the patch alone.
w.python('''
    hidden = onsurface.Surface(shell)
    update(view, CameraPosition=[0, 0, 6], CameraFocalPoint=[0, 0, 0], CameraViewUp=[0, 1, 0], CameraViewAngle=25)
    width, height = view.ViewSize
    interactor = view.GetInteractor()

    def send(event, place):
        interactor.SetEventInformation(round(place[0] * width), round((1.0 - place[1]) * height))
        interactor.InvokeEvent(event)

    for event, place in (('MouseMove', (0.5, 0.5)), ('LeftButtonPress', (0.5, 0.5)), ('MouseMove', (0.65, 0.5)),
                         ('LeftButtonRelease', (0.65, 0.5))):
        send(event + 'Event', place)''')
w.wait(300)
w.python('hidden.check_under(patch.Seed, (0.65, 0.5)); update(ball, Radius=1.0)')

# The curve of a loop goes with the input, too.
w.python('SetActiveSource(cut); Show(cut, view)')
w.wait(300)
w.python('''
    def check_curve(radius):
        curve = actors(balls=False)[0].GetMapper().GetInput()
        radii = [numpy.linalg.norm(curve.GetPoint(i)) for i in range(12)]
        assert 12 < curve.GetNumberOfPoints() and numpy.allclose(radii[1:], radius, rtol=0.01), radii

    check_curve(1.0)
    update(ball, Radius=1.2)''')
w.wait(300)
w.python('check_curve(1.2)')

# Without a feature there is a handle for where it would go.
w.python('''
    SetActiveSource(None)  # or it would be the feature
    paste = ShapePasteFeature(registrationName='Paste', Target=shell)
    assert paste.Feature is None
    SetActiveSource(paste)''')
w.wait(300)
w.python('check_radius(1.2); Delete(paste)')
w.run()
