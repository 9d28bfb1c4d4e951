/**
 * @class   vtkShapeMeditWriter
 * @brief   writes a mesh in Medit's format (.mesh), which Gmsh and Mmg read, too
 *
 * The file has the points, the cells with the region + 1 as reference, and the quadrilaterals and
 * triangles of the solid cells' boundary with the patch + 1 as reference, unless the mesh has
 * surface cells of its own.
 *
 * What is written in which section: shape::WriteMedit. Input, regions and patches: vtkShapeWriter.
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
