"""Gives the hexahedra of a bar materials from a CT-like image, and bends it with CalculiX."""
import os
import subprocess
import sys

import shapemap
from paraview.simple import *

folder = sys.argv[1] if len(sys.argv) > 1 else '.'

# A bar of 10 x 2 x 2 mm that is denser at its skin. Your own scan: OpenDataFile('scan.nrrd').
bar = Clean(Input=Box(XLength=10.0, YLength=2.0, ZLength=2.0, Center=[5.0, 0.0, 0.0]))
solid = ShapeHexRemesh(Surface=bar, CellSize=0.5)
grid = ResampleToImage(Input=bar, UseInputBounds=0, SamplingBounds=[-1, 11, -2, 2, -2, 2], SamplingDimensions=[61, 41, 41])
scan = Calculator(Input=grid, ResultArrayName='HU', Function='600 + 500 * max(abs(coordsY), abs(coordsZ))')
bone = ShapeImageValues(Input=solid, Image=scan, ImageArray='HU', Density='0.01 + 0.001 * HU', Materials=10)
SaveData(os.path.join(folder, 'Bone.inp'), bone, DensityScale=1e-9)
facts = shapemap.facts(bone)
print('%d materials, mass %.3f mg' % (facts['Materials'], facts['Mass']))

# The mean of the larger of |y| and |z| over a square of half side 1 is 2/3.
assert abs(facts['Mass'] / 40.0 - (0.61 + 0.5 * 2.0 / 3.0)) < 0.005

# The file has the materials and their sections; the deck adds a support and gravity.
text = open(os.path.join(folder, 'Bone.inp')).read()
nodes = [line.split(', ') for line in text.split('*ELEMENT')[0].splitlines() if line[0].isdigit()]
end = [node for node, x, *_ in nodes if float(x) < 1e-6]
deck = '*INCLUDE, INPUT=Bone.inp\n*NSET, NSET=End\n%s\n*BOUNDARY\nEnd, 1, 3\n*STEP\n*STATIC\n*DLOAD\n%s' % (
    ',\n'.join(end), 'Region0, GRAV, 9810., 0., 0., -1.\n*NODE FILE\nU\n*END STEP\n')
open(os.path.join(folder, 'Bend.inp'), 'w').write(deck)
run = subprocess.run(['ccx', 'Bend'], cwd=folder, stdout=subprocess.PIPE, text=True)
assert 'Job finished' in run.stdout and 'ERROR' not in run.stdout, run.stdout[-2000:]
