"""The libraries that call OpenCASCADE and ITK are beside the filters': their readers get as far as the file."""
import os
import tempfile

import shapemap

with tempfile.TemporaryDirectory() as folder:
    path = os.path.join(folder, 'broken.step')
    with open(path, 'w') as file:
        file.write('ISO-10303-21;\n')
    for reader, words in ((shapemap.vtkShapeCADReader(), 'OpenCASCADE cannot read it as STEP'),
                          (shapemap.vtkShapeImageReader(), 'it is no NRRD, MetaImage or NIfTI image')):
        refusals = []

        def hear(caller, event, text):
            refusals.append(text)
        hear.CallDataType = 'string0'
        reader.AddObserver('ErrorEvent', hear)
        reader.SetFileName(path)
        reader.Update()
        assert any(words in text for text in refusals), refusals
