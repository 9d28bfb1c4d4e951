"""Maps a head onto a ball in layers: skull and brain meet their targets as the surface does."""
import os

import shapemap
from paraview.simple import *

data = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'Data', 'Phantom%sSmall.vtp')

# TargetPosition maps the three surfaces to the unit sphere, a polycube and a cube.
head, skull, brain = (OpenDataFile(data % name) for name in ('Head', 'Skull', 'Brain'))
mapped = ShapeHarmonicVolumeMap(Domain=brain, Boundary=head, MapArray='TargetPosition',
                                Features=[skull, brain], Exact=1, Tolerance=1e-3)
mapped.UpdatePipeline()
errors = shapemap.facts(mapped)['BorderRMSEVertices']
for name, error in zip(('head', 'skull', 'brain'), errors):
    print('%s: error %.2f %% of the size' % (name, 100 * error))
    assert error < 0.03
