"""Shape Image Reader: the directions of medical images, which ParaView's own readers leave out.

As an example: File > Open, or ShapeImageReader, reads a segmentation, and Shape Label Surfaces extracts its
surface where the patient has it."""
import gzip
import os
import tempfile

import numpy
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
import shapemap

import shapetesting
from shapetesting import points, triangles

folder = tempfile.mkdtemp()
SIZE = (12, 10, 8)


def nrrd(path, values, kind, directions, origin='0,0,0', encoding='raw'):
    """A file as 3D Slicer writes it."""
    body = values.astype(values.dtype.newbyteorder('<')).tobytes(order='F')
    head = ('NRRD0004\ntype: %s\ndimension: 3\nspace: left-posterior-superior\nsizes: %d %d %d\n'
            'space directions: %s\nkinds: domain domain domain\nendian: little\nencoding: %s\n'
            'space origin: (%s)\n\n' % (kind, *values.shape, directions, encoding, origin))
    with open(path, 'wb') as file:
        file.write(head.encode() + (gzip.compress(body) if encoding == 'gzip' else body))
    return path


# The example: the first index goes to the right, so the axes are left-handed; triangles still face outwards.
i, j, k = numpy.indices(SIZE)
ball = (i - 5.5) ** 2 + (j - 4.5) ** 2 + (k - 3.5) ** 2 < 9.0
path = nrrd(os.path.join(folder, 'segmentation.nrrd'), (2 * ball).astype(numpy.uint8), 'unsigned char',
            '(-2,0,0) (0,3,0) (0,0,4)', '100,-7,9', 'gzip')
image = simple.ShapeImageReader(FileNames=[path])
surface = simple.ShapeLabelSurfaces(Input=image)
surface.UpdatePipeline()
found = shapetesting.output(surface)
centre = numpy.array([100.0 - 2.0 * 5.5, -7.0 + 3.0 * 4.5, 9.0 + 4.0 * 3.5])
assert numpy.abs(points(found).mean(axis=0) - centre).max() < 1e-6
corners = points(found)[triangles(found)]
volume = numpy.linalg.det(corners - centre).sum() / 6.0
assert abs(volume / (24.0 * ball.sum()) - 1.0) < 0.1, volume

# Every type of number comes through, in the order of VTK's images.
random = numpy.random.default_rng(4)
for name, kind in (('signed char', numpy.int8), ('unsigned char', numpy.uint8), ('short', numpy.int16),
                   ('unsigned short', numpy.uint16), ('int', numpy.int32), ('unsigned int', numpy.uint32),
                   ('long long int', numpy.int64), ('unsigned long long int', numpy.uint64),
                   ('float', numpy.float32), ('double', numpy.float64)):
    values = random.integers(-100 if numpy.dtype(kind).kind != 'u' else 0, 100, SIZE).astype(kind)
    reader = shapemap.vtkShapeImageReader()
    reader.SetFileName(nrrd(os.path.join(folder, 'numbers.nrrd'), values, name, '(0,2,0) (3,0,0) (0,0,-4)'))
    reader.UpdateInformation()
    assert reader.GetOutputDataObject(0).GetNumberOfPoints() == 0  # until it is needed
    reader.Modified()
    reader.Update()
    data = reader.GetOutputDataObject(0)
    read = vtk_to_numpy(data.GetPointData().GetScalars())
    assert read.dtype == kind and data.GetDimensions() == SIZE, (name, read.dtype)
    assert (read == values.ravel(order='F')).all(), name
# Its second index goes along x.
position = [0.0, 0.0, 0.0]
data.TransformContinuousIndexToPhysicalPoint(1, 2, 3, position)
assert numpy.abs(numpy.array(position) - [6.0, 2.0, -12.0]).max() < 1e-12, position

# A part is cropped from the whole.
data.ReleaseData()
reader.UpdateExtent([2, 5, 0, 9, 3, 7])
part = reader.GetOutputDataObject(0)
assert part.GetExtent() == (2, 5, 0, 9, 3, 7)
assert (vtk_to_numpy(part.GetPointData().GetScalars()) == values[2:6, :, 3:].ravel(order='F')).all()

# Wrong files are refused once, with their name, and leave nothing.
for content in (b'', b'NRRD0004\ntype: float\ndimension: 3\nsizes: 4 4 4\nencoding: raw\n\n12'):
    with open(path, 'wb') as file:
        file.write(content)
    reader, messages = shapemap.vtkShapeImageReader(), []
    reader.AddObserver('ErrorEvent', lambda *_: messages.append('refused'))
    reader.SetFileName(path)
    reader.Update()
    assert len(messages) == 1 and reader.GetOutputDataObject(0).GetNumberOfPoints() == 0, messages
print('images of', SIZE, 'voxels in ten types')
