"""Draws hexahedra of Shape Hex Remesh: one picture for each model, MODEL.png. Left the polycube of Shape
Polycube, coloured by its six sides, or why it finds none (large triangles are cut into smaller ones for
it); in the middle the hexahedra, and on the right a cut through them, coloured by the scaled Jacobian.

    Utilities/pvpython.sh Testing/Benchmarks/HexPictures.py OUTPUT [MODEL ...] [Property=value ...]

MODEL is one of libcgal-demo's in build/models; without any, six of them. Properties are Shape Hex Remesh's. The hexahedra are kept as MODEL.vtu and the polycubes as MODEL.vtp; where these are
there already, they are only drawn again.
"""
import os
import textwrap

import sweep

import numpy
from paraview import simple
import shapemap
from vtkmodules.vtkCommonCore import vtkPoints, vtkStringArray
from vtkmodules.vtkFiltersModeling import vtkLinearSubdivisionFilter
from vtkmodules.vtkIOXML import (
    vtkXMLPolyDataReader, vtkXMLPolyDataWriter, vtkXMLUnstructuredGridReader,
    vtkXMLUnstructuredGridWriter)

import off
import panels
import pictures
import scenes
import shapetesting
from shapetesting import fact

SIZE = (1800, 700)
LEAST = 5000  # triangles of a surface of which a polycube is made
SHIFT, WIDEST, LINE = 1.2, [1.15, 1.0], -0.62  # of the three panels
# Of each model: towards the viewer, up, and the normal of the plane that cuts it, which shows what
# lies against it.
VIEWS = {
    'bunny00': ([0.55, 0.2, 0.81], [0, 1, 0], [0.55, 0.0, 0.83]),
    'fandisk': ([0.6, -0.7, 0.45], [0, 0, 1], [1, 0, 0]),
    'femur': ([0.25, -1, 0.0], [0, 0, -1], [0, 1, 0]),
    'hand': ([1, 0.25, 0.4], [0, 1, 0], [1, 0, 0]),
    'joint': ([0.7, 0.6, 0.6], [0, 1, 0], [0, 1, 0]),
    'eight': ([0.4, 1, 0.2], [1, 0, 0], [0, 1, 0])}
# Of the polycube: +x, -x, +y, -y, +z, -z.
SIDES = [[0.84, 0.35, 0.30], [0.95, 0.66, 0.58], [0.35, 0.62, 0.38], [0.66, 0.82, 0.62],
         [0.27, 0.47, 0.70], [0.62, 0.76, 0.90]]


def kept(path, reader, writer, make):
    """The data set in a file, made where there is none."""
    if not os.path.exists(path):
        save = writer()
        save.SetInputData(make())
        save.SetFileName(path)
        save.SetDataModeToBinary()
        assert save.Write(), 'cannot write ' + path
    load = reader()
    load.SetFileName(path)
    load.Update()
    return load.GetOutput()


def made(algorithm, surface, port, settings):
    """An output of a filter, or, where it fails, nothing but its words."""
    sweep.set_properties(algorithm, settings)
    algorithm.SetInputDataObject(surface)
    messages = shapetesting.run(algorithm)
    data = algorithm.GetOutputDataObject(port)
    if messages:
        data = data.NewInstance()
        data.SetPoints(vtkPoints()) # files without points are an error to their reader
        words = vtkStringArray()
        words.SetName('Error')
        words.InsertNextValue(messages[0].strip().split(': ')[-1])
        data.GetFieldData().AddArray(words)
    return data


def refined(surface):
    """The surface in triangles that are small enough for a polycube."""
    triangles = scenes.triangulated(surface)
    subdivide = vtkLinearSubdivisionFilter()
    subdivide.SetInputData(triangles)
    count = triangles.GetNumberOfPolys()
    subdivide.SetNumberOfSubdivisions(max(0, int(numpy.ceil(numpy.log(LEAST / count) / numpy.log(4.0)))))
    subdivide.Update()
    return subdivide.GetOutput()


