/**
 * @class   vtkShapeFoamWriter
 * @brief   write a mesh as the polyMesh of an OpenFOAM case
 *
 * FileName, with the extension .foam, is an empty file that ParaView's reader opens. The mesh is in
 * the folder constant/polyMesh beside it, which is made if necessary. The Input has solid cells
 * only. Points that no cell uses are left out.
 *
 * A mesh in the folder is replaced only if the .foam file exists, too: Save Data has asked then.
 * If the folder has a file that this writer does not write, the file belongs to another mesh, and
 * it is an error.
 *
 * Files of the folder: shape::GetFoamFiles. Order of the faces: shape::PolyMesh. Input, regions and
 * patches: vtkShapeWriter.
 */
#ifndef vtkShapeFoamWriter_h
#define vtkShapeFoamWriter_h

#include "vtkShapeWriter.h"

class VTKSHAPEFILTERS_EXPORT vtkShapeFoamWriter : public vtkShapeWriter
{
public:
  static vtkShapeFoamWriter* New();
  vtkTypeMacro(vtkShapeFoamWriter, vtkShapeWriter);

protected:
  vtkShapeFoamWriter() = default;
  ~vtkShapeFoamWriter() override = default;
  void AddFiles(const shape::MeshSets& sets, const shape::Progress& progress) override;
  void WriteText(
    std::ostream& file, const shape::MeshSets& sets, const shape::Progress& progress) override;

private:
  vtkShapeFoamWriter(const vtkShapeFoamWriter&) = delete;
  void operator=(const vtkShapeFoamWriter&) = delete;
};

#endif
