"""Two filters in two threads give the bits that each gives alone, and neither waits forever: one computes after the
other, although Python runs the other thread while an observer hears of progress."""
import threading

import shapemap

import shapetesting
from shapetesting import array, read


def spectrum(file):
    filter = shapemap.vtkShapeLaplaceSpectrum()
    filter.SetInputDataObject(read(file))
    filter.SetNumberOfEigenpairs(40)
    filter.AddObserver('ProgressEvent', lambda caller, event: heard.append(caller))
    return filter


heard = []
files = ['FigureASmall.vtp', 'FigureBSmall.vtp']
alone = [array(shapetesting.outputs(spectrum(file))[0], 'Eigenfunctions').copy() for file in files]
for _ in range(3):
    together = [spectrum(file) for file in files]
    threads = [threading.Thread(target=each.Update) for each in together]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(60.0)
        assert not thread.is_alive(), 'a filter waits forever'
    for filter, expected in zip(together, alone):
        assert (array(filter.GetOutputDataObject(0), 'Eigenfunctions') == expected).all()
assert len(heard) > 20
