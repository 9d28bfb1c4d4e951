"""Shows where two surfaces differ in area and in angles under a map between them."""
from paraview.simple import *

# A sphere, and the same sphere stretched along x.
stretch = '2*coordsX*iHat + coordsY*jHat + coordsZ*kHat'
sphere = Sphere(Radius=1.0, ThetaResolution=64, PhiResolution=64)
ellipsoid = Calculator(Input=sphere, CoordinateResults=1, Function=stretch)
mapped = Calculator(Input=sphere, ResultArrayName='TargetPosition', Function=stretch)

difference = ShapeMapDifference(SurfaceA=mapped, SurfaceB=ellipsoid)
difference.UpdatePipeline()

# Around x = 0 lengths along x are doubled, and so are areas. Circles become ellipses of 2 to 1,
# whose conformal difference is (2 + 1/2) / 2. The arrays are local means, at the resolution that
# NumberOfEigenpairs gives.
for name, exact in (('AreaDifference', 2.0), ('ConformalDifference', 1.25)):
    maximum = difference.PointData[name].GetRange()[1]
    print('%s: maximum %.3f, exactly %.2f' % (name, maximum, exact))
    assert abs(maximum / exact - 1.0) < 0.1
