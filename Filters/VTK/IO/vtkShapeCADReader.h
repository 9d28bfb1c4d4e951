/**
 * @class   vtkShapeCADReader
 * @brief   read a CAD file as triangles
 *
 * Outputs:
 * - Surface: vtkPolyData of triangles. Cell arrays: `Patch` (int), the CAD face from 1, and
 *   `RegionId` (int), the solid from 0. Solids have no common points.
 * - Edges: vtkPolyData of polylines, the edges between CAD faces at the surface's points. Cell
 *   array `Edge` (int), from 1. The points have no arrays.
 *
 * Field data of Surface:
 * - CADReader.Unit (string): the unit of the coordinates, such as mm or in, if the file says so.
 * - CADReader.Deflection: the one that was used. CADReader.Distance: the largest distance of the
 *   triangles from the exact surface that was found.
 * - CADReader.OpenEdges: number of edges with only one triangle; 0 if all is closed.
 * - CADReader.PatchNames, CADReader.RegionNames (string): names in the file, by number, or empty.
 *
 * The mathematics: shape::ReadCAD.
 */
#ifndef vtkShapeCADReader_h
#define vtkShapeCADReader_h

#include "vtkShapeAlgorithm.h" // for the macros
#include "vtkShapeReader.h"

#include "IO/CADReader.h" // for the options

class VTKSHAPEFILTERS_EXPORT vtkShapeCADReader : public vtkShapeReader
{
public:
  static vtkShapeCADReader* New();
  vtkTypeMacro(vtkShapeCADReader, vtkShapeReader);

  ///@{
  /// The properties. Effects and ranges: vtkShapeCADReader.xml. Defaults: shape::CADReaderOptions.
  vtkShapeOption(Deflection, double);
  vtkShapeOption(Angle, double);
  vtkShapeOption(SewingTolerance, double);
  ///@}

protected:
  vtkShapeCADReader();
  ~vtkShapeCADReader() override = default;
  std::string GetOutputType() override;
  void ReadContent(
    std::string content, vtkDataObject* output, const shape::Progress& progress) override;

private:
  vtkShapeCADReader(const vtkShapeCADReader&) = delete;
  void operator=(const vtkShapeCADReader&) = delete;

  shape::CADReaderOptions Options;
};

#endif
