"""What the filters say about bad input and doubtful sizes: one line that names the fact and the remedy."""
import math
import os
import resource

from vtkmodules.util.misc import calldata_type
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkIOGeometry import vtkSTLReader
import shapemap

import shapetesting
from shapetesting import copy, fact, facts, new, outputs, read

LONGEST = 215 # characters; most have fewer than 160


def one_line(name, said):
    """The text of a message without where it comes from, which VTK adds."""
    assert 'Shape ' + name in said, said
    text = said[said.index('Shape ' + name):].strip()
    assert '\n' not in text and len(text) <= LONGEST, '%d characters: %s' % (len(text), text)
    print(text)
    return text


def refused(words, name, *inputs, **settings):
    """The filter says one line that begins with its name, has the words, and leaves nothing."""
    said = one_line(name, shapetesting.refusal(new(getattr(shapemap, 'vtkShape' + name.replace(' ', '')), *inputs,
                                                   **settings)))
    for word in words:
        assert word in said, said


def warnings(name, *inputs, **settings):
    """The outputs and the warnings of a filter that works."""
    algorithm = new(getattr(shapemap, 'vtkShape' + name.replace(' ', '')), *inputs, **settings)
    said = []

    @calldata_type(VTK_STRING)
    def record(caller, event, message):
        said.append(message)

    algorithm.AddObserver('WarningEvent', record)
    return outputs(algorithm), said


def warned(words, name, *inputs, **settings):
    """It works, and says one warning with the words, which is also a fact."""
    made, said = warnings(name, *inputs, **settings)
    assert len(said) == 1, said
    text = one_line(name, said[0])
    assert text == 'Shape %s: %s' % (name, fact(made[0], name.replace(' ', '') + '.Warning')), text
    for word in words:
        assert word in text, text
    return made[0]


def silent(name, *inputs, **settings):
    made, said = warnings(name, *inputs, **settings)
    assert not said and not facts(made[0]).HasArray(name.replace(' ', '') + '.Warning'), said
    return made[0]


dented, genus_two = read('DentedSphere600.vtp'), read('TwoTorusSmall.vtp')
opened = shapetesting.without_cells(dented, [0])

plain = copy(dented)
plain.GetPointData().Initialize()

# A needed input is missing, or has no map.
refused(['press Pick', 'connect points to Seeds'], 'Geodesic Distance', dented)
for name in ('Map Error Curve', 'Map Difference', 'Correspondence', 'Boundary Distance'):
    refused(['is not connected; choose it under Inputs'], name, dented)
refused(["has no point array 'TargetPosition'; make it with Shape Correspondence"], 'Morph', plain)
refused(["no point array 'TargetPosition'"], 'Map Quality', plain)
refused(['press Draw Loop', 'Loop Points has 0 positions'], 'Cut Feature', dented)

# Too little memory is said before BLAS asks for it, which would ask for ever.
limit = resource.getrlimit(resource.RLIMIT_AS)
used = int(open('/proc/self/statm').read().split()[0]) * resource.getpagesize()
for name, remedy in (('Laplace Spectrum', 'or lower Number Of Eigenpairs'), ('Geodesic Distance', 'use a coarser input')):
    resource.setrlimit(resource.RLIMIT_AS, (used + 100 * 2 ** 20, limit[1]))
    try:
        refused(['out of memory', remedy], name, dented, *([dented] if name == 'Geodesic Distance' else []))
    finally:
        resource.setrlimit(resource.RLIMIT_AS, limit)
silent('Laplace Spectrum', dented)

# Options: the value and the range.
refused(['Compactness is 0; it must be positive'], 'Polycube', dented, Compactness=0.0)
refused(['CollocationRatio is nan; it must be positive'], 'Harmonic Volume Map', dented, dented,
        CollocationRatio=math.nan)
refused(['Tolerance is -1; it must be at least 0'], 'Harmonic Volume Map', dented, dented, Tolerance=-1.0)
refused(['Tolerance is nan; it must be at least 0'], 'Transfer Fields', dented, dented, Tolerance=math.nan)
refused(['EdgeGrowth is inf; it must be at least 0 and at most 1'], 'Fill Holes', opened, EdgeGrowth=math.inf)
refused(['Scale is nan'], 'Fill Holes', opened, FillMethod=3, Scale=math.nan)

# What is not closed, or has handles.
for name in ('Hex Remesh', 'Polycube', 'Tetrahedralize'):
    refused(['1 open loop', 'Shape Fill Holes'], name, opened)
refused(['Euler number -2', 'genus 2'], 'Parameterize', genus_two)
refused(['vtkTriangle', 'Shape Tetrahedralize'], 'Untangle', dented)

# Sizes that are too large for the shape, as when units are mixed up.
warned(['Cell Size 100 is more than a quarter', 'use a smaller value'], 'Hex Remesh', dented, CellSize=100.0)
silent('Hex Remesh', dented, CellSize=0.4)
warned(['Target Edge Length 0.6 is more than'], 'Polycube', dented, TargetEdgeLength=0.6)
warned(['Maximum Volume 1000 is more than the volume of the solid'], 'Tetrahedralize', dented, MaximumVolume=1000.0)
silent('Tetrahedralize', dented, MaximumVolume=0.1)
warned(['Radius 40 is more than the diagonal'], 'Exponential Map', dented, Radius=40.0)
silent('Exponential Map', dented, Radius=0.5)

# Surfaces between which no continuous one-to-one map exists.
warned(['genus 2 and 0', 'no continuous one-to-one map exists'], 'Correspondence', genus_two, dented,
       Method=1)
silent('Correspondence', dented, dented, Method=1)

# A scanned surface that is open, and whose sheets touch: Shape Fill Holes says what it mends.
reader = vtkSTLReader()
reader.SetFileName(os.path.join(shapetesting.BUILD, 'models', 'pig.stl'))
reader.Update()
pig = reader.GetOutput()
refused(['Shape Fill Holes'], 'Hex Remesh', pig)
warned(['copies of points were added where sheets of the surface touch'], 'Fill Holes', pig)
silent('Fill Holes', opened)
