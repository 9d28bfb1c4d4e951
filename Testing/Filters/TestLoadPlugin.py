"""LoadPlugin in a pvpython that finds neither the plugin nor the package by itself makes the filters and the
package shapemap available, without a message."""
import os
import subprocess
import sys
import tempfile

SCRIPT = '''
from paraview.simple import *
LoadPlugin(%r, ns=globals())
made = ShapeParameterize(Input=Sphere())
made.UpdatePipeline()
assert made.PointData.GetArray('TargetPosition').GetNumberOfComponents() == 3
import shapemap, shapemap.views
assert shapemap.vtkShapeMorph().GetClassName() == 'vtkShapeMorph'
print('loaded')
'''
folder = os.environ['PV_PLUGIN_PATH'].split(os.pathsep)[0]
environment = {name: value for name, value in os.environ.items() if name not in ('PV_PLUGIN_PATH', 'PYTHONPATH')}
with tempfile.NamedTemporaryFile('w', suffix='.py') as script:
    script.write(SCRIPT % os.path.join(folder, 'ShapeMap.so'))
    script.flush()
    done = subprocess.run(['pvpython', script.name], env=environment, capture_output=True, text=True)
assert done.returncode == 0 and done.stdout == 'loaded\n' and not done.stderr, done
