"""In parallel the pieces of a mesh become one file whose cells hang together.

Run twice by CTest: under pvpython on one process, which writes the truth, and under pvbatch --sym on
two: TestDistributedWriters.py FOLDER."""
import os
import sys

from paraview import simple

import shapetesting

processes, rank = shapetesting.parallel()


def facts(path):
    """What an input file says of the mesh, by places instead of numbers."""
    blocks = {}
    for line in open(path):
        if line.startswith('*'):
            lines = blocks.setdefault(line.strip(), [])
        else:
            lines.append(line.strip().split(', '))
    nodes = {line[0]: tuple(map(float, line[1:])) for line in blocks.pop('*NODE')}
    elements = {line[0]: tuple(nodes[node] for node in line[1:])
                for line in blocks.pop('*ELEMENT, TYPE=C3D8I, ELSET=Hexahedra')}
    found = {'nodes': sorted(nodes.values()), 'elements': sorted(elements.values())}
    patches = []
    for key, lines in blocks.items():
        if '*NSET' in key and 'Patch' not in key:
            found[key] = sorted(nodes[node] for line in lines for node in line)
        elif '*ELSET' in key:
            found[key] = sorted(elements[element] for line in lines for element in line)
        elif '*NSET' in key:  # numbered by their first faces, which depends on the pieces
            patches.append(sorted(nodes[node] for line in lines for node in line))
        elif '*SURFACE' in key:
            patches.append(sorted((elements[element], face) for element, face in lines))
    found['patches'] = sorted(patches, key=repr)
    return found


folder = sys.argv[1]
path = [os.path.join(folder, name) for name in ('one.inp', 'several.inp')]
image = simple.Wavelet(WholeExtent=[0, 7, 0, 5, 0, 6])
cells = simple.PointDatatoCellData(Input=image)
regions = simple.Calculator(Input=cells, AttributeType='Cell Data', ResultArrayName='RegionId',
                            Function='if(RTData > 180, 1, 0)')
solid = simple.Threshold(Input=regions, Scalars=['CELLS', 'RTData'], LowerThreshold=-1e9,
                         UpperThreshold=1e9)
solid.UpdatePipeline()
own = solid.SMProxy.GetClientSideObject().GetOutputDataObject(0)
assert own.IsA('vtkUnstructuredGrid')
assert 0 < own.GetNumberOfCells() < 210 or processes == 1 and own.GetNumberOfCells() == 210

simple.SaveData(path[processes > 1], solid)
if processes == 1:
    truth = facts(path[0])
    assert len(truth['nodes']) == 8 * 6 * 7 and len(truth['elements']) == 210
    assert len(truth['patches']) == 12 and truth['*NSET, NSET=Interface0_1']
    print('one process wrote the truth')
elif rank == 0:
    truth, found = facts(path[0]), facts(path[1])
    assert truth.keys() == found.keys(), (truth.keys(), found.keys())
    for key in truth:
        assert truth[key] == found[key], key
    print(processes, 'processes wrote the same mesh')

# Nothing to write on one process is no error; Medit's writer goes the same way.
side = simple.Calculator(Input=image, ResultArrayName='X', Function='coordsX')
corner = simple.Threshold(Input=side, Scalars=['POINTS', 'X'], LowerThreshold=-1.0,
                          UpperThreshold=2.0)
corner.UpdatePipeline()
own = corner.SMProxy.GetClientSideObject().GetOutputDataObject(0).GetNumberOfCells()
assert own == (2 * 5 * 6 if rank == 0 else 0), own
simple.SaveData(os.path.join(folder, 'corner.mesh'), corner)
if rank == 0:
    words = open(os.path.join(folder, 'corner.mesh')).read().split('\n')
    count = words[words.index('Hexahedra') + 1], words[words.index('Vertices') + 1]
    note = os.path.join(folder, 'corner.txt')
    if processes == 1:
        open(note, 'w').write(' '.join(count))
    assert open(note).read().split() == list(count), count
