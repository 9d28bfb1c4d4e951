"""Packs an installation as a wheel, by the standard library alone: wheel.py ROOT BUILD PREFIX FOLDER"""
import base64
import glob
import hashlib
import os
import re
import subprocess
import sys
import sysconfig
import zipfile

root, build, prefix, folder = sys.argv[1:]
cache = dict(re.findall(r'^(\w+):\w+=(.*)$', open(os.path.join(build, 'CMakeCache.txt')).read(), re.MULTILINE))
package = os.path.join(prefix, 'lib', 'python3', 'dist-packages', 'shapemap')
libraries = [path for path in glob.glob(os.path.join(prefix, 'lib*', '**', 'libvtkShapeFilters.so.*'), recursive=True)
             if os.path.basename(path).endswith('.' + cache['CMAKE_PROJECT_VERSION'])]
assert len(libraries) == 1, libraries


def needed(path):
    """The names of the shared libraries that a file links."""
    printed = subprocess.run(['readelf', '-d', path], stdout=subprocess.PIPE, text=True, check=True).stdout
    return set(re.findall(r'\(NEEDED\).*\[(.+)\]', printed))


files = {'shapemap/' + os.path.basename(path): path
         for path in glob.glob(os.path.join(package, '*')) if os.path.isfile(path)}
# Those that call OpenCASCADE, OpenCV and ITK lie beside the filters'.
for path in libraries + glob.glob(os.path.join(os.path.dirname(libraries[0]), 'libshape_[cin]*.so')):
    files['shapemap/' + os.path.basename(path)] = path
linked = set().union(*(needed(path) for path in files.values() if '.so' in path))
linked -= {os.path.basename(path) for path in files}
# libvtkCommonCore-pv5.11.so.1 is ParaView's, libvtkCommonCore-9.1.so.1 plain VTK's.
suffix = next(re.match(r'libvtkCommonCore-(.+)\.so', name).group(1)
              for name in linked if name.startswith('libvtkCommonCore-'))
of_paraview = suffix.startswith('pv')
version = '%s+%s' % (cache['CMAKE_PROJECT_VERSION'], suffix if of_paraview else 'vtk' + suffix)
tag = 'cp{0}-cp{0}-{1}'.format(sysconfig.get_config_var('py_version_nodot'),
                               re.sub('[-.]', '_', sysconfig.get_platform()))
licences = ['BSD-3-Clause'] + [licence for option, licence in (
    ('SHAPEMAP_CHOLMOD', 'GPL-2.0-or-later'), ('SHAPEMAP_TETGEN', 'AGPL-3.0-or-later')) if cache[option] == 'ON']

metadata = '''Metadata-Version: 2.1
Name: shapemap
Version: %s
Summary: Which point of one shape corresponds to which point of another: VTK filters as Python functions
License: %s
License-File: LICENSE
Platform: linux
Classifier: Programming Language :: Python :: 3
Classifier: Topic :: Scientific/Engineering
Classifier: Typing :: Typed
Requires-Python: %s
Requires-Dist: numpy
%sDescription-Content-Type: text/plain

Made for the VTK of Debian's package %s, and links to the libraries above.

ShapeMap itself is under the BSD 3-Clause licence.%s%s
''' % (version, ' AND '.join(licences), '==%s.*' % sysconfig.get_python_version(),
       ''.join('Requires-External: %s\n' % name for name in sorted(linked)),
       'python3-paraview' if of_paraview else 'python3-vtk9',
       ' Linking CHOLMOD puts this binary under GPL 2 or newer.' if 'GPL-2.0-or-later' in licences else '',
       ' Linking TetGen puts it under AGPL 3 or newer.' if 'AGPL-3.0-or-later' in licences else '')
info = 'shapemap-%s.dist-info/' % version
contents = {name: (open(path, 'rb').read(), os.access(path, os.X_OK)) for name, path in sorted(files.items())}
contents[info + 'LICENSE'] = open(os.path.join(root, 'LICENSE'), 'rb').read(), False
contents[info + 'METADATA'] = metadata.encode(), False
contents[info + 'entry_points.txt'] = b'[console_scripts]\nshapemap = shapemap.__main__:main\n', False
contents[info + 'WHEEL'] = ('Wheel-Version: 1.0\nGenerator: ShapeMap\nRoot-Is-Purelib: false\nTag: %s\n' % tag).encode(), False
record = ['%s,sha256=%s,%d' % (
    name, base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b'=').decode(), len(data))
    for name, (data, _) in contents.items()] + [info + 'RECORD,,']
contents[info + 'RECORD'] = '\n'.join(record + ['']).encode(), False

os.makedirs(folder, exist_ok=True)
wheel = os.path.join(folder, 'shapemap-%s-%s.whl' % (version, tag))
with zipfile.ZipFile(wheel, 'w', zipfile.ZIP_DEFLATED) as archive:
    for name, (data, executable) in contents.items():
        # The same files give the same wheel.
        entry = zipfile.ZipInfo(name, (2020, 1, 1, 0, 0, 0))
        entry.external_attr = (0o100755 if executable else 0o100644) << 16
        entry.compress_type = zipfile.ZIP_DEFLATED
        archive.writestr(entry, data)
print('%s: %.1f MB, %.1f MB installed' % (
    wheel, os.path.getsize(wheel) / 1e6, sum(len(data) for data, _ in contents.values()) / 1e6))
