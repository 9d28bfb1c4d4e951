"""The cases of CompareOutputs.py: what each filter and writer runs on, and with which options.

A new filter needs cases here; CompareOutputs.py stops without them.
"""
import functools
import itertools

import numpy

import FilterChanges
from FilterInputs import (
    CAME, CLOSED, GOES, OPEN, SMALL, SOLIDS, SPHERES, SURFACES, border, extreme, handle, hollow,
    in_blocks, landmarks, lattice, loop_points, section, seeds, shape, shrunk, tangled)
from FilterRuns import PRESENT, alternatives, chain, execute, file_lines, smproxy_of

import filters  # FilterRuns knows where it is


# Inputs that several filters have.

def map_of(name):
    """A model's surface with its map to the sphere."""
    return chain('ShapeParameterize', 0, [shape(name)], AreaWeight=3.0)


def hexahedra(name):
    return chain('ShapeHexRemesh', 0, [shape(name)], Method=2, CellsOnLongestSide=5)


def carried(domain, boundary, port=0):
    return chain('ShapeHarmonicVolumeMap', port, [domain, boundary])


def found(method):
    """Both surfaces with the maps between them."""
    a, b = shape('FigureASmall.vtp'), shape('FigureBSmall.vtp')
    return [chain('ShapeCorrespondence', port, [a, b, landmarks(a, 5)], Method=method)
            for port in (0, 1)]


CAVITY = hollow(shape('PhantomHeadSmall.vtp'), shape('PhantomBrainSmall.vtp'))
PIERCED = hollow(shape('PhantomHeadSmall.vtp'), shape('PhantomSkullSmall.vtp'))
SHELL = hollow(shape('larger_sphere'), shrunk(shape('larger_sphere'), 0.4))


# The cases: filter, name, inputs by port, settings, whether each value of enumerations is tried.

def distances():
    for name in SURFACES + CLOSED:
        yield 'ShapeBoundaryDistance', name, [lattice(shape(name)), shape(name)], {}, name == 'eight'
    for name in SOLIDS:
        yield ('ShapeBoundaryDistance', name, [shape(name), shape('PhantomHeadSmall.vtp')], {},
               False)
    yield 'ShapeBoundaryDistance', 'hollow', [lattice(CAVITY), CAVITY], {}, False
    yield 'ShapeBoundaryDistance', 'hexahedra', [hexahedra('cow'), shape('cow')], {}, False
    for name in OPEN:
        yield 'ShapeBoundaryDistance', name, [lattice(shape(name)), shape(name)], {}, name == 'pig'

    for name in SURFACES + CLOSED + OPEN:
        yield ('ShapeGeodesicDistance', name, [shape(name), seeds(shape(name), 2)], {},
               name in SMALL + OPEN)
    for name in SURFACES + CLOSED + OPEN:
        yield 'ShapeExponentialMap', name, [shape(name)], {
            'Seed': extreme(shape(name), 4)}, name in SURFACES[:3] + ('cow', 'head', 'eight')


def parameterizations():
    for name in ('BentBarSmall.vtp', 'DentedSphere600.vtp') + SPHERES:
        yield 'ShapeParameterize', name, [shape(name)], {}, name in ('cow', 'DentedSphere600.vtp')
        if name not in ('bunny00', 'man'):
            yield 'ShapeParameterize', name + ' by area', [shape(name)], {'AreaWeight': 3.0}, False
    yield 'ShapeParameterize', 'TwoTorusSmall.vtp', [shape('TwoTorusSmall.vtp')], {}, False
    for name in OPEN:
        for domain in (0, 2):
            yield 'ShapeParameterize', '%s domain %d' % (name, domain), [shape(name)], {
                'Domain': domain}, name == 'mushroom' or (name, domain) == ('head', 2)
    cap = chain('ShapeCutFeature', 0, [shape('cow'), section(shape('cow'), 0.8)])
    yield 'ShapeParameterize', 'cap', [cap], {'Domain': 0, 'Refine': 1}, True
    for name in ('DentedSphere600.vtp', 'cow', 'hand'):
        for count in (3, 4):
            yield 'ShapeParameterize', '%s %d cones' % (name, count), [
                shape(name), seeds(shape(name), count)], {'Domain': 3}, count == 3


