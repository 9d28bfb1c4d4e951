"""Computes the mean and the modes of 20 shapes, and where two groups of a CSV file differ."""
from paraview.simple import *

# Ellipsoids whose length varies; those of the group "b" are thicker.
with open('groups.csv', 'w') as file:
    file.write('Subject,Group\n' + ''.join('%d,%s\n' % (k, 'ab'[k % 2]) for k in range(20)))
sphere = Clean(Input=Sphere(ThetaResolution=32, PhiResolution=32, Radius=1.0))
stretch = '%g*coordsX*iHat + %g*coordsY*jHat + coordsZ*kHat'
shapes = [Calculator(Input=sphere, CoordinateResults=1,
                     Function=stretch % (2.5 + 0.02 * ((7 * k) % 20), 1.5 + 0.2 * (k % 2)))
          for k in range(20)]
atlas = ShapeAtlas(Shapes=GroupDatasets(Input=shapes), Table=CSVReader(FileName='groups.csv'),
                   Groups='Group')
atlas.UpdatePipeline()

facts = servermanager.Fetch(atlas, idx=4)
modes, p = (facts.GetColumnByName('Atlas.' + name).GetTuple1(0) for name in ('NumberOfModes', 'GroupPValue'))
print('%d modes; the groups differ: p = %.3f' % (modes, p))
assert modes == 2 and p < 0.01
SaveData('mean.vtp', atlas, DataMode='Binary')
