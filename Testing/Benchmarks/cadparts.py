"""Forty CAD parts, each written for a script of Gmsh's OpenCASCADE: booleans of boxes, cylinders, cones,
spheres and tori, fillets and chamfers. They have curved creases, holes close to edges, thin walls, corners of
four patches, and a genus of 0 to 20.

CHOOSING, ASSERTING and UNSEEN divide them. Parameters of the kernels are chosen on the first fifteen only;
what is claimed is claimed of the next fifteen, other designs of the same kinds, and of the last ten, which
are of other kinds.
"""
import math
import os
import subprocess

EVERYWHERE = ((-1e3, -1e3, -1e3), (1e3, 1e3, 1e3))


class Script:
    """Lines of a .geo file. A solid is the name of a list of volumes."""

    def __init__(self):
        self.Lines, self.Count = ['SetFactory("OpenCASCADE");'], 0

    def solid(self, expression):
        self.Count += 1
        self.Lines.append('v%d() = %s' % (self.Count, expression))
        return 'v%d()' % self.Count

    def primitive(self, kind, *numbers):
        self.Count += 1
        name = 'v%d' % self.Count
        self.Lines.append('%s() = {newv}; %s(%s(0)) = {%s};' % (
            name, kind, name, ', '.join('%.15g' % number for number in numbers)))
        return name + '()'

    def box(self, *corner_and_size):
        return self.primitive('Box', *corner_and_size)

    def cylinder(self, *foot_axis_radius):
        return self.primitive('Cylinder', *foot_axis_radius)

    def cone(self, *foot_axis_radii):
        return self.primitive('Cone', *foot_axis_radii)

    def sphere(self, *centre_radius):
        return self.primitive('Sphere', *centre_radius)

    def torus(self, *centre_radii_angle):
        return self.primitive('Torus', *centre_radii_angle)

    def wedge(self, *corner_size_top):
        return self.primitive('Wedge', *corner_size_top)

    def combine(self, how, one, others):
        return self.solid('Boolean%s{ Volume{%s}; Delete; }{ Volume{%s}; Delete; };' % (
            how, one, ', '.join(others)))

    def cut(self, one, *others):
        return self.combine('Difference', one, others)

    def join(self, one, *others):
        return self.combine('Union', one, others)

    def common(self, one, *others):
        return self.combine('Intersection', one, others)

    def turn(self, solid, axis, through, degrees):
        self.Lines.append('Rotate{ {%g, %g, %g}, {%g, %g, %g}, %.15g }{ Volume{%s}; }' % (
            *axis, *through, math.radians(degrees), solid))
        return solid

    def edges(self, boxes):
        """The name of the list of curves that lie in one of the boxes (lowest and highest corner)."""
        self.Count += 1
        self.Lines.append('e%d() = {};' % self.Count)
        for low, high in boxes:
            self.Lines.append('e%d() += Curve In BoundingBox {%s};' % (
                self.Count, ', '.join('%g' % number for number in (
                    *(value - 1e-3 for value in low), *(value + 1e-3 for value in high)))))
        return 'e%d()' % self.Count

    def fillet(self, solid, radius, *boxes):
        return self.solid('Fillet{ %s }{ %s }{ %g };' % (solid, self.edges(boxes), radius))

    def text(self, size):
        """Triangles have edges of at most `size`, and 20 follow a full circle."""
        return '\n'.join(self.Lines + [
            'Mesh.MeshSizeMax = %.10g;' % size, 'Mesh.MeshSizeFromCurvature = 20;',
            'Mesh.Algorithm = 6;', 'Mesh.RandomSeed = 1;', ''])


def ring(count, radius, begin=0.0):
    """Positions on a circle around the z axis."""
    return [(radius * math.cos(angle), radius * math.sin(angle)) for angle in (
        begin + 2.0 * math.pi * i / count for i in range(count))]


# The parts to choose with.

