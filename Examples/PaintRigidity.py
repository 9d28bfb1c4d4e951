"""Paints a stiff part onto a sheet, and bends the sheet: the stiff part keeps its shape."""
from paraview.simple import *

plane = Plane(Origin=[-1, -1, 0], Point1=[1, -1, 0], Point2=[-1, 1, 0], XResolution=60, YResolution=60)
border = FeatureEdges(Input=plane, BoundaryEdges=1, FeatureEdges=0, NonManifoldEdges=0, ManifoldEdges=0)
old = Calculator(Input=border, ResultArrayName='SourcePosition', Function='coords')
saddle = Calculator(Input=old, CoordinateResults=1, Function='coords + 0.4*(coordsX^2 - coordsY^2)*kHat')

# One stroke along a line. It has a mode (0: Set), radius, strength, value and the number of its points.
path = [value for k in range(41) for value in (-0.5 + k / 40, 0.4, 0.0)]
painted = ShapePaintArray(Input=plane, ArrayName='Rigidity', InitialValue=1.0,
                          Strokes=[0, 0.4, 1.0, 8.0, 41], StrokePoints=path)
painted.UpdatePipeline()
print('Rigidity from %g to %g' % painted.PointData['Rigidity'].GetRange())
low, high = painted.PointData['Rigidity'].GetRange()
assert low == 1.0 and 7.9 < high <= 8.0

# How much the stiff part is bent: the difference of heights within it.
bends = []
for name in ('None', 'Rigidity'):
    bent = ShapeDeform(Input=painted, Boundary=saddle, RigidityArray=name)
    stiff = Threshold(Input=bent, Scalars=['POINTS', 'Rigidity'], LowerThreshold=6.0, UpperThreshold=8.0,
                      ThresholdMethod='Between')
    stiff.UpdatePipeline()
    low, high = stiff.GetDataInformation().GetBounds()[4:]
    bends.append(high - low)
    print('Rigidity Array %s: the stiff part rises by %.4f' % (name, bends[-1]))
assert bends[1] < 0.9 * bends[0]
