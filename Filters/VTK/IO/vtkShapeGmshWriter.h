/**
 * @class   vtkShapeGmshWriter
 * @brief   write a mesh in Gmsh's format
 *
 * The extension is .msh. The file has the points, the cells and, if the mesh has no surface
 * cells, the boundary faces. Regions and patches are physical groups with names.
 *
 * Sections of the file: shape::WriteGmsh. Input, regions and patches: vtkShapeWriter.
 */
#ifndef vtkShapeGmshWriter_h
#define vtkShapeGmshWriter_h

#include "vtkShapeWriter.h"

class VTKSHAPEFILTERS_EXPORT vtkShapeGmshWriter : public vtkShapeWriter
{
public:
  static vtkShapeGmshWriter* New();
  vtkTypeMacro(vtkShapeGmshWriter, vtkShapeWriter);

protected:
  vtkShapeGmshWriter() = default;
  ~vtkShapeGmshWriter() override = default;
  void WriteText(
    std::ostream& file, const shape::MeshSets& sets, const shape::Progress& progress) override;

private:
  vtkShapeGmshWriter(const vtkShapeGmshWriter&) = delete;
  void operator=(const vtkShapeGmshWriter&) = delete;
};

#endif