def spectra():
    for name in SURFACES + CLOSED + OPEN:
        if name not in ('bunny00', 'man'):
            yield 'ShapeLaplaceSpectrum', name, [shape(name)], {
                'NumberOfEigenpairs': 30}, name in ('cow', 'pig')
    yield 'ShapeLaplaceSpectrum', 'default', [shape('FigureASmall.vtp')], {}, False


def cuts_and_fills():
    for name in ('BentBarSmall.vtp', 'FigureASmall.vtp', 'PhantomHeadSmall.vtp') + CLOSED + OPEN:
        for share in (0.2, 0.8):
            yield ('ShapeCutFeature', '%s at %g' % (name, share),
                   [shape(name), section(shape(name), share)],
                   {'FillHole': 0} if name == 'bunny00' else {},
                   share == 0.8 and name in SMALL + ('pig', 'FigureASmall.vtp'))
    for name in ('elephant', 'PhantomHeadSmall.vtp'):
        yield 'ShapeCutFeature', name + ' LoopPoints', [shape(name)], {
            'LoopPoints': loop_points(shape(name), 0.3)}, False

    for name in OPEN + ('blobby_3cc', 'three_peaks'):
        yield 'ShapeFillHoles', name, [shape(name)], {}, name in ('pig', 'head', 'mushroom')
    for name in ('cow', 'elephant', 'FigureASmall.vtp'):
        rest = chain('ShapeCutFeature', 1, [shape(name), section(shape(name), 0.8)], FillHole=0)
        yield 'ShapeFillHoles', 'rest of ' + name, [rest], {'LoopIndices': [0]}, name != 'cow'


def pastes():
    for giver, taker in (('cow', 'larger_sphere'), ('elephant', 'PhantomHeadSmall.vtp'),
                         ('femur', 'elephant'), ('FigureASmall.vtp', 'BentBarSmall.vtp'),
                         ('camel', 'mushroom'), ('elephant', 'bunny00')):
        feature = chain('ShapeCutFeature', 0, [shape(giver), section(shape(giver), 0.85)])
        for scale in (0.3, 1.0):
            yield ('ShapePasteFeature', '%s on %s by %g' % (giver, taker, scale),
                   [feature, shape(taker)],
                   {'Seed': extreme(shape(taker), 4), 'Scale': scale, 'Rotation': 25.0},
                   giver in ('cow', 'femur') and scale == 0.3)
    for name in ('cow', 'elephant'):
        cut = [chain('ShapeCutFeature', port, [shape(name), section(shape(name), 0.8)])
               for port in (0, 1)]
        yield 'ShapePasteFeature', name + ' in its old position', cut, {
            'Seed': lambda cut=cut: numpy.array(shapetesting.facts(cut[0]()).GetArray(
                'CutFeature.Seed').GetTuple(0)).tolist()}, False


def deformations():
    for name in ('BentBarSmall.vtp', 'FigureASmall.vtp', 'cow', 'elephant', 'femur', 'eight', 'pig'):
        yield 'ShapeDeform', name, [shape(name), handle(shape(name))], {}, name in (
            'BentBarSmall.vtp', 'eight', 'pig')
    for name in ('head', 'mask_cone', 'pig'):
        yield 'ShapeDeform', name + ' by its border', [shape(name), border(shape(name))], {}, False
    for name in ('BentBarSmall', 'TwistedBarSmall'):
        straight = chain('ShapeMorph', 0, [shape(name + '.vtp')], time=1.0)
        yield 'ShapeDeform', name + ' solid', [shape(name + '.vtu'), straight], {}, (
            name == 'BentBarSmall')
    yield 'ShapeDeform', 'hexahedra', [hexahedra('cow'), handle(shape('cow'))], {}, False
    yield 'ShapeDeform', 'blocks', [in_blocks(shape('eight')), handle(shape('eight'))], {}, False


