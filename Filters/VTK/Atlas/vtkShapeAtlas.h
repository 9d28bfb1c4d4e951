/**
 * @class   vtkShapeAtlas
 * @brief   compute the mean shape of a population and its modes of variation
 *
 * Inputs
 * - Shapes: three or more surfaces as the blocks of composite data, for instance of Group Datasets
 *   or the Shapes of vtkShapeCollection. Each block of the top level is a shape; blocks inside it
 *   and pieces of several processes are joined. With Correspondence SamePoints, all shapes have the
 *   same points and triangles in the same order. With Maps, each shape has `TargetPosition` on the
 *   template.
 * - Template: optional. By default, it is the first shape or, with Maps, the shape that is mapped
 * to itself.
 * - Table: optional, a row for each shape. If a column of words has the names of all blocks, rows
 *   are found by name, and otherwise by order.
 *
 * Output 0: on one process, the template at the mean shape, with the point arrays
 * - `SourcePosition`: the position on the template.
 * - `Mode0`, `Mode1`, ...: the displacement for one standard deviation. The shape with the weights
 *   w is the position plus the sum of w_k Mode_k.
 * - `PositionDeviation`: the standard deviation of the position.
 * - For each quantity, a point array of real numbers with one component that all shapes have:
 *   `<Name>Mean`, `<Name>Deviation`, and `<Name>Mode0`, ..., its change with each mode.
 * - With Groups, `GroupDifference` (second mean minus first), `PValue` and `QValue`.
 * - With Regression, `Slope`, `SlopePValue` and `SlopeQValue`.
 *
 * Output 1: a table with a row for each shape: Shape, Name, and Score0, Score1, ..., the weights of
 * the modes. Then ProcrustesDistance (from the mean), Size, and Scale, the factor of the alignment.
 * Then ReconstructionError, MahalanobisDistance, OutlierDistance, OutlierRank, and the columns of
 * Table.
 *
 * Output 2: a table with a row for each number of modes: Modes, Variance (of the last one),
 * Explained, Generalisation and Specificity.
 *
 * Output 3: the shapes, aligned, with the points of the template, as the blocks of a multiblock
 * data set with the names of the shapes.
 *
 * Facts
 * - Atlas.Shapes, .NumberOfModes.
 * - .Template: number of the shape that is the template, -1 for the input.
 * - .Explained: share of the variance that the modes explain.
 * - .Outlier: number of the shape of rank 0.
 * - .LargestGap: with Maps, of a template point from a mapped shape, divided by the template's
 *   longest side.
 * - .TableRows: `by order`, or the name of the column with the names.
 * - .FirstGroup, .SecondGroup, .GroupPValue, .GroupRSquared, .GroupPermutations.
 * - .RegressionPValue, .RegressionRSquared, .RegressionMean (of the column),
 *   .RegressionPermutations.
 *
 * The mathematics: shape::BuildAtlas.
 */
#ifndef vtkShapeAtlas_h
#define vtkShapeAtlas_h

#include "vtkShapeAlgorithm.h"

#include "Atlas/Atlas.h" // for the options

class vtkTable;

class VTKSHAPEFILTERS_EXPORT vtkShapeAtlas : public vtkShapeAlgorithm
{
public:
  static vtkShapeAtlas* New();
  vtkTypeMacro(vtkShapeAtlas, vtkShapeAlgorithm);

  /// How the points of the shapes correspond to those of the template.
  enum class CorrespondenceType
  {
    SamePoints,
    Maps,
    Automatic ///< Maps if there are maps and a shape has other triangles than the template
  };

  ///@{
  /// The properties. Effects and ranges: vtkShapeAtlas.xml. Enumerations and defaults:
  /// shape::AtlasOptions.
  vtkShapeEnumOptionAs(Correspondence, Correspondence, CorrespondenceType,
    CorrespondenceType::SamePoints, CorrespondenceType::Automatic);
  vtkShapeOption(Scale, bool);
  vtkShapeOption(NumberOfModes, int);
  vtkShapeOption(SpecificitySamples, int);
  vtkSetStdStringFromCharMacro(Groups);
  vtkGetCharFromStdStringMacro(Groups);
  vtkSetStdStringFromCharMacro(Regression);
  vtkGetCharFromStdStringMacro(Regression);
  vtkShapeOption(RemoveRegression, bool);
  vtkShapeOption(Permutations, int);
  vtkShapeOption(Seed, int);
  ///@}

protected:
  vtkShapeAtlas();
  ~vtkShapeAtlas() override = default;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapeAtlas(const vtkShapeAtlas&) = delete;
  void operator=(const vtkShapeAtlas&) = delete;

  CorrespondenceType Correspondence = CorrespondenceType::Automatic;
  std::string Groups;
  std::string Regression;
  shape::AtlasOptions Options;
};

#endif
