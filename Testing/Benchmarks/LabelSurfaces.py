"""Shape Label Surfaces beside VTK's discrete contour with windowed sinc smoothing, on phantoms whose
interfaces are known: a ball that planes half-way between random seeds divide.

    Utilities/pvpython.sh Testing/Benchmarks/LabelSurfaces.py [--size 128 ...] [--regions 8 ...] [--first 100] [--count 3]

Distances are in voxels: of corners of triangles from the plane between the two nearest seeds, where the
ball's surface is more than three voxels away; the angle is between a triangle's normal and that of its
plane; the curve error is the distance of the points of curves from the edges of the Voronoi cells. The
volume is compared with that of 64 samples in each voxel; `voxels %` is how far the number of voxels, which
the surfaces keep, is from it. Seconds are CPU seconds. The default
parameters were chosen on seeds 1 to 20; `--first` is the first seed of the phantoms that are measured."""
import argparse
import itertools
import time

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkWindowedSincPolyDataFilter
from vtkmodules.vtkFiltersGeneral import vtkDiscreteFlyingEdges3D
import shapemap

import sweep


class Phantom:
    def __init__(self, size, regions, number):
        self.size = size
        self.seeds = numpy.random.default_rng(number).uniform(0.1 * size, 0.9 * size, (regions, 3))

    def labels(self, places):
        """1 and up inside the ball, 0 outside."""
        label = numpy.zeros(len(places), numpy.int16)
        nearest = numpy.full(len(places), numpy.inf)
        for number, seed in enumerate(self.seeds, 1):
            squared = ((places - seed) ** 2).sum(axis=1)
            label[squared < nearest] = number
            numpy.minimum(nearest, squared, out=nearest)
        label[((places - 0.5 * self.size) ** 2).sum(axis=1) >= (0.45 * self.size) ** 2] = 0
        return label

    def grid(self):
        axis = numpy.arange(self.size, dtype=float)
        return numpy.stack(numpy.meshgrid(axis, axis, axis, indexing='ij'), axis=-1)

    def image(self):
        labels = self.labels(self.grid().transpose(2, 1, 0, 3).reshape(-1, 3))
        image = vtkImageData()
        image.SetDimensions([self.size] * 3)
        array = numpy_to_vtk(labels, deep=True)
        array.SetName('Label')
        image.GetPointData().SetScalars(array)
        return image

    def volumes(self):
        """Of each region, by samples."""
        steps = (numpy.arange(4) - 1.5) / 4.0
        counts = numpy.zeros(len(self.seeds) + 1)
        for k in range(self.size):
            slab = self.grid()[:, :, k].reshape(-1, 3)
            for shift in numpy.stack(numpy.meshgrid(steps, steps, steps), axis=-1).reshape(-1, 3):
                counts += numpy.bincount(self.labels(slab + shift), minlength=len(counts))
        return counts[1:] / 64.0

    def measure(self, corners):
        """Distances of corners (m x 3 x 3) from their planes, and angles of their normals."""
        inside = (numpy.linalg.norm(corners - 0.5 * self.size, axis=2) < 0.45 * self.size - 3.0).all(axis=1)
        corners = corners[inside]
        centres = corners.mean(axis=1)
        order = numpy.argsort(((centres[:, None] - self.seeds) ** 2).sum(axis=2), axis=1)
        a, b = self.seeds[order[:, 0]], self.seeds[order[:, 1]]
        normals = (b - a) / numpy.linalg.norm(b - a, axis=1)[:, None]
        distances = numpy.einsum('ijk,ik->ij', corners - 0.5 * (a + b)[:, None], normals)
        own = numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        lengths = numpy.linalg.norm(own, axis=1)
        cosines = abs((own * normals).sum(axis=1)[lengths > 0.0] / lengths[lengths > 0.0])
        return distances.ravel(), numpy.degrees(numpy.arccos(numpy.minimum(cosines, 1.0)))

    def curves(self):
        """The parts of the lines of equal distance to three seeds where no other seed is nearer: a position
        and a direction of each line, and the range of multiples of the direction."""
        for triple in itertools.combinations(range(len(self.seeds)), 3):
            a, b, c = self.seeds[list(triple)]
            rows = numpy.array([b - a, c - a])
            start = numpy.linalg.lstsq(rows, 0.5 * numpy.array([b @ b - a @ a, c @ c - a @ a]), rcond=None)[0]
            along = numpy.cross(*rows)
            along /= numpy.linalg.norm(along)
            others = numpy.delete(self.seeds, triple, axis=0)
            # The squared distance to another seed minus that to a is slope t + offset.
            slopes = 2.0 * (a - others) @ along
            offsets = ((start - others) ** 2).sum(axis=1) - ((start - a) ** 2).sum()
            first = max((-offset / slope for slope, offset in zip(slopes, offsets) if slope > 0.0),
                        default=-numpy.inf)
            last = min((-offset / slope for slope, offset in zip(slopes, offsets) if slope < 0.0),
                       default=numpy.inf)
            if first <= last:
                yield start, along, first, last

    def curve_errors(self, places):
        """Distances of positions from the nearest curve."""
        places = places[numpy.linalg.norm(places - 0.5 * self.size, axis=1) < 0.45 * self.size - 3.0]
        errors = numpy.full(len(places), numpy.inf)
        for start, along, first, last in self.curves():
            steps = numpy.clip((places - start) @ along, first, last)
            numpy.minimum(errors, numpy.linalg.norm(start + steps[:, None] * along - places, axis=1), out=errors)
        return errors