def bracket(s):
    """An angle with a filleted inner edge and two holes in each leg."""
    part = s.join(s.box(0, 0, 0, 4, 3, 0.6), s.box(0, 0, 0, 0.6, 3, 3))
    part = s.fillet(part, 0.5, ((0.6, 0, 0.6), (0.6, 3, 0.6)))
    holes = [s.cylinder(2.8, y, -1, 0, 0, 3, 0.35) for y in (0.8, 2.2)]
    return s.cut(part, *holes, *[s.cylinder(-1, y, 2.1, 3, 0, 0, 0.35) for y in (0.8, 2.2)])


def flange(s):
    """A disk with a hub, a bore and six bolt holes."""
    part = s.join(s.cylinder(0, 0, 0, 0, 0, 0.5, 2.5), s.cylinder(0, 0, 0, 0, 0, 1.6, 1.2))
    holes = [s.cylinder(x, y, -1, 0, 0, 3, 0.25) for x, y in ring(6, 1.85)]
    return s.cut(part, s.cylinder(0, 0, -1, 0, 0, 4, 0.8), *holes)


def elbow(s):
    """A quarter of a pipe between two round flanges."""
    bend = s.join(s.torus(0, 0, 0, 2, 0.7, math.pi / 2), s.cylinder(2, -0.4, 0, 0, 0.4, 0, 1.0),
                  s.cylinder(-0.4, 2, 0, 0.4, 0, 0, 1.0))
    return s.cut(bend, s.torus(0, 0, 0, 2, 0.45, math.pi / 2), s.cylinder(2, -1, 0, 0, 1, 0, 0.45),
                 s.cylinder(-1, 2, 0, 1, 0, 0, 0.45))


def cross_bores(s):
    """A cube with three bores that cross in its centre: curves where four patches nearly meet."""
    return s.cut(s.box(-1, -1, -1, 2, 2, 2), s.cylinder(-2, 0, 0, 4, 0, 0, 0.5),
                 s.cylinder(0, -2, 0, 0, 4, 0, 0.45), s.cylinder(0, 0, -2, 0, 0, 4, 0.4))


def plate_of_holes(s):
    """A plate with twenty holes."""
    holes = [s.cylinder(0.6 + x, 0.6 + y, -1, 0, 0, 3, 0.3) for x in range(5) for y in range(4)]
    return s.cut(s.box(0, 0, 0, 5.2, 4.2, 0.5), *holes)


def edge_hole(s):
    """A plate with a hole and a slot whose walls to the edges are thin."""
    slot = s.join(s.box(2.4, 0.25, -1, 1.2, 0.6, 3), s.cylinder(2.4, 0.55, -1, 0, 0, 3, 0.3),
                  s.cylinder(3.6, 0.55, -1, 0, 0, 3, 0.3))
    return s.cut(s.box(0, 0, 0, 4.2, 2.4, 0.7), s.cylinder(0.85, 1.65, -1, 0, 0, 3, 0.6), slot)


def rounded_block(s):
    """A block, all edges filleted, with a bore."""
    return s.cut(s.fillet(s.box(0, 0, 0, 3, 2, 1.5), 0.3, EVERYWHERE),
                 s.cylinder(1.5, 1, -1, 0, 0, 4, 0.45))


def nozzle(s):
    """A frustum with a conical bore and a round groove."""
    part = s.join(s.cone(0, 0, 0, 0, 0, 3, 1.5, 0.8), s.cylinder(0, 0, -0.5, 0, 0, 0.5, 1.9))
    return s.cut(part, s.cone(0, 0, -0.5, 0, 0, 3.5, 1.0, 0.4), s.torus(0, 0, -0.25, 1.9, 0.15))


def saddle(s):
    """Two cylinders of unequal radii that cross at an angle."""
    return s.join(s.cylinder(-2, 0, 0, 4, 0, 0, 0.9), s.cylinder(0, 0, 0, 1.2, 0, 2.2, 0.6))


def oblique_bore(s):
    """A block with an oblique bore, whose ends are ellipses."""
    return s.cut(s.box(0, 0, 0, 3, 2, 2), s.cylinder(0.2, 1, -1, 2.2, 0.3, 4, 0.5))


