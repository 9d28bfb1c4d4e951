#pragma once

#include "Correspondence/Correspondence.h"

#include "vtkSmartPointer.h"

#include <string>

class vtkIdTypeArray;
class vtkPolyData;
class vtkTable;

/// Conversion of results of Shape Correspondence to VTK data, with the arrays that
/// vtkShapeCorrespondence documents.
namespace vtkShapeCorrespondenceResult
{

vtkSmartPointer<vtkIdTypeArray> ToIds(const Eigen::VectorXi& values, const std::string& name);

/// Writes a row for each candidate map. ofA, ofB: their points, as numbered in the inputs.
void WriteCandidates(const shape::BlendedIntrinsicResult& blended, const Eigen::MatrixXi& ofA,
  const Eigen::MatrixXi& ofB, vtkTable* table);

/// Writes a polyline for each path of the base domain, and for each loop around a handle.
void WriteBase(const shape::CorrespondenceResult& result, const shape::Mesh& a,
  const shape::Mesh& b, vtkPolyData* output);

} // namespace vtkShapeCorrespondenceResult
