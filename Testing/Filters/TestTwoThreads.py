"""Two filters in two threads give the bits that each gives alone, and neither waits forever: one computes after the
other, although Python runs the other thread while an observer hears of progress."""
import threading

import shapemap

from shapetesting import array, read


def spectrum(file):
    filter = shapemap.vtkShapeLaplaceSpectrum()
    filter.SetInputDataObject(read(file))
    filter.SetNumberOfEigenpairs(40)
    filter.AddObserver('ProgressEvent', lambda caller, event: heard.append(caller))
    filter.Update()
    return filter


def compute(file, results):
    """In the thread that computes, because VTK runs a Python observer in the state of the thread that added it."""
    results[file] = spectrum(file)


heard = []
files = ['FigureASmall.vtp', 'FigureBSmall.vtp']
alone = {file: array(spectrum(file).GetOutputDataObject(0), 'Eigenfunctions').copy() for file in files}
for _ in range(3):
    together = {}
    threads = [threading.Thread(target=compute, args=(file, together)) for file in files]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(60.0)
        assert not thread.is_alive(), 'a filter waits forever'
    for file in files:
        assert (array(together[file].GetOutputDataObject(0), 'Eigenfunctions') == alone[file]).all()
assert len(heard) > 20
