/**
 * @class   vtkShapeNetworkDescriptors
 * @brief   describe the points of a surface by a trained neural network
 *
 * Input: a surface, also composite or distributed. Polygons are triangulated internally.
 *
 * Output: the same surface with the point array ArrayName (double, one component for each column of
 * the network's output), which is 0 at points without a triangle.
 *
 * The mathematics: shape::ComputeNetworkDescriptors.
 */
#ifndef vtkShapeNetworkDescriptors_h
#define vtkShapeNetworkDescriptors_h

#include "vtkShapeAlgorithm.h"

#include "Network/NetworkDescriptors.h" // for the options

#include <string>
#include <vector>

class VTKSHAPEFILTERS_EXPORT vtkShapeNetworkDescriptors : public vtkShapeAlgorithm
{
public:
  static vtkShapeNetworkDescriptors* New();
  vtkTypeMacro(vtkShapeNetworkDescriptors, vtkShapeAlgorithm);

  ///@{
  /// The properties. Effects and ranges: vtkShapeNetworkDescriptors.xml. Enumerations and defaults:
  /// shape::NetworkDescriptorOptions.
  vtkSetStdStringFromCharMacro(FileName);
  vtkGetCharFromStdStringMacro(FileName);
  void SetNumberOfInputArrays(int count);
  void SetInputArrays(int index, const std::string& name);
  std::vector<std::string> GetInputArrays() { return this->InputArrays; }
  vtkShapeEnumOption(Scale, shape::NetworkDescriptorOptions::ScaleType,
    shape::NetworkDescriptorOptions::ScaleType::UnitArea,
    shape::NetworkDescriptorOptions::ScaleType::Given);
  vtkShapeOption(NumberOfEigenpairs, int);
  vtkSetMacro(ArrayName, std::string);
  vtkGetMacro(ArrayName, std::string);
  ///@}

protected:
  vtkShapeNetworkDescriptors();
  ~vtkShapeNetworkDescriptors() override = default;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapeNetworkDescriptors(const vtkShapeNetworkDescriptors&) = delete;
  void operator=(const vtkShapeNetworkDescriptors&) = delete;

  Eigen::MatrixXd ReadArrays(vtkPolyData* surface) const;

  std::string FileName, ArrayName = "NetworkDescriptors";
  std::vector<std::string> InputArrays;
  shape::NetworkDescriptorOptions Options;
};

#endif
