"""Shape Example: every shape of the list, what to try with it, and what is missing.

As an example: one call makes a shape, and a filter takes it."""
import os

from paraview import simple
import shapemap

import shapetesting

sphere = simple.ShapeParameterize(Input=simple.ShapeExample(Shape='Dented Sphere'))
sphere.UpdatePipeline()
assert shapetesting.output(sphere, 1).GetNumberOfPoints() == 642

# The list offers what can be made, and nothing else.
example = simple.ShapeExample()
example.UpdatePipelineInformation()
listed = list(example.GetProperty('Shape').GetAvailable())
assert 'Figure' in listed and 'Bunny' in listed and len(listed) > 20, listed
counts = {'Bunny': 37706, 'Figure': 1134, 'Ball of Hexahedra': 997, 'Two-Holed Torus': 1668}
for name in listed:
    example.Shape = name
    example.UpdatePipeline()
    data = shapetesting.output(example)
    assert data.GetNumberOfCells() > 0, name
    assert data.GetNumberOfPoints() == counts.get(name, data.GetNumberOfPoints()), name
    assert data.GetClassName() == (
        'vtkUnstructuredGrid' if name.endswith('Hexahedra') else 'vtkPolyData'), name
    example.UpdatePropertyInformation()
    words = shapetesting.fact(data, 'Example.TryNext')
    assert example.SMProxy.GetProperty('TryNext').GetElement(0) == words, name
    assert 20 < len(words) < 100, (name, words)
    assert shapetesting.fact(data, 'Example.Shape') == name

# Without the package, its models are not listed, and refused with the remedy in one line.
made = shapemap.vtkShapeExample()
made.SetModelArchive('/nowhere/data.tar.gz')
names = made.GetShapes()
assert names.GetNumberOfValues() == 11
log = os.path.join(os.environ.get('TMPDIR', '/tmp'), 'shapemap-example-%d.txt' % os.getpid())


def refused(name):
    from vtkmodules.vtkCommonCore import vtkFileOutputWindow, vtkOutputWindow
    window = vtkFileOutputWindow()
    window.SetFileName(log)
    before = vtkOutputWindow.GetInstance()
    vtkOutputWindow.SetInstance(window)
    made.SetShape(name)
    made.Update()
    vtkOutputWindow.SetInstance(before)
    del window
    text = open(log).read()
    os.remove(log)
    assert made.GetOutputDataObject(0).GetNumberOfPoints() == 0
    return text


text = refused('Bunny')
assert 'Shape Example: install libcgal-demo, the Debian package that has' in text, text
assert "there is no shape 'Teapot'; choose one of the list" in refused('Teapot')
print(len(listed), 'shapes')
