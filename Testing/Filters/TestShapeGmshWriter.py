"""Shape Gmsh Writer: Gmsh reads the same mesh, with its named groups, from the files.

As an example: a bar of two materials is saved with the patches of its boundary."""
import os
import subprocess
import tempfile

import numpy
from paraview import simple
from paraview.modules.vtkRemotingServerManager import vtkSMProxyManager

import calculix
import gmsh_reader

folder = tempfile.mkdtemp()

# The example.
places, corners, materials = calculix.bent_bar()
source = simple.TrivialProducer()
source.GetClientSideObject().SetOutput(calculix.hexahedra(places, corners, materials))
path = os.path.join(folder, 'bar.msh')
simple.SaveData(path, source, FeatureAngle=45)
listed = vtkSMProxyManager.GetProxyManager().GetWriterFactory().GetSupportedFileTypes(source.SMProxy, 0)
assert 'Gmsh mesh(*.msh )' in listed, listed

# Gmsh keeps the numbers of nodes; in its old format it writes 16 digits.
found, elements = gmsh_reader.read(path)
assert abs(found - places).max() < 1e-15
assert set(elements) == {3, 5}
hexahedra, regions = elements[5]
order = numpy.argsort(numpy.concatenate([numpy.flatnonzero(materials == m) for m in (0, 1)]))
assert (hexahedra[order] == corners).all() and (regions[order] == materials + 1).all()
quads, patches = elements[3]
assert sorted(numpy.bincount(patches)[1:]) == [6, 6, 6, 12, 12, 18, 18], 'six patches and the interface'
volume = gmsh_reader.volume(source.GetClientSideObject().GetOutputDataObject(0))
a, b, c, d = found[quads[patches <= 6]].transpose(1, 0, 2)
enclosed = sum((numpy.cross(p - a, q - a) * a).sum() for p, q in ((b, c), (c, d))) / 6.0
assert abs(enclosed - volume) < 1e-2 * volume, 'the boundary faces outwards'

# The groups have names; Gmsh's own check finds nothing wrong.
names = open(path).read().split('$PhysicalNames\n')[1].split('\n$End')[0].splitlines()[1:]
assert names == ['2 %d "Patch%d"' % (n + 1, n) for n in range(6)] + [
    '2 7 "Interface0_1"', '3 1 "Region0"', '3 2 "Region1"'], names
check = subprocess.run(['gmsh', path, '-check', '-0'], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
assert check.returncode == 0 and 'Error' not in check.stdout and 'Warning' not in check.stdout, check.stdout
print('Gmsh reads the nodes, hexahedra, quadrilaterals and groups that were written')
