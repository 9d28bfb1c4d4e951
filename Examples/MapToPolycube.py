"""Maps a surface onto a polycube, whose grid then fills the solid with hexahedra."""
import shapemap
from paraview.simple import *

ellipsoid = Transform(Input=Sphere(ThetaResolution=40, PhiResolution=40))
ellipsoid.Transform.Scale = [2.0, 1.0, 1.0]

# Output 0 is the surface with TargetPosition and Label, the direction of the polycube's face for each
# triangle. Output 1 is the polycube, whose faces lie at multiples of TargetEdgeLength.
polycube = ShapePolycube(Input=ellipsoid, TargetEdgeLength=0.15)
polycube.UpdatePipeline()
charts = shapemap.facts(polycube)['Charts']
distortion = shapemap.facts(polycube)['Distortion']
print('%d charts, distortion %.2f (1 is none)' % (charts, distortion))
assert charts >= 6 and distortion >= 1.0

hexahedra = ShapeHexRemesh(Surface=ellipsoid, Polycube=OutputPort(polycube, 1), CellSize=0.15)
hexahedra.UpdatePipeline()
minimum, maximum = hexahedra.CellData['ScaledJacobian'].GetRange()
print('%d hexahedra, scaled Jacobian %.2f to %.2f' % (
    hexahedra.GetDataInformation().GetNumberOfCells(), minimum, maximum))
assert minimum > 0.0
