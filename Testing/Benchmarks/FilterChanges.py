"""What CompareOutputs.py and FilterCases.py know of the change between two builds."""

# Other names, as old: new. Builds with the old and with the new names run; the new ones are compared.
FILTER_NAMES = {'ShapeShapeDifference': 'ShapeMapDifference'}
PROPERTY_NAMES = {}
ARRAY_NAMES = {'ShapeDifference.': 'MapDifference.'}  # beginnings of names, field data too

# Arrays that are meant to be gone or to differ: regular expressions of "FILTER: CASE" and of the array
# (as "0: cell ScaledJacobian", 0 being the output), and why. They are reported and fail nothing.
EXPECTED = ()
