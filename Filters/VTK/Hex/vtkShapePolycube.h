/**
 * @class   vtkShapePolycube
 * @brief   maps a closed surface onto a polycube
 *
 * A polycube is a shape whose faces lie across the axes; here they are at whole multiples of
 * TargetEdgeLength, so that a grid of that size fills it with hexahedra.
 *
 * Input: the closed surface of one solid (polygons are triangulated inside). Blocks and distributed
 * pieces are joined first; each process gets its own back.
 *
 * Output 0: the same surface with the point array `TargetPosition` (double, 3), where each point
 * goes, and the cell array `Label` (int): the side of the polycube that a cell goes to, 0 to 5 =
 * +x, -x, +y, -y, +z, -z. Output 1: the polycube: the same cells at their target positions, with
 * `SourcePosition` and `Label`. No triangle is turned over, and each lies in a plane across its
 * axis. The polycube may overlap itself.
 *
 * Field data of both: Polycube.Charts, .Corners (of the polycube), .EdgeLength (that was used),
 * .Distortion (of the map of the solid inside, the mean of the elliptic energy: 1 is none).
 *
 * An error says which charts are at fault where no polycube is found. TetGen is needed; it works in
 * a process of its own. Single library calls take up to a second: an abort takes effect after them.
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
  /// What a border between charts costs against normals that are not along the axis: more makes
  /// fewer charts. Positive. Where it gives no polycube, others are tried, too. Default: 3.
  vtkShapeOption(Compactness, double);
  ///@}

  ///@{
  /// The unit of the polycube's whole coordinates, in the surface's units; smaller where charts
  /// need it. 0: what gives about 12,000 hexahedra. Default: 0.
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
