"""Two figures: landmarks picked in the view, a map, a field transferred along it, the morph and its animation."""
import glob
import os
import tempfile

import journey
import window

folder = tempfile.TemporaryDirectory()
GROUP = window.PROPERTIES + 'ShapeLandmarks/'

w = journey.Journey('Correspondence')
w.open('FigureBSmall.vtp')
w.open('FigureASmall.vtp')
w.step('opened')
w.filter('Shape Landmarks')
w.choose_inputs(SurfaceB='FigureBSmall.vtp')
w.apply()
w.wait(300)
w.step('beside each other')
w.run()
