/**
 * @class   vtkShapeReader
 * @brief   base of the readers of files
 *
 * An error names the file, and the line if it is known.
 */
#ifndef vtkShapeReader_h
#define vtkShapeReader_h

#include "vtkShapeSource.h"

#include <string> // for the content

class VTKSHAPEFILTERS_EXPORT vtkShapeReader : public vtkShapeSource
{
public:
  vtkTypeMacro(vtkShapeReader, vtkShapeSource);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The properties. Effects and ranges: vtkShapeReader.xml.
  vtkSetStdStringFromCharMacro(FileName);
  vtkGetCharFromStdStringMacro(FileName);
  ///@}

protected:
  vtkShapeReader() = default;
  ~vtkShapeReader() override = default;
  void Make(vtkDataObject* output, const shape::Progress& progress) final;

  /// Fills the output from the content of the file.
  virtual void ReadContent(
    std::string content, vtkDataObject* output, const shape::Progress& progress) = 0;

private:
  vtkShapeReader(const vtkShapeReader&) = delete;
  void operator=(const vtkShapeReader&) = delete;

  std::string FileName;
};

#endif
