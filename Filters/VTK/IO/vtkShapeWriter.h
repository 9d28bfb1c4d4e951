/**
 * @class   vtkShapeWriter
 * @brief   base of the writers of meshes for solvers
 *
 * Input: vtkUnstructuredGrid of vertices, lines, triangles, quadrilaterals (or pixels), tetrahedra,
 * pyramids, wedges and hexahedra (or voxels), linear ones, mixed. Another cell is an error. Ghost
 * cells are left out. Every point is written, also one that no cell uses.
 *
 * Written is what this process has. In ParaView the pieces of all processes are gathered on the
 * first one before, and points of several pieces at the same place become one there.
 *
 * A file that could not be written whole, because the disk is full or the user stopped, is removed.
 *
 * The sets that the files name: shape::FindMeshSets.
 */
#ifndef vtkShapeWriter_h
#define vtkShapeWriter_h

#include "vtkShapeAlgorithm.h"     // for the macros
#include "vtkShapeFiltersModule.h" // for the export macro
#include "vtkWriter.h"

#include "Base/Progress.h" // for shape::Progress

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

  /// The name that ParaView's messages show: "Shape Abaqus Writer" for vtkShapeAbaqusWriter.
  std::string GetLabel();

  ///@{
  /// The file to write, or to write anew.
  vtkSetStdStringFromCharMacro(FileName);
  vtkGetCharFromStdStringMacro(FileName);
  ///@}

  ///@{
  /// The cell array of whole numbers, 0 or greater, that says which region a cell is of. Without an
  /// array of the default's name, or with an empty name, every cell is of region 0. Default:
  /// RegionId.
  vtkSetStdStringFromCharMacro(RegionArray);
  vtkGetCharFromStdStringMacro(RegionArray);
  ///@}

  ///@{
  /// The boundary is split into patches where its normal turns by more, in degrees, from 0 to 180.
  /// Default: 40.
  vtkSetMacro(FeatureAngle, double);
  vtkGetMacro(FeatureAngle, double);
  ///@}

protected:
  vtkShapeWriter() = default;
  ~vtkShapeWriter() override = default;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() final;

  /// Writes the text.
  virtual void WriteText(
    std::ostream& file, const shape::MeshSets& sets, const shape::Progress& progress) = 0;

private:
  vtkShapeWriter(const vtkShapeWriter&) = delete;
  void operator=(const vtkShapeWriter&) = delete;

  shape::MeshSets ReadInput(const shape::Progress& progress);
  void WriteWhole(const shape::MeshSets& sets, const shape::Progress& progress);

  std::string FileName;
  std::string RegionArray = "RegionId";
  double FeatureAngle = 40.0;
};

#endif
