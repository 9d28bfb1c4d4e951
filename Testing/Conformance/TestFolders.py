"""The order of the house. Plugin uses Filters/VTK, which uses Filters/Kernels. A room (a folder of
kernels) includes only rooms before it, and files include each other without circles. A header in
Private/ is included from its own room alone; one beside Private/ by another room, by the filters or
by the room's own headers. Only the files named here include VTK, TetGen, OpenCL, OpenCV, ITK or OpenCASCADE. Every filter and
writer has all its parts. Run with python3 TestFolders.py ROOT."""
import collections
import os
import re
import sys

ORDER = [
    'Base', 'Linear', 'Mesh', 'Search', 'Geometry', 'Labels', 'Solids', 'Distance', 'Planar', 'Quality',
    'Laplacian', 'Distortion', 'Geodesics', 'Spectrum', 'Network', 'Remesh', 'Skeleton', 'Parameterize', 'ExponentialMap', 'Transfer', 'Materials',
    'Correspondence/Pair', 'Correspondence/Landmarks', 'Correspondence/Functional',
    'Correspondence/Transport', 'Correspondence/Conformal', 'Correspondence/CommonBase', 'Correspondence/Averages',
    'Correspondence/Reversible', 'Correspondence/Evaluate', 'Correspondence', 'Correspondence/Consistent',
    'Fmm', 'Tetrahedra', 'Untangle', 'Harmonic', 'Cage',
    'Hex/Voxels', 'Hex/Features', 'Hex/Optimize', 'Hex/Fit', 'Hex/Grid', 'Hex/Polycube', 'Hex', 'Atlas',
    'Deform', 'Fill', 'Solidify', 'CutPaste', 'IO']
# The fast multipole method is a library of its own.
LIBRARIES = {'Base': [], 'Linear': ['Base'], 'Fmm': ['Base', 'Linear']}
USE_VTK = ['Geometry/Private/QuadricSampling.cxx', 'Search/CellLocator.cxx', 'Search/Private/CellInterpolation.cxx',
           'Solids/IsoSurface.cxx']
USE_TETGEN = ['Tetrahedra/Private/TetGen.cxx']
USE_OPENCL = ['Kernels/Fmm/Private/OpenCLSum.cxx']
USE_OPENCV = ['Kernels/Network/Private/NetworkLibrary.cxx']
USE_ITK = ['Kernels/IO/Private/ImageLibrary.cxx']
USE_OCCT = ['Kernels/IO/Private/CascadeFile.cxx', 'Kernels/IO/Private/CascadeFile.h',
            'Kernels/IO/Private/CascadeLibrary.cxx', 'Kernels/IO/TestCADReader.cxx']
# No mathematics, or one line in the wrapper, which its header states: no kernel.
WITHOUT_KERNEL = ['vtkShapeExample']
# Base classes, whose XML holds what the others inherit.
BASES = ['vtkShapeAlgorithm', 'vtkShapeDeformingAlgorithm', 'vtkShapeReader', 'vtkShapeWriter']
OCCT = re.compile(r'(BRep|TopoDS|STEPControl|IGESControl)\w*\.hxx')
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)

root = sys.argv[1]
faults = []


def sources(*folder):
    """The paths of the C++ files below a folder, from there, and what each includes."""
    top = os.path.join(root, *folder)
    for path, _, names in os.walk(top):
        for name in sorted(names):
            if name.endswith(('.h', '.cxx')):
                whole = os.path.join(path, name)
                yield os.path.relpath(whole, top), INCLUDE.findall(open(whole).read())


def room(path):
    folder = os.path.dirname(path)
    return folder[:-len('/Private')] if folder.endswith('/Private') else folder


kernels = dict(sources('Filters', 'Kernels'))
users = collections.defaultdict(set)  # of a kernel's header: who includes it
for path, includes in kernels.items():
    if room(path) not in ORDER:
        faults.append('%s: there is no room %s in the order' % (path, room(path)))
        continue
    for include in includes:
        if include in kernels:
            users[include].add(path)
            if ORDER.index(room(include)) > ORDER.index(room(path)):
                faults.append('%s includes %s, which comes after it' % (path, include))
            library = LIBRARIES.get(room(path))
            if library is not None and room(include) not in library + [room(path)]:
                faults.append('%s includes %s: it is in another library' % (path, include))
        elif os.path.basename(include).startswith('vtk') and path not in USE_VTK:
            faults.append('%s includes %s: only %s may' % (path, include, ', '.join(USE_VTK)))
filters = dict(sources('Filters', 'VTK'))
for path, includes in filters.items():
    for include in includes:
        if include in kernels:
            users[include].add(None)
        if re.match('pq|Q(t|[A-Z])|vtkSM|vtkPV', include):
            faults.append('%s includes %s: Qt and ParaView belong to Plugin/' % (path, include))
