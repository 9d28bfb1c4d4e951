"""What the parts of the reproduction share: solids with a map of their boundary, and a harmonic
volume map of it, also in a process of its own, so that the peak memory is its own."""
import json
import os
import subprocess
import sys
import time

import numpy
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

HERE = os.path.dirname(os.path.abspath(__file__))
UTILITIES = os.path.dirname(HERE)
sys.path.insert(0, UTILITIES)
import off  # noqa: E402

BUILD = os.environ.get('SHAPEMAP_PREFIX', os.path.join(os.path.dirname(UTILITIES), 'build'))
START = time.time()
# Of the scanned models' sphere maps: limbs must stay large enough to compute on, as in demo.py.
AREA_WEIGHT = 3.0


def say(text):
    print('%6.1f s  %s' % (time.time() - START, text), flush=True)


def read(path):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(path)
    reader.Update()
    if reader.GetOutput().GetNumberOfPoints() == 0:
        raise RuntimeError('cannot read ' + path)
    return reader.GetOutput()


def write(data, path):
    writer = vtkXMLPolyDataWriter()
    writer.SetInputData(data)
    writer.SetFileName(path)
    writer.SetDataModeToBinary()
    if not writer.Write():
        raise RuntimeError('cannot write ' + path)


def points(data):
    return vtk_to_numpy(data.GetPoints().GetData()).astype(float)


def targets(data):
    return vtk_to_numpy(data.GetPointData().GetArray('TargetPosition'))


def surface(coordinates, triangles, images):
    """A surface with its map."""
    data = off.surface(coordinates, triangles)
    array = numpy_to_vtk(numpy.ascontiguousarray(images), deep=True)
    array.SetName('TargetPosition')
    data.GetPointData().AddArray(array)
    return data


def triangles(data):
    return vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def generated(name):
    """The file of a shape that the build has made."""
    return os.path.join(BUILD, 'Data', name + '.vtp')


def turned_round(name, folder):
    """The file of a generated shape's image, mapped back onto the shape."""
    path = os.path.join(folder, name + 'Back.vtp')
    shape = read(generated(name))
    write(surface(targets(shape), triangles(shape), points(shape)), path)
    return path


def onto_sphere(name, folder):
    """The file of a model with its map onto the unit sphere by Shape Parameterize; made once."""
    path = os.path.join(folder, name + '.vtp')
    if not os.path.exists(path):
        producer = simple.TrivialProducer(guiName=name)
        producer.GetClientSideObject().SetOutput(off.read(
            os.path.join(BUILD, 'models', name + '.off')))
        sphere = simple.ShapeParameterize(Input=producer, AreaWeight=AREA_WEIGHT)
        sphere.UpdatePipeline()
        image = sphere.GetClientSideObject().GetOutputDataObject(0)
        if image.GetNumberOfPoints() == 0:
            raise RuntimeError('Shape Parameterize failed on ' + name)
        write(image, path)
        simple.Delete(sphere)
        say('%s: mapped onto the sphere, area weight %g' % (name, AREA_WEIGHT))
    return path


def volume_map(boundary, **options):
    """Makes the harmonic volume map of a boundary's file and returns the table of levels as a
    dictionary of columns, with `wall` and `cpu`: the seconds of the filter alone."""
    reader = simple.XMLPolyDataReader(FileName=[boundary])
    reader.UpdatePipeline()
    # The map is made for the boundary; carrying one point costs nothing.
    domain = simple.PointSource(NumberOfPoints=1, Radius=0.0)
    domain.UpdatePipeline()
    options = dict(dict(Method='MultiLevel'), **options) # the paper's, unless said otherwise
    harmonic = simple.ShapeHarmonicVolumeMap(Domain=domain, Boundary=reader, **options)
    wall, cpu = time.time(), time.process_time()
    harmonic.UpdatePipeline()
    took = dict(wall=time.time() - wall, cpu=time.process_time() - cpu)
    table = harmonic.GetClientSideObject().GetOutputDataObject(2)
    if table.GetNumberOfRows() == 0:
        raise RuntimeError('Shape Harmonic Volume Map failed on ' + boundary)
    for c in range(table.GetNumberOfColumns()):
        took[table.GetColumnName(c)] = [
            table.GetColumn(c).GetValue(r) for r in range(table.GetNumberOfRows())]
    for proxy in (harmonic, domain, reader):
        simple.Delete(proxy)
    return took


def volume_map_alone(boundary, **options):
    """The same in a process of its own (one_map.py), with that process's peak memory in MiB:
    `before` the filter ran and `peak`."""
    run = subprocess.run(
        [os.path.join(UTILITIES, 'pvpython.sh'), os.path.join(HERE, 'one_map.py'), boundary,
         json.dumps(options)], stdout=subprocess.PIPE, universal_newlines=True, check=True)
    return json.loads(run.stdout.splitlines()[-1])
