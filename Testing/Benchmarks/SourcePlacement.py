"""Where the sources of a harmonic volume map lie: on offsets of the surface, as today, or after a conformal map.

    Utilities/pvpython.sh Testing/Benchmarks/SourcePlacement.py [SOLID ...] [--choose] [--sources 300] [--samples 700]

In the plane, sources and collocation points belong on the images of circles under a conformal map (Katsurada and
Okamoto, "The collocation points of the fundamental solution method for the potential problem", 1996), and Li et al.
2010, section 6.1, suggest a conformal map of the surface in space. Placements, each with the same numbers:

- Uniform, Adaptive: as SourceSampling. Even samples, or denser where the surface is curved; all at one offset.
- Conformal: even samples of the sphere under the map of Shape Parameterize; the offset follows the local scale of
  the map, at most 4 times that of Uniform.
- Level: even samples, moved along the field lines of the surface's equilibrium charge, the harmonic function outside
  that is 1 on the surface and 0 far away. The offset is inverse to its slope: nearly one of its level sets.
- Equilibrium: the same field lines, and samples as dense as the charge: each source has the same flux, as the images
  of even samples of a circle have in the plane.

Fields: three that are harmonic inside and known there (a growing wave, a cubic polynomial, charges at 0.12 outside),
and waves that are given on the surface alone. RMS errors on the surface and inside at independent positions, divided
by the field's standard deviation; condition numbers before truncation at 1e-12; CPU seconds of placing and solving.
--choose runs the solids on which the offset was chosen, with offsets of 1, 2 and 4 spacings: 4 had the least mean
error inside for each placement. The claims are about the other solids."""
import argparse
import time

import numpy
from scipy.spatial import cKDTree
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.util.numpy_support import numpy_to_vtk
import shapemap

import sweep  # finds what the tests share
import off
import shapetesting
from shapetesting import array, new, outputs, points, triangles

PLACEMENTS = ('Uniform', 'Adaptive', 'Conformal', 'Level', 'Equilibrium')
FARTHEST = 4.0  # of local offsets / the offset of Uniform


def bump(position, width):
    return numpy.exp(-(position / width) ** 2)


# Solids that deform a ball, as functions of its points.
BALLS = {
    'ball': lambda p: p,
    'bowl': lambda p: numpy.where(p[:, 2:] > 0.0, p * [1.0, 1.0, -0.72], p),
    'groove': lambda p: p * (1.0 - 0.45 * bump(p[:, 2:], 0.12)),
    'plate': lambda p: p * [1.0, 0.8, 0.06],
    'needle': lambda p: p * [1.0, 0.1, 0.1],
    'bean': lambda p: p * [1.6, 0.55, 0.55] + numpy.outer(1.4 * p[:, 0] ** 2, [0.0, 0.0, 1.0]),
    'star': lambda p: p * [1.0, 1.0, 0.5] * (1.0 + 0.45 * (1.0 - p[:, 2:] ** 2) * numpy.maximum(
        0.0, numpy.cos(3.0 * numpy.arctan2(p[:, 1:2], p[:, :1]))) ** 2),
    'dumbbell': lambda p: p * [1.6, 1.0, 1.0] * numpy.where(
        [True, False, False], 1.0, 1.0 - 0.75 * bump(p[:, :1], 0.5)),
    'saucer': lambda p: p * [1.0, 1.0, 0.12] + numpy.outer(0.5 * (p[:, 0] ** 2 + p[:, 1] ** 2), [0.0, 0.0, 1.0]),
}
CHOSEN = ('ball', 'bowl', 'groove', 'FigureASmall', 'TwistedBarSmall')
ASSERTED = ('plate', 'needle', 'bean', 'star', 'dumbbell', 'saucer', 'DentedSphere3k', 'BentBarSmall', 'FigureBSmall',
            'PhantomHeadSmall', 'PhantomBrainSmall', 'TwoTorusSmall')


def shape(name):
    """The points, with a longest side of 1 around the origin, and the triangles."""
    if name in BALLS:
        data = shapetesting.read('DentedSphere3k.vtp')
        sphere = array(data, 'TargetPosition') - array(data, 'TargetPosition').mean(axis=0)
        places = BALLS[name](sphere / numpy.linalg.norm(sphere, axis=1)[:, None])
    else:
        data = shapetesting.read(name + '.vtp')
        places = points(data)
    low, high = places.min(axis=0), places.max(axis=0)
    return (places - 0.5 * (low + high)) / (high - low).max(), triangles(data)


def cloud(places):
    data, own = vtkPolyData(), vtkPoints()
    own.SetData(numpy_to_vtk(numpy.ascontiguousarray(places), deep=True))
    data.SetPoints(own)
    return data


def lengths(vectors):
    return numpy.linalg.norm(vectors, axis=-1)


def spread(places, count, density, first):
    """Rows that are far from each other; distances count more where `density` is high."""
    nearest, chosen = numpy.full(len(places), numpy.inf), [first]
    while len(chosen) < count:
        nearest = numpy.minimum(nearest, ((places - places[chosen[-1]]) ** 2).sum(axis=1))
        chosen.append(int(numpy.argmax(nearest * density)))
    return numpy.array(chosen)


