"""Morphs one figure into another along a map, and saves the frames of the animation."""
import os
import sys

from paraview.simple import *

folder = sys.argv[1] if len(sys.argv) > 1 else '.'
data = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'Data', '')

# TargetPosition of the figure is the image of each point. Time runs from 0 to 1.
figure = OpenDataFile(data + 'FigureASmall.vtp')
morph = ShapeMorph(Input=figure)

view = CreateView('RenderView')
view.ViewSize = [300, 300]
Show(morph, view)
view.ResetActiveCameraToPositiveY()
ResetCamera(view)
scene = GetAnimationScene()
scene.UpdateAnimationUsingDataTimeSteps()
scene.PlayMode = 'Sequence'
scene.NumberOfFrames = 5
SaveAnimation(os.path.join(folder, 'Morph.png'), view)

for frame in range(5):
    path = os.path.join(folder, 'Morph.%04d.png' % frame)
    morph.UpdatePipeline(time=frame / 4)
    bounds = morph.GetDataInformation().GetBounds()
    print('%s: the figure is %.3f wide' % (os.path.basename(path), bounds[1] - bounds[0]))
    assert os.path.getsize(path) > 0
