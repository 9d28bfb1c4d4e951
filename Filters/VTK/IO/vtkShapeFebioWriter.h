/**
 * @class   vtkShapeFebioWriter
 * @brief   write a mesh as the mesh section of a FEBio model
 *
 * The extension is .feb. The file has the mesh section of a model, with parts for the regions, and
 * surfaces and node sets for the patches.
 *
 * Sections of the file: shape::WriteFebio. Input, regions and patches: vtkShapeWriter.
 */
#ifndef vtkShapeFebioWriter_h
#define vtkShapeFebioWriter_h

#include "vtkShapeWriter.h"

class VTKSHAPEFILTERS_EXPORT vtkShapeFebioWriter : public vtkShapeWriter
{
public:
  static vtkShapeFebioWriter* New();
  vtkTypeMacro(vtkShapeFebioWriter, vtkShapeWriter);

protected:
  vtkShapeFebioWriter() = default;
  ~vtkShapeFebioWriter() override = default;
  void WriteText(
    std::ostream& file, const shape::MeshSets& sets, const shape::Progress& progress) override;

private:
  vtkShapeFebioWriter(const vtkShapeFebioWriter&) = delete;
  void operator=(const vtkShapeFebioWriter&) = delete;
};

#endif
