#!/usr/bin/env python3
"""Writes the shapes that tests and examples use, with their maps as the point array TargetPosition, and a network.

    make_shapes.py OUTPUT_FOLDER [--large]

Needs numpy and VTK's Python modules. The small set is the one that is committed beside this script.
"""

import argparse
import math
import pathlib

from shapes.bars import bar, bar_solid
from shapes.charges import dented_sphere_charges
from shapes.creatures import (
    HORSE, HORSE_CUBES, KITTEN, KITTEN_CUBES, SKULL_CUBES, creature, drawn_polycube)
from shapes.dented_sphere import dented_sphere
from shapes.figures import figure_a, figure_b, skeleton_a, skeleton_b
from shapes.files import write_charges, write_curves, write_solid, write_surface
from shapes.networks import random_features
from shapes.phantom import brain, head, skull
from shapes.solids import ball, cube
from shapes.two_torus import two_torus

BEND = (math.pi / 2, 0.0)
BEND_AND_TWIST = (2 * math.pi / 3, math.pi / 2)

SMALL = {
    "DentedSphere600.vtp": lambda: dented_sphere(8),
    "TwoTorusSmall.vtp": lambda: two_torus(5),
    "BentBarSmall.vtp": lambda: bar(6, *BEND),
    "TwistedBarSmall.vtp": lambda: bar(6, *BEND_AND_TWIST),
    "PhantomHeadSmall.vtp": lambda: head(16),
    "PhantomSkullSmall.vtp": lambda: skull(2),
    "PhantomBrainSmall.vtp": lambda: brain(16),
    "FigureASmall.vtp": lambda: figure_a(0.034),
    "FigureBSmall.vtp": lambda: figure_b(0.034),
    "KittenSmall.vtp": lambda: creature(KITTEN, 0.045),
    "HorseSmall.vtp": lambda: creature(HORSE, 0.04),
    "FigureASkeleton.vtp": skeleton_a,
    "FigureBSkeleton.vtp": skeleton_b,
    "DentedSphereCharges.vtp": lambda: dented_sphere_charges(8),
    "BentBarSmall.vtu": lambda: bar_solid(6, *BEND),
    "TwistedBarSmall.vtu": lambda: bar_solid(6, *BEND_AND_TWIST),
    "BallSmall.vtu": lambda: ball(12),
    "CubeSmall.vtu": lambda: cube(8, 0.55),
    "KittenPolycube.vtu": lambda: drawn_polycube(*KITTEN_CUBES),
    "HorsePolycube.vtu": lambda: drawn_polycube(*HORSE_CUBES),
    "SkullPolycube.vtu": lambda: drawn_polycube(*SKULL_CUBES),
    "RandomFeatures.onnx": random_features,
}

LARGE = {
    "DentedSphere3k.vtp": lambda: dented_sphere(17),
    "DentedSphere10k.vtp": lambda: dented_sphere(32),
    "DentedSphere40k.vtp": lambda: dented_sphere(63),
    "DentedSphere100k.vtp": lambda: dented_sphere(100),
    "TwoTorus.vtp": lambda: two_torus(10),
    "BentBar.vtp": lambda: bar(20, *BEND),
    "TwistedBar.vtp": lambda: bar(20, *BEND_AND_TWIST),
    "PhantomHead.vtp": lambda: head(48),
    "PhantomSkull.vtp": lambda: skull(5),
    "PhantomBrain.vtp": lambda: brain(44),
    "FigureA.vtp": lambda: figure_a(0.0146),
    "FigureB.vtp": lambda: figure_b(0.0146),
    "Kitten.vtp": lambda: creature(KITTEN, 0.03),
    "Horse.vtp": lambda: creature(HORSE, 0.03),
    "BentBar.vtu": lambda: bar_solid(20, *BEND),
    "TwistedBar.vtu": lambda: bar_solid(20, *BEND_AND_TWIST),
    "Ball.vtu": lambda: ball(40),
    "Cube.vtu": lambda: cube(32, 0.55),
}


def writer(name):
    """What writes a file of this name."""
    for ending, write in (("Skeleton.vtp", write_curves), ("Charges.vtp", write_charges), (".vtp", write_surface),
                          (".onnx", pathlib.Path.write_bytes)):
        if name.endswith(ending):
            return write
    return write_solid


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("output_folder", type=pathlib.Path)
    parser.add_argument("--large", action="store_true", help="the small set and the large one")
    arguments = parser.parse_args()
    arguments.output_folder.mkdir(parents=True, exist_ok=True)
    for name, make in {**SMALL, **(LARGE if arguments.large else {})}.items():
        writer(name)(arguments.output_folder / name, *make())


if __name__ == "__main__":
    main()
