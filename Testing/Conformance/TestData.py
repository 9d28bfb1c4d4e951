"""Facts about the generated shapes that hold by construction, or the construction is wrong.

    python3 TestData.py GENERATED_FOLDER COMMITTED_FOLDER

GENERATED_FOLDER holds the small set and the large one; each committed file must equal its generated twin.
COMMITTED_FOLDER is the one of the generator, whose deformation of the figures is a formula that is checked here, too.
"""

import pathlib
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON, vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkImplicitPolyDataDistance
from vtkmodules.vtkFiltersVerdict import vtkMeshQuality
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader

# Of each surface: points, Euler number, domain.
SURFACES = {
    "DentedSphere600": (642, 2, "sphere"),
    "DentedSphere3k": (2892, 2, "sphere"),
    "DentedSphere10k": (10242, 2, "sphere"),
    "DentedSphere40k": (39692, 2, "sphere"),
    "DentedSphere100k": (100002, 2, "sphere"),
    "TwoTorusSmall": (1668, -2, "slab"),
    "TwoTorus": (6678, -2, "slab"),
    "BentBarSmall": (650, 2, "bar"),
    "BentBar": (7202, 2, "bar"),
    "TwistedBarSmall": (650, 2, "bar"),
    "TwistedBar": (7202, 2, "bar"),
    "PhantomHeadSmall": (2562, 2, "sphere"),
    "PhantomHead": (23042, 2, "sphere"),
    "PhantomSkullSmall": (1926, -2, "skull"),
    "PhantomSkull": (12048, -2, "skull"),
    "PhantomBrainSmall": (1538, 2, "brain"),
    "PhantomBrain": (11618, 2, "brain"),
}
# Of each pair of figures: points.
FIGURES = {"Small": 1134, "": 6310}
# Of each creature, without a map: points, Euler number.
CREATURES = {"KittenSmall": (1352, 0), "Kitten": (3082, 0), "HorseSmall": (1650, 2), "Horse": (3048, 2)}
# Of each polycube drawn by hand: unit cubes, Euler number of the boundary, which is that of its solid.
DRAWN = {"Kitten": (39, 0), "Horse": (40, 2), "Skull": (45, -2)}
# Of each solid: points, hexahedra, a lower bound on the scaled Jacobian.
SOLIDS = {
    "BentBarSmall": (1225, 864, 0.99),
    "BentBar": (35721, 32000, 0.99),
    "TwistedBarSmall": (1225, 864, 0.9),
    "TwistedBar": (35721, 32000, 0.9),
    "BallSmall": (997, 864, 0.7),
    "Ball": (33281, 32000, 0.7),
    "CubeSmall": (729, 512, 1 - 1e-12),
    "Cube": (35937, 32768, 1 - 1e-12),
}
# Of each polycube: boxes to fill, then boxes to empty, and the area of what is left.
V = 0.11


def voxels(low, high):
    """A box of the skull's voxels where it lies in the unit sphere."""
    return V * (np.array(low) - [0, -0.5, 0.5]), V * (np.array(high) - [0, -0.5, 0.5])


POLYCUBES = {
    "slab": ([((-3.1, -1.8, -0.5), (3.1, 1.8, 0.5))],
             [((-2.1, -0.8, -9), (-0.5, 0.8, 9)), ((0.5, -0.8, -9), (2.1, 0.8, 9))], 66.8),
    "bar": ([((-2, -0.5, -0.5), (2, 0.5, 0.5))], [], 18.0),
    "skull": ([voxels((-4, -5, -1), (4, 3, 6)), voxels((-4, 3, -1), (4, 4, 4)),
               voxels((-3, 0, -3), (3, 4, -1)), voxels((-2, 1, -5), (2, 4, -3))],
              [voxels((1, 3, 0), (3, 9, 2)), voxels((1, 2, 0), (9, 3, 2)),
               voxels((-3, 3, 0), (-1, 9, 2)), voxels((-9, 2, 0), (-1, 3, 2))], 482 * V**2),
    "brain": ([voxels((-2.5, -4, 0), (2.5, 1, 5))], [], 6 * (5 * V)**2),
}
# The corners of a unit cube in VTK's order.
CUBE = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]])
# Bend and twist (radians) of a bar of length 4.
BARS = {"BentBar": (np.pi / 2, 0), "TwistedBar": (2 * np.pi / 3, np.pi / 2)}


