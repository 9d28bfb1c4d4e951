# In the shell of the window, once the filter has run.
from paraview.simple import *

made = GetActiveSource()
names = [made.PointData.GetArray(k).GetName() for k in range(made.PointData.GetNumberOfArrays())]
SaveScreenshot('/tmp/test/window.png', GetActiveView(), ImageResolution=[400, 300])
with open('/tmp/test/window.txt', 'w') as file:
    print('the filter of the menu ran' if made.GetXMLName() == 'ShapeLaplaceSpectrum' and 'Eigenfunctions' in names
          else '%s: %s' % (made.GetXMLName(), names), file=file)