def ring_groove(s):
    """A block with a round groove and a boss within it."""
    part = s.cut(s.box(-2, -2, 0, 4, 4, 1), s.torus(0, 0, 1, 1.3, 0.35))
    return s.join(part, s.cone(0, 0, 1, 0, 0, 0.6, 0.6, 0.4))


def pulley(s):
    """A disk with a V groove around it, a bore and a keyway."""
    part = s.join(s.cone(0, 0, 0, 0, 0, 0.6, 2, 1.5), s.cone(0, 0, 0.6, 0, 0, 0.6, 1.5, 2))
    return s.cut(part, s.join(s.cylinder(0, 0, -1, 0, 0, 4, 0.5), s.box(-0.12, 0, -1, 0.24, 0.68, 4)))


def yoke(s):
    """A fork with round ends and a pin hole through both arms, its inner edges filleted."""
    arms = [s.join(s.box(0, -0.7, z, 2.2, 1.4, 0.5), s.cylinder(2.2, 0, z, 0, 0, 0.5, 0.7))
            for z in (0, 1.3)]
    part = s.join(s.box(-0.8, -0.7, 0, 0.8, 1.4, 1.8), *arms)
    part = s.fillet(part, 0.2, ((0, -0.7, 0.5), (0, 0.7, 0.5)), ((0, -0.7, 1.3), (0, 0.7, 1.3)))
    return s.cut(part, s.cylinder(2.2, 0, -1, 0, 0, 4, 0.35))


def dimples(s):
    """A block with spherical dimples, one of which cuts an edge, and a bevelled top."""
    part = s.wedge(0, 0, 0, 3, 2, 1.6, 2.2)
    return s.cut(part, s.sphere(0.8, 1.0, -0.2, 0.6), s.sphere(2.1, 0.9, -0.3, 0.6),
                 s.sphere(0, 2, 0.8, 0.5))


def frame(s):
    """The bars along the edges of a box."""
    part = s.box(0, 0, 0, 3, 2.4, 2)
    return s.cut(part, s.box(0.4, 0.4, -1, 2.2, 1.6, 4), s.box(-1, 0.4, 0.4, 5, 1.6, 1.2),
                 s.box(0.4, -1, 0.4, 2.2, 5, 1.2))


# The parts to assert on.

def lever(s):
    """Two bosses of unequal size and height, a web between them, and a bore in each."""
    part = s.join(s.cylinder(0, 0, 0, 0, 0, 1.2, 0.9), s.cylinder(3.4, 0, 0, 0, 0, 0.9, 0.6),
                  s.box(0, -0.35, 0.2, 3.4, 0.7, 0.5))
    return s.cut(part, s.cylinder(0, 0, -1, 0, 0, 4, 0.5), s.cylinder(3.4, 0, -1, 0, 0, 4, 0.3))


def cogwheel(s):
    """A disk with ten teeth and a bore."""
    teeth = [s.turn(s.box(1.5, -0.22, 0, 0.75, 0.44, 0.7), (0, 0, 1), (0, 0, 0), 36 * i)
             for i in range(10)]
    return s.cut(s.join(s.cylinder(0, 0, 0, 0, 0, 0.7, 1.8), *teeth), s.cylinder(0, 0, -1, 0, 0, 3, 0.6))


def manifold(s):
    """A block with a long bore and three side bores that end in it."""
    sides = [s.cylinder(x, 0.8, 0.8, 0, 0, 2, 0.3) for x in (0.9, 2.2, 3.5)]
    return s.cut(s.box(0, 0, 0, 4.4, 1.6, 1.6), s.cylinder(-1, 0.8, 0.8, 7, 0, 0, 0.42), *sides)


def sieve(s):
    """A disk with eighteen holes in two rings around one."""
    holes = [s.cylinder(x, y, -1, 0, 0, 3, 0.22) for x, y in
             ring(6, 0.8) + ring(12, 1.6, 0.1) + [(0, 0)]]
    return s.cut(s.cylinder(0, 0, 0, 0, 0, 0.45, 2.1), *holes)


