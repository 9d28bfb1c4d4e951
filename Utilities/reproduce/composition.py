"""Pictures after the figures of "Drag-and-drop surface composition" (Schmidt and Singh 2010), by the
filters Shape Deform, Exponential Map, Fill Holes, Cut Feature and Paste Feature, on demo models:
pvpython composition.py FOLDER [NUMBER...], all of them or some.

1: creatures; 2: a whole drag; 3: sums and integrals along a curve; 4: a bunny on a cylinder; 5: layers of
the front; 6: arrival times and density; 7: parameters on a mushroom; 8: multiresolution; 9: bumps one
after the other; 10: estimates of one neighbour, and their mean; 11: exponential maps; 12: a hole filled
step by step; 13: fills; 14abc: beside Poisson mesh merging; 14: a soup, and a scan repaired; 14points:
the same on points; 15: a head swapped; 16: smoothed afterwards; 17: cars. It writes composition1.png and so on, and composition.md: what
was measured, and what was claimed. It fails where a claim does not hold.

Documentation/Papers/DragAndDropComposition.md compares the figures with those of the paper. Needs Debian's
python3-scipy.
"""
import os
import sys

from paraview import simple
from vtkmodules.vtkCommonCore import vtkLogger

import claims
import composition_cars
import composition_creatures
import composition_deform
import composition_estimates
import composition_fills
import composition_front
import composition_layers
import composition_maps
import composition_overview
import composition_parts
import composition_pipeline
import composition_points
import composition_poisson
import composition_soups

FIGURES = {'1': composition_creatures.fig1, '2': composition_overview.fig2,
           '3': composition_estimates.fig3, '4': composition_deform.fig4,
           '5': composition_layers.fig5, '6': composition_front.fig6, '7': composition_deform.fig7,
           '8': composition_parts.fig8, '9': composition_parts.fig9,
           '10': composition_estimates.fig10, '11': composition_maps.fig11,
           '12': composition_pipeline.fig12, '13': composition_fills.fig13,
           '14abc': composition_poisson.fig14abc, '14': composition_soups.fig14,
           '14points': composition_points.fig14points,
           '15': composition_creatures.fig15, '16': composition_overview.fig16,
           '17': composition_cars.fig17}


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
