"""Rows of panels in one picture, in which each shape has a view of its own."""
import os

import numpy
from paraview import simple
from vtkmodules.vtkCommonDataModel import vtkPlane, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkClipPolyData, vtkTubeFilter

import panels
import scenes  # knows where shapetesting.py is

from composition_common import at, with_normals
from scenes import points

HANDLE = [0.05, 0.45, 0.75]


def cropped(data, right, up):
    """What is less than so far from the z axis; the very data where that is all of it."""
    if (numpy.abs(points(data)) <= [right, up, numpy.inf]).all():
        return data
    data = with_normals(data)
    for axis, most in ((0, right), (1, up)):
        for side in (-1.0, 1.0):
            plane, clip = vtkPlane(), vtkClipPolyData()
            normal = [0.0, 0.0, 0.0]
            normal[axis] = side
            plane.SetOrigin([side * most if k == axis else 0.0 for k in range(3)])
            plane.SetNormal(normal)
            clip.SetInputData(data)
            clip.SetClipFunction(plane)
            clip.InsideOutOn()
            clip.Update()
            data = clip.GetOutput()
    return data


class Row:
    """Panels of one unit's width and `height`, counted from 0 in rows of `columns`. What is shown in
    a panel is seen from `direction` and `centre` is in its middle, `size` as large as the panel."""

    def __init__(self, columns, rows=1, height=1.0, foot=0.1, pixels=1600):
        self.Columns, self.Rows, self.Height, self.Foot = columns, rows, height, foot
        high = rows * (height + 0.16) + foot
        self.High = high
        self.Picture = panels.Picture((pixels, int(round(pixels * high / columns))),
                                      [0.0, 0.0, 1.0], [0.0, 1.0, 0.0])

    def shift(self, panel):
        return (panel % self.Columns, -(panel // self.Columns) * (self.Height + 0.16))

    def show(self, panel, data, centre, size, direction, up, colour=None, **options):
        """As panels.Picture.show."""
        toward = numpy.asarray(direction, float) / numpy.linalg.norm(direction)
        right = numpy.cross(up, toward)
        right /= numpy.linalg.norm(right)
        view = numpy.stack([right, numpy.cross(toward, right), toward])
        turned = at(data, (points(data) - centre) @ view.T)
        turned.GetPointData().RemoveArray('Normals')
        turned.GetCellData().RemoveArray('Normals')
        turned = cropped(turned, 0.49 * size, 0.5 * self.Height * size)
        display = self.Picture.show(turned, self.shift(panel), 1.0 / size, colour=colour, **options)
        display.Specular = 0.15
        return display

    def tube(self, panel, curve, centre, size, *view, width=0.006, colour=HANDLE):
        """A curve, thick."""
        plain, tube = vtkPolyData(), vtkTubeFilter()
        plain.SetPoints(curve.GetPoints())
        plain.SetLines(curve.GetLines())
        tube.SetInputData(plain)
        tube.SetRadius(width * size)
        tube.SetNumberOfSides(12)
        tube.Update()
        self.Picture.flat(self.show(panel, tube.GetOutput(), centre, size, *view, colour))

    def dots(self, panel, positions, view, size, colour):
        """Small balls of this radius, as a share of the panel."""
        ball = panels.balls(numpy.atleast_2d(positions), size * view[1])
        self.Picture.flat(self.show(panel, ball, *view, colour))

    def caption(self, panel, text, size=17):
        right, up = self.shift(panel)
        lines = text.split('\n')
        for index, line in enumerate(lines):
            self.Picture.caption(line, right, up - 0.5 * self.Height - 0.06 - 0.055 * index * size / 17,
                                 size)

    def footnote(self, text, size=16):
        self.Picture.caption(text, 0.5 * (self.Columns - 1),
                             0.5 * self.Height - self.High + 0.04, size)

    def save(self, folder, number):
        path = os.path.join(folder, 'composition%s.png' % number)
        self.Picture.save(path, (0.5 * (self.Columns - 1), 0.5 * (self.Height - self.High)), self.High)
        scenes.say('drew ' + os.path.basename(path))


def redden(row, display, name, high):
    """Colours a shown surface by a point array: grey at 0, red at `high`."""
    row.Picture.colour(display, 'POINTS', name, 0.0, high, steps=64)
    table = simple.GetColorTransferFunction(name)
    table.ColorSpace = 'Lab'
    table.RGBPoints = [0.0, 0.80, 0.82, 0.84, 0.25 * high, 0.95, 0.85, 0.70,
                       0.5 * high, 0.95, 0.60, 0.35, high, 0.80, 0.05, 0.08]
