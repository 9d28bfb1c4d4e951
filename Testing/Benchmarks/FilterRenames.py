"""What has another name than in an older build, as old name: new name. FilterCases.py runs builds with
the old and with the new names; CompareOutputs.py compares by the new ones."""
FILTERS = {'ShapeShapeDifference': 'ShapeMapDifference'}
PROPERTIES = {}
ARRAYS = {'ShapeDifference.': 'MapDifference.'}  # beginnings of names, field data too
