"""Maps a head onto another one without landmarks, and carries the brain inside along."""
import os
import sys

import shapemap
from paraview.simple import *

folder = sys.argv[1] if len(sys.argv) > 1 else '.'
data = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'Data', '')

# The second head is wider and asymmetric.
head = PassArrays(Input=OpenDataFile(data + 'PhantomHeadSmall.vtp'))
brain = PassArrays(Input=OpenDataFile(data + 'PhantomBrainSmall.vtp'))
other = Calculator(Input=head, CoordinateResults=1, Function=(
    'iHat*1.2*coordsX + jHat*(coordsY+0.15*coordsX*coordsX) + kHat*coordsZ*(1+0.1*coordsX)'))

registered = ShapeRegisterVolume(Input=head, Target=other)
registered.UpdatePipeline()
facts = shapemap.facts(registered)
print('mean distance: %g before, %g after; distortion: %g' % tuple(
    facts[name] for name in ('MeanDistanceBefore', 'MeanDistanceAfter', 'DistortionAfter')))
assert facts['MeanDistanceAfter'] < 0.1 * facts['MeanDistanceBefore']
SaveData(os.path.join(folder, 'solid.vtu'), OutputPort(registered, 1), DataMode='Binary')

# Any other data inside go along by the harmonic map of the images.
moved = ShapeHarmonicVolumeMap(Domain=brain, Boundary=registered)
SaveData(os.path.join(folder, 'brain.vtp'), moved, DataMode='Binary')