class Solid:
    def __init__(self, name):
        self.points, self.triangles = shape(name)
        self.surface = off.surface(self.points, self.triangles.tolist())
        corners = self.points[self.triangles]
        across = numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        if (corners[:, 0] * across).sum() < 0.0:
            across = -across
        self.areas, self.area = 0.5 * lengths(across), 0.5 * lengths(across).sum()
        self.random = numpy.random.default_rng(1)
        # Many random positions, among which samples are chosen.
        self.places, self.owners, self.barycentric = self.scatter(12000)
        self.normals = self.blend(self.corner_means(across))
        self.normals /= lengths(self.normals)[:, None]
        self.tests = self.scatter(4000)[0]
        within = self.random.uniform(self.points.min(axis=0), self.points.max(axis=0), (30000, 3))
        self.inner = within[self.distances(within) < -1e-3][:2000]
        outside = self.places + 0.12 * self.normals
        outside = outside[self.distances(outside) > 0.1]
        self.charges = outside[spread(outside, 6, 1.0, 0)]
        self.charge_surface()

    def scatter(self, count):
        owners = self.random.choice(len(self.triangles), count, p=self.areas / self.area)
        barycentric = self.random.dirichlet([1.0, 1.0, 1.0], count)
        return (barycentric[:, :, None] * self.points[self.triangles[owners]]).sum(axis=1), owners, barycentric

    def corner_means(self, values):
        """Sums of the triangles' values at their corners."""
        sums = numpy.zeros((len(self.points),) + values.shape[1:])
        for corner in self.triangles.T:
            numpy.add.at(sums, corner, values)
        return sums

    def blend(self, values):
        """Values of the points, at the random positions."""
        share = self.barycentric.reshape(self.barycentric.shape + (1,) * (values.ndim - 1))
        return (share * values[self.triangles[self.owners]]).sum(axis=1)

    def distances(self, places):
        measured = new(shapemap.vtkShapeBoundaryDistance, cloud(places), self.surface)
        return array(outputs(measured)[0], 'BoundaryDistance')

    def charge_surface(self, count=1500):
        """The equilibrium charge: its potential is 1 on the surface. A disk of radius r and density 1 has r / 2 at
        its centre."""
        sites = self.places[spread(self.places, count, 1.0, 0)]
        nearest = cKDTree(sites).query(self.places)[1]
        areas = numpy.maximum(numpy.bincount(nearest, minlength=count) / len(self.places), 0.2 / count) * self.area
        apart = lengths(sites[:, None] - sites) + numpy.eye(count)
        potentials = areas / (4.0 * numpy.pi * apart)
        numpy.fill_diagonal(potentials, 0.5 * numpy.sqrt(areas / numpy.pi))
        density = numpy.linalg.solve(potentials, numpy.ones(count))
        self.sites, self.loads = sites, density * areas
        self.density = numpy.maximum(density, 1e-3 * density.mean())[nearest] / density.mean()

    def slope(self, places):
        """The direction in which the potential of the equilibrium charge falls."""
        away = places[:, None] - self.sites
        field = (away * (self.loads / lengths(away) ** 3)[:, :, None]).sum(axis=1)
        return field / lengths(field)[:, None]

    def curvature(self, spacing):
        """Turning of the normals within a spacing, from 0.5 to 4 times the mean, as GeometryAdaptive."""
        apart, others = cKDTree(self.places).query(self.places, k=40, distance_upper_bound=spacing)
        used = numpy.isfinite(apart) & (apart > 0.2 * spacing)
        turned = lengths(self.normals[:, None] - self.normals[numpy.where(used, others, 0)])
        rates = numpy.where(used, turned / numpy.where(used, apart, 1.0), 0.0)
        rate = rates.sum(axis=1) / numpy.maximum(used.sum(axis=1), 1)
        return numpy.clip(rate / rate.mean(), 0.5, 4.0)

    def sphere(self):
        """Images on the unit sphere, and the area of an image / area of what it is the image of."""
        images = array(outputs(new(shapemap.vtkShapeParameterize, self.surface, Domain=1))[0], 'TargetPosition')
        corners = images[self.triangles]
        areas = 0.5 * lengths(numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]))
        scale = self.blend(self.corner_means(areas) / self.corner_means(self.areas))
        on = self.blend(images)
        return on / lengths(on)[:, None], numpy.maximum(scale, 1e-9)

    def fields(self, places):
        x, y, z = places.T
        charged = sum(0.1 / lengths(places - charge) for charge in self.charges)
        return numpy.stack([numpy.cos(3.0 * y) * numpy.exp(3.0 * x), 8.0 * x * y * z + z * z - x * x, charged,
                            numpy.sin(12.0 * x) * numpy.cos(9.0 * y + 4.0 * z)], axis=1)