def solids(folder, model, path, settings):
    """The hexahedra and the polycube of a model."""
    hexahedra = kept(os.path.join(folder, model + '.vtu'), vtkXMLUnstructuredGridReader,
                     vtkXMLUnstructuredGridWriter,
                     lambda: made(shapemap.vtkShapeHexRemesh(), off.read(path), 0, settings))
    polycube = kept(os.path.join(folder, model + '.vtp'), vtkXMLPolyDataReader, vtkXMLPolyDataWriter,
                    lambda: made(
                        shapemap.vtkShapePolycube(), refined(off.read(path)), 1, {}))
    return hexahedra, polycube


def draw(path, model, hexahedra, polycube):
    direction, up, normal = VIEWS.get(model, ([0.5, 0.4, 0.8], [0, 1, 0], [0, 0, 1]))
    sheet = panels.Sheet(SIZE, direction, up, SHIFT, WIDEST, LINE)

    def show(column, data, like=None):
        display = sheet.fit(column, data, like, representation='Surface With Edges', width=1.0)
        display.Ambient = 0.35
        return display

    if polycube.GetNumberOfCells():
        display = show(-1, polycube)
        table = simple.GetColorTransferFunction('Label')
        table.InterpretValuesAsCategories = 1
        table.Annotations = [text for label in range(6) for text in [str(label)] * 2]
        table.IndexedColors = [value for colour in SIDES for value in colour]
        pictures.colour_by(display, 'CELLS', 'Label', table, sheet.View)
        display.Representation = 'Surface'
        sheet.label(-1, 'polycube: %d charts, %d corners' % (
            fact(polycube, 'Polycube.Charts'), fact(polycube, 'Polycube.Corners')))
    else:
        sheet.caption('\n'.join(['Shape Polycube finds none:'] + textwrap.wrap(
            fact(polycube, 'Error').split(';')[0], 34)), -SHIFT, 0.0)
    table = simple.GetColorTransferFunction('ScaledJacobian')
    table.ColorSpace, table.RGBPoints = 'RGB', pictures.QUALITY
    for column, data in ((0, hexahedra), (1, scenes.behind(
            hexahedra, hexahedra.GetCenter(), normal))):
        pictures.colour_by(show(column, data, hexahedra), 'CELLS', 'ScaledJacobian', table,
                           sheet.View, 'Scaled Jacobian' if column else None, [0.33, 0.01])
    sheet.label(0, '%s: %d hexahedra by method %s' % (model, hexahedra.GetNumberOfCells(), fact(
        hexahedra, 'HexRemesh.Method')))
    sheet.label(1, 'scaled Jacobian at least %.2f, in the mean %.2f' % (fact(
        hexahedra, 'HexRemesh.MinimumScaledJacobian'), fact(hexahedra, 'HexRemesh.MeanScaledJacobian')))
    sheet.save(path, [0.0, -0.13], 1.45)


def main():
    parser = sweep.parser(__doc__, models=False)
    parser.add_argument('output')
    parser.add_argument('--folder', help="of OFF files; the build's models by default")
    parser.add_argument('words', nargs='*', metavar='MODEL | Property=value')
    options = parser.parse_args()
    os.makedirs(options.output, exist_ok=True)
    simple._DisableFirstRenderCameraReset()
    for model, path in sweep.models(options, list(VIEWS)):
        hexahedra, polycube = solids(options.output, model, path, sweep.properties(options))
        if hexahedra.GetNumberOfCells() == 0:
            raise RuntimeError('%s: no hexahedra: %s' % (model, fact(hexahedra, 'Error')))
        draw(os.path.join(options.output, model + '.png'), model, hexahedra, polycube)
        print('%s: %d hexahedra%s' % (model, hexahedra.GetNumberOfCells(), (
            '' if polycube.GetNumberOfCells() else '; no polycube: ' + fact(polycube, 'Error'))), flush=True)


if __name__ == '__main__':
    main()
