"""Proves that a volume map folds nowhere, and shows how large the parts are that another one inverts."""
import os
import sys

import shapemap
from paraview.simple import *

folder = sys.argv[1] if len(sys.argv) > 1 else '.'
data = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'Data', '')

# The map of a dented ball onto the unit ball, as it was stored: every part is certified.
stored = OpenDataFile(data + 'DentedSphereCharges.vtp')
certificate = ShapeCertificate(Map=stored)
certificate.UpdatePipeline()
facts = shapemap.facts(certificate)
print('certified: %g, one to one: %d' % (facts['Certified'], facts['Bijective']))
assert facts['Bijective'] == 1

# The map of the unit ball onto a horse folds in small parts.
ball = OutputPort(ShapeParameterize(Input=OpenDataFile(data + 'HorseSmall.vtp')), 1)
solid = ShapeHarmonicVolumeMap(Domain=ball, Boundary=ball, MapArray='SourcePosition')
certificate = ShapeCertificate(Map=OutputPort(solid, 1), Tolerance=1.0 / 256.0)
certificate.UpdatePipeline()
facts = shapemap.facts(certificate)
print('certified: %g, undecided: %g, inverted: at most %g' % tuple(
    facts[name] for name in ('Certified', 'Undecided', 'Inverted')))
assert facts['Certified'] > 0.95
SaveData(os.path.join(folder, 'boxes.vtu'), certificate, DataMode='Binary')
SaveData(os.path.join(folder, 'witnesses.vtp'), OutputPort(certificate, 1), DataMode='Binary')
