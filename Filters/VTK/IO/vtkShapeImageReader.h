/**
 * @class   vtkShapeImageReader
 * @brief   read a medical image with its directions
 *
 * Output: vtkImageData with the origin, the spacing and the directions of the file, in the axes of
 * DICOM. Point array `ImageScalars`, of the type and the number of components in the file.
 *
 * Only the header is read until data are requested. In parallel, each process keeps its extent.
 *
 * The formats: shape::ReadImageHeader.
 */
#ifndef vtkShapeImageReader_h
#define vtkShapeImageReader_h

#include "vtkShapeSource.h"

#include <string> // for the name

class VTKSHAPEFILTERS_EXPORT vtkShapeImageReader : public vtkShapeSource
{
public:
  static vtkShapeImageReader* New();
  vtkTypeMacro(vtkShapeImageReader, vtkShapeSource);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The properties. Effects and ranges: vtkShapeReader.xml.
  vtkSetStdStringFromCharMacro(FileName);
  vtkGetCharFromStdStringMacro(FileName);
  ///@}

protected:
  vtkShapeImageReader() = default;
  ~vtkShapeImageReader() override = default;
  std::string GetOutputType() override;
  void Announce(vtkInformation* output) override;
  void Make(vtkDataObject* output, const shape::Progress& progress) override;

private:
  vtkShapeImageReader(const vtkShapeImageReader&) = delete;
  void operator=(const vtkShapeImageReader&) = delete;

  std::string FileName;
};

#endif
