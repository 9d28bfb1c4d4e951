"""Shape Landmarks Reader: files of other programs open in File > Open, pairs in a script."""
import os
import tempfile

from paraview import simple
import shapemap

import shapetesting
from shapetesting import array, fact, points

FILES = {
    'points.fcsv': '# Markups fiducial file version = 4.11\n# CoordinateSystem = LPS\n'
                   '# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label\n'
                   '1,1,2,3,0,0,0,1,1,1,0,first\n2,4,5,6,0,0,0,1,1,1,0,\n',
    'points.mrk.json': '{"markups": [{"type": "Fiducial", "coordinateSystem": "LPS", "controlPoints": [\n'
                       '{"label": "first", "position": [1, 2, 3]}, {"label": "", "position": [4, 5, 6]}]}]}',
    'points.pp': '<PickedPoints><point x="1" y="2" z="3" name="first"/><point x="4" y="5" z="6"/></PickedPoints>',
    'points.pts': 'Version 1.0\n3\nfirst 1 2 3\ngone 9999 9999 9999\n2 4 5 6\n',
    'pairs.tps': 'LM3=2\n0.5 1 1.5\n2 2.5 3\nSCALE=2\nLM3=2\n7 8 9\n10 11 12\n',
    'pairs.csv': 'x,y,z,tx,ty,tz,name\n1,2,3,7,8,9,first\n4,5,6,10,11,12,\n'}
expected = [[1, 2, 3], [4, 5, 6]]
with tempfile.TemporaryDirectory() as folder:
    for name, content in FILES.items():
        path = os.path.join(folder, name)
        with open(path, 'w') as file:
            file.write(content)
        # A table of another program opens as before, and so do the point clouds that ParaView reads: the
        # reader claims no .csv and no .pts.
        reader = (simple.ShapeLandmarksReader(FileNames=[path]) if name.endswith(('.csv', '.pts')) else
                  simple.OpenDataFile(path))
        reader.UpdatePipeline()
        assert reader.SMProxy.GetXMLName() == 'ShapeLandmarksReader', name
        read = shapetesting.output(reader)
        assert (points(read) == expected).all() and read.GetNumberOfVerts() == 2, name
        names = read.GetPointData().GetAbstractArray('Name')
        first = '1' if name == 'pairs.tps' else 'first'
        assert [names.GetValue(0), names.GetValue(1)] == [first, '2'], name
        assert array(read, 'Number').tolist() == [1, 2]
        if name.startswith('pairs'):
            assert (array(read, 'TargetPosition') == [[7, 8, 9], [10, 11, 12]]).all()
        elif name not in ('points.pp', 'points.pts'):
            assert fact(read, 'LandmarksReader.CoordinateSystem') == 'LPS'
            reader.CoordinateSystem = 'RAS'
            reader.UpdatePipeline()
            assert (points(shapetesting.output(reader)) == [[-1, -2, 3], [-4, -5, 6]]).all()

    other = simple.ShapeLandmarksReader(FileNames=[os.path.join(folder, 'pairs.tps')], Specimen=2, TargetSpecimen=0)
    other.UpdatePipeline()
    assert (points(shapetesting.output(other)) == [[7, 8, 9], [10, 11, 12]]).all()
    assert shapetesting.output(other).GetPointData().GetArray('TargetPosition') is None

    bad = shapemap.vtkShapeLandmarksReader()
    bad.SetFileName(os.path.join(folder, 'bad.csv'))
    with open(bad.GetFileName(), 'w') as file:
        file.write('x,y,z\n1,2,3\n1,2,three\n')
    message = ' '.join(shapetesting.run(bad))
    assert 'Shape Landmarks Reader: bad.csv: line 3, column z: `three` is no finite number' in message, message
    assert bad.GetOutputDataObject(0).GetNumberOfPoints() == 0
print('landmarks of every format are read')
