/**
 * @class   vtkShapeFromOperators
 * @brief   recover a surface from its shape difference operators to another one
 *
 * Inputs
 * - Input: the oriented 2-manifold for which the operators were computed (SurfaceA of
 *   vtkShapeMapDifference). Blocks and distributed pieces are joined first, and each process gets
 *   its own pieces back.
 * - Operators: the second output of vtkShapeMapDifference, or another table with a row for each
 *   eigenfunction and the columns Area0, Area1, ..., Conformal0, ... It may also have OffsetArea0,
 *   ..., OffsetConformal0, ... and the field data MapDifference.OffsetDistance.
 *
 * Output 0: Input with its points moved, so that the edges have the recovered lengths, and with
 * `SourcePosition`. Without the operators of offset surfaces, the result is one of many: a surface
 * can bend and keep its lengths. The one near Input is found.
 *
 * Output 1: on one process, the triangles of Input at the recovered positions, with the cell arrays
 * - `Area`: the area that the area operator determines.
 * - `SideLengths` (3): recovered lengths of the edges opposite the corners of the triangle.
 * - `Angles` (3): the angles at its corners in degrees, from these lengths; 0 in a broken triangle.
 * - `NormalCurvatures` (3), with operators of offset surfaces: the second fundamental form, divided
 *   by the squared length, of these edges; positive where the surface is convex.
 *
 * Facts: FromOperators.BrokenTriangles, the number of triangles whose lengths break the triangle
 * inequality, and .LengthError, the root mean square of the relative differences between recovered
 * lengths and those of output 0.
 *
 * The mathematics: shape::RecoverFromOperators.
 */
#ifndef vtkShapeFromOperators_h
#define vtkShapeFromOperators_h

#include "vtkShapeAlgorithm.h"

#include "Correspondence/Evaluate/FromOperators.h" // for the options

class VTKSHAPEFILTERS_EXPORT vtkShapeFromOperators : public vtkShapeAlgorithm
{
public:
  static vtkShapeFromOperators* New();
  vtkTypeMacro(vtkShapeFromOperators, vtkShapeAlgorithm);

  ///@{
  /// The properties. Effects and ranges: vtkShapeFromOperators.xml. Defaults:
  /// shape::MetricRecoveryOptions, shape::MetricEmbeddingOptions.
  vtkShapeOptionOf(Options.Metric, Smoothness, double);
  vtkShapeOptionOf(Options.Embedding, Iterations, int);
  ///@}

protected:
  vtkShapeFromOperators();
  ~vtkShapeFromOperators() override = default;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapeFromOperators(const vtkShapeFromOperators&) = delete;
  void operator=(const vtkShapeFromOperators&) = delete;

  shape::FromOperatorsOptions Options;
};

#endif
