"""Shape Certificate on the sphere maps of closed surfaces of genus 0: a table of what is proven.

Each model is mapped onto the ball, and the ball onto it. `certified`, `undecided` and `inverted` are
shares of the volume; `cpu` and `memory` (GiB, above that before) are the certificate's, `rmse` is the
error of the map at the boundary. Witnesses are checked here again by the derivative of
vtkShapeHarmonicTransform: none is positive.

    Utilities/pvpython.sh Testing/Benchmarks/Certificate.py [--distance 0.9] [MODEL ...] [Property=value ...]

Properties are Shape Certificate's; --distance is Charge Distance of the maps. With --keep FOLDER the
charge sets are kept in that folder, or taken from there.
"""
import os
import time

import sweep

import numpy
import off
import shapemap
import shapetesting
from UntangleModels import facing_outwards
from shapetesting import fact, points
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

MODELS = (
    'bear', 'bear_bis', 'blobby', 'bull', 'bunny00', 'cactus', 'camel', 'cow', 'dino', 'dragknob', 'fandisk',
    'hand', 'handle', 'homer', 'itemb', 'man', 'oblong', 'retinal', 'spool', 'triceratops')


def peak_memory(reset=False):
    """Of this process, in GiB, since the last reset."""
    if reset:
        with open('/proc/self/clear_refs', 'w', encoding='ascii') as file:
            file.write('5')
    with open('/proc/self/status', encoding='ascii') as file:
        return next(int(line.split()[1]) for line in file if line.startswith('VmHWM')) / 2.0 ** 20


def charges_of(surface, map_array, distance, kept):
    """The charge set of a map of the solid in a surface, or why there is none."""
    if kept and os.path.exists(kept):
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(kept)
        reader.Update()
        return reader.GetOutput(), ''
    volume_map = shapemap.vtkShapeHarmonicVolumeMap()
    volume_map.SetInputDataObject(0, surface)
    volume_map.SetInputDataObject(1, surface)
    volume_map.SetMapArray(map_array)
    volume_map.SetChargeDistance(distance)
    messages = shapetesting.run(volume_map)
    if messages:
        return None, messages[0].strip().splitlines()[-1]
    charges = volume_map.GetOutputDataObject(1)
    error = numpy_to_vtk(numpy.array([fact(charges, 'HarmonicVolumeMap.RMSEInside')]), deep=True)
    error.SetName('Error')
    charges.GetFieldData().AddArray(error)
    if kept:
        writer = vtkXMLPolyDataWriter()
        writer.SetFileName(kept)
        writer.SetInputData(charges)
        writer.Write()
    return charges, ''


def determinants(charges, places):
    """Of the map's derivative; positions at the surface that count as outside are left out."""
    transform = shapemap.vtkShapeHarmonicTransform()
    transform.SetChargeSetData(charges)
    transform.Update()
    image, derivative, found = [0.0] * 3, numpy.zeros((3, 3)), []
    for place in places:
        transform.InternalTransformDerivative(list(place), image, derivative)
        if list(place) != image:
            found.append(numpy.linalg.det(derivative))
    return numpy.array(found)


def certified(charges, settings):
    """The row of a map."""
    certificate = shapemap.vtkShapeCertificate()
    certificate.SetInputDataObject(0, charges)
    sweep.set_properties(certificate, settings)
    before, start = peak_memory(reset=True), time.process_time()
    assert not shapetesting.run(certificate)
    row = dict(cpu=time.process_time() - start, memory=peak_memory() - before)
    facts = certificate.GetOutputDataObject(2)
    for name in ('Certified', 'Undecided', 'Inverted', 'Bijective', 'BoundaryCrossings', 'Witnesses'):
        row[name.lower()] = fact(facts, 'Certificate.' + name)
    row['crossings'] = row['boundarycrossings']
    row['rmse'] = charges.GetFieldData().GetArray('Error').GetValue(0)
    sample = points(certificate.GetOutputDataObject(1))[::7]
    row['wrong'] = int((determinants(charges, sample) > 0.0).sum())
    return row


def sphere_maps(options, table):
    """Of each model: label, surface and map array of its map onto the ball, and of the ball onto it. A model
    without a sphere map is a row of the table."""
    for name, path in sweep.models(options, MODELS):
        parameterize = shapemap.vtkShapeParameterize()
        parameterize.SetInputDataObject(facing_outwards(off.read(path)))
        parameterize.SetDomain(1)
        messages = shapetesting.run(parameterize)
        if messages:
            table.print({'map': name}, messages[0].strip().splitlines()[-1])
            continue
        yield name + ' to ball', parameterize.GetOutputDataObject(0), 'TargetPosition'
        yield 'ball to ' + name, parameterize.GetOutputDataObject(1), 'SourcePosition'


def main():
    parser = sweep.parser(__doc__)
    parser.add_argument('--distance', type=float, default=0.9, help='of the charges')
    parser.add_argument('--keep', help='a folder for the charge sets')
    options = parser.parse_args()
    claims, wrong, maps = sweep.Claims(), [], 0
    table = sweep.Table('map:<24', 'points:7d', 'charges:8d', 'rmse:8.1e', 'certified:10.6f', 'undecided:9.1e',
                        'inverted:9.1e', 'witnesses:9.0f', 'crossings:9.0f', 'bijective:9.0f', 'cpu:7.1f',
                        'memory:6.2f')
    for label, surface, array in sphere_maps(options, table):
        kept = os.path.join(options.keep, label.replace(' ', '_') + '.vtp') if options.keep else ''
        charges, reason = charges_of(surface, array, options.distance, kept)
        row = {'map': label}
        if charges:
            row.update(certified(charges, sweep.properties(options)),
                       points=surface.GetNumberOfPoints(), charges=charges.GetNumberOfPoints())
            maps += 1
            if row['wrong']:
                wrong.append('%s: %d' % (label, row['wrong']))
        table.print(row, reason)
    claims.none('%d maps' % maps, 'with a positive determinant at a witness', wrong)
    claims.finish()


if __name__ == '__main__':
    main()
