"""For steps of a window: whether a place lies on a surface, under a pixel of the active view."""
import numpy
from paraview import servermanager, simple
from vtkmodules.vtkCommonCore import mutable
from vtkmodules.vtkCommonDataModel import vtkCellLocator, vtkGenericCell


class Surface:
    def __init__(self, proxy):
        self.locator = vtkCellLocator()
        self.locator.SetDataSet(servermanager.Fetch(proxy))
        self.locator.BuildLocator()

    def check_under(self, place, pixel, tolerance=1.5):
        """`pixel` in parts of the view's width and of its height from the top; the tolerance in pixels."""
        self.check_at(place, place, pixel, tolerance)

    def check_at(self, place, shown, pixel, tolerance=1.5):
        """The same of a surface that the view moves: it shows the place at another one."""
        closest, squared = [0.0] * 3, mutable(0.0)
        self.locator.FindClosestPoint(place, closest, vtkGenericCell(), mutable(0), mutable(0), squared)
        assert squared.get() < 1e-20, 'the place is off the surface: %g' % squared.get()**0.5
        seen = self.pixel(shown)
        wanted = numpy.array([pixel[0], 1.0 - pixel[1]]) * simple.GetActiveView().ViewSize
        assert numpy.abs(seen - wanted).max() <= tolerance, (seen, wanted)

    @staticmethod
    def pixel(place):
        """Where a place is seen, in pixels from the lower left corner."""
        renderer = simple.GetActiveView().GetRenderer()
        renderer.SetWorldPoint(*place, 1.0)
        renderer.WorldToDisplay()
        return numpy.array(renderer.GetDisplayPoint()[:2])
