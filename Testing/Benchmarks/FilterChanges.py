"""What CompareOutputs.py and FilterCases.py know of the change between two builds."""

# Other names, as old: new. Builds with the old and with the new names run; the new ones are compared.
FILTER_NAMES = {'ShapeShapeDifference': 'ShapeMapDifference'}
PROPERTY_NAMES = {}
ARRAY_NAMES = {'ShapeDifference.': 'MapDifference.'}  # beginnings of names, field data too

# Angles in degrees that a filter makes as small as it can: rounding shows in them.
DEGREES = tuple('0: field PasteFeature.Deviation%s' % which
                for which in ('Before', 'After', '95Before', '95After'))

# Arrays that are meant to be gone or to differ: regular expressions of "FILTER: CASE" and of the array
# (as "0: cell ScaledJacobian", 0 being the output), and why. They are reported and fail nothing.
_FACTS = ('facts describe the mesh on which they were computed, and are removed from outputs with points '
          'of their own')
_MEASURES = ('measures of the old geometry are removed from outputs with points of their own; those of '
             'hexahedra are computed again')
_NAMES = ('ScaledJacobian|Jacobian|Volume|Shape|Skew|Taper|EdgeRatio|EquiangleSkew|MaxAspectFrobenius|'
          'Distance|BoundaryDistance|GeodesicDistance')
EXPECTED = tuple(
    # Facts of every filter but the one that the case runs.
    (r'^(?!Shape%s: )' % name, r'^\d+: field %s\.' % name, _FACTS)
    for name in ('CutFeature', 'HarmonicVolumeMap', 'HexRemesh', 'LaplaceSpectrum', 'Parameterize',
                 'PasteFeature', 'Polycube', 'Tetrahedralize', 'FillHoles')
) + (
    # Shape Hex Remesh's and Shape Boundary Distance's own measures stay under test.
    (r'^(?!ShapeHexRemesh: |ShapeBoundaryDistance: |ShapeGeodesicDistance: )',
     r'^\d+: (cell|point) (active )?(%s)$' % _NAMES, _MEASURES),
    (r'^Shape(Tetrahedralize|Untangle|Deform|Morph|PasteFeature|FillHoles|CutFeature|ApplyVolumeMap|'
     r'HarmonicVolumeMap): ', r'^\d+: (cell|point) (Outwards|Normals|active Normals)$',
     'normals of the surface are not those of an output with points of its own'),
    # Data are carried onto derived meshes by one rule (vtkShapeCarry).
    (r'^Shape(Tetrahedralize|Untangle|HarmonicVolumeMap): ',
     r'^\d+: (point|cell) (active )?(Region|Label|Number|Integers?|Words?|\w*Ids?)$',
     'integers, ids and words come from the source with the largest weight and are not averaged; global '
     'ids are left out'),
    (r'^Shape(CutFeature|PasteFeature): ', r'^\d+: point (active )?(Region|Label|Number|Integers?|Words?)$',
     'of several sources with the same weight, the one with the lowest number counts'),
    (r'^ShapeTransferFields: ', r'^\d+: point (Giver)?(Colou?rs?|RGB)$', 'colours are interpolated'),
    (r'^Shape(PasteFeature|ExponentialMap): ', r'^\d+: (point|cell) active ',
     'the roles of arrays are kept'),
    (r'^ShapeParameterize: cap', r'^\d+: point Outwards$',
     'the cap is cut from a surface, and normals at the new points of the cut have unit length again'),
    (r'', r'^\d+: field (HexRemesh|FillHoles)\.Reason$', 'reasons are in plainer words'),
)
