"""shapemap.views: each layout shows what its words say, with equal colours where they promise it, and is
refused with a reason where the source lacks what it needs."""
from paraview import servermanager, simple
from shapemap import views

import shapetesting


def displays(layout):
    """The visible displays of data in each of the two views, from left to right."""
    found = [servermanager._getPyProxy(layout.SMProxy.GetView(cell)) for cell in (1, 2)]
    assert None not in found, found
    return [[display for display in view.Representations
             if hasattr(display, 'Input') and display.Visibility and display.Input.GetXMLName() != 'TextSource'] for view in found]


def refused(layout, source, words):
    before = len(simple.GetSources()), len(simple.GetLayouts())
    try:
        layout(source)
    except ValueError as error:
        assert words in str(error), error
    else:
        raise AssertionError('%s took a source without %s' % (layout.__name__, words))
    assert before == (len(simple.GetSources()), len(simple.GetLayouts())), 'a refused layout leaves nothing behind'


surface = simple.OpenDataFile(shapetesting.data_file('DentedSphere600.vtp'))
plain = simple.Sphere()
refused(views.map_quality, plain, 'point array TargetPosition')
refused(views.hexahedra, surface, 'cell array ScaledJacobian')
refused(views.deck_check, surface, 'cell array RegionId')
refused(views.correspondence, surface, 'output of Shape Correspondence')

(shape,), (image,) = displays(views.map_quality(surface))
assert list(shape.ColorArrayName) == list(image.ColorArrayName) == ['CELLS', 'ConformalDistortion']
assert shape.LookupTable.SMProxy == image.LookupTable.SMProxy
assert [shape.LookupTable.RGBPoints[i] for i in (0, -4)] == [1.0, 3.0]
bounds = image.Input.GetDataInformation().GetBounds()
assert all(abs(abs(bound) - 1.0) < 0.01 for bound in bounds), 'the image is the unit sphere: %s' % (bounds,)
links = servermanager.ProxyManager()
assert links.GetRegisteredLink('ShapeMap Map Quality') is not None, 'the cameras are linked'

hexahedra = simple.ShapeHexRemesh(Surface=surface, CellsOnLongestSide=10)
(cut,), (bars,) = displays(views.hexahedra(hexahedra))
cells = hexahedra.GetDataInformation().GetNumberOfCells()
kept = cut.Input.GetDataInformation().GetNumberOfCells()
assert 0.2 < kept / cells < 0.8, 'about half of the cells are cut away: %d of %d are left' % (kept, cells)
counted = servermanager.Fetch(bars.Input).GetRowData().GetArray('bin_values')
assert sum(counted.GetTuple1(i) for i in range(20)) == cells, 'the histogram has each cell once'

(regions,), (patches,) = displays(views.deck_check(hexahedra))
assert list(regions.ColorArrayName) == ['CELLS', 'RegionId'] and list(patches.ColorArrayName) == ['CELLS', 'Patch']
faces = hexahedra[1].GetDataInformation().GetNumberOfCells()
texts = [source.Text for source in simple.GetSources().values() if source.GetXMLName() == 'TextSource']
assert 'Region 0: %d cells' % cells in texts and 'Patch 0: %d faces' % faces in texts, texts

scaled = simple.Transform(Input=surface)
scaled.Transform.Scale = [1.0, 1.3, 0.8]
found = simple.ShapeCorrespondence(SurfaceA=surface, SurfaceB=scaled)
(first,), (second,) = displays(views.correspondence(found))
assert first.LookupTable.SMProxy == second.LookupTable.SMProxy
images = [shapetesting.array(shapetesting.output(display.Input), 'PositionOnSurfaceB') for display in (first, second)]
assert abs(images[0].max(axis=0) - images[1].max(axis=0)).max() < 0.1, 'the images on B reach as far as B'