def read(path):
    """Points, cells and TargetPosition (or None)."""
    reader = vtkXMLPolyDataReader() if path.suffix == ".vtp" else vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    data = reader.GetOutput()
    if path.stem.endswith("Skeleton"):
        return read_curves(path.name, data)
    cells = data.GetPolys() if path.suffix == ".vtp" else data.GetCells()
    corners = 3 if path.suffix == ".vtp" else 8
    assert data.GetNumberOfCells() > 0, f"{path.name} is empty or cannot be read"
    assert data.GetNumberOfCells() == cells.GetNumberOfCells(), f"{path.name} has cells of other kinds"
    offsets = vtk_to_numpy(cells.GetOffsetsArray())
    assert (np.diff(offsets) == corners).all(), f"{path.name}: a cell has not {corners} corners"
    if path.suffix == ".vtu":
        assert data.IsHomogeneous() and data.GetCellType(0) == VTK_HEXAHEDRON, path.name
    points = vtk_to_numpy(data.GetPoints().GetData())
    target = data.GetPointData().GetArray("TargetPosition")
    target = None if target is None else vtk_to_numpy(target)
    for array in (points,) if target is None else (points, target):
        assert array.dtype == np.float64 and array.shape == points.shape, f"{path.name}: not double x 3"
        assert np.isfinite(array).all(), f"{path.name}: not finite"
    return points, vtk_to_numpy(cells.GetConnectivityArray()).reshape(-1, corners).astype(np.int64), target


def read_curves(name, data):
    """Points, how many points each curve has, and no target."""
    lines = data.GetLines()
    assert data.GetNumberOfCells() == lines.GetNumberOfCells() > 0, f"{name}: not polylines"
    ids = vtk_to_numpy(lines.GetConnectivityArray())
    assert (ids == np.arange(data.GetNumberOfPoints())).all(), f"{name}: curves share points"
    return vtk_to_numpy(data.GetPoints().GetData()), np.diff(vtk_to_numpy(lines.GetOffsetsArray())), None


def read_array(path, name, field=False):
    """A point array or field data of a .vtp file."""
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    data = reader.GetOutput()
    return vtk_to_numpy((data.GetFieldData() if field else data.GetPointData()).GetArray(name))


def triple(a, b, c):
    """a . (b x c), row by row."""
    return np.einsum("ij,ij->i", a, np.cross(b, c))


def volume(points, triangles):
    """The volume that a closed surface bounds; positive where it is oriented outward."""
    return triple(*points[triangles].transpose(1, 0, 2)).sum() / 6


def doubled_normals(points, triangles):
    a, b, c = points[triangles].transpose(1, 0, 2)
    return np.cross(b - a, c - a)


def assert_closed_manifold(name, triangles, count, euler):
    """Each side has one twin in the other direction, each point one fan of triangles, all in one piece."""
    sides = np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=-1).reshape(-1, 2)
    keys, twins = sides @ [count, 1], sides @ [1, count]
    order = np.argsort(keys)
    assert (np.diff(keys[order]) > 0).all(), f"{name}: a side is used twice in the same direction"
    twin = order[np.minimum(np.searchsorted(keys[order], twins), len(order) - 1)]
    assert (keys[twin] == twins).all(), f"{name}: a side has no twin"

    # Around a point: from the side that leaves it to the side after its twin. One cycle a point.
    turn = twin // 3 * 3 + (twin + 1) % 3
    label = np.arange(len(sides))
    jump = turn
    for _ in range(10):  # fans of up to 2^10 triangles
        label, jump = np.minimum(label, label[jump]), jump[jump]
    assert (label == label[turn]).all(), f"{name}: a fan of more than 1024 triangles"
    assert len(np.unique(label)) == count == len(np.unique(triangles)), f"{name}: a point with two fans or none"

    piece = np.arange(count)
    while True:
        least = piece.copy()
        np.minimum.at(least, sides[:, 0], piece[sides[:, 1]])
        least = least[least]
        if (least == piece).all():
            break
        piece = least
    assert (piece == 0).all(), f"{name}: more than one piece"
    assert count - len(sides) // 2 + len(triangles) == euler, f"{name}: the Euler number is not {euler}"