def hinge(s):
    """A leaf with two knuckles around a pin hole, and three holes for screws."""
    knuckles = [s.cylinder(0, y, 0.3, 0, 0.9, 0, 0.45) for y in (0, 2.1)]
    part = s.join(s.box(0, 0, -0.15, 2.4, 3, 0.4), *knuckles)
    part = s.cut(part, s.box(-1, 0.9, -1, 1.6, 1.2, 3))
    screws = [s.cylinder(1.7, y, -1, 0, 0, 3, 0.22) for y in (0.5, 1.5, 2.5)]
    return s.cut(part, s.cylinder(0, -1, 0.3, 0, 5, 0, 0.22), *screws)


def heat_sink(s):
    """Five fins on a base, filleted at their feet."""
    part = s.join(s.box(0, 0, 0, 4.1, 2.5, 0.6), *[
        s.box(0.9 * i, 0, 0.6, 0.5, 2.5, 1.4) for i in range(5)])
    feet = [((x, 0, 0.6), (x, 2.5, 0.6)) for i in range(5) for x in (0.9 * i, 0.9 * i + 0.5)
            if 0.1 < x < 4.0]
    return s.fillet(part, 0.12, *feet)


def tee(s):
    """A pipe with a branch."""
    part = s.join(s.cylinder(-2, 0, 0, 4, 0, 0, 0.8), s.cylinder(0, 0, 0, 0, 0, 2, 0.65))
    return s.cut(part, s.cylinder(-3, 0, 0, 6, 0, 0, 0.5), s.cylinder(0, 0, 0, 0, 0, 3, 0.4))


def cone_on_block(s):
    """A frustum on a block, filleted between them, with bevelled corners of the block."""
    part = s.join(s.box(-1.5, -1.5, 0, 3, 3, 0.9), s.cone(0, 0, 0.9, 0, 0, 1.4, 1.0, 0.5))
    part = s.fillet(part, 0.25, ((-1, -1, 0.9), (1, 1, 0.9)))
    corner = s.turn(s.box(1.5, -1, -1, 1, 2, 4), (0, 0, 1), (0, 0, 0), 45)
    return s.cut(part, s.turn(s.box(1.75, -1, -1, 1, 2, 4), (0, 0, 1), (0, 0, 0), 225), corner)


def mug(s):
    """A cup with a handle."""
    handle = s.turn(s.torus(0, 0, 0, 0.8, 0.2, math.pi), (1, 0, 0), (0, 0, 0), 90)
    handle = s.turn(handle, (0, 1, 0), (0, 0, 0), 90)
    s.Lines.append('Translate{1.05, 0, 1.3}{ Volume{%s}; }' % handle)
    cup = s.cylinder(0, 0, 0, 0, 0, 2.6, 1.2)
    return s.cut(s.join(cup, handle), s.cylinder(0, 0, 0.4, 0, 0, 3, 0.85))


def slotted_plate(s):
    """A plate with an oblique slot and two countersunk holes."""
    slot = s.join(s.box(-0.8, -0.3, -1, 1.6, 0.6, 3), s.cylinder(-0.8, 0, -1, 0, 0, 3, 0.3),
                  s.cylinder(0.8, 0, -1, 0, 0, 3, 0.3))
    sunk = [tool for x, y in ((-1.7, 0.8), (1.7, -0.8)) for tool in (
        s.cylinder(x, y, -1, 0, 0, 3, 0.25), s.cone(x, y, 0.3, 0, 0, 0.4, 0.25, 0.55))]
    return s.cut(s.box(-2.5, -1.5, 0, 5, 3, 0.6), s.turn(slot, (0, 0, 1), (0, 0, 0), 35), *sunk)


