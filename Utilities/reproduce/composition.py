"""Pictures after the figures of "Drag-and-drop surface composition" (Schmidt and Singh 2010), by the
filters Shape Deform, Exponential Map, Fill Holes, Cut Feature and Paste Feature, on demo models:
pvpython composition.py FOLDER [NUMBER...], all of them or some.

1: creatures; 2: a whole drag; 4: a bunny on a cylinder; 6: arrival times and density; 7: parameters on
a mushroom; 8: multiresolution; 9: bumps one after the other; 11: exponential maps; 13: fills; 14: a
soup, and a scan repaired; 15: a head swapped; 16: smoothed afterwards. It writes composition1.png and
so on, and composition.md: what was measured, and what was claimed. It fails where a claim does not
hold.
"""
import os
import sys

from paraview import simple
from vtkmodules.vtkCommonCore import vtkLogger

import claims
import composition_creatures
import composition_deform
import composition_fills
import composition_front
import composition_maps
import composition_overview
import composition_parts
import composition_soups

FIGURES = {'1': composition_creatures.fig1, '2': composition_overview.fig2,
           '4': composition_deform.fig4, '6': composition_front.fig6, '7': composition_deform.fig7,
           '8': composition_parts.fig8, '9': composition_parts.fig9, '11': composition_maps.fig11,
           '13': composition_fills.fig13, '14': composition_soups.fig14,
           '15': composition_creatures.fig15, '16': composition_overview.fig16}


def main(folder, *numbers):
    os.makedirs(folder, exist_ok=True)
    simple._DisableFirstRenderCameraReset()
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_WARNING)  # a cut surface says that it is cut
    collected = claims.Claims()
    for number in numbers or FIGURES:
        FIGURES[number](folder, collected)
    collected.write(os.path.join(folder, 'composition.md'))
    collected.finish()


if __name__ == '__main__':
    main(*sys.argv[1:])