def near_pairs(low, high):
    """Pairs of boxes that overlap, found by a grid as coarse as the largest box."""
    size = (high - low).max()
    first = np.floor((low - low.min(axis=0)) / size).astype(np.int64)
    last = np.floor((high - low.min(axis=0)) / size).astype(np.int64)
    steps = np.argwhere(np.ones((2, 2, 2)))
    cells = first[:, None, :] + steps
    box = np.repeat(np.arange(len(low)), 8)[(cells <= last[:, None, :]).all(axis=2).reshape(-1)]
    cells = cells[(cells <= last[:, None, :]).all(axis=2)]
    keys = np.ravel_multi_index(cells.T, last.max(axis=0) + 1)
    order = np.argsort(keys, kind="stable")
    keys, box = keys[order], box[order]
    found = []
    for shift in range(1, len(keys)):
        same = keys[shift:] == keys[:-shift]
        if not same.any():
            break
        a, b = box[:-shift][same], box[shift:][same]
        keep = ((low[a] <= high[b]) & (low[b] <= high[a])).all(axis=1)
        found.append(np.stack([a[keep], b[keep]], axis=1))
    return np.unique(np.concatenate(found), axis=0)


def piercings(points, triangles):
    """How many pairs (side, triangle) without a common point cross each other deeper than rounding."""
    corners = points[triangles]
    pairs = near_pairs(corners.min(axis=1), corners.max(axis=1))
    noise = 1e-12 * np.ptp(points, axis=0).max()**3
    count = 0
    for one, other in ((pairs[:, 0], pairs[:, 1]), (pairs[:, 1], pairs[:, 0])):
        abc = triangles[other]
        a, b, c = points[abc].transpose(1, 0, 2)
        for i in range(3):
            side = triangles[one][:, [i, (i + 1) % 3]]
            apart = (abc[:, :, None] != side[:, None, :]).all(axis=(1, 2))
            p, q = points[side].transpose(1, 0, 2)
            normal = np.cross(b - a, c - a)
            above, below = np.einsum("ij,ij->i", p - a, normal), np.einsum("ij,ij->i", q - a, normal)
            crosses = apart & (above * below < 0) & (np.minimum(abs(above), abs(below)) > noise)
            p, d = p[crosses], (q - p)[crosses]
            x, y, z = (corner[crosses] - p for corner in (a, b, c))
            turns = np.stack([triple(d, x, y), triple(d, y, z), triple(d, z, x)])
            count += int(((turns > 0).all(axis=0) | (turns < 0).all(axis=0)).sum())
    return count


def inside(domain, p):
    """Is the point within the polycube?"""
    def within_any(boxes):
        result = np.zeros(len(p), dtype=bool)
        for low, high in boxes:
            result |= ((p > low) & (p < high)).all(axis=1)
        return result
    fill, empty, _ = POLYCUBES[domain]
    return within_any(fill) & ~within_any(empty)


