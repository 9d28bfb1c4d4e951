/**
 * @class   vtkShapeDynaWriter
 * @brief   write a mesh as a keyword file of LS-DYNA
 *
 * The extension is .k. The file has parts for the regions, and sets of nodes and segments for the
 * patches.
 *
 * Sections of the file: shape::WriteDyna. Input, regions and patches: vtkShapeWriter.
 */
#ifndef vtkShapeDynaWriter_h
#define vtkShapeDynaWriter_h

#include "vtkShapeWriter.h"

class VTKSHAPEFILTERS_EXPORT vtkShapeDynaWriter : public vtkShapeWriter
{
public:
  static vtkShapeDynaWriter* New();
  vtkTypeMacro(vtkShapeDynaWriter, vtkShapeWriter);

protected:
  vtkShapeDynaWriter() = default;
  ~vtkShapeDynaWriter() override = default;
  void WriteText(
    std::ostream& file, const shape::MeshSets& sets, const shape::Progress& progress) override;

private:
  vtkShapeDynaWriter(const vtkShapeDynaWriter&) = delete;
  void operator=(const vtkShapeDynaWriter&) = delete;
};

#endif
