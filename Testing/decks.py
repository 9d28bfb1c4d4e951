"""A deck of CalculiX for the tests: two blocks that are tied, with all that a deck of work has besides its
mesh. The upper end is pulled; with a Poisson's ratio of 0 the stress is the same everywhere, so that the
displacement of that end is known."""
import os
import re
import subprocess

import numpy

PULL, YOUNG, SIZE = 3.0, 1000.0, numpy.array([1.0, 1.0, 2.0])


def block(counts, low, high, first_node, first_element):
    """Lines of the nodes and of the elements of a block, and the numbers of both as arrays."""
    axes = [numpy.linspace(low[k], high[k], counts[k] + 1) for k in range(3)]
    shape = numpy.array(counts) + 1
    nodes = numpy.arange(shape.prod()).reshape(shape) + first_node
    places = numpy.stack(numpy.meshgrid(*axes, indexing='ij'), axis=-1).reshape(-1, 3)
    corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    cells = numpy.stack([nodes[tuple(slice(a, a + m) for a, m in zip(corner, counts))].ravel()
                         for corner in corners], axis=1)
    elements = numpy.arange(len(cells)).reshape(counts) + first_element
    node_lines = ['%8d, %.12g,\t%.12e , %.12g' % (number, *place)
                  for number, place in zip(nodes.ravel(), places)]
    element_lines = ['%d, %s,\n  %s' % (number, ', '.join(map(str, cell[:5])), ','.join(map(str, cell[5:])))
                     for number, cell in zip(elements.ravel(), cells)]
    return node_lines, element_lines, nodes, elements


def listed(numbers):
    numbers = [str(number) for number in numpy.ravel(numbers)]
    return '\n'.join(', '.join(numbers[i:i + 8]) for i in range(0, len(numbers), 8))


def write(folder, counts):
    """Writes pull.inp, with the nodes of the upper block in mesh/upper.inc and the materials in
    material.inc. counts: cells of each block. Lines of the deck end with CR LF, and it has bytes of Latin 1
    and no line end at its end. Returns its path."""
    half = SIZE[2] / 2.0
    lower = block(counts, (0, 0, 0), (1, 1, half), 1, 1)
    count, cells = lower[2].size, lower[3].size
    upper = block(counts, (0, 0, half), (1, 1, 2 * half), 1000 + count, 500 + cells)
    loose = 999 + count
    text = f'''** Zwei Bl\u00f6cke, verbunden
*Heading
 A deck of two blocks
*Node , nset=AllNodes
{os.linesep.join(lower[0])}
{loose}, 0.5, 0.5, {half}
*INCLUDE, INPUT=mesh/upper.inc
*ELEMENT, TYPE=C3D8I , ELSET=Lower
{os.linesep.join(lower[1])}
*ELEMENT, TYPE=C3D8I, ELSET=Upper
{os.linesep.join(upper[1])}
** the number of a node here is none: 1, 2., 3., 4.
*NSET, NSET=Every, GENERATE
1, {count}, 1
*ELSET, ELSET=Both
Lower, Upper
*NSET, NSET=Bottom
{listed(lower[2][:, :, 0])}
*NSET, NSET=Top
{listed(upper[2][:, :, -1])}
*NSET, NSET=Pin
{lower[2][0, 0, 0]}
*NSET, NSET=Edge
{lower[2][-1, 0, 0]}
*SURFACE, NAME=Under, TYPE=ELEMENT
{chr(10).join('%d, S2' % number for number in lower[3][:, :, -1].ravel())}
*SURFACE, NAME=Above, TYPE=ELEMENT
{chr(10).join('%d, S1' % number for number in upper[3][:, :, 0].ravel())}
*SURFACE, NAME=End, TYPE=ELEMENT
{chr(10).join('%d, S2' % number for number in upper[3][:, :, -1].ravel())}
*TIE, NAME=Glue, POSITION TOLERANCE=0.01
Above, Under
*ORIENTATION, NAME=Fibre, SYSTEM=RECTANGULAR
0., 1., 0., -1., 0., 0.
*INCLUDE, INPUT=material.inc
*SOLID SECTION, ELSET=Lower, MATERIAL=Bone, ORIENTATION=Fibre
*SOLID SECTION, ELSET=Upper, MATERIAL=Bone
*BOUNDARY
Bottom, 3
Pin, 1, 2
Edge, 2
*STEP
*STATIC
*DSLOAD
End, P, {-PULL}
*NODE PRINT, NSET=Top
U
*END STEP'''
    os.makedirs(os.path.join(folder, 'mesh'), exist_ok=True)
    files = {'pull.inp': text.replace('\n', '\r\n'),
             'mesh/upper.inc': '\n'.join(upper[0]) + '\n',
             'material.inc': '*MATERIAL, NAME=Bone\n*ELASTIC\n%g, 0.\n' % YOUNG}
    for name, content in files.items():
        with open(os.path.join(folder, name), 'wb') as file:
            file.write(content.encode('latin-1'))
    return os.path.join(folder, 'pull.inp')


def solve(path):
    """{node of the upper end: displacement} that CalculiX finds."""
    folder, name = os.path.split(path)
    run = subprocess.run(['ccx', name[:-len('.inp')]], cwd=folder, stdout=subprocess.PIPE,
                         stderr=subprocess.STDOUT, text=True)
    assert run.returncode == 0 and 'ERROR' not in run.stdout.upper(), run.stdout[-3000:]
    rows = [line.split() for line in open(path[:-len('inp')] + 'dat')]
    return {int(row[0]): numpy.array(row[1:], float) for row in rows if len(row) == 4 and row[0].isdigit()}


def without_coordinates(content):
    """The bytes of a file of such a deck, and its lines of nodes with their numbers only."""
    line = re.compile(rb'(?m)^( *\d+, )[^,\n]+,[^,\n]+,[^,\n\r]+')
    begin = content.find(b'*Node')
    end = content.find(b'*INCLUDE') if begin >= 0 else len(content)
    begin = max(begin, 0)
    return content[:begin] + line.sub(rb'\1', content[begin:end]) + content[end:]
