/**
 * @class   vtkShapeSymmetry
 * @brief   find the symmetries of a surface in any pose
 *
 * Input: an oriented 2-manifold of one component, open or closed. Blocks and distributed pieces are
 * joined first, and each process gets its own pieces back.
 *
 * Output 0: the surface with the point arrays
 * - `TargetPosition`, `TargetCell`, `TargetBarycentric`: the precise map of the chosen Element onto
 *   the surface itself.
 * - `Generator1`, `Generator2`, ...: the images of the points under each generator of the group.
 * - `Orbit`: the point of the fundamental domain that stands for the point's orbit.
 * - `Symmetrized`, if Array is chosen: its mean over the group.
 * The cell array `Copy` has the element that takes the fundamental domain, where it is 0, to the
 * part with the cell.
 *
 * Output 1: on one process, the curves that reflections keep, as lines with the cell array
 * `Element`.
 *
 * Output 2: on one process, a table with a row for each element of the group, the identity first.
 * Its columns are `Element`, `Order`, `Reversing` (1 if it reverses orientation), `Generator` (1 if
 * it is one) and `Distortion`. This is the mean change of distances along the surface, divided by
 * the root of the area.
 *
 * Output 3: on one process, a table with the composition: row i and column Element j have the
 * element that is i after j.
 *
 * Facts: Symmetry.Order (number of elements, 1 if there is no symmetry), .Generators, .Reversing
 * (number of elements) and .Distortion (the largest one). Symmetry.Bound is the largest distortion
 * of a symmetry. Symmetry.Rejected is the smallest distortion of a map that was tried and is no
 * symmetry, -1 if there was none.
 *
 * The mathematics: shape::FindSymmetries.
 */
#ifndef vtkShapeSymmetry_h
#define vtkShapeSymmetry_h

#include "vtkShapeAlgorithm.h"

#include "Correspondence/Symmetry.h" // for the options

class VTKSHAPEFILTERS_EXPORT vtkShapeSymmetry : public vtkShapeAlgorithm
{
public:
  static vtkShapeSymmetry* New();
  vtkTypeMacro(vtkShapeSymmetry, vtkShapeAlgorithm);

  ///@{
  /// The properties. Effects and ranges: vtkShapeSymmetry.xml. Defaults: shape::SymmetryOptions.
  vtkShapeOption(Tolerance, double);
  vtkShapeOption(MaximumOrder, int);
  vtkShapeOption(SearchPoints, int);
  vtkShapeOption(CoarsePoints, int);
  vtkShapeOptionAs(Element, Element, int);
  vtkSetStdStringFromCharMacro(Array);
  vtkGetCharFromStdStringMacro(Array);
  ///@}

protected:
  vtkShapeSymmetry();
  ~vtkShapeSymmetry() override = default;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapeSymmetry(const vtkShapeSymmetry&) = delete;
  void operator=(const vtkShapeSymmetry&) = delete;

  void WriteSurface(const shape::SymmetryResult& result, const shape::Surface& surface);
  void WriteGroup(const shape::SymmetryResult& result);

  int Element = 1; ///< the map that is output, at most the last element
  std::string Array = "None";
  shape::SymmetryOptions Options;
};

#endif