def crank(s):
    """Journals of a shaft, a crank pin and two webs."""
    webs = [s.join(s.cylinder(0, 0, z, 0, 0, 0.4, 0.8), s.cylinder(1.1, 0, z, 0, 0, 0.4, 0.7),
                   s.box(0, -0.6, z, 1.1, 1.2, 0.4)) for z in (1.0, 2.2)]
    return s.join(s.cylinder(0, 0, 0, 0, 0, 1.0, 0.45), s.cylinder(0, 0, 2.6, 0, 0, 1.0, 0.45),
                  s.cylinder(1.1, 0, 1.4, 0, 0, 0.8, 0.4), *webs)


def near_rim(s):
    """A round plate with three holes close to its rim, one of them blind with a conical end."""
    blind = s.join(s.cylinder(-1.0, -1.0, 0.5, 0, 0, 2, 0.45), s.cone(-1.0, -1.0, 0.2, 0, 0, 0.3, 0.1, 0.45))
    return s.cut(s.cylinder(0, 0, 0, 0, 0, 1.0, 2), s.cylinder(1.35, 0, -1, 0, 0, 3, 0.5),
                 s.cylinder(0, 1.4, -1, 0, 0, 3, 0.45), blind)


def ball_joint(s):
    """A ball with two flats and a bore, on a stem."""
    ball = s.common(s.sphere(0, 0, 0, 1.3), s.box(-2, -2, -0.9, 4, 4, 1.8))
    part = s.join(ball, s.cylinder(1.0, 0, 0, 2.2, 0, 0, 0.5))
    return s.cut(part, s.cylinder(0, 0, -2, 0, 0, 4, 0.6))


def housing(s):
    """An open box with walls, holes in three of them, and a boss inside."""
    part = s.cut(s.box(0, 0, 0, 3.6, 2.8, 1.8), s.box(0.35, 0.35, 0.4, 2.9, 2.1, 3))
    part = s.join(part, s.cylinder(1.8, 1.4, 0.3, 0, 0, 0.7, 0.5))
    return s.cut(part, s.cylinder(-1, 1.4, 1.1, 6, 0, 0, 0.4), s.cylinder(1.8, -1, 1.1, 0, 2, 0, 0.35),
                 s.cylinder(1.8, 1.4, -1, 0, 0, 4, 0.25))


def ribbed_bracket(s):
    """An angle with a triangular rib and four holes, one leg with round corners."""
    part = s.join(s.box(0, 0, 0, 3.4, 3, 0.5), s.box(0, 0, 0, 0.5, 3, 2.6), s.wedge(0.5, 1.25, 0.5, 1.8, 0.5, 1.5, 0))
    part = s.fillet(part, 0.6, ((3.4, 0, 0), (3.4, 0, 0.5)), ((3.4, 3, 0), (3.4, 3, 0.5)))
    return s.cut(part, *[s.cylinder(2.7, y, -1, 0, 0, 3, 0.25) for y in (0.7, 2.3)],
                 *[s.cylinder(-1, y, 1.8, 3, 0, 0, 0.3) for y in (0.7, 2.3)])


# Parts of other kinds than those above. No parameter is chosen with them.

def piston(s):
    """A piston: a crown with two ring grooves, hollow below, and a pin hole through its skirt."""
    grooves = [s.cut(s.cylinder(0, 0, z, 0, 0, 0.25, 2), s.cylinder(0, 0, z, 0, 0, 0.25, 1.05))
               for z in (1.3, 1.8)]
    part = s.cut(s.cylinder(0, 0, 0, 0, 0, 2.4, 1.3), *grooves)
    return s.cut(part, s.cylinder(0, 0, -1, 0, 0, 2.0, 0.9), s.cylinder(-2, 0, 0.45, 4, 0, 0, 0.3))


def turbine_disk(s):
    """A disk with eight round slots that cut its rim, and a bore."""
    slots = [s.cylinder(x, y, -1, 0, 0, 3, 0.35) for x, y in ring(8, 1.85, 0.2)]
    return s.cut(s.cylinder(0, 0, 0, 0, 0, 0.8, 2.0), s.cylinder(0, 0, -1, 0, 0, 3, 0.5), *slots)


