"""The plugin is there by itself: pvpython.py [server]"""
import subprocess
import sys

from paraview.simple import *

if len(sys.argv) > 1:
    # It ends with its client.
    process = subprocess.Popen(['pvserver', '--server-port=11222'], stdout=subprocess.PIPE, text=True)
    while 'Accepting connection' not in process.stdout.readline():
        assert process.poll() is None, 'the server ended'
    Connect('localhost', 11222)
sphere = ShapeParameterize(Input=Sphere(ThetaResolution=16))
sphere.UpdatePipeline()
low, high = OutputPort(sphere, 1).GetDataInformation().GetBounds()[:2]
assert 1.9 < high - low <= 2.0, (low, high)
print('Shape Parameterize ran', flush=True)