def assert_onto_sphere(name, target, triangles):
    """On the unit sphere, every image triangle outward, the sphere covered once."""
    assert abs(np.linalg.norm(target, axis=1) - 1).max() < 1e-12, f"{name}: off the unit sphere"
    a, b, c = target[triangles].transpose(1, 0, 2)
    determinant = triple(a, b, c)
    assert (determinant > 0).all(), f"{name}: {(determinant <= 0).sum()} image triangles flipped or flat"
    dots = [np.einsum("ij,ij->i", u, v) for u, v in ((a, b), (b, c), (c, a))]
    angle = 2 * np.arctan2(determinant, 1 + sum(dots)).sum()
    assert abs(angle - 4 * np.pi) < 1e-8, f"{name}: the images cover a solid angle of {angle}"


def assert_onto_polycube(name, domain, target, triangles):
    """On the polycube's surface, no image triangle flipped or flat, the surface covered once."""
    corners = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
    beside = np.stack([inside(domain, target + 1e-12 * corner) for corner in corners])
    assert (beside.any(axis=0) & ~beside.all(axis=0)).all(), f"{name}: off the polycube"
    normals = doubled_normals(target, triangles)
    areas = np.linalg.norm(normals, axis=1) / 2
    assert areas.min() > 0, f"{name}: {(areas == 0).sum()} image triangles are flat"
    step = 1e-4 * normals / (2 * areas[:, None])
    middle = target[triangles].mean(axis=1)
    good = inside(domain, middle - step) & ~inside(domain, middle + step)
    assert good.all(), f"{name}: {(~good).sum()} image triangles are flipped or off the faces"
    area = POLYCUBES[domain][2]
    assert abs(areas.sum() - area) < 1e-9 * area, f"{name}: the images' area is {areas.sum()}, not {area}"


def bent(name, box):
    """Where a bar's point comes from: twist about the axis, then roll the axis onto a circle, as complex numbers."""
    bend_angle, twist_angle = BARS[name.replace("Small", "")]
    share = box[:, 0] / 4
    section = (box[:, 1] + 1j * box[:, 2]) * np.exp(1j * twist_angle * share)
    radius = 4 / bend_angle
    arc = 1j * radius + (section.real - radius) * 1j * np.exp(1j * bend_angle * share)
    return np.stack([arc.real, arc.imag, section.imag], axis=1)


def check_surface(name, points, triangles, target):
    count, euler, domain = SURFACES[name]
    assert len(points) == count, f"{name}: {len(points)} points, not {count}"
    assert_closed_manifold(name, triangles, count, euler)
    assert volume(points, triangles) > 0, f"{name}: oriented inward"
    if domain == "sphere":
        assert_onto_sphere(name, target, triangles)
    else:
        assert_onto_polycube(name, domain, target, triangles)
    if name.startswith("Dented"):
        # A surface that turns outward everywhere as seen from the centre, along rays: it cannot meet itself.
        assert np.linalg.norm(np.cross(points, target), axis=1).max() < 1e-12, f"{name}: not on its ray"
        assert triple(*points[triangles].transpose(1, 0, 2)).min() > 0, f"{name}: not star-shaped"
        assert np.ptp(np.linalg.norm(points, axis=1)) > 0.4, f"{name}: no dents"
    else:
        crossings = piercings(points, triangles)
        assert crossings == 0, f"{name}: meets itself in {crossings} places"
    if name.startswith("TwoTorus"):
        normals = doubled_normals(points, triangles)
        normals /= np.linalg.norm(normals, axis=1, keepdims=True)
        sides = np.sort(np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=-1).reshape(-1, 2), axis=1)
        pairs = np.lexsort(sides.T).reshape(-1, 2) // 3
        crease = np.degrees(np.arccos(np.clip((normals[pairs[:, 0]] * normals[pairs[:, 1]]).sum(axis=1), -1, 1)))
        limit = 60 if "Small" in name else 30
        assert crease.max() < limit, f"{name}: a crease of {crease.max()} degrees is not round"
    if domain == "bar":
        assert abs(bent(name, target) - points).max() < 1e-12, f"{name}: not the bend of its target"


def check_creature(name, points, triangles, target):
    count, euler = CREATURES[name]
    assert len(points) == count and target is None, f"{name}: {len(points)} points, not {count}"
    assert_closed_manifold(name, triangles, count, euler)
    assert volume(points, triangles) > 0, f"{name}: oriented inward"
    assert piercings(points, triangles) == 0, f"{name}: meets itself"


