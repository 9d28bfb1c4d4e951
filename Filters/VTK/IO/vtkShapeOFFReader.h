/**
 * @class   vtkShapeOFFReader
 * @brief   read a surface in the Object File Format
 *
 * Output: vtkPolyData with double points. Faces become polygons; faces of two points become lines,
 * and faces of one point vertices. The arrays are there if the file has them:
 *
 * - point and cell array RGB or RGBA (unsigned char): colours, from 0 to 255.
 * - cell array ColorIndex (int): indices in a colour map, which the file does not have; -1 for
 * faces without an index.
 * - point normals Normals and texture coordinates TCoords (float).
 *
 * The format: shape::ReadOFF.
 */
#ifndef vtkShapeOFFReader_h
#define vtkShapeOFFReader_h

#include "vtkShapeReader.h"

class VTKSHAPEFILTERS_EXPORT vtkShapeOFFReader : public vtkShapeReader
{
public:
  static vtkShapeOFFReader* New();
  vtkTypeMacro(vtkShapeOFFReader, vtkShapeReader);

protected:
  vtkShapeOFFReader() = default;
  ~vtkShapeOFFReader() override = default;
  std::string GetOutputType() override;
  void ReadContent(
    std::string content, vtkDataObject* output, const shape::Progress& progress) override;

private:
  vtkShapeOFFReader(const vtkShapeOFFReader&) = delete;
  void operator=(const vtkShapeOFFReader&) = delete;
};

#endif
