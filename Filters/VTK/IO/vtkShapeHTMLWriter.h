/**
 * @class   vtkShapeHTMLWriter
 * @brief   write a mesh as a web page that turns, cuts and filters it
 *
 * The page is a single file and works without a network. Input: vtkPolyData or vtkUnstructuredGrid
 * of linear cells. Ghost cells are ignored. The page has the point and cell arrays of numbers with
 * up to three components, and the numbers and words of the field data. Values have single
 * precision.
 *
 * Format of the page: shape::WriteHTML.
 */
#ifndef vtkShapeHTMLWriter_h
#define vtkShapeHTMLWriter_h

#include "vtkShapeFileWriter.h"

class VTKSHAPEFILTERS_EXPORT vtkShapeHTMLWriter : public vtkShapeFileWriter
{
public:
  static vtkShapeHTMLWriter* New();
  vtkTypeMacro(vtkShapeHTMLWriter, vtkShapeFileWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The properties. Effects and ranges: vtkShapeHTMLWriter.xml.
  vtkSetStdStringFromCharMacro(Title);
  vtkGetCharFromStdStringMacro(Title);
  ///@}

protected:
  vtkShapeHTMLWriter() = default;
  ~vtkShapeHTMLWriter() override = default;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  Content ReadInput(const shape::Progress& progress) override;

private:
  vtkShapeHTMLWriter(const vtkShapeHTMLWriter&) = delete;
  void operator=(const vtkShapeHTMLWriter&) = delete;

  std::string Title;
};

#endif
