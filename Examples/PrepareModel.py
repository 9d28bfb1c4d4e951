"""Reads a model of your own and fills its holes: PrepareModel.py FOLDER MODEL."""
import os
import sys

import shapemap
from paraview.simple import *

root = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..')
folder = sys.argv[1] if len(sys.argv) > 1 else '.'
models = os.environ.get('SHAPEMAP_MODELS', os.path.join(root, 'build', 'models'))
path = sys.argv[2] if len(sys.argv) > 2 else os.path.join(models, 'pig.stl')

model = OpenDataFile(path)  # .off, .stl, .ply, .obj, .vtp, ...


def open_edges(surface):
    edges = FeatureEdges(Input=surface, FeatureEdges=0, ManifoldEdges=0)
    edges.UpdatePipeline()
    return edges.GetDataInformation().GetNumberOfCells()


surface = Clean(Input=model)  # merges points with the same coordinates
closed = ShapeFillHoles(Input=surface)
closed.UpdatePipeline()
print('%s: %d points, %d open edges, %d holes; %d open edges after' % (
    os.path.basename(path), surface.GetDataInformation().GetNumberOfPoints(), open_edges(surface),
    shapemap.facts(closed)['Loops'], open_edges(closed)))
assert open_edges(closed) == 0
SaveData(os.path.join(folder, 'Model.ply'), Triangulate(Input=closed))
