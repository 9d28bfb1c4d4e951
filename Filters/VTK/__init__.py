"""ShapeMap's filters as VTK classes: shapemap.vtkShapeParameterize() and so on."""
from .vtkShapeFilters import *
