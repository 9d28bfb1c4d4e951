"""The filters run on a server, of one process or two, and the client gets the result:
TestClientServer.py pvserver, or TestClientServer.py mpiexec -n 2 pvserver"""
import os
import sys
import tempfile

import numpy
import shapemap
from paraview import simple

import shapetesting
from shapetesting import array

with shapetesting.server(sys.argv[1:]) as port:
    simple.Connect('localhost', port)
    session = simple.servermanager.ActiveConnection
    assert session.IsRemote(), 'the session is not remote'
    print('connected to', session.GetNumberOfDataPartitions(), 'process(es)')

    model = simple.XMLPolyDataReader(FileName=[shapetesting.data_file('DentedSphere600.vtp')])
    sphere = simple.ShapeParameterize(Input=model)
    assert sphere.SMProxy.GetClientSideObject() is None, 'the filter lives in the client'
    sphere.UpdatePipeline()
    mapped = simple.servermanager.Fetch(sphere)
    assert mapped.GetNumberOfPoints() == 642
    assert abs(numpy.linalg.norm(array(mapped, 'TargetPosition'), axis=1) - 1.0).max() < 1e-12

    ball = simple.XMLUnstructuredGridReader(FileName=[shapetesting.data_file('BallSmall.vtu')])
    volume = simple.ShapeHarmonicVolumeMap(
        Domain=ball, Boundary=simple.OutputPort(sphere, 1), MapArray='SourcePosition')
    volume.UpdatePipeline()
    carried = simple.servermanager.Fetch(volume)
    if carried.IsA('vtkMultiBlockDataSet'):
        carried = simple.servermanager.Fetch(simple.MergeBlocks(volume))
    assert carried.GetNumberOfCells() == 864
    assert shapemap.facts(volume)['RMSEInside'] < 0.05

    # The server writes; a mesh in pieces becomes one file.
    with tempfile.TemporaryDirectory() as folder:
        simple.SaveData(os.path.join(folder, 'ball.mesh'), ball)
        words = open(os.path.join(folder, 'ball.mesh')).read().split()
        assert words[words.index('Vertices') + 1] == str(ball.GetDataInformation().GetNumberOfPoints())
        assert words[words.index('Hexahedra') + 1] == '864'
    simple.Disconnect()
print('the client got what the server made')
