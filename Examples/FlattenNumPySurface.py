"""Flattens a surface given as NumPy arrays, without ParaView."""
import numpy
import shapemap

# Half of a cylindrical wall of radius 1 and height 1: points, and the corners of quadrilaterals.
rows, columns = numpy.mgrid[0:17, 0:49]
angles = numpy.pi * columns / 48
points = numpy.stack([numpy.cos(angles), numpy.sin(angles), rows / 16], axis=-1).reshape(-1, 3)
index = numpy.arange(17 * 49).reshape(17, 49)
quads = numpy.stack([index[:-1, :-1], index[:-1, 1:], index[1:, 1:], index[1:, :-1]], axis=-1)

flat = shapemap.parameterize(points, quads.reshape(-1, 4), domain='FreeBoundary')
plane = shapemap.point_array(flat.surface, 'TargetPosition')

# A cylinder is developable: its image is a rectangle with sides of pi and 1.
corners = plane[index[[0, 0, -1], [0, -1, 0]]]
sides = numpy.linalg.norm(corners[1:] - corners[0], axis=1)
print('sides %.3f and %.3f' % tuple(sides))
assert abs(sides - [numpy.pi, 1.0]).max() < 0.01 and abs(plane[:, 2]).max() == 0.0
