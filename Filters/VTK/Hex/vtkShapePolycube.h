/**
 * @class   vtkShapePolycube
 * @brief   map a closed surface onto a polycube
 *
 * A polycube is a solid whose faces are orthogonal to the axes. Here, its faces lie at integer
 * multiples of one length, so a grid with cells of this size divides it into hexahedra.
 *
 * Input: the closed surface that bounds one solid. Polygons are triangulated internally. Blocks and
 * distributed pieces are joined first, and each process gets its own pieces back.
 *
 * Outputs
 * - 0: the same surface with the point array `TargetPosition` (double, 3) and the cell array
 *   `Label` (int). Label is the direction of the face of the polycube to which a cell goes, 0 to 5
 *   = +x, -x, +y, -y, +z, -z.
 * - 1: the polycube: the same cells at their target positions, with `SourcePosition` and `Label`.
 *   No triangle is flipped, and each triangle lies in a plane orthogonal to the direction of its
 *   label. The polycube may overlap itself.
 *
 * Facts: Polycube.Charts and .Corners (numbers of charts and corners), and .EdgeLength
 * (the unit of length that was used). Polycube.Distortion is the mean elliptic energy of the map
 * inside the solid, 1 without distortion.
 *
 * If no polycube is found, the error names the charts that prevent it. TetGen is required, and
 * runs in its own process.
 *
 * The mathematics: shape::BuildPolycube.
 */
#ifndef vtkShapePolycube_h
#define vtkShapePolycube_h

#include "vtkShapeAlgorithm.h"

#include "Hex/Polycube/Polycube.h" // for the options

class VTKSHAPEFILTERS_EXPORT vtkShapePolycube : public vtkShapeAlgorithm
{
public:
  static vtkShapePolycube* New();
  vtkTypeMacro(vtkShapePolycube, vtkShapeAlgorithm);

  ///@{
  /// The properties. Effects and ranges: vtkShapePolycube.xml. Enumerations and defaults:
  /// shape::PolycubeOptions.
  vtkShapeOption(Compactness, double);
  vtkShapeOption(TargetEdgeLength, double);
  ///@}

protected:
  vtkShapePolycube();
  ~vtkShapePolycube() override = default;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapePolycube(const vtkShapePolycube&) = delete;
  void operator=(const vtkShapePolycube&) = delete;

  shape::PolycubeOptions Options;
};

#endif