def check_drawn(name, points, hexahedra, drawn):
    """Unit cubes at integers, as many as said, whose boundary is a closed manifold; they are drawn in their order."""
    count, euler = DRAWN[name]
    assert len(hexahedra) == count, f"{name}: {len(hexahedra)} cubes, not {count}"
    assert (points == np.rint(points)).all(), f"{name}: points off the lattice"
    corners = points[hexahedra]
    assert (corners - corners[:, :1] == CUBE).all(), f"{name}: a cell is no unit cube"
    assert ((drawn[hexahedra] - drawn[hexahedra[:, 0]][:, None] > 0) == (CUBE > 0)).all(), f"{name}: drawn turned"
    quads = boundary_quads(hexahedra)
    triangles = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
    used, triangles = np.unique(triangles, return_inverse=True)
    assert_closed_manifold(name, triangles.reshape(-1, 3), len(used), euler)


def jacobians(move, points):
    """The determinant of the map `move` at each point, by central differences."""
    step = 1e-6 * np.eye(3)
    columns = [(move(points + e) - move(points - e)) / 2e-6 for e in step]
    return triple(*columns)


def grid_inside(points, triangles, cells, gap):
    """The points of a grid over the surface's box that lie deeper than `gap` inside."""
    low, high = points.min(axis=0), points.max(axis=0)
    grid = low + (np.argwhere(np.ones((cells, cells, cells))) + 0.5) / cells * (high - low)
    return grid[signed_distance(points, triangles, grid) < -gap]


def at_share(curve, shares):
    """The points of a polyline at shares of its length."""
    length = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(curve, axis=0), axis=1))])
    return np.stack([np.interp(shares * length[-1], length, column) for column in curve.T], axis=1)


def check_figures(folder, deform):
    """Each figure B is the one-to-one image of its figure A; the skeletons lie inside and correspond by arc length."""
    skeletons = [read(folder / f"Figure{figure}Skeleton.vtp") for figure in "AB"]
    for size, count in FIGURES.items():
        a, triangles, target = read(folder / f"FigureA{size}.vtp")
        b, triangles_b, no_target = read(folder / f"FigureB{size}.vtp")
        name = f"figures{size}"
        assert len(a) == count and (triangles == triangles_b).all() and no_target is None, f"{name}: {len(a)} points"
        assert (target == b).all() and (read_array(folder / f"FigureB{size}.vtp", "SourcePosition") == a).all(), name
        assert abs(deform(a) - b).max() < 1e-12, f"{name}: not the deformation"
        assert_closed_manifold(name, triangles, count, 2)
        for points, (curves, _, _) in zip((a, b), skeletons):
            assert volume(points, triangles) > 0.03, f"{name}: oriented inward"
            assert piercings(points, triangles) == 0, f"{name}: a figure meets itself"
            # No triangle is turned against those around it.
            normals = doubled_normals(points, triangles)
            normals /= np.linalg.norm(normals, axis=1, keepdims=True)
            around = sum(np.stack([np.bincount(corner, column, count) for column in normals.T], axis=1)
                         for corner in triangles.T)
            around /= np.linalg.norm(around, axis=1, keepdims=True)
            agreement = np.einsum("tij,tj->ti", around[triangles], normals).min()
            assert agreement > 0.7, f"{name}: normals at a point as far apart as {np.degrees(np.arccos(agreement))}"
            depth = -signed_distance(points, triangles, curves[::4]).max()
            assert depth > 0.01, f"{name}: the skeleton is {depth} inside"
            longest = np.linalg.norm(points[triangles] - points[np.roll(triangles, -1, axis=1)], axis=2).max()
            assert longest < 3 * (0.034 if size else 0.0146), f"{name}: a side of {longest}"
        # One-to-one on the boundary and locally inside: one-to-one.
        if size:
            least = jacobians(deform, grid_inside(a, triangles, 24, 0)).min()
            assert least > 0.1, f"{name}: the deformation's determinant falls to {least}"
    shares = np.linspace(0, 1, 101)
    curves = [np.split(points, np.cumsum(counts)[:-1]) for points, counts, _ in skeletons]
    assert len(curves[0]) == len(curves[1]) == 5, "the skeletons have not five curves each"
    for i, (one, other) in enumerate(zip(*curves)):
        assert len(one) != len(other), f"curve {i}: the samples correspond"
        gap = np.linalg.norm(deform(at_share(one, shares)) - at_share(other, shares), axis=1).max()
        assert gap < 1e-5, f"curve {i}: equal shares of arc length are {gap} apart"