def along_field(solid, places, normals, offsets):
    """Positions at these arc lengths along field lines. The first step, near the layer of charges, is normal."""
    near = numpy.sqrt(solid.area / len(solid.sites))
    ends = places + numpy.minimum(offsets, near)[:, None] * normals
    left = offsets - numpy.minimum(offsets, near)
    while left.max() > 0.0:
        step = numpy.minimum(left, numpy.maximum(offsets / 20.0, near / 2.0))
        middle = ends + 0.5 * step[:, None] * solid.slope(ends)
        ends, left = ends + step[:, None] * solid.slope(middle), left - step
    return ends


def draw_back(solid, places, ends):
    """Sources that are nearer to another part than half their offset go back towards their positions."""
    ends = ends.copy()
    for _ in range(12):
        near = solid.distances(ends) < 0.5 * lengths(ends - places)
        ends[near] = places[near] + 0.7 * (ends[near] - places[near])
    return ends


def place(solid, placement, sources, samples, offset):
    """Rows of collocation points, and the sources."""
    spacing, density, on = numpy.sqrt(solid.area / sources), 1.0, solid.places
    if placement == 'Adaptive':
        density = solid.curvature(spacing)
    elif placement == 'Equilibrium':
        density = solid.density
    elif placement == 'Conformal':
        on, scale = solid.sphere()
    rows, chosen = spread(on, samples, density, 0), spread(on, sources, density, 1)
    places, normals = solid.places[chosen], solid.normals[chosen]
    local = numpy.ones(sources)
    if placement == 'Conformal':
        local = numpy.sqrt(4.0 * numpy.pi / (scale[chosen] * solid.area))
    elif placement == 'Level':
        local = 1.0 / solid.density[chosen]
    elif placement == 'Equilibrium':
        local = 1.0 / numpy.sqrt(solid.density[chosen])
    offsets = offset * spacing * numpy.minimum(local, FARTHEST)
    if placement in ('Level', 'Equilibrium'):
        ends = along_field(solid, places, normals, offsets)
        lost = solid.distances(ends) < 0.4 * numpy.minimum(offsets, spacing)
        return rows, numpy.where(lost[:, None], draw_back(solid, places, ends), ends)
    return rows, draw_back(solid, places, places + offsets[:, None] * normals)


def measure(solid, rows, sources):
    """RMS errors of each field on the surface and inside, and the condition number."""
    places = solid.places[rows]
    counts = numpy.bincount(cKDTree(places).query(solid.places)[1], minlength=len(rows))
    weights = numpy.sqrt(numpy.maximum(counts, 1) / counts.mean())[:, None]

    def columns(at):
        return numpy.hstack([0.25 / numpy.pi / lengths(at[:, None] - sources), at, numpy.ones((len(at), 1))])

    left, values, right = numpy.linalg.svd(columns(places) * weights, full_matrices=False)
    kept = values > 1e-12 * values[0]
    values_at = solid.fields(places)
    weighted = right[kept].T @ (left[:, kept].T @ (values_at * weights) / values[kept][:, None])

    def error(at):
        return numpy.sqrt(((columns(at) @ weighted - solid.fields(at)) ** 2).mean(axis=0)) / values_at.std(axis=0)

    return error(solid.tests), error(solid.inner), values[0] / values[-1]


def mean(values):
    """Geometric."""
    return float(numpy.exp(numpy.log(values).mean()))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('solids', nargs='*', metavar='SOLID')
    parser.add_argument('--choose', action='store_true')
    parser.add_argument('--sources', type=int, default=300)
    parser.add_argument('--samples', type=int, default=700)
    options = parser.parse_args()
    table = sweep.Table('solid:<18', 'placement:<12', 'offset:6.1f', 'surface:9.1e', 'inside:9.1e', 'waves:9.1e',
                        'condition:10.0e', 'CPU s:6.1f')
    found = {}
    for name in options.solids or (CHOSEN if options.choose else ASSERTED):
        solid = Solid(name)
        for placement in PLACEMENTS:
            if placement == 'Conformal' and name.startswith('TwoTorus'):
                continue  # not of genus 0
            for offset in (1.0, 2.0, 4.0) if options.choose else (4.0,):
                start = time.process_time()
                surface, inside, condition = measure(
                    solid, *place(solid, placement, options.sources, options.samples, offset))
                row = {'surface': mean(surface[:3]), 'inside': mean(inside[:3]), 'waves': surface[3],
                       'condition': condition, 'CPU s': time.process_time() - start}
                found.setdefault((placement, offset), {})[name] = row
                table.print(dict(row, solid=name, placement=placement, offset=offset))
    means = {}
    for key, rows in found.items():
        means[key] = {column: mean([row[column] for row in rows.values()]) for column in next(iter(rows.values()))}
        table.print(dict(means[key], solid='mean of %d' % len(rows), placement=key[0], offset=key[1]))
    if options.choose or options.solids:
        return
    claims = sweep.Claims()
    today = means['Adaptive', 4.0]
    for placement in ('Conformal', 'Level', 'Equilibrium'):
        claims.at_least(placement, 'waves, of Adaptive', means[placement, 4.0]['waves'] / today['waves'], 1.5)
    claims.at_least('Conformal', 'inside, of Adaptive', means['Conformal', 4.0]['inside'] / today['inside'], 3.0)
    claims.finish()


if __name__ == '__main__':
    main()
