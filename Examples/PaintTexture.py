"""Paints a texture on a surface around a point by the exponential map, and saves a picture."""
import os
import sys

import numpy
import shapemap
from paraview.simple import *

folder = sys.argv[1] if len(sys.argv) > 1 else '.'
data = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'Data', '')

surface = OpenDataFile(data + 'PhantomHeadSmall.vtp')
patch = ShapeExponentialMap(Input=surface, Seed=[0.0, 0.3, 1.1], Radius=0.7)
patch.UpdatePipeline()
flipped = shapemap.facts(patch)['Flipped']
coverage = shapemap.facts(patch)['Coverage']
print('%d triangles, %d flipped, %.0f %% of the texture used' % (
    patch.GetDataInformation().GetNumberOfCells(), flipped, 100 * coverage))
assert flipped == 0 and 0.8 < coverage <= 1.0

# Any picture can be the texture. This one is a checkerboard.
checks = numpy.kron(numpy.indices((16, 16)).sum(axis=0) % 2, numpy.ones((8, 8)))
picture = os.path.join(folder, 'Checks.ppm')
with open(picture, 'wb') as file:
    file.write(b'P6\n128 128\n255\n')
    file.write(numpy.repeat(55 + 200 * checks, 3).astype(numpy.uint8).tobytes())

view = CreateView('RenderView')
Show(surface, view).Representation = 'Surface'
shown = Show(patch, view)
shown.Texture = CreateTexture(picture)
shown.Position = [0.0, 0.0, 0.005]  # above the surface
ResetCamera(view)
SaveScreenshot(os.path.join(folder, 'Textured.png'), view, ImageResolution=[600, 600])