def solids():
    for name in ('DentedSphere600.vtp', 'TwistedBarSmall.vtp', 'TwoTorusSmall.vtp'):
        yield 'ShapeHexRemesh', name, [shape(name)], {'CellsOnLongestSide': 5}, False
    for name, data in [(name, shape(name)) for name in (
            'anchor', 'cow', 'joint', 'larger_sphere', 'FigureASmall.vtp')] + [('hollow', CAVITY)]:
        yield 'ShapeHexRemesh', name + ' by a grid', [data], {
            'CellsOnLongestSide': 5, 'Method': 2}, False
    yield 'ShapeHexRemesh', 'BentBarSmall.vtp', [shape('BentBarSmall.vtp')], {
        'CellsOnLongestSide': 5}, True
    yield 'ShapeHexRemesh', 'inner', [
        shape('PhantomHeadSmall.vtp'), None, [shape('PhantomBrainSmall.vtp')]], {
            'CellsOnLongestSide': 7}, False
    polycube = [chain('ShapePolycube', port, [shape('BentBarSmall.vtp')], TargetEdgeLength=0.4)
                for port in (0, 1)]
    yield 'ShapeHexRemesh', 'polycube', [shape('BentBarSmall.vtp'), polycube[1]], {}, False
    for name, length in (('BentBarSmall.vtp', 0.3), ('DentedSphere600.vtp', 0.4), ('cross', 0.1),
                         ('TwistedBarSmall.vtp', 0.4), ('cow', 0.08)):
        yield 'ShapePolycube', name, [shape(name)], {'TargetEdgeLength': length}, False
    for name in SURFACES + CLOSED:
        if name not in ('bunny00', 'man'):
            yield ('ShapeTetrahedralize', name, [shape(name)], {},
                   name in ('eight', 'BentBarSmall.vtp'))
    for name, data in (('hollow', CAVITY), ('skull', PIERCED), ('shell', SHELL)):
        yield 'ShapeTetrahedralize', name, [data], {}, False
    yield 'ShapeTetrahedralize', 'inner', [
        shape('PhantomHeadSmall.vtp'),
        [shape('PhantomSkullSmall.vtp'), shape('PhantomBrainSmall.vtp')]], {}, False


def volume_maps():
    ball = shape('DentedSphere600.vtp')
    for name in SURFACES:
        yield ('ShapeHarmonicVolumeMap', name, [lattice(shape(name)), shape(name)], {},
               name in ('BentBarSmall.vtp', 'DentedSphere600.vtp'))
    for name in ('cow', 'hand'):
        yield 'ShapeHarmonicVolumeMap', name, [hexahedra(name), map_of(name)], {}, False
    for name in ('BentBarSmall', 'TwistedBarSmall'):
        yield 'ShapeHarmonicVolumeMap', name + ' solid', [
            shape(name + '.vtu'), shape(name + '.vtp')], {}, False
    yield 'ShapeHarmonicVolumeMap', 'skeleton', [
        lattice(shape('FigureASmall.vtp')), shape('FigureASmall.vtp'),
        shape('FigureASkeleton.vtp'), shape('FigureBSkeleton.vtp'), shape('FigureBSmall.vtp')], {}, False
    yield 'ShapeHarmonicVolumeMap', 'phantom', [
        lattice(shape('PhantomHeadSmall.vtp')), shape('PhantomHeadSmall.vtp'),
        [shape('PhantomBrainSmall.vtp')]], {}, False
    yield 'ShapeHarmonicVolumeMap', 'phantom exact', [
        lattice(shape('PhantomHeadSmall.vtp')), shape('PhantomHeadSmall.vtp'),
        [shape('PhantomBrainSmall.vtp')]], {'Exact': 1}, False
    yield 'ShapeHarmonicVolumeMap', 'hollow', [lattice(CAVITY), CAVITY], {}, False
    bar = shape('BentBarSmall.vtp')
    yield 'ShapeHarmonicVolumeMap', 'sliding', [
        shape('BentBarSmall.vtu'), bar, None, None, chain('ShapeMorph', 0, [bar], time=1.0)], {
            'FreeBoundary': 1}, False

    charges = carried(lattice(ball), ball, 1)
    for name, data in (('lattice', lattice(ball)), ('solid', shape('BallSmall.vtu')),
                       ('surface', shape('DentedSphere600.vtp')), ('blocks', in_blocks(ball))):
        yield 'ShapeApplyVolumeMap', name, [data, shape('DentedSphereCharges.vtp')], {}, True
        yield 'ShapeApplyVolumeMap', name + ' fitted', [data, charges], {}, False
    cow_charges = carried(hexahedra('cow'), map_of('cow'), 1)
    yield 'ShapeApplyVolumeMap', 'cow', [hexahedra('cow'), cow_charges], {}, False
    yield 'ShapeApplyVolumeMap', 'ball to cow', [
        shape('BallSmall.vtu'), cow_charges], {'Inverse': 1}, False


