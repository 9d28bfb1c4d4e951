"""Files of meshes, images and landmarks: which are read and written, by their extensions."""
from __future__ import annotations

import importlib
import os
import shutil
import tempfile
import warnings
from typing import Any, Callable, Optional

from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkDataSet, vtkPolyData, vtkTable, vtkUnstructuredGrid
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter

from .run import Run, ShapeError

# The module and the class of what reads each extension.
_READERS = {
    'vtp': ('vtkmodules.vtkIOXML', 'vtkXMLPolyDataReader'), 'vtu': ('vtkmodules.vtkIOXML', 'vtkXMLUnstructuredGridReader'),
    'vtk': ('vtkmodules.vtkIOLegacy', 'vtkDataSetReader'), 'stl': ('vtkmodules.vtkIOGeometry', 'vtkSTLReader'),
    'obj': ('vtkmodules.vtkIOGeometry', 'vtkOBJReader'), 'ply': ('vtkmodules.vtkIOPLY', 'vtkPLYReader'),
    'off': ('shapemap', 'vtkShapeOFFReader'), 'mesh': ('shapemap', 'vtkShapeMeditReader'),
    **dict.fromkeys(('inp', 'k', 'key', 'dyn', 'feb'), ('shapemap', 'vtkShapeDeckReader')),
    **dict.fromkeys(('step', 'stp', 'iges', 'igs', 'brep'), ('shapemap', 'vtkShapeCADReader'))}
_IMAGES = {
    'vti': ('vtkmodules.vtkIOXML', 'vtkXMLImageDataReader'),
    **dict.fromkeys(('nrrd', 'nhdr', 'mha', 'mhd', 'nii', 'nii.gz'), ('shapemap', 'vtkShapeImageReader'))}
_LANDMARKS = dict.fromkeys(('fcsv', 'json', 'pp', 'pts', 'tps', 'csv'), ('shapemap', 'vtkShapeLandmarksReader'))
_SURFACE_WRITERS = {
    'vtp': ('vtkmodules.vtkIOXML', 'vtkXMLPolyDataWriter'), 'vtk': ('vtkmodules.vtkIOLegacy', 'vtkDataSetWriter'),
    'stl': ('vtkmodules.vtkIOGeometry', 'vtkSTLWriter'), 'ply': ('vtkmodules.vtkIOPLY', 'vtkPLYWriter'),
    'obj': ('vtkmodules.vtkIOGeometry', 'vtkOBJWriter')}
_SOLID_WRITERS = {
    'vtu': ('vtkmodules.vtkIOXML', 'vtkXMLUnstructuredGridWriter'),
    'vtk': ('vtkmodules.vtkIOLegacy', 'vtkDataSetWriter'), 'inp': ('shapemap', 'vtkShapeAbaqusWriter'),
    'k': ('shapemap', 'vtkShapeDynaWriter'), 'feb': ('shapemap', 'vtkShapeFebioWriter'),
    'msh': ('shapemap', 'vtkShapeGmshWriter'), 'mesh': ('shapemap', 'vtkShapeMeditWriter'),
    'exo': ('shapemap', 'vtkShapeExodusWriter'), 'foam': ('shapemap', 'vtkShapeFoamWriter')}

# Endings of two parts, and the extension for each.
_DOUBLE = {'.nii.gz': 'nii.gz', '.seg.nrrd': 'nrrd', '.mrk.json': 'json'}
#: The extensions that are written.
WRITTEN = tuple(dict.fromkeys((*_SURFACE_WRITERS, *_SOLID_WRITERS)))
WRITTEN_SOLIDS = tuple(_SOLID_WRITERS)
WRITTEN_SURFACES = tuple(_SURFACE_WRITERS)


def split(path: str) -> tuple[str, str]:
    """The name of a file without its ending, and its extension: in small letters, without the dot."""
    name = os.path.basename(path)
    for ending, extension in _DOUBLE.items():
        if name.lower().endswith(ending):
            return name[:-len(ending)], extension
    stem, last = os.path.splitext(name)
    return stem, last[1:].lower()


def extension(path: str) -> str:
    return split(path)[1]


def stem(path: str) -> str:
    return split(path)[0]


def read_by(types: tuple[str, ...]) -> tuple[str, ...]:
    """The extensions of what an input of these classes takes: images, or meshes, or both."""
    images = 'vtkImageData' in types or 'vtkDataSet' in types
    return (*(_READERS if set(types) - {'vtkImageData'} else ()), *(_IMAGES if images else ()))


