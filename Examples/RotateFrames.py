"""Moves one end of a tube, and rotates frames at points of the other; the shape follows."""
import shapemap
from paraview.simple import *

# A barrel, open at both ends. They are the handle: part 0 is the longer one, at the bottom.
barrel = Sphere(Radius=1, ThetaResolution=48, PhiResolution=24, StartPhi=30, EndPhi=100)
deformed = ShapeDeform(Input=barrel)

# The upper end: a translation, a rotation by 30 degrees about the axis y, and a scale.
deformed.HandleMotions = [1, 0.6, 0, 0.3, 0, 30, 0, 0.8]
deformed.UpdatePipeline()
print('%d parts, the upper end is now at x = %.2f' % (
    shapemap.facts(deformed)['Parts'], deformed.GetDataInformation().GetBounds()[1]))

# The lower end: a frame is rotated about the axis y, and two frames hold the shape.
width = deformed[1].GetDataInformation().GetBounds()[1]
deformed.FrameRotations = [1, 0, -0.2, 0, 60, 0, 0, 1, -0.2, 0, 0, 0, 0, -1, -0.2, 0, 0, 0]
deformed.UpdatePipeline()
wider = deformed.GetDataInformation().GetBounds()[1]
print('handle up to x = %.2f, shape up to x = %.2f' % (width, wider))
assert shapemap.facts(deformed)['Parts'] == 2 and shapemap.facts(deformed)['Prepared'] == 0
assert wider > width