for path, includes in sources('Plugin'):
    for include in includes:
        if include in kernels:
            faults.append('%s includes the kernel %s: drive a filter instead' % (path, include))
for part in ('Filters', 'Plugin', 'Testing'):
    for path, includes in sources(part):
        if ('tetgen.h' in includes) != (path in ['Kernels/' + use for use in USE_TETGEN]):
            faults.append('%s: %s, and no other file, includes tetgen.h' % (path, USE_TETGEN))
        if ('CL/opencl.hpp' in includes) != (path in USE_OPENCL):
            faults.append('%s: %s, and no other file, includes OpenCL' % (path, USE_OPENCL))
        if ('opencv2/dnn.hpp' in includes) != (path in USE_OPENCV):
            faults.append('%s: %s, and no other file, includes OpenCV' % (path, USE_OPENCV))
        if any(re.match(r'itk\w*\.h', include) for include in includes) != (path in USE_ITK):
            faults.append('%s: %s, and no other file, includes ITK' % (path, USE_ITK))
        if any(OCCT.match(include) for include in includes) != (path in USE_OCCT):
            faults.append('%s: %s, and no other file, includes OpenCASCADE' % (path, USE_OCCT))

for header in (path for path in kernels if path.endswith('.h')):
    private = '/Private/' in header
    outside = any(user is None or room(user) != room(header) for user in users[header])
    shown_by = [user for user in users[header] if user is not None and user.endswith('.h') and
                '/Private/' not in user]
    if private and shown_by:
        faults.append('%s is private, and %s shows it to others' % (header, shown_by[0]))
    if private and outside:
        faults.append('%s is private, and used outside of its room' % header)
    if not private and not outside and not shown_by:
        faults.append('%s is used in its room alone: it belongs to Private/' % header)

# Of the inline functions of two classes with one name, such as their destructors, the linker keeps only one.
owners = collections.defaultdict(set)
for path in (path for path in kernels if path.endswith('.h')):
    text = open(os.path.join(root, 'Filters', 'Kernels', path)).read()
    for name in re.findall(r'^(?:struct|class) (\w+)(?: final)?(?: *:[^;{]*)?\s*\{', text, re.MULTILINE):
        owners[name].add(path)
for name, where in owners.items():
    if len(where) > 1:
        faults.append('%s is a class in %s: give them different names' % (name, ' and in '.join(sorted(where))))

# A unit is a header with its source: no circle of units.
units = collections.defaultdict(set)
for path, includes in kernels.items():
    units[path.rsplit('.', 1)[0]] |= {include[:-2] for include in includes if include in kernels}
done, open_units = set(), []


def visit(unit):
    if unit in open_units:
        faults.append('a circle: ' + ' -> '.join(open_units[open_units.index(unit):] + [unit]))
    elif unit not in done:
        open_units.append(unit)
        for other in sorted(units[unit] - {unit}):
            visit(other)
        open_units.pop()
        done.add(unit)


for unit in sorted(units):
    visit(unit)

names = {os.path.basename(path)[:-4]: os.path.dirname(path) for path in filters
         if path.endswith('.cxx')}
described = [name for name in names if name not in BASES and os.path.exists(
    os.path.join(root, 'Filters', 'VTK', names[name], name + '.xml'))]
tests = {os.path.basename(path): room(path) for path, _ in sources('Testing', 'Kernels')}
rooms = {os.path.basename(path): room(path) for path in kernels}
for name in described:
    subject = name[len('vtkShape'):]
    if not os.path.exists(os.path.join(root, 'Testing/Filters/TestShape%s.py' % subject)):
        faults.append('%s has no Testing/Filters/TestShape%s.py' % (name, subject))
    if name not in WITHOUT_KERNEL:
        for part in (subject + '.h', subject + '.cxx'):
            if part not in rooms:
                faults.append('%s has no kernel %s' % (name, part))
            elif rooms[part].split('/')[0] != names[name]:
                faults.append('%s and its kernel %s are in different rooms' % (name, part))
        if 'Test%s.cxx' % subject not in tests:
            faults.append('%s has no kernel test Test%s.cxx' % (name, subject))
for test, place in tests.items():
    unit = test[len('Test'):]
    if test.startswith('Test') and rooms.get(unit, place) != place:
        faults.append('%s is in Testing/Kernels/%s, and what it tests in %s' % (
            test, place, rooms[unit]))

assert kernels and described, 'nothing was found below ' + root
if faults:
    raise AssertionError('\n'.join(faults))
print(len(kernels), 'kernel files in', len(ORDER), 'rooms and', len(described),
      'filters and writers keep the order')
