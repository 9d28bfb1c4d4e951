/**
 * @class   vtkShapeWriter
 * @brief   base of the writers of meshes for solvers
 *
 * Input: vtkUnstructuredGrid of linear vertices, lines, triangles, quadrilaterals (or pixels),
 * tetrahedra, pyramids, wedges and hexahedra (or voxels), mixed. Other cells are errors. Ghost
 * cells are ignored. Each point is written, even if no cell uses it.
 *
 * The writer writes only the data of this process. In ParaView, the pieces of all processes are
 * first gathered on one process, and coincident points of different pieces are merged.
 *
 * After an error or an abort, the incomplete file is removed.
 *
 * The sets in the files: shape::FindMeshSets.
 */
#ifndef vtkShapeWriter_h
#define vtkShapeWriter_h

#include "vtkShapeAlgorithm.h"     // for the macros
#include "vtkShapeFiltersModule.h" // for the export macro
#include "vtkWriter.h"

#include "Base/Progress.h"         // for shape::Progress
#include "Geometry/FeatureAngle.h" // for the default

#include <iosfwd> // for the file
#include <string> // for names

namespace shape
{
struct MeshSets;
}

class VTKSHAPEFILTERS_EXPORT vtkShapeWriter : public vtkWriter
{
public:
  vtkTypeMacro(vtkShapeWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Returns the name of the writer in messages: "Shape Abaqus Writer" for vtkShapeAbaqusWriter.
  std::string GetLabel();

  ///@{
  /// The properties. Effects and ranges: vtkShapeWriter.xml.
  vtkSetStdStringFromCharMacro(FileName);
  vtkGetCharFromStdStringMacro(FileName);
  vtkSetStdStringFromCharMacro(RegionArray);
  vtkGetCharFromStdStringMacro(RegionArray);
  vtkSetMacro(FeatureAngle, double);
  vtkGetMacro(FeatureAngle, double);
  ///@}

protected:
  vtkShapeWriter() = default;
  ~vtkShapeWriter() override = default;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() final;

  /// Writes the content of the file.
  virtual void WriteText(
    std::ostream& file, const shape::MeshSets& sets, const shape::Progress& progress) = 0;

private:
  vtkShapeWriter(const vtkShapeWriter&) = delete;
  void operator=(const vtkShapeWriter&) = delete;

  shape::MeshSets ReadInput(const shape::Progress& progress);
  void WriteWhole(const shape::MeshSets& sets, const shape::Progress& progress);

  std::string FileName;
  std::string RegionArray = "RegionId";
  double FeatureAngle = shape::DefaultFeatureAngle;
};

#endif
