/**
 * @class   vtkShapeMeditReader
 * @brief   read a mesh in Medit's format
 *
 * Output: vtkUnstructuredGrid with double points. The point array and the cell array Reference
 * (int) have the references of the file. Gmsh and Mmg write the numbers of regions and patches
 * there.
 *
 * Sections that are read: shape::ReadMedit.
 */
#ifndef vtkShapeMeditReader_h
#define vtkShapeMeditReader_h

#include "vtkShapeReader.h"

class VTKSHAPEFILTERS_EXPORT vtkShapeMeditReader : public vtkShapeReader
{
public:
  static vtkShapeMeditReader* New();
  vtkTypeMacro(vtkShapeMeditReader, vtkShapeReader);

protected:
  vtkShapeMeditReader() = default;
  ~vtkShapeMeditReader() override = default;
  std::string GetOutputType() override;
  void ReadContent(
    std::string content, vtkDataObject* output, const shape::Progress& progress) override;

private:
  vtkShapeMeditReader(const vtkShapeMeditReader&) = delete;
  void operator=(const vtkShapeMeditReader&) = delete;
};

#endif
