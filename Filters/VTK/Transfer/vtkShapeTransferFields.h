/**
 * @class   vtkShapeTransferFields
 * @brief   carries fields from one shape to another along a map between them
 *
 * Direction says which of the two shapes has the map array.
 * - Pull: the Input (the receiver) has it, and it leads into the Source (the giver): the point x
 *   takes the giver's value at its target f(x). Maps compose: where the giver has a map array t of
 *   the same name, the receiver's becomes t(f(x)). Where the Input has the precise map of Shape
 *   Correspondence, TargetCell and TargetBarycentric, and MapArray is TargetPosition, values are
 *   taken there: on thin parts the place closest to TargetPosition may lie on the other side. Where
 *   it was made for another surface than the Source, the closest places are taken, and
 *   PrecisePoints says so.
 * - Push: the Source has it, and it leads into the Input: the giver's value at z is handed to the
 *   place h(z). The receiver gets the inverse as its map array: at x the z with h(z) = x. Where h
 *   folds the giver, one of the places z is taken.
 *
 * Inputs
 * - Input: points or cells of any dataset, also composite or distributed.
 * - Source: a solid, or a surface where no cell is solid; gathered from all its blocks and
 *   processes, with the arrays that all of them have.
 *
 * Output: the receiver with, at its points,
 * - the giver's point arrays: numbers of floating point interpolated in the cell that contains the
 *   place (on a surface at the closest place, or in TargetCell); integers and words of the point of
 *   that cell that weighs most, so that labels stay labels. Vectors keep their components; the
 *   giver's normals, which belong to its shape, stay behind.
 * - the giver's cell arrays: the value of that cell.
 * - `OutsideDomain` (int): 1 where the place is farther than Tolerance from every cell of the
 *   giver; the values are then those of the closest place in one.
 *
 * Nothing is lost where names meet. The receiver's arrays keep theirs; one of the giver whose name
 * is taken gets `Giver` in front. The map array that is made here, and OutsideDomain, take their
 * names: what the receiver had there is kept with `Receiver` in front. So are TargetCell and
 * TargetBarycentric, which belong to the map that was replaced.
 *
 * Field data, over all processes without ghosts: TransferFields.OutsidePoints, and .PrecisePoints:
 * how many took their values in TargetCell.
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
  /// 0 = Pull: the Input has the map array, which leads into the Source. 1 = Push: the Source has
  /// it, which leads into the Input. Default: Pull.
  vtkShapeEnumOption(Direction, shape::TransferFieldsOptions::DirectionType,
    shape::TransferFieldsOptions::DirectionType::Pull,
    shape::TransferFieldsOptions::DirectionType::Push);
  ///@}

  ///@{
  /// The point array (3 components) of the Input (Pull) or the Source (Push) that says where each
  /// point goes. Default: TargetPosition.
  vtkSetStdStringFromCharMacro(MapArray);
  vtkGetCharFromStdStringMacro(MapArray);
  ///@}

  ///@{
  /// How far beyond the giver's cells a place may lie before it counts as outside, as a share of
  /// the longest side of the giver's box; and how far TargetPosition may be from the place in
  /// TargetCell before that counts as made for another surface. Default: 0.01.
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
