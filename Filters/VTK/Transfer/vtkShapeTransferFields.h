/**
 * @class   vtkShapeTransferFields
 * @brief   transfer fields from one shape to another along a map between them
 *
 * Direction states which of the two shapes has the map array.
 * - Pull: the Input (the receiver) has it, and it leads into the Source (the giver). The point x
 *   takes the value of the giver at f(x). Maps compose: if the giver has a map array t of the same
 *   name, that of the receiver becomes t(f(x)). If MapArray is TargetPosition, the values are
 *   taken at `TargetCell` and `TargetBarycentric`, if present, because the closest position may be
 *   on the other side of a thin part. If these were made for another surface than the Source,
 *   closest positions are used, and PrecisePoints is 0.
 * - Push: the Source has it, and it leads into the Input. The value of the giver at z goes to
 *   h(z). The receiver gets the inverse as its map array: at x the z with h(z) = x. Where h folds
 *   the giver, one of several z is used.
 *
 * Inputs
 * - Input: points or cells of any data set, also composite or distributed.
 * - Source: a solid, or a surface if no cell is solid. It is gathered from all its blocks and
 *   processes, with the arrays that all of them have.
 *
 * Output: the receiver with, at its points,
 * - the point arrays of the giver. Floating-point values and colours are interpolated in the cell
 *   that contains the position (on a surface at the closest position, or in `TargetCell`). Other
 *   arrays have the value at the point of that cell with the largest weight, so that labels stay
 *   labels. Vectors keep their components. Normals and global ids of the giver are not
 *   transferred.
 * - the cell arrays of the giver: the value of that cell.
 * - `OutsideDomain` (int): 1 if the position is farther than Tolerance from each cell of the
 *   giver. The values are then those of the closest position.
 *
 * Arrays of the receiver keep their names. An array of the giver whose name is taken gets the
 * prefix `Giver`. The new map array and `OutsideDomain` take their names, and arrays that they
 * replace are kept with the prefix `Receiver`. So are `TargetCell` and `TargetBarycentric`, which
 * belong to the replaced map.
 *
 * Field data, over all processes without ghosts: TransferFields.OutsidePoints, and .PrecisePoints,
 * the number of points whose values were taken in `TargetCell`.
 *
 * The mathematics: shape::TransferFields.
 */
#ifndef vtkShapeTransferFields_h
#define vtkShapeTransferFields_h

#include "vtkShapeAlgorithm.h"

#include "Transfer/TransferFields.h" // for the options

class VTKSHAPEFILTERS_EXPORT vtkShapeTransferFields : public vtkShapeAlgorithm
{
public:
  static vtkShapeTransferFields* New();
  vtkTypeMacro(vtkShapeTransferFields, vtkShapeAlgorithm);

  ///@{
  /// The properties. Effects and ranges: vtkShapeTransferFields.xml. Enumerations and defaults:
  /// shape::TransferFieldsOptions.
  vtkShapeEnumOption(Direction, shape::TransferFieldsOptions::DirectionType,
    shape::TransferFieldsOptions::DirectionType::Pull,
    shape::TransferFieldsOptions::DirectionType::Push);
  vtkSetStdStringFromCharMacro(MapArray);
  vtkGetCharFromStdStringMacro(MapArray);
  vtkShapeOption(Tolerance, double);
  ///@}

protected:
  vtkShapeTransferFields();
  ~vtkShapeTransferFields() override = default;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapeTransferFields(const vtkShapeTransferFields&) = delete;
  void operator=(const vtkShapeTransferFields&) = delete;

  std::string MapArray = "TargetPosition";
  shape::TransferFieldsOptions Options;
};

#endif
