/**
 * @class   vtkShapeMeditWriter
 * @brief   write a mesh in Medit's format, for Gmsh or Mmg
 *
 * The extension is .mesh. The file has the points and the cells. The reference of a cell is its
 * region + 1. If the mesh has no surface cells, the boundary faces of the solid cells follow, with
 * their patch + 1 as reference, and then the faces between regions.
 *
 * Sections of the file: shape::WriteMedit. Input, regions and patches: vtkShapeWriter.
 */
#ifndef vtkShapeMeditWriter_h
#define vtkShapeMeditWriter_h

#include "vtkShapeWriter.h"

class VTKSHAPEFILTERS_EXPORT vtkShapeMeditWriter : public vtkShapeWriter
{
public:
  static vtkShapeMeditWriter* New();
  vtkTypeMacro(vtkShapeMeditWriter, vtkShapeWriter);

protected:
  vtkShapeMeditWriter() = default;
  ~vtkShapeMeditWriter() override = default;
  void WriteText(
    std::ostream& file, const shape::MeshSets& sets, const shape::Progress& progress) override;

private:
  vtkShapeMeditWriter(const vtkShapeMeditWriter&) = delete;
  void operator=(const vtkShapeMeditWriter&) = delete;
};

#endif