def bearing_cap(s):
    """Half of a bearing: a saddle on a base, with two bolt holes."""
    part = s.join(s.box(-2.2, 0, 0, 4.4, 1.5, 0.5), s.common(
        s.cylinder(0, 0, 0, 0, 1.5, 0, 1.3), s.box(-2, 0, 0, 4, 1.5, 2)))
    part = s.cut(part, s.cylinder(0, -1, 0, 0, 4, 0, 0.8))
    return s.cut(part, *[s.cylinder(x, 0.75, -1, 0, 0, 3, 0.22) for x in (-1.75, 1.75)])


def spool(s):
    """Two round ends on a waist that is a part of a torus, with a bore."""
    part = s.cut(s.cylinder(0, 0, -1, 0, 0, 2, 1.5), s.torus(0, 0, 0, 1.6, 0.7))
    return s.cut(part, s.cylinder(0, 0, -2, 0, 0, 4, 0.4))


def lens(s):
    """What two spheres have in common: one sharp round edge, and nothing flat."""
    return s.common(s.sphere(0, 0, -1.2, 2), s.sphere(0, 0, 1.2, 2))


def honeycomb(s):
    """A block with twelve hexagonal channels of thin walls."""
    part = s.box(0, 0, 0, 4.4, 3.4, 1.0)
    channels = []
    for x, y in ((0.75 + 0.97 * i, 0.75 + 0.95 * j) for i in range(4) for j in range(3)):
        sides = [s.turn(s.box(x - 0.36, y - 0.208, -1, 0.72, 0.416, 3), (0, 0, 1), (x, y, 0), 60 * k)
                 for k in range(3)]
        channels.append(s.join(sides[0], *sides[1:]))
    return s.cut(part, *channels)


def tripod(s):
    """Three bars from a ball, 120 degrees apart, each with an eye close to its round end."""
    arms = []
    for k in range(3):
        arm = s.join(s.box(0, -0.35, -0.3, 1.9, 0.7, 0.6), s.cylinder(1.9, 0, -0.3, 0, 0, 0.6, 0.35))
        arms.append(s.turn(s.cut(arm, s.cylinder(1.9, 0, -1, 0, 0, 2, 0.2)), (0, 0, 1), (0, 0, 0), 120 * k))
    return s.join(s.sphere(0, 0, 0, 0.8), *arms)


def tube_cage(s):
    """Six bent bars between two rings: half of a cage of round tubes."""
    bars = [s.cylinder(x, y, 0, 0, 0, 1.8, 0.22) for x, y in ring(6, 1.4)]
    return s.join(s.torus(0, 0, 0, 1.4, 0.32), s.torus(0, 0, 1.8, 1.4, 0.32), *bars)


def soap_dish(s):
    """A block, its upright edges rounded, with a bowl in its top and three drains beside its deepest point."""
    part = s.fillet(s.box(-2, -1.3, 0, 4, 2.6, 1.0), 0.6, *[
        ((x, y, 0), (x, y, 1)) for x in (-2, 2) for y in (-1.3, 1.3)])
    part = s.cut(part, s.sphere(0, 0, 3.0, 2.3))
    return s.cut(part, *[s.cylinder(x, y, -1, 0, 0, 3, 0.18) for x, y in ring(3, 0.45)])


def wedge_clamp(s):
    """A bevelled block with an oblique bore that leaves near the edge of the bevel, and a slit."""
    part = s.wedge(0, 0, 0, 3.2, 1.8, 1.8, 1.6)
    part = s.cut(part, s.cylinder(1.0, 0.9, -1, 0.35, 0, 4, 0.45))
    return s.cut(part, s.box(-1, 0.82, -1, 1.75, 0.16, 4))


CHOOSING = {part.__name__: part for part in (
    bracket, flange, elbow, cross_bores, plate_of_holes, edge_hole, rounded_block, nozzle, saddle,
    oblique_bore, ring_groove, pulley, yoke, dimples, frame)}
