"""Meshes read by Gmsh, and their volume."""
import os
import subprocess
import tempfile

import numpy
from vtkmodules.vtkFiltersVerdict import vtkCellSizeFilter

NODES_OF = {1: 2, 2: 3, 3: 4, 4: 4, 5: 8, 15: 1}  # Gmsh's types: line, triangle, quad, tet, hex, point


def read(path):
    """What Gmsh has of a file: points, and {type: (corners, references)}."""
    out = os.path.join(tempfile.mkdtemp(), 'out.msh')
    run = subprocess.run(['gmsh', path, '-0', '-format', 'msh22', '-o', out], stdout=subprocess.PIPE,
                         stderr=subprocess.STDOUT, text=True)
    assert run.returncode == 0 and 'Error' not in run.stdout, run.stdout
    lines = open(out).read().splitlines()
    first = lines.index('$Nodes') + 2
    nodes = [line.split() for line in lines[first:lines.index('$EndNodes')]]
    nodes.sort(key=lambda node: int(node[0]))
    assert [int(node[0]) for node in nodes] == list(range(1, len(nodes) + 1))
    places = numpy.array([node[1:] for node in nodes], float)
    elements = {}
    for line in lines[lines.index('$Elements') + 2:lines.index('$EndElements')]:
        numbers = [int(word) for word in line.split()]
        corners, references = elements.setdefault(numbers[1], ([], []))
        corners.append([n - 1 for n in numbers[-NODES_OF[numbers[1]]:]])
        references.append(numbers[4])  # the elementary entity
    return places, {kind: (numpy.array(corners), numpy.array(references))
                    for kind, (corners, references) in elements.items()}


def volume(grid):
    sizes = vtkCellSizeFilter()
    sizes.SetInputData(grid)
    sizes.ComputeSumOn()
    sizes.Update()
    return sizes.GetOutput().GetFieldData().GetArray('Volume').GetValue(0)
