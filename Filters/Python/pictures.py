"""Pictures of shapes, drawn without a window, and the sheet of them."""
from __future__ import annotations

import contextlib
import os
import shutil
import subprocess
from collections.abc import Iterator, Sequence
from typing import Any

import numpy
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataSet, vtkImageData

SIZE = 240
CAPTION = 34


@contextlib.contextmanager
def display() -> Iterator[str]:
    """Something to draw on: the display that is there or, for VTK that needs an X display, Xvfb. Gives why there is
    none, or nothing."""
    try:
        import vtkmodules.vtkRenderingFreeType
        import vtkmodules.vtkRenderingOpenGL2
        from vtkmodules.vtkRenderingCore import vtkRenderWindow
    except ImportError as error:
        yield 'this VTK cannot render (%s)' % error
        return
    window = vtkRenderWindow().GetClassName()
    if not window.startswith('vtkX') and _draws():
        yield ''
        return
    if os.environ.get('DISPLAY') and _draws():
        yield ''
        return
    if shutil.which('Xvfb') is None:
        yield 'there is no X display; set DISPLAY, or install Xvfb'
        return
    read, written = os.pipe()
    server = subprocess.Popen(
        ['Xvfb', '-displayfd', str(written), '-screen', '0', '640x480x24', '-nolisten', 'tcp'], pass_fds=[written],
        stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)
    os.close(written)
    before = os.environ.get('DISPLAY')
    try:
        with os.fdopen(read) as pipe:
            number = pipe.readline().strip()
        os.environ['DISPLAY'] = ':' + number
        yield '' if number and _draws() else 'VTK cannot render on Xvfb'
    finally:
        server.terminate()
        server.wait()
        del os.environ['DISPLAY']
        if before is not None:
            os.environ['DISPLAY'] = before


def _draws() -> bool:
    """Whether a process, which may die of it, can draw."""
    process = os.fork()
    if process == 0:
        try:
            import signal
            signal.alarm(60)
            with open(os.devnull, 'w') as nothing:
                os.dup2(nothing.fileno(), 1)
                os.dup2(nothing.fileno(), 2)
            from vtkmodules.vtkFiltersSources import vtkSphereSource
            source = vtkSphereSource()
            source.Update()
            # The sphere is not of one colour.
            os._exit(0 if numpy.ptp(image_of(source.GetOutput(), '', (0.0, 1.0))[SIZE // 2]) > 0 else 1)
        finally:
            os._exit(1)
    _, status = os.waitpid(process, 0)
    return status == 0


def image_of(data: vtkDataSet, array: str, colours: tuple[float, float]) -> NDArray[numpy.uint8]:
    """A picture of the surface of a shape, coloured by an array, if it has that: blue at the first of
    the `colours`, red at the second."""
    import vtkmodules.vtkRenderingFreeType
    import vtkmodules.vtkRenderingOpenGL2
    from vtkmodules.vtkCommonCore import vtkLookupTable
    from vtkmodules.vtkRenderingCore import (
        vtkActor, vtkDataSetMapper, vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter)
    mapper = vtkDataSetMapper()
    mapper.SetInputData(data)
    mapper.ScalarVisibilityOff()
    for held, mode in ((data.GetCellData(), 'SetScalarModeToUseCellFieldData'),
                       (data.GetPointData(), 'SetScalarModeToUsePointFieldData')):
        if array and held.HasArray(array):
            table = vtkLookupTable()
            table.SetHueRange(*((0.667, 0.0) if colours[0] < colours[1] else (0.0, 0.667)))
            mapper.SetLookupTable(table)
            getattr(mapper, mode)()
            mapper.SelectColorArray(array)
            mapper.SetScalarRange(*sorted(colours))
            mapper.ScalarVisibilityOn()
            break
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(0.8, 0.8, 0.75)
    renderer = vtkRenderer()
    renderer.SetBackground(1.0, 1.0, 1.0)
    renderer.AddActor(actor)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(1.0, -2.0, 1.0)
    camera.SetViewUp(0.0, 0.0, 1.0)
    renderer.ResetCamera()
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(SIZE, SIZE)
    window.AddRenderer(renderer)
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.Update()
    return _pixels(grab.GetOutput())


def draw(data: vtkDataSet, array: str, colours: tuple[float, float], path: str) -> None:
    """Writes a picture of a shape, as a PNG file."""
    _write(image_of(data, array, colours), path)


def sheet(rows: Sequence[tuple[str, str, str]], path: str) -> None:
    """Writes one PNG file of all pictures. Rows: the PNG file, if it exists, the name, what is below it."""
    from vtkmodules.vtkIOImage import vtkPNGReader
    columns = max(1, min(8, len(rows)))
    tile = numpy.array([SIZE + CAPTION, SIZE])
    image = numpy.full((*(tile * [-(-len(rows) // columns), columns]), 3), 255, numpy.uint8)
    for k, (picture, name, below) in enumerate(rows):
        row, column = tile * divmod(k, columns)
        if os.path.exists(picture):
            reader = vtkPNGReader()
            reader.SetFileName(picture)
            reader.Update()
            image[row:row + SIZE, column:column + SIZE] = _pixels(reader.GetOutput())
        else:
            image[row:row + SIZE, column:column + SIZE] = 225
        for line, text in enumerate((name, below)):
            written = _text(text)[:CAPTION // 2, :SIZE - 8]
            top, left = row + SIZE + line * (CAPTION // 2), column + 4
            image[top:top + len(written), left:left + written.shape[1]] = written
    _write(image, path)


def _text(text: str) -> NDArray[numpy.uint8]:
    """Black words on white."""
    import vtkmodules.vtkRenderingFreeType
    from vtkmodules.vtkRenderingCore import vtkTextProperty, vtkTextRenderer
    style = vtkTextProperty()
    style.SetFontSize(12)
    style.SetColor(0.0, 0.0, 0.0)
    image = vtkImageData()
    size = [0, 0]
    renderer = vtkTextRenderer.GetInstance()
    if not text or not renderer.RenderString(style, text, image, size, 72):
        return numpy.empty((0, 0, 3), numpy.uint8)
    width, height, _ = image.GetDimensions()
    pixels = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[::-1]
    pixels = pixels[height - size[1]:, :size[0]]
    return numpy.repeat(255 - pixels[:, :, 3:4], 3, axis=2).astype(numpy.uint8)


def _pixels(image: Any) -> NDArray[numpy.uint8]:
    """Rows from the top."""
    width, height, _ = image.GetDimensions()
    return numpy.array(vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[::-1, :, :3])


def _write(image: NDArray[numpy.uint8], path: str) -> None:
    from vtkmodules.vtkIOImage import vtkPNGWriter
    height, width = image.shape[:2]
    data = vtkImageData()
    data.SetDimensions(width, height, 1)
    data.GetPointData().SetScalars(numpy_to_vtk(numpy.ascontiguousarray(image[::-1]).reshape(-1, 3), deep=True))
    writer = vtkPNGWriter()
    writer.SetFileName(path + '.writing')
    writer.SetInputData(data)
    writer.Write()
    os.replace(path + '.writing', path)
