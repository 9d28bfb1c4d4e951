/**
 * @class   vtkShapeWriter
 * @brief   base of the writers of meshes for solvers
 *
 * Input: vtkUnstructuredGrid of linear vertices, lines, triangles, quadrilaterals (or pixels),
 * tetrahedra, pyramids, wedges and hexahedra (or voxels), mixed. Other cells are errors. Ghost
 * cells are ignored. Each point is written, even if no cell uses it. The cell array FacePatch (int,
 * 6), which Shape Hex Remesh writes, has the patch of each face of a hexahedron in VTK's order.
 *
 * If the cells have the arrays MaterialId (int), MaterialModulus and MaterialDensity, which Shape
 * Image Values writes, formats that have materials get them.
 *
 * The sets in the files: shape::FindMeshSets. The materials: shape::FindMeshMaterials.
 */
#ifndef vtkShapeWriter_h
#define vtkShapeWriter_h

#include "vtkShapeFileWriter.h"

#include "Geometry/FeatureAngle.h" // for the default
#include "IO/MeshMaterials.h"      // for the options

#include <iosfwd> // for the file
#include <string> // for names

namespace shape
{
struct MeshSets;
}

class VTKSHAPEFILTERS_EXPORT vtkShapeWriter : public vtkShapeFileWriter
{
public:
  vtkTypeMacro(vtkShapeWriter, vtkShapeFileWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The properties. Effects and ranges: vtkShapeWriter.xml.
  vtkSetStdStringFromCharMacro(RegionArray);
  vtkGetCharFromStdStringMacro(RegionArray);
  vtkSetMacro(FeatureAngle, double);
  vtkGetMacro(FeatureAngle, double);
  vtkShapeOptionOf(MaterialOptions, PoissonRatio, double);
  vtkShapeOptionOf(MaterialOptions, DensityScale, double);
  ///@}

protected:
  vtkShapeWriter() = default;
  ~vtkShapeWriter() override = default;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  Content ReadInput(const shape::Progress& progress) final;

  /// Adds the files that belong to FileName (AddFile), if the format has several.
  virtual void AddFiles(const shape::MeshSets& sets, const shape::Progress& progress);

  /// Writes the content of FileName.
  virtual void WriteText(
    std::ostream& file, const shape::MeshSets& sets, const shape::Progress& progress) = 0;

private:
  vtkShapeWriter(const vtkShapeWriter&) = delete;
  void operator=(const vtkShapeWriter&) = delete;

  std::string RegionArray = "RegionId";
  double FeatureAngle = shape::DefaultFeatureAngle;
  shape::MeshMaterialsOptions MaterialOptions;
};

#endif
