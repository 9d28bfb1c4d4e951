/**
 * @class   vtkShapeExample
 * @brief   make a shape to try the filters on
 *
 * Output: vtkPolyData, or vtkUnstructuredGrid for shapes of hexahedra. Generated shapes are files
 * beside the library, in share/ShapeMap/examples. Scanned and designed models are read from
 * ModelArchive, which belongs to Debian's package libcgal-demo, if it is installed. With a server,
 * the files of the server count.
 *
 * Field data: Example.Shape and Example.TryNext (words).
 */
#ifndef vtkShapeExample_h
#define vtkShapeExample_h

#include "vtkShapeSource.h"

#include "vtkNew.h" // for the names

class vtkStringArray;

class VTKSHAPEFILTERS_EXPORT vtkShapeExample : public vtkShapeSource
{
public:
  static vtkShapeExample* New();
  vtkTypeMacro(vtkShapeExample, vtkShapeSource);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The properties. Effects and ranges: vtkShapeExample.xml.
  vtkSetStdStringFromCharMacro(Shape);
  vtkGetCharFromStdStringMacro(Shape);
  ///@}

  ///@{
  /// The archive of models, a .tar.gz file. It is in another folder on other systems.
  vtkSetStdStringFromCharMacro(ModelArchive);
  vtkGetCharFromStdStringMacro(ModelArchive);
  ///@}

  /// Returns the names of the shapes that are available on this computer.
  vtkStringArray* GetShapes();
  /// Returns what to try with the chosen shape; empty if there is no such shape.
  const char* GetTryNext();

protected:
  vtkShapeExample();
  ~vtkShapeExample() override;
  std::string GetOutputType() override;
  void Make(vtkDataObject* output, const shape::Progress& progress) override;

private:
  vtkShapeExample(const vtkShapeExample&) = delete;
  void operator=(const vtkShapeExample&) = delete;

  std::string Shape = "Figure";
  std::string ModelArchive = "/usr/share/doc/libcgal-dev/data.tar.gz";
  vtkNew<vtkStringArray> Shapes;
};

#endif