def corners_of(surface):
    places = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    return places[vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)]


def ours(image):
    algorithm = shapemap.vtkShapeLabelSurfaces()
    algorithm.SetInputDataObject(image)
    algorithm.SetLabelArray('Label')
    start = time.process_time()
    algorithm.Update()
    seconds = time.process_time() - start
    facts = algorithm.GetOutputDataObject(2)
    volumes = vtk_to_numpy(facts.GetColumnByName('LabelSurfaces.Volumes')).ravel()
    return seconds, algorithm.GetOutputDataObject(0), algorithm.GetOutputDataObject(1), volumes


def peer(image, regions):
    """The pipeline of VTK's examples for medical images; normals as it makes them."""
    start = time.process_time()
    contour = vtkDiscreteFlyingEdges3D()
    contour.SetInputData(image)
    contour.GenerateValues(regions, 1, regions)
    smoother = vtkWindowedSincPolyDataFilter()
    smoother.SetInputConnection(contour.GetOutputPort())
    smoother.SetNumberOfIterations(15)
    smoother.BoundarySmoothingOff()
    smoother.FeatureEdgeSmoothingOff()
    smoother.SetFeatureAngle(120.0)
    smoother.SetPassBand(0.001)
    smoother.NonManifoldSmoothingOn()
    smoother.NormalizeCoordinatesOn()
    smoother.Update()
    seconds = time.process_time() - start
    surface = smoother.GetOutput()
    labels = vtk_to_numpy(surface.GetPointData().GetScalars())
    cells = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    a, b, c = corners_of(surface).transpose(1, 0, 2)
    each = abs(numpy.bincount(labels[cells[:, 0]].astype(int), (numpy.cross(b, c) * a).sum(axis=1) / 6.0))
    return seconds, surface, each[1:]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--size', type=int, nargs='+', default=[128])
    parser.add_argument('--regions', type=int, nargs='+', default=[8])
    parser.add_argument('--first', type=int, default=100)
    parser.add_argument('--count', type=int, default=3)
    options = parser.parse_args()
    claims = sweep.Claims()
    table = sweep.Table('phantom:<12', 'method:<16', 'seconds:8.2f', 'RMS:8.3f', 'angle:8.2f', 'volume %:9.3f',
                        'voxels %:9.3f', 'curves:8.3f', 'curves RMS:11.3f')
    numbers = range(options.first, options.first + options.count)
    for size, regions, number in itertools.product(options.size, options.regions, numbers):
        name = '%d/%d/%d' % (size, regions, number)
        phantom = Phantom(size, regions, number)
        image, exact = phantom.image(), phantom.volumes()
        found = exact > 0.0
        seconds, surface, curves, volumes = ours(image)
        distances, angles = phantom.measure(corners_of(surface))
        errors = phantom.curve_errors(vtk_to_numpy(curves.GetPoints().GetData()))
        voxels = numpy.bincount(vtk_to_numpy(image.GetPointData().GetScalars()), minlength=len(found) + 1)[1:][found]
        row = {'phantom': name, 'method': 'Label Surfaces', 'seconds': seconds,
               'RMS': numpy.sqrt((distances ** 2).mean()), 'angle': numpy.median(angles),
               'volume %': 100.0 * abs(volumes / exact[found] - 1.0).max(),
               'voxels %': 100.0 * abs(voxels / exact[found] - 1.0).max(),
               'curves': errors.max(), 'curves RMS': numpy.sqrt((errors ** 2).mean())}
        beside_voxels = 100.0 * abs(volumes / voxels - 1.0).max()
        table.print(row)
        seconds, surface, volumes = peer(image, regions)
        distances, angles = phantom.measure(corners_of(surface))
        other = {'phantom': name, 'method': 'windowed sinc', 'seconds': seconds,
                 'RMS': numpy.sqrt((distances ** 2).mean()), 'angle': numpy.median(angles),
                 'volume %': 100.0 * abs(volumes[found] / exact[found] - 1.0).max()}
        table.print(other)
        claims.at_most(name, 'RMS of interfaces (voxels)', row['RMS'], 0.15)
        claims.at_most(name, 'median angle (degrees)', row['angle'], 3.0)
        claims.at_most(name, 'volumes (%)', row['volume %'], 0.5)
        claims.at_most(name, 'volumes beside the voxels (%)', beside_voxels, 0.1)
        claims.at_most(name, 'curves (voxels)', row['curves'], 0.5)
        for figure in ('RMS', 'angle', 'volume %'):
            claims.at_most(name, figure + ' / that of windowed sinc', row[figure] / other[figure], 1.0)
    claims.finish()


if __name__ == '__main__':
    main()