def check_charges(folder):
    """The charge set's surface is the dented sphere's; it has no charge inside, and its map is one-to-one."""
    points, triangles, _ = read(folder / "DentedSphereCharges.vtp")
    charges = read_array(folder / "DentedSphereCharges.vtp", "Charge")
    affine = read_array(folder / "DentedSphereCharges.vtp", "Affine", field=True)
    surface, surface_triangles, _ = read(folder / "DentedSphere600.vtp")
    assert charges.shape == points.shape and affine.shape == (3, 4), "shapes of the charge set"
    count = len(points) - len(surface)
    assert (points[count:] == surface).all() and (triangles == surface_triangles + count).all(), "another surface"
    assert (charges[count:] == 0).all() and (charges[:count] != 0).all() and count == 12, "charges on the surface"
    assert signed_distance(surface, surface_triangles, points[:count]).min() > 0.3, "a charge near the domain"

    def move(y):
        distances = np.linalg.norm(y[:, None, :] - points[:count], axis=2)
        return y @ affine[:, :3].T + affine[:, 3] + (1 / (4 * np.pi * distances)) @ charges[:count]
    least = jacobians(move, grid_inside(surface, surface_triangles, 16, 0)).min()
    assert least > 0.3, f"the charge set's determinant falls to {least}"
    image = move(surface)
    assert piercings(image, surface_triangles) == 0 and volume(image, surface_triangles) > 0, "the image meets itself"


def boundary_quads(hexahedra):
    """The faces that one hexahedron has and no other; no face has more than two."""
    faces = hexahedra[:, [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]]]
    faces = faces.reshape(-1, 4)
    _, first, uses = np.unique(np.sort(faces, axis=1), axis=0, return_index=True, return_counts=True)
    assert uses.max() <= 2, "a face with three hexahedra"
    return faces[first[uses == 1]]


def least_scaled_jacobian(path):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    quality = vtkMeshQuality()
    quality.SetInputConnection(reader.GetOutputPort())
    quality.SetHexQualityMeasureToScaledJacobian()
    quality.Update()
    return vtk_to_numpy(quality.GetOutput().GetCellData().GetArray("Quality")).min()


def check_solid(path, points, hexahedra, target):
    name = path.stem
    count, cells, bound = SOLIDS[name]
    assert (len(points), len(hexahedra)) == (count, cells), f"{name}: {len(points)} points, {len(hexahedra)} cells"
    least = least_scaled_jacobian(path)
    assert least > bound, f"{name}: least scaled Jacobian {least}, not above {bound}"
    quads = boundary_quads(hexahedra)
    skin, quads = np.unique(quads, return_inverse=True)
    triangles = quads.reshape(-1, 4)[:, [0, 1, 2, 0, 2, 3]].reshape(-1, 3)
    assert_closed_manifold(name, triangles, len(skin), 2)
    solid = volume(points[skin], triangles)
    if name.startswith("Ball"):
        radius = np.linalg.norm(points, axis=1)
        assert abs(radius[skin] - 1).max() < 1e-12, f"{name}: skin off the unit sphere"
        assert np.delete(radius, skin).max() < 1 - 1e-3, f"{name}: an inner point on the sphere"
        assert 0.95 < solid / (4 * np.pi / 3) < 1, f"{name}: volume {solid}"
    elif name.startswith("Cube"):
        assert abs(abs(points[skin]).max(axis=1) - 0.55).max() < 1e-12, f"{name}: skin off the cube"
        assert abs(solid - 1.1**3) < 1e-12 and np.linalg.norm(points, axis=1).max() < 0.96, f"{name}: volume {solid}"
    else:
        assert abs(bent(name, target) - points).max() < 1e-12, f"{name}: not the bend of its target"
        assert abs(volume(target[skin], triangles) - 4) < 1e-11, f"{name}: the target is not the box"
        assert abs(solid / 4 - 1) < 0.02, f"{name}: bending changed the volume to {solid}"


