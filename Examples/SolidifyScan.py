"""Turns a scan with holes, cracks and debris into the closed surface of a solid, and says what was done."""
import os
import sys

import shapemap
from paraview.simple import *

folder = sys.argv[1] if len(sys.argv) > 1 else '.'

# A dome without a bottom, whose triangles are not connected, and a small ball beside it.
# Your own: OpenDataFile('scan.stl').
dome = Shrink(Input=Sphere(ThetaResolution=40, PhiResolution=40, EndPhi=120.0), ShrinkFactor=1.0)
debris = Sphere(Radius=0.01, Center=[1.0, 0.0, 0.0])
scan = AppendDatasets(Input=[dome, debris])

# Look at the defects first: the second output has a point at each of them.
report = ShapeSolidify(Input=scan, Method='Report')
report.UpdatePipeline()
found = shapemap.facts(report)
print('%d points of several triangles, %d open loop(s), %d piece(s)' % (
    found['DuplicatePoints'], found['OpenLoops'], found['PiecesBefore']))

solid = ShapeSolidify(Input=scan, SmallestPiece=0.05)
solid.UpdatePipeline()
done = shapemap.facts(solid)
print('%d triangles kept, %d new, in %d gap(s)' % (done['Kept'], done['Made'], done['GapsClosed']))
assert done['GapsClosed'] == 1 and done['RemovedPieces'] == 1
assert done['Pieces'] == 1 and done['EulerNumber'] == 2

# A right surface is returned bit for bit.
again = ShapeSolidify(Input=solid)
again.UpdatePipeline()
assert shapemap.facts(again)['Defects'] == 0
SaveData(os.path.join(folder, 'Solid.stl'), solid)
