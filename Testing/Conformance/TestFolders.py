"""The order of the house: Plugin -> Filters/VTK -> Filters/Kernels, and inside the kernels a folder
includes only folders before it. Only Geometry's .cxx files include VTK. Every filter and
writer has all its parts. Run with python3 TestFolders.py ROOT."""
import os
import re
import sys

ORDER = ['Core', 'Geometry', 'Quality', 'Surface', 'Mapping', 'Correspondence', 'Volume', 'Hex',
         'Deform']
# Filters whose mathematics is one line of the wrapper, which its header states: no kernel.
WITHOUT_KERNEL = ['vtkShapeMorph']
# Base classes, whose XML holds what the others inherit.
BASES = ['vtkShapeAlgorithm', 'vtkShapeDeformingAlgorithm', 'vtkShapeWriter']
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)

root = sys.argv[1]
kernels = os.path.join(root, 'Filters', 'Kernels')
wrappers = os.path.join(root, 'Filters', 'VTK')
faults = []
seen = 0


def sources(folder):
    for path, _, names in os.walk(folder):
        for name in names:
            if name.endswith(('.h', '.cxx')):
                yield os.path.join(path, name)


for path in sources(kernels):
    seen += 1
    folder = os.path.relpath(path, kernels).split(os.sep)[0]
    if folder not in ORDER:
        faults.append('%s: there is no folder %s in the order' % (path, folder))
        continue
    for include in INCLUDE.findall(open(path).read()):
        first = include.split('/')[0]
        if first in ORDER and ORDER.index(first) > ORDER.index(folder):
            faults.append('%s includes %s, which comes after it' % (path, include))
        if os.path.basename(include).startswith('vtk') and not (
                folder == 'Geometry' and path.endswith('.cxx')):
            faults.append('%s includes %s: only Geometry/*.cxx may' % (path, include))

for path in sources(os.path.join(root, 'Filters', 'VTK')):
    for include in INCLUDE.findall(open(path).read()):
        if re.match('pq|Q(t|[A-Z])|vtkSM|vtkPV', include):
            faults.append('%s includes %s: Qt and ParaView belong to Plugin/' % (path, include))
for path in sources(os.path.join(root, 'Plugin')):
    for include in INCLUDE.findall(open(path).read()):
        if include.split('/')[0] in ORDER:
            faults.append('%s includes the kernel %s: drive a filter instead' % (path, include))

tetgen = os.path.join(kernels, 'Volume', 'TetGen.cxx')
for part in ('Filters', 'Plugin', 'Testing'):
    for path in sources(os.path.join(root, part)):
        if ('tetgen.h' in INCLUDE.findall(open(path).read())) != (path == tetgen):
            faults.append('%s: Volume/TetGen.cxx, and no other file, includes tetgen.h' % path)

headers = {os.path.basename(path) for path in sources(kernels)}
filters = [name[:-4] for name in sorted(os.listdir(wrappers))
           if name.endswith('.xml') and name[:-4] not in BASES]
for name in filters:
    kernel = name[len('vtkShape'):]
    parts = [('Filters/VTK/%s.h' % name, None), ('Filters/VTK/%s.cxx' % name, None),
             ('Testing/Filters/TestShape%s.py' % kernel, None)]
    if name not in WITHOUT_KERNEL:
        parts += [('Filters/Kernels/*/%s.h' % kernel, kernel + '.h' in headers),
                  ('Filters/Kernels/*/%s.cxx' % kernel, kernel + '.cxx' in headers),
                  ('Testing/Kernels/Test%s.cxx' % kernel, None)]
    for part, there in parts:
        if not (os.path.exists(os.path.join(root, part)) if there is None else there):
            faults.append('%s has no %s' % (name, part))

assert seen > 0 and filters, 'nothing was found below ' + root
if faults:
    raise AssertionError('\n'.join(faults))
print(seen, 'kernel files and', len(filters), 'filters and writers keep the order')
