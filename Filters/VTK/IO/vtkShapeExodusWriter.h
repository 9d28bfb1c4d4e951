/**
 * @class   vtkShapeExodusWriter
 * @brief   write a mesh as an Exodus II file
 *
 * The extension is .exo. The file has element blocks for the regions, and side sets and node sets
 * for the patches.
 *
 * Parts of the file: shape::WriteExodus. Input, regions and patches: vtkShapeWriter.
 */
#ifndef vtkShapeExodusWriter_h
#define vtkShapeExodusWriter_h

#include "vtkShapeWriter.h"

class VTKSHAPEFILTERS_EXPORT vtkShapeExodusWriter : public vtkShapeWriter
{
public:
  static vtkShapeExodusWriter* New();
  vtkTypeMacro(vtkShapeExodusWriter, vtkShapeWriter);

protected:
  vtkShapeExodusWriter() = default;
  ~vtkShapeExodusWriter() override = default;
  void WriteText(
    std::ostream& file, const shape::MeshSets& sets, const shape::Progress& progress) override;

private:
  vtkShapeExodusWriter(const vtkShapeExodusWriter&) = delete;
  void operator=(const vtkShapeExodusWriter&) = delete;
};

#endif
