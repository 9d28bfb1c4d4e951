/**
 * @class   vtkShapeLandmarksReader
 * @brief   read landmarks from files of other programs, or from a table
 *
 * Output: vtkPolyData with a vertex for each landmark. Arrays:
 * - point array `Name` (string): the name, or the number from 1.
 * - point array `Number` (int): the number from 1.
 * - point array `TargetPosition` (double, 3): the corresponding position, if the file has pairs.
 * - field data LandmarksReader.CoordinateSystem (string): LPS or RAS, if the file says so.
 *
 * The formats: shape::ReadLandmarks.
 */
#ifndef vtkShapeLandmarksReader_h
#define vtkShapeLandmarksReader_h

#include "vtkShapeAlgorithm.h" // for the macros
#include "vtkShapeReader.h"

#include "IO/LandmarksReader.h" // for the options

class VTKSHAPEFILTERS_EXPORT vtkShapeLandmarksReader : public vtkShapeReader
{
public:
  static vtkShapeLandmarksReader* New();
  vtkTypeMacro(vtkShapeLandmarksReader, vtkShapeReader);

  ///@{
  /// The properties. Effects and ranges: vtkShapeLandmarksReader.xml. Enumerations and defaults:
  /// shape::LandmarksReaderOptions.
  vtkShapeEnumOption(CoordinateSystem, shape::LandmarksReaderOptions::CoordinateSystemType,
    shape::LandmarksReaderOptions::CoordinateSystemType::AsInFile,
    shape::LandmarksReaderOptions::CoordinateSystemType::RAS);
  vtkShapeOption(Specimen, int);
  vtkShapeOption(TargetSpecimen, int);
  ///@}

protected:
  vtkShapeLandmarksReader() = default;
  ~vtkShapeLandmarksReader() override = default;
  std::string GetOutputType() override;
  void ReadContent(
    std::string content, vtkDataObject* output, const shape::Progress& progress) override;

private:
  vtkShapeLandmarksReader(const vtkShapeLandmarksReader&) = delete;
  void operator=(const vtkShapeLandmarksReader&) = delete;

  shape::LandmarksReaderOptions Options;
};

#endif
