"""Shape Label Surfaces and Shape Tetrahedralize on images of CGAL's demonstrations: the labels of a liver
and the grey values of a skull, beside CGAL's mesher of label images.

    Utilities/pvpython.sh Testing/Benchmarks/LabelImages.py F [--images FOLDER] [--whole]

The images are in data.tar.gz of libcgal-dev (data/images); --images names the folder with liver.inr.gz and
skull_2.9.inr. F receives the images and meshes. Every second or fourth voxel of the liver is used, so that voxels
are nearly cubes; --whole adds the surfaces of all of its voxels.

Topology: the components and the Euler number of each region's surface against those of the voxels, counted
in the cells between neighbouring samples. In such a cell, samples of a region are connected along its
edges; and along the diagonal of a face, if the other two have different labels, or if the region is not the
outside and has the lower label of two regions. Distances are those of the corners of interface triangles from the
faces between voxels of different labels, divided by the mean spacing: exact flat interfaces have about a
quarter. Seconds are CPU seconds."""
import gzip
import os
import resource
import time

import numpy
from scipy import ndimage, spatial
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
import shapemap

import sweep

TYPES = {('unsigned fixed', 8): numpy.uint8, ('float', 32): numpy.float32}


def read_image(path):
    """The values of an INRIMAGE file by k, j, i, and the spacings. The header ends with '##}' at a multiple
    of 256 bytes."""
    with (gzip.open if path.endswith('.gz') else open)(path, 'rb') as file:
        content = file.read()
    size = (content.index(b'##}') // 256 + 1) * 256
    entries = dict(line.split('=', 1) for line in content[:size].decode('latin-1').splitlines() if '=' in line)
    kind = TYPES[entries['TYPE'], int(entries['PIXSIZE'].split()[0])]
    shape = [int(entries[axis + 'DIM']) for axis in 'ZYX']
    return (numpy.frombuffer(content, kind, numpy.prod(shape), size).reshape(shape),
            numpy.array([float(entries['V' + axis]) for axis in 'XYZ']))


def write_labels(labels, spacing, path):
    """An INRIMAGE file of bytes."""
    header = '#INRIMAGE-4#{\n' + ''.join('%sDIM=%d\n' % pair for pair in zip('XYZ', labels.shape[::-1]))
    header += 'VDIM=1\nTYPE=unsigned fixed\nPIXSIZE=8 bits\nSCALE=2**0\nCPU=decm\n'
    header += ''.join('V%s=%.9g\n' % pair for pair in zip('XYZ', spacing))
    with open(path, 'wb') as file:
        file.write((header + '\n' * (252 - len(header)) + '##}\n').encode() + labels.astype(numpy.uint8).tobytes())


def to_vtk(values, spacing):
    image = vtkImageData()
    image.SetDimensions(values.shape[::-1])
    image.SetSpacing(spacing)
    array = numpy_to_vtk(values.ravel(), deep=True)
    array.SetName('Label')
    image.GetPointData().SetScalars(array)
    return image


def faces_of(labels):
    """The corners of each face between four neighbouring samples, in cyclic order: one array of k, j, i for
    each axis."""
    for axis in range(3):
        b, c = [other for other in range(3) if other != axis]
        yield [labels[tuple(slice(1, None) if (turn >> 1 if other == c else turn in (1, 2)) and other != axis
                            else slice(None) if other == axis else slice(None, -1)
                            for other in range(3))] for turn in range(4)]


def joins(own, other, opposite):
    """Whether the diagonal between two samples of one region connects them: `other` and `opposite` are the
    labels of the face's other corners."""
    return (own != other) & (own != opposite) & (
        (other != opposite) | (other == 0) | ((own != 0) & (own < other)))


def topology(labels, label):
    """The components and the Euler number of the surface of a region in a padded image. For a union of
    contractible parts, the Euler number is the alternating sum of the numbers of parts in cubes, faces, edges
    and samples."""
    inside = labels == label
    euler = -int(inside.sum())
    number = numpy.arange(labels.size).reshape(labels.shape)
    links = []
    for axis in range(3):
        a, b = (numpy.moveaxis(inside, axis, 0)[s] for s in (slice(None, -1), slice(1, None)))
        euler += int((a | b).sum())
        first, second = (numpy.moveaxis(number, axis, 0)[s] for s in (slice(None, -1), slice(1, None)))
        links.append(numpy.stack([first[a == b], second[a == b]]))
    diagonals = []
    for corners, numbers in zip(faces_of(labels), faces_of(number)):
        own = [corner == label for corner in corners]
        parts = own[0] | own[1] | own[2] | own[3]
        across = []
        for turn in range(2):
            both = own[turn] & own[turn + 2] & ~own[1 - turn] & ~own[3 - turn]
            connected = both & joins(corners[turn], corners[1 - turn], corners[3 - turn])
            across.append(connected)
            apart = both & ~connected
            parts = parts.astype(numpy.int8) + apart
            links.append(numpy.stack([numbers[turn][connected], numbers[turn + 2][connected]]))
            # What surrounds two parts that are not connected is connected between them.
            links.append(numpy.stack([numbers[1 - turn][apart], numbers[3 - turn][apart]]))
        euler -= int(parts.sum())
        diagonals.append(across)
    euler += count_cubes(inside, diagonals)
    links = numpy.concatenate(links, axis=1)
    graph = coo_matrix((numpy.ones(links.shape[1], numpy.int8), links), shape=(labels.size, labels.size))
    # Components of the region and of what surrounds it form a tree, and its edges are the surfaces.
    return connected_components(graph, directed=False)[0] - 1, 2 * euler


def count_cubes(inside, diagonals):
    """The number of parts of the region in all cubes of eight samples."""
    size = [n - 1 for n in inside.shape]
    corner = lambda bits: inside[tuple(slice(bit, bit + n) for bit, n in zip(bits, size))]
    corners = [tuple((c >> axis) & 1 for axis in range(3)) for c in range(8)]
    values = numpy.stack([corner(bits) for bits in corners], axis=-1)
    mixed = values.any(axis=-1) & ~values.all(axis=-1)
    full = int(values.all(axis=-1).sum())
    own = values[mixed]
    part = numpy.where(own, numpy.arange(8, dtype=numpy.int8), numpy.int8(8))
    links = []
    for a in range(8):
        for axis in range(3):
            if not (a >> axis) & 1:
                b = a | 1 << axis
                links.append((a, b, own[:, a] & own[:, b]))
    for axis in range(3):
        b, c = [other for other in range(3) if other != axis]
        cycle = [0, 1 << b, 1 << b | 1 << c, 1 << c]
        for side in range(2):
            for turn in range(2):
                across = diagonals[axis][turn]
                across = across[tuple(slice(side, side + n) if other == axis else slice(None)
                                      for other, n in enumerate(size))][mixed]
                links.append((cycle[turn] | side << axis, cycle[turn + 2] | side << axis, across))
    for _ in range(8):
        for a, b, connected in links:
            lower = numpy.minimum(part[:, a], part[:, b])
            part[:, a] = numpy.where(connected, lower, part[:, a])
            part[:, b] = numpy.where(connected, lower, part[:, b])
    return full + int((own & (part == numpy.arange(8))).sum())


def surfaces(image, threshold=None):
    algorithm = shapemap.vtkShapeLabelSurfaces()
    algorithm.SetInputDataObject(image)
    algorithm.SetLabelArray('Label')
    if threshold is not None:
        algorithm.SetThresholds(0, threshold)
    start = time.process_time()
    algorithm.Update()
    seconds = time.process_time() - start
    facts = algorithm.GetOutputDataObject(2)
    fact = lambda name: vtk_to_numpy(facts.GetColumnByName('LabelSurfaces.' + name)).ravel()
    return algorithm.GetOutputDataObject(0), fact, seconds


def tetrahedra(surface):
    algorithm = shapemap.vtkShapeTetrahedralize()
    algorithm.SetInputDataObject(surface)
    start = time.process_time()
    algorithm.Update()
    seconds = time.process_time() - start
    solid = algorithm.GetOutputDataObject(0)
    return (vtk_to_numpy(solid.GetPoints().GetData()).astype(float),
            vtk_to_numpy(solid.GetCells().GetConnectivityArray()).reshape(-1, 4),
            vtk_to_numpy(solid.GetCellData().GetArray('RegionId')), seconds)


def read_medit(path):
    with open(path) as file:
        words = iter(file.read().split())
    for word in words:
        if word == 'Vertices':
            points = numpy.array([[float(next(words)) for _ in range(4)] for _ in range(int(next(words)))])[:, :3]
        elif word == 'Tetrahedra':
            cells = numpy.array([[int(next(words)) for _ in range(5)] for _ in range(int(next(words)))])
            return points, cells[:, :4] - 1, cells[:, 4]
    raise ValueError(path + ' has no tetrahedra')


def interfaces(cells, regions):
    """The points of the triangles between regions, or between a region and the outside."""
    faces = numpy.sort(cells[:, [[1, 2, 3], [0, 2, 3], [0, 1, 3], [0, 1, 2]]].reshape(-1, 3), axis=1)
    owners = numpy.repeat(regions, 4)
    order = numpy.lexsort(faces.T)
    faces, owners = faces[order], owners[order]
    same = (faces[1:] == faces[:-1]).all(axis=1)
    inner = numpy.zeros(len(faces), bool)
    equal = same & (owners[1:] == owners[:-1])
    inner[1:] |= equal
    inner[:-1] |= equal
    return numpy.unique(faces[~inner])


def distances(places, labels, spacing):
    """From the nearest face between voxels of different labels."""
    middles, axes = [], []
    for axis in range(3):
        along = numpy.moveaxis(labels, 2 - axis, 0)
        at = numpy.stack(numpy.nonzero(numpy.moveaxis(along[1:] != along[:-1], 0, 2 - axis)), axis=1)[:, ::-1]
        middles.append((at + 0.5 * (numpy.arange(3) == axis)) * spacing)
        axes.append(numpy.full(len(at), axis))
    middles, axes = numpy.concatenate(middles), numpy.concatenate(axes)
    _, near = spatial.cKDTree(middles).query(places, 12)
    offsets = abs(places[:, None] - middles[near])
    across = numpy.arange(3) == axes[near][:, :, None]
    offsets = numpy.where(across, offsets, numpy.maximum(offsets - 0.5 * spacing, 0.0))
    return numpy.linalg.norm(offsets, axis=2).min(axis=1)


def smallest_angle(points, cells):
    """Between two faces of a tetrahedron, in degrees."""
    corners = points[cells]
    normals = []
    for a, b, c in ((1, 3, 2), (0, 2, 3), (0, 3, 1), (0, 1, 2)):
        normal = numpy.cross(corners[:, b] - corners[:, a], corners[:, c] - corners[:, a])
        normals.append(normal / numpy.linalg.norm(normal, axis=1)[:, None])
    return min(180.0 - numpy.degrees(numpy.arccos(numpy.clip((normals[a] * normals[b]).sum(axis=1), -1, 1))).max()
               for a in range(4) for b in range(a))


def describe(points, cells, regions, labels, spacing):
    a, b, c, d = points[cells].transpose(1, 0, 2)
    each = abs((numpy.cross(b - a, c - a) * (d - a)).sum(axis=1)) / 6.0
    voxels = {label: (labels == label).sum() * numpy.prod(spacing) for label in numpy.unique(labels[labels != 0])}
    away = distances(points[interfaces(cells, regions)], labels, spacing) / spacing.mean()
    return {'tetrahedra': len(cells), 'angle': smallest_angle(points, cells),
            'volumes': max(100.0 * abs(each[regions == label].sum() / volume - 1.0)
                           for label, volume in voxels.items()),
            'RMS': numpy.sqrt((away ** 2).mean()), 'maximum': away.max()}


def check_surfaces(name, image, labels, claims, table, threshold=None):
    surface, fact, seconds = surfaces(image, threshold)
    padded = numpy.pad(labels, 1)
    for label, components, euler in zip(fact('Labels'), fact('Components'), fact('EulerNumbers')):
        right = topology(padded, label)
        print('%s, label %d: components %d, Euler number %d; voxels %d and %d' % (
            name, label, components, euler, *right), flush=True)
        claims.check('%s, label %d' % (name, label), 'components and Euler number', '%d, %d' % (components, euler),
                     (components, euler) == right)
    table.print({'image': name, 'voxels': labels.size, 'triangles': surface.GetNumberOfCells(),
                 'intersections': fact('Intersections')[0], 'seconds': seconds,
                 'GiB': resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 2 ** 20})
    return surface, seconds


def main():
    parser = sweep.parser(__doc__, models=False)
    parser.add_argument('folder')
    parser.add_argument('--images', default='.')
    parser.add_argument('--whole', action='store_true')
    options = parser.parse_args()
    program, claims = sweep.Program(options), sweep.Claims()
    table = sweep.Table('image:<14', 'voxels:10d', 'triangles:10d', 'intersections:14.0f', 'seconds:8.1f', 'GiB:6.2f')
    solids = sweep.Table('image:<14', 'method:<14', 'tetrahedra:10d', 'seconds:8.1f', 'angle:7.2f', 'volumes:9.3f',
                         'RMS:7.3f', 'maximum:8.3f')
    liver, spacing = read_image(os.path.join(options.images, 'liver.inr.gz'))
    if options.whole:
        check_surfaces('liver, whole', to_vtk(liver, spacing), liver, claims, table)
    skull, skull_spacing = read_image(os.path.join(options.images, 'skull_2.9.inr'))
    steps = (slice(None, None, 2), slice(None, None, 4), slice(None, None, 4))
    for name, values, spacing, labels, threshold in (
            ('liver', liver[steps], spacing * (4, 4, 2), liver[steps], None),
            ('skull', skull, skull_spacing, (skull >= 2.9).astype(numpy.uint8), 2.9)):
        image = to_vtk(numpy.ascontiguousarray(values), spacing)
        surface, seconds = check_surfaces(name, image, labels, claims, table, threshold)
        points, cells, regions, more = tetrahedra(surface)
        solids.print(dict(describe(points, cells, regions, labels, spacing), image=name, method='Label Surfaces',
                          seconds=seconds + more))
        path = os.path.join(options.folder, name)
        write_labels(labels, spacing, path + '.inr')
        size = spacing.mean()
        outcome = program.run('image_tetrahedra', path + '.inr', path + '.mesh', size, 0.25 * size, 8.0 * size)
        seconds = outcome.row()['cpu']
        points, cells, numbers = read_medit(path + '.mesh')
        # CGAL numbers the labels from 1.
        regions = numpy.unique(labels[labels != 0])[numbers - 1]
        solids.print(dict(describe(points, cells, regions, labels, spacing), image=name, method='CGAL',
                          seconds=seconds))
    claims.finish()


if __name__ == '__main__':
    main()