def surface_maps():
    a, b = shape('FigureASmall.vtp'), shape('FigureBSmall.vtp')
    yield 'ShapeCorrespondence', 'figures', [a, b, landmarks(a, 5)], {}, True
    yield 'ShapeCorrespondence', 'figures without landmarks', [a, b], {}, False
    for method in range(7):
        yield 'ShapeCorrespondence', 'figures without landmarks, method %d' % method, [a, b], {
            'Method': method, 'NumberOfEigenpairs': 60}, False
    head = shape('PhantomHeadSmall.vtp')
    sphere = chain('ShapeMorph', 0, [head], time=0.7)
    yield 'ShapeCorrespondence', 'head', [head, sphere, landmarks(head, 4)], {'Method': 5}, True
    yield 'ShapeCorrespondence', 'figures on an orbifold', [a, b, landmarks(a, 4)], {'Method': 6}, False
    yield 'ShapeCorrespondence', 'models', [
        shape('cow'), shape('hand')], {'Method': 1, 'NumberOfEigenpairs': 60}, False
    yield 'ShapeCorrespondence', 'eight', [
        shape('eight'), chain('ShapeDeform', 0, [shape('eight'), handle(shape('eight'))])], {
            'Method': 1, 'NumberOfEigenpairs': 50}, False
    for method in (0, 1, 5):
        there, back = found(method)
        name = 'correspondence %d' % method
        yield 'ShapeMapErrorCurve', name, [there, back, a], {}, method == 0
        yield 'ShapeMapDifference', name, [there, back], {}, method == 0
        yield 'ShapeMapQuality', name, [there], {}, False
        yield 'ShapeTransferFields', name, [there, back], {}, method == 0
    yield 'ShapeMapErrorCurve', 'truth', [a, b, a], {}, True
    yield 'ShapeMapErrorCurve', 'landmarks', [found(1)[0], b, landmarks(a, 6)], {}, False
    yield 'ShapeMapDifference', 'truth', [a, b], {'NumberOfEigenpairs': 30}, False
    yield 'ShapeMapDifference', 'bar', [
        shape('BentBarSmall.vtp'), chain('ShapeMorph', 0, [shape('BentBarSmall.vtp')], time=1.0)], {
            'NumberOfEigenpairs': 20}, False


def along_maps():
    """What is measured on, moved by and carried along maps."""
    mapped = carried(hexahedra('cow'), map_of('cow'))
    moved_bar = carried(shape('BentBarSmall.vtu'), shape('BentBarSmall.vtp'))
    yield 'ShapeMapQuality', 'no map', [shape('BallSmall.vtu')], {}, False
    for name in SURFACES + ('BentBarSmall.vtu', 'TwistedBarSmall.vtu'):
        yield 'ShapeMapQuality', name, [shape(name)], {}, False
        for share in (0.0, 0.3, 1.0):
            yield 'ShapeMorph', '%s at %g' % (name, share), [shape(name)], {'time': share}, False
    for name in ('cow', 'hand', 'camel'):
        yield 'ShapeMapQuality', name, [map_of(name)], {}, False
        yield 'ShapeMorph', name + ' at 0.5', [map_of(name)], {'time': 0.5}, False
    for name, data in (('cow mapped', mapped), ('bar mapped', moved_bar)):
        yield 'ShapeMapQuality', name, [data], {'MapArray': CAME}, False
        yield 'ShapeMorph', name + ' at 0.5', [data], {'MapArray': CAME, 'time': 0.5}, False
        yield 'ShapeUntangle', name, [data], {}, True
    yield 'ShapeMorph', 'blocks', [in_blocks(shape('DentedSphere600.vtp'))], {'time': 0.5}, False
    for name in SOLIDS:
        yield 'ShapeUntangle', name, [tangled(shape(name)), shape(name)], {}, True
        yield 'ShapeUntangle', name + ' without rest', [tangled(shape(name))], {}, False
    tetrahedra = chain('ShapeTetrahedralize', 0, [shape('eight')])
    yield 'ShapeUntangle', 'tetrahedra', [tangled(tetrahedra), tetrahedra], {}, True
    moved = carried(tetrahedra, shape('DentedSphere600.vtp'))
    yield 'ShapeUntangle', 'outside', [moved], {}, False
    for name, taker, giver, array in (
            ('bar', shape('BentBarSmall.vtu'),
             chain('ShapeMorph', 0, [shape('BentBarSmall.vtu')], time=1.0), GOES),
            ('cow', map_of('cow'), chain('ShapeParameterize', 1, [shape('hand')]), GOES),
            ('solid', mapped, shape('cow'), CAME)):
        yield 'ShapeTransferFields', name, [taker, giver], {'MapArray': array}, True
    yield 'ShapeTransferFields', 'pushed', [
        lattice(chain('ShapeMorph', 0, [shape('TwistedBarSmall.vtu')], time=1.0)),
        shape('TwistedBarSmall.vtu')], {'Direction': 1}, False


