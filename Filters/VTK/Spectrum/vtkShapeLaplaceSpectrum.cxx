#include "vtkShapeLaplaceSpectrum.h"

#include "vtkShapeComposite.h"
#include "vtkShapeConvert.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <vector>

vtkStandardNewMacro(vtkShapeLaplaceSpectrum);

vtkShapeLaplaceSpectrum::vtkShapeLaplaceSpectrum()
{
  this->DeclareInput("Input", PortData::WholePolygons, PortUse::Required, { "vtkPolyData" });
  this->DeclareOutputLikeInput();
  this->DeclareMemoryRemedy("lower Number Of Eigenpairs");
}

void vtkShapeLaplaceSpectrum::Execute(const shape::Progress& progress)
{
  // The embedding by MDS needs a manifold.
  this->RepairInput(
    0, 0, this->Options.Embedding != shape::LaplaceSpectrumOptions::EmbeddingType::Spectral);
  const GatheredInput& whole = this->GetGatheredInput(0);
  const shape::Surface mesh = vtkShapeConvert::ToMesh(whole.Data, "the surface");
  shape::LaplaceSpectrumResult analysis =
    shape::ComputeLaplaceSpectrum(mesh, this->Options, progress);

  std::vector<vtkShapeComposite::PointField> fields;
  const auto add = [&](const char* name, Eigen::MatrixXd& values)
  {
    fields.push_back({ name, vtkShapeConvert::Rows(values, whole.OwnPoints) });
    values.resize(0, 0);
  };
  add("Eigenfunctions", analysis.Spectrum.Eigenfunctions);
  add("HeatKernelSignature", analysis.HeatKernel);
  add("WaveKernelSignature", analysis.WaveKernel);
  add("Embedding", analysis.Embedding);
  vtkDataObject* output = this->GetOutputDataObject(0);
  vtkShapeComposite::AddPointFields(this->GetInputDataObject(0, 0), output, fields);
  output->GetFieldData()->AddArray(
    vtkShapeConvert::ToArray(analysis.Spectrum.Eigenvalues, "LaplaceSpectrum.Eigenvalues"));
}