def read(path: str) -> vtkDataSet:
    """The mesh or the landmarks of a file. Raises ShapeError if it cannot be read."""
    kinds = {**_LANDMARKS, **_READERS, **_IMAGES}
    if extension(path) not in kinds:
        raise ShapeError('%s: its extension is unknown; give one of %s' % (path, ', '.join(kinds)))
    module, name = kinds[extension(path)]
    run = Run(_new(module, name))
    run.set('SetFileName', path)
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter('always')
        try:
            (data,), _ = run.outputs([0], None)
        except ShapeError as error:
            # Some readers only warn of what is wrong, and VTK then describes the request that failed.
            said = str(caught[0].message) if caught and 'returned failure' in str(error) else str(error)
            raise ShapeError('%s cannot be read: %s' % (path, said)) from error
    if not isinstance(data, vtkDataSet) or data.GetNumberOfPoints() == 0:
        raise ShapeError('%s has no points; it is empty or damaged' % path)
    return data


def as_type(data: vtkDataSet, types: tuple[str, ...]) -> vtkDataSet:
    """The data for an input that takes these classes: its surface if the input takes only surfaces."""
    if data.IsA('vtkImageData') and not {'vtkImageData', 'vtkDataSet'} & set(types):
        raise ShapeError('it is an image; extract its surfaces with "shapemap surfaces", and give those')
    if not any(data.IsA(each) for each in types) and 'vtkPolyData' in types:
        return _surface_of(data)
    return data


def write(data: vtkDataObject, folder: str, name: str, format: Optional[str] = None) -> list[str]:
    """Writes data to a file, or to a folder if the format needs several files. What has that name is replaced
    only by complete files. Returns its path relative to the folder, with those of the files in it."""
    if isinstance(data, vtkTable):
        module, kind, format = 'vtkmodules.vtkIOCore', 'vtkDelimitedTextWriter', 'csv'
    else:
        solid = not isinstance(data, vtkPolyData)
        format = format or ('vtu' if solid else 'vtp')
        writers = _SOLID_WRITERS if solid else _SURFACE_WRITERS
        if not solid and format not in writers and format in _SOLID_WRITERS:
            # Formats of solvers have shells, too.
            writers, data = _SOLID_WRITERS, _grid_of(data)
        if format not in writers:
            raise ShapeError('a solid cannot be written as .%s; give --format one of %s' % (format, ', '.join(writers)))
        module, kind = writers[format]
    os.makedirs(folder, exist_ok=True)
    file = '%s.%s' % (name, format)
    with tempfile.TemporaryDirectory(prefix='.writing-', dir=folder) as made:
        run = Run(_new(module, kind))
        run.set('SetFileName', os.path.join(made, file))
        run.set('SetInputDataObject', data)
        if hasattr(run.algorithm, 'SetFileTypeToBinary'):
            run.set('SetFileTypeToBinary')
        run.outputs([], None)
        if not os.path.exists(os.path.join(made, file)):
            raise ShapeError('%s cannot be written in %s; free some space' % (file, folder))
        if len(os.listdir(made)) == 1:
            os.replace(os.path.join(made, file), os.path.join(folder, file))
            return [file]
        target = os.path.join(folder, name)
        if os.path.isdir(target):
            shutil.rmtree(target)
        os.makedirs(target)
        # The file that names the others comes last.
        for each in sorted(os.listdir(made), key=lambda each: each == file):
            os.replace(os.path.join(made, each), os.path.join(target, each))
        return [os.path.relpath(os.path.join(place, each), folder)
                for place, _, held in sorted(os.walk(target)) for each in sorted(held)]


def replace(path: str, content: bytes) -> None:
    """Writes a small file, which is never incomplete. One with this content already is left alone."""
    if os.path.exists(path):
        with open(path, 'rb') as held:
            if held.read() == content:
                return
    with open(path + '.writing', 'wb') as made:
        made.write(content)
    os.replace(path + '.writing', path)


def _new(module: str, name: str) -> Any:
    kind: Callable[[], Any] = getattr(importlib.import_module(module), name)
    return kind()


def _grid_of(data: vtkDataSet) -> vtkUnstructuredGrid:
    grid = vtkAppendFilter()
    grid.SetInputData(data)
    grid.Update()
    return grid.GetOutput()


def _surface_of(data: vtkDataSet) -> vtkPolyData:
    surface = vtkGeometryFilter()
    surface.SetInputData(data)
    surface.Update()
    return surface.GetOutput()