def files():
    regions = chain('ShapeTetrahedralize', 0, [
        shape('PhantomHeadSmall.vtp'), [shape('PhantomBrainSmall.vtp')]])
    for name, data in [(each, shape(each)) for each in SOLIDS] + [
            ('cow', hexahedra('cow')), ('anchor', hexahedra('anchor')), ('regions', regions),
            ('cow mapped', carried(hexahedra('cow'), map_of('cow')))]:
        for writer in ('ShapeAbaqusWriter', 'ShapeMeditWriter'):
            yield writer, name, [data], {}, True


def kinds_of_data():
    """Polygons that are no triangles, and several blocks."""
    for name in ('cross_quad', 'double-torus-example', 'hedra'):
        data = shape(name)
        for filter, inputs, settings in (
                ('ShapeBoundaryDistance', [lattice(data), data], {}),
                ('ShapeGeodesicDistance', [data, seeds(data, 2)], {}),
                ('ShapeLaplaceSpectrum', [data], {'NumberOfEigenpairs': 8}),
                ('ShapeTetrahedralize', [data], {}),
                ('ShapeCutFeature', [data, section(data, 0.7)], {})):
            yield filter, name, inputs, settings, False
    yield 'ShapeParameterize', 'blocks', [in_blocks(shape('hand'))], {}, False
    yield 'ShapeMapQuality', 'blocks', [in_blocks(shape('DentedSphere600.vtp'))], {}, False
    yield 'ShapeTransferFields', 'blocks', [in_blocks(each) for each in found(1)], {}, False


def options():
    """Options that matter only with others."""
    bar = shape('BentBarSmall.vtp')
    for method in (1, 2):
        for sampling in ('CollocationSampling', 'SourceSampling'):
            yield ('ShapeHarmonicVolumeMap', 'method %d, uniform %s' % (method, sampling),
                   [lattice(bar), bar], {'Method': method, sampling: 0}, False)
    yield 'ShapeParameterize', 'pig refined', [shape('pig')], {'Domain': 2, 'Refine': 1}, False
    for option, array in (('RigidityArray', 'Number'), ('ScaleArray', 'Number'),
                          ('SegmentArray', 'Mark')):
        yield 'ShapeDeform', 'eight, ' + option, [shape('eight'), handle(shape('eight'))], {
            option: array}, False
    for name in ('camel', 'bear'):
        for value in (0, 1, 2):
            yield 'ShapeDeform', '%s, multiresolution %d' % (name, value), [
                shape(name), handle(shape(name))], {'Multiresolution': value}, False
    for name in ('mushroom', 'three_peaks'):
        yield 'ShapeFillHoles', name + ', multiresolution', [shape(name)], {
            'FillMethod': 1, 'Multiresolution': 1}, False


CASES = (distances, parameterizations, spectra, cuts_and_fills, pastes, deformations, solids,
         volume_maps, surface_maps, along_maps, files, kinds_of_data, options)


def all_cases():
    """Cases with their variants, each once: (filter, name, function that runs it)."""
    writers = filters.writers()
    known = set()
    for name, case, inputs, settings, vary in itertools.chain.from_iterable(made() for made in CASES):
        is_writer = name in writers
        known.add(name)
        variants = [{}]
        if vary:
            smproxy = (filters.proxy(name + 'Core', 'internal_writers') if is_writer
                       else smproxy_of(name))
            variants += [{key: value} for key, value in alternatives(smproxy, settings)]
        for variant in variants:
            words = ''.join(', %s=%s' % item for item in variant.items())
            yield name, case + words, functools.partial(
                file_lines if is_writer else execute, name, inputs, {**settings, **variant})
    missing = {FilterChanges.FILTER_NAMES.get(name, name) for name in PRESENT} | set(writers)
    missing -= known
    assert not missing, 'there are no cases of ' + ', '.join(sorted(missing))
