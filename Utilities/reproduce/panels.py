"""Several shapes side by side in one ParaView picture."""
import numpy
from paraview import simple
from vtkmodules.vtkFiltersCore import vtkGlyph3D
from vtkmodules.vtkFiltersSources import vtkSphereSource

import scenes  # knows where pictures.py is

import pictures

SKIN = [0.93, 0.80, 0.70]
BONE = [0.96, 0.93, 0.80]
BRAIN = [0.85, 0.45, 0.50]
STEEL = [0.72, 0.78, 0.84]
RED = [0.85, 0.10, 0.12]
GREEN = [0.05, 0.60, 0.20]


def source(data):
    """A data set as a ParaView source."""
    producer = simple.TrivialProducer()
    producer.GetClientSideObject().SetOutput(data)
    producer.UpdatePipeline()
    return producer


def balls(positions, radius, resolution=20):
    """A small ball at each position."""
    ball, glyphs = vtkSphereSource(), vtkGlyph3D()
    ball.SetRadius(radius)
    ball.SetThetaResolution(resolution)
    ball.SetPhiResolution(resolution)
    glyphs.SetInputData(scenes.point_set(positions))
    glyphs.SetSourceConnection(ball.GetOutputPort())
    glyphs.ScalingOff()
    glyphs.Update()
    return glyphs.GetOutput()


class Picture:
    """A white picture of panels. A panel is `shift` away from the scene's origin, along the right
    and up of the camera, which looks from `direction`."""

    def __init__(self, size, direction, up):
        self.View = pictures.new_view(size)
        self.Direction = numpy.array(direction, float) / numpy.linalg.norm(direction)
        self.Right = numpy.cross(up, self.Direction)
        self.Right /= numpy.linalg.norm(self.Right)
        self.Up = numpy.cross(self.Direction, self.Right)
        self.Size = size
        self.Captions = []

    def place(self, right, up=0.0):
        return list(right * self.Right + up * self.Up)

    def show(self, data, shift=(0.0, 0.0), scale=1.0, centre=(0.0, 0.0, 0.0), colour=None,
             opacity=1.0, representation='Surface', width=2.0, smooth=None):
        """Shows a data set, its `centre` in the middle of the panel; `smooth` is the angle in
        degrees above which an edge stays sharp."""
        proxy = source(data)
        if smooth:
            proxy = simple.GenerateSurfaceNormals(Input=proxy, FeatureAngle=smooth)
        display = simple.Show(proxy, self.View)
        display.Representation = representation
        display.Scale = [scale] * 3
        display.Position = [p - scale * c for p, c in zip(self.place(*shift), centre)]
        display.Opacity, display.LineWidth = opacity, width
        display.EdgeColor = pictures.INK
        if colour:
            pictures.plain(display, colour)
        return display

    def colour(self, display, association, array, low, high, title=None, position=None,
               preset='Jet', steps=20, form='%.1f'):
        table = simple.GetColorTransferFunction(array)
        table.ApplyPreset(preset, True)
        table.RescaleTransferFunction(low, high)
        table.Discretize, table.NumberOfTableValues = 1, steps
        pictures.colour_by(display, association, array, table, self.View, title, position)
        if title:
            bar = simple.GetScalarBar(table, self.View)
            bar.LabelFormat = bar.RangeLabelFormat = form

    def flat(self, display):
        display.Ambient, display.Diffuse, display.Specular = 1.0, 0.0, 0.0

    def dots(self, places, shift, radius, scale=1.0, centre=(0.0, 0.0, 0.0), colour=RED):
        """Small balls of this radius, in the units of the places."""
        self.flat(self.show(balls(places, radius), shift, scale, centre, colour))

    def caption(self, text, right, up, size=17):
        """Words centred at a place of the scene."""
        self.Captions.append((text, right, up, size))

    def save(self, path, centre, height):
        """Writes the picture, `centre` in its middle and `height` high."""
        width = height * self.Size[0] / self.Size[1]
        for text, right, up, size in self.Captions:
            # Letters are about half as wide as they are high.
            pixels = 0.48 * size * max(len(line) for line in text.split('\n'))
            x = 0.5 + (right - centre[0]) / width - 0.5 * pixels / self.Size[0]
            pictures.caption(self.View, text, [x, 0.5 + (up - centre[1]) / height], size)
        pictures.look(self.View, self.place(*centre), height, 4.0 * self.Direction, list(self.Up))
        simple.SaveScreenshot(path, self.View)
        simple.Delete(self.View)


class Sheet(Picture):
    """Panels in a row, each with a data set as large as fits and words below."""

    def __init__(self, size, direction, up, shift, widest, line):
        """`shift` from panel to panel in heights of a panel, `widest` the width and height that a panel
        shows, `line` where the words are."""
        super().__init__(size, direction, up)
        self.Shift, self.Widest, self.Line = shift, numpy.array(widest), line

    def where(self, column, like):
        """The shift, the scale and the centre with which `like` fills a panel, for show() and dots()."""
        frame = numpy.stack([self.Right, self.Up])
        places = scenes.points(like) @ frame.T
        low, high = places.min(axis=0), places.max(axis=0)
        return (self.Shift * column, 0.0), 1.0 / max((high - low) / self.Widest), 0.5 * (low + high) @ frame

    def fit(self, column, data, like=None, **options):
        """Shows a data set, as large and where `like` would be; options as of show()."""
        return self.show(data, *self.where(column, like or data), **options)

    def label(self, column, text):
        self.caption(text, self.Shift * column, self.Line)
