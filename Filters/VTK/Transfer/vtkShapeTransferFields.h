/**
 * @class   vtkShapeTransferFields
 * @brief   transfer fields from one shape to another along a map between them
 *
 * Direction says which of the two shapes has the map array.
 * - Pull: Input, the receiver, has a map f into Source, the giver. A point x of the receiver gets
 *   the value of the giver at f(x). Maps are composed: if the giver has a map array t with the same
 *   name, the map array of the output is t(f(x)). If MapArray is TargetPosition and `TargetCell`
 *   and `TargetBarycentric` are present, the values are taken at the surface points that these
 *   arrays give. Closest positions could be on the other side of a thin part. If these arrays
 *   belong to another surface than Source, closest positions are used, and PrecisePoints is 0.
 * - Push: Source, the giver, has a map h into Input, the receiver. A point x of the receiver gets
 *   the value of the giver at the position z with h(z) = x. The map array of the output is the
 *   inverse map, which takes x to z. Where h folds the giver, several z are possible, and one of
 *   them is used.
 *
 * Inputs
 * - Input: any data set, which may be composite or distributed.
 * - Source: a solid or, if it has no solid cells, a surface. Source is gathered from all blocks and
 *   processes, with the arrays that all of them have.
 *
 * Output: the receiver with these additional point arrays:
 * - the point arrays of the giver. Floating-point values and colours are interpolated in the cell
 *   that contains the position. On a surface, this is the cell with the closest position, or
 *   `TargetCell`. Other values are copied from one point of this cell, the one with the largest
 *   interpolation weight, so that labels stay labels. Vectors keep their components. Normals and
 *   global ids of the giver are not transferred.
 * - the cell arrays of the giver, with the value of the same cell.
 * - `OutsideDomain` (int): 1 if the position is farther than Tolerance from all cells of the giver,
 *   otherwise 0. The values are then taken at the closest position.
 *
 * If SplitSeams is true, the giver is a surface whose texture coordinates have seams, and the
 * receiver is a surface, points of the receiver along the seams are copied. The copies follow the
 * other points. See shape::SplitAtSeams.
 *
 * Arrays of the receiver keep their names. Only the arrays that the new map array and
 * `OutsideDomain` replace get the prefix `Receiver`, and so do the `TargetCell` and
 * `TargetBarycentric` of a replaced map. An array of the giver with the same name as an array of
 * the receiver gets the prefix `Giver`.
 *
 * Facts count points over all processes, without ghosts. TransferFields.OutsidePoints: those with
 * OutsideDomain = 1. PrecisePoints: those whose values were taken in `TargetCell`. SeamPoints:
 * those that were copied.
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
  vtkSetMacro(SplitSeams, bool);
  vtkGetMacro(SplitSeams, bool);
  ///@}

protected:
  vtkShapeTransferFields();
  ~vtkShapeTransferFields() override = default;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapeTransferFields(const vtkShapeTransferFields&) = delete;
  void operator=(const vtkShapeTransferFields&) = delete;

  std::string MapArray = "TargetPosition";
  bool SplitSeams = true;
  shape::TransferFieldsOptions Options;
};

#endif