ASSERTING = {part.__name__: part for part in (
    lever, cogwheel, manifold, sieve, hinge, heat_sink, tee, cone_on_block, mug, slotted_plate, crank,
    near_rim, ball_joint, housing, ribbed_bracket)}
UNSEEN = {part.__name__: part for part in (
    piston, turbine_disk, bearing_cap, spool, lens, honeycomb, tripod, tube_cage, soap_dish, wedge_clamp)}


def read_triangles(path):
    """Points and triangles of a file in Gmsh's format 2.2, without unused points."""
    lines = open(path).read().splitlines()
    nodes = [line.split() for line in lines[lines.index('$Nodes') + 2:lines.index('$EndNodes')]]
    positions = {int(node[0]): tuple(map(float, node[1:4])) for node in nodes}
    elements = [[int(word) for word in line.split()] for line in
                lines[lines.index('$Elements') + 2:lines.index('$EndElements')]]
    triangles = [element[-3:] for element in elements if element[1] == 2]
    used = sorted({node for triangle in triangles for node in triangle})
    index = {node: i for i, node in enumerate(used)}
    return [positions[node] for node in used], [[index[node] for node in triangle] for triangle in triangles]


def volume(points, triangles):
    def six_fold(a, b, c):
        return (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                a[2] * (b[0] * c[1] - b[1] * c[0]))
    return sum(six_fold(*(points[i] for i in triangle)) for triangle in triangles) / 6.0


def oriented(triangles):
    """The triangles with all edges passed once in each direction: Gmsh turns faces of cones around. Raises
    ValueError unless the surface is closed and can be oriented."""
    at = {}
    for i, triangle in enumerate(triangles):
        for k in range(3):
            at.setdefault(frozenset((triangle[k - 1], triangle[k])), []).append(i)
    turned, todo = {0: triangles[0]}, [0]
    while todo:
        own = todo.pop()
        for k in range(3):
            edge = turned[own][k - 1], turned[own][k]
            for other in at[frozenset(edge)]:
                if other not in turned:
                    corners = triangles[other]
                    same = any((corners[j - 1], corners[j]) == edge for j in range(3))
                    turned[other] = corners[::-1] if same else corners
                    todo.append(other)
    found = [turned[i] for i in sorted(turned)]
    edges = {(triangle[k - 1], triangle[k]) for triangle in found for k in range(3)}
    if len(found) < len(triangles) or len(edges) < 3 * len(found) or any(
            edge[::-1] not in edges for edge in edges):
        raise ValueError('not one closed surface')
    return found


def genus(points, triangles):
    """Of a connected closed surface, whose Euler number is 2 - 2 genus."""
    return 1 - (len(points) - len(triangles) // 2) // 2


def write(name, folder):
    """Meshes a part's surface as NAME.off. Returns its path, points and triangles."""
    script = Script()
    {**CHOOSING, **ASSERTING, **UNSEEN}[name](script)
    paths = {kind: os.path.join(folder, name + '.' + kind) for kind in ('geo', 'msh', 'off')}
    # A part is about 4 long: edges of 0.2 give some thousand triangles.
    with open(paths['geo'], 'w') as file:
        file.write(script.text(0.2))
    run = subprocess.run(['gmsh', paths['geo'], '-2', '-format', 'msh22', '-o', paths['msh']],
                         stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    assert run.returncode == 0 and 'Error' not in run.stdout, run.stdout
    points, triangles = read_triangles(paths['msh'])
    triangles = oriented(triangles)
    if volume(points, triangles) < 0.0:
        triangles = [triangle[::-1] for triangle in triangles]
    with open(paths['off'], 'w') as file:
        file.write('OFF\n%d %d 0\n' % (len(points), len(triangles)))
        file.writelines('%.17g %.17g %.17g\n' % point for point in points)
        file.writelines('3 %d %d %d\n' % tuple(triangle) for triangle in triangles)
    return paths['off'], points, triangles
