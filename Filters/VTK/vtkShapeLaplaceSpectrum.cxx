#include "vtkShapeLaplaceSpectrum.h"

#include "vtkShapeConvert.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkShapeLaplaceSpectrum);

vtkShapeLaplaceSpectrum::vtkShapeLaplaceSpectrum()
{
  this->DeclareInput("Input", PortData::WholeSurface, PortUse::Required, { "vtkPolyData" });
  this->DeclareOutputLikeInput();
}

void vtkShapeLaplaceSpectrum::Execute(const shape::Progress& progress)
{
  const WholeInput& whole = this->GetWhole(0);
  const shape::Mesh mesh = vtkShapeConvert::ToMesh(whole.Data, "the surface");
  shape::SpectralAnalysis analysis = shape::AnalyseSpectrum(mesh, this->Options, progress);

  // This process's points come block by block.
  std::vector<std::pair<std::string, Eigen::MatrixXd>> fields;
  const auto add = [&](const char* name, Eigen::MatrixXd& values)
  {
    fields.emplace_back(name, vtkShapeConvert::Rows(values, whole.OwnPoints));
    values.resize(0, 0);
  };
  add("Eigenfunctions", analysis.Spectrum.Eigenfunctions);
  add("HeatKernelSignature", analysis.HeatKernel);
  add("WaveKernelSignature", analysis.WaveKernel);
  add("Embedding", analysis.Embedding);
  vtkDataObject* output = this->GetOutputDataObject(0);
  vtkIdType first = 0;
  vtkShapeConvert::ForEachLeaf(this->GetInputDataObject(0, 0), output,
    vtkShapeConvert::Points::Kept,
    [&](vtkDataSet* from, vtkDataSet* to)
    {
      const vtkIdType count = from->GetNumberOfPoints();
      to->ShallowCopy(from);
      for (const auto& [name, values] : fields)
      {
        to->GetPointData()->AddArray(
          vtkShapeConvert::ToArray(values.middleRows(first, count), name));
      }
      first += count;
    });
  output->GetFieldData()->AddArray(
    vtkShapeConvert::ToArray(analysis.Spectrum.Eigenvalues, "LaplaceSpectrum.Eigenvalues"));
}
