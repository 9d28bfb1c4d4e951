#include "vtkShapeDeformingAlgorithm.h"

vtkShapeDeformingAlgorithm::vtkShapeDeformingAlgorithm() = default;