def signed_distance(points, triangles, at):
    """The distance of each row of `at` to a surface, negative inside."""
    data, coordinates, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    coordinates.SetData(numpy_to_vtk(points, deep=True))
    cells.SetData(numpy_to_vtkIdTypeArray(3 * np.arange(len(triangles) + 1), deep=True),
                  numpy_to_vtkIdTypeArray(np.ascontiguousarray(triangles).reshape(-1), deep=True))
    data.SetPoints(coordinates)
    data.SetPolys(cells)
    distance = vtkImplicitPolyDataDistance()
    distance.SetInput(data)
    return np.array([distance.EvaluateFunction(row) for row in at])


def check_nesting(name, outer, inner, gap):
    """The inner surface lies within the outer one: nothing crosses, a thousand points at least `gap` inside."""
    (p, s), (q, t) = outer, inner
    crossings = piercings(np.concatenate([p, q]), np.concatenate([s, t + len(p)]))
    assert crossings == 0, f"{name}: the surfaces cross in {crossings} places"
    nearest = -signed_distance(p, s, q[:: len(q) // 1000]).max()
    assert nearest > gap, f"{name}: the gap is {nearest}, not above {gap}"


def check_twin(name, generated, committed):
    """Equal but for the last bits, in which mathematical libraries differ."""
    for new, old in zip(generated, committed):
        assert (new is None) == (old is None) and (new is None or new.shape == old.shape), f"{name} is stale"
    assert (generated[1] == committed[1]).all(), f"{name}: other cells than a fresh one"
    for new, old in zip(generated[::2], committed[::2]):
        assert new is None or abs(new - old).max() < 1e-12, f"{name}: differs from a fresh one; run make_shapes.py"


def main(generated, committed):
    shapes = {}
    for name in SURFACES:
        shapes[name] = read(generated / f"{name}.vtp")
        check_surface(name, *shapes[name])
    for name in SOLIDS:
        path = generated / f"{name}.vtu"
        check_solid(path, *read(path))
    for name in CREATURES:
        check_creature(name, *read(generated / f"{name}.vtp"))
    for name in DRAWN:
        check_drawn(name, *read(generated / f"{name}Polycube.vtu"))
    check_figures(generated, figures.deform)
    check_charges(generated)
    for size in ("Small", ""):
        head, skull, brain = (shapes[f"Phantom{part}{size}"] for part in ("Head", "Skull", "Brain"))
        for space, column in (("source", 0), ("target", 2)):
            surfaces = [(part[column], part[1]) for part in (head, skull, brain)]
            check_nesting(f"skull{size} in head ({space})", surfaces[0], surfaces[1], 0.05)
            check_nesting(f"brain{size} in skull ({space})", surfaces[1], surfaces[2], 0.05)
    files = [path for path in sorted(committed.iterdir()) if path.suffix in (".vtp", ".vtu")]
    assert files, f"no shapes in {committed}"
    for path in files:
        check_twin(path.name, read(generated / path.name), read(path))
    assert sum(path.stat().st_size for path in files) < 2e6, "the committed shapes are more than 2 MB"


if __name__ == "__main__":
    sys.path.insert(0, sys.argv[2])
    from shapes import figures
    main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]))
