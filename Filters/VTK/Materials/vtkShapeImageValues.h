/**
 * @class   vtkShapeImageValues
 * @brief   compute the means of an image within cells, and materials from them
 *
 * Inputs
 * - Input: a vtkUnstructuredGrid of linear tetrahedra, pyramids, wedges, hexahedra or voxels, which
 *   may be composite or distributed. Other cells are errors.
 * - Image: a vtkImageData with point arrays of any types, any spacing and any directions, also
 *   distributed. Each process holds the part around the Input.
 *
 * Output 0: the Input with these cell arrays (double, if not stated otherwise):
 * - the mean of each point array of the image, under its name. An array of the Input with the same
 *   name is replaced. The mean is over the part of the cell in the image, and 0 if there is none.
 * - `Coverage`: the share of the cell that lies in the image, from 0 to 1.
 * - `RegionId` (int): 0, if the Input does not have it.
 *
 * With an expression for Density also
 * - `Density` and `Modulus`: the means of both laws over the cell.
 * - `MaterialId` (int): the material, numbered from 0 by ascending modulus.
 * - `MaterialDensity`, `MaterialModulus`: the values of the material, which writers write.
 *
 * Output 1: a table of the materials: `Id` (int), `Modulus`, `Density`, `Volume`, `Cells` (the
 * number of cells). It has no rows without an expression for Density. In parallel, the first
 * process has the rows.
 *
 * The initial law of the modulus is that of Morgan, Bayraktar and Keaveny (2003) for the neck of
 * the femur.
 *
 * Facts, over all processes, without ghosts: ImageValues.Cells, .Volume, .CellsOutside and
 * .CellsPartlyOutside (of the image). With an expression for Density also .Mass and .Stiffness (the
 * integrals of density and modulus) and .Materials. Of the voxels at the boundary: .BoundaryVoxels,
 * .RaisedVoxels and .UnresolvedVoxels (without inner voxels nearby).
 *
 * The mathematics: shape::ComputeImageValues, shape::ExtrapolateToBoundary, shape::MaterialBins.
 */
#ifndef vtkShapeImageValues_h
#define vtkShapeImageValues_h

#include "vtkShapeAlgorithm.h"

#include "Materials/ImageValues.h" // for the options

class VTKSHAPEFILTERS_EXPORT vtkShapeImageValues : public vtkShapeAlgorithm
{
public:
  static vtkShapeImageValues* New();
  vtkTypeMacro(vtkShapeImageValues, vtkShapeAlgorithm);

  ///@{
  /// The properties. Effects and ranges: vtkShapeImageValues.xml. Defaults:
  /// shape::ImageValuesOptions.
  vtkSetStdStringFromCharMacro(ImageArray);
  vtkGetCharFromStdStringMacro(ImageArray);
  vtkSetStdStringFromCharMacro(Density);
  vtkGetCharFromStdStringMacro(Density);
  vtkSetStdStringFromCharMacro(ModulusLaw);
  vtkGetCharFromStdStringMacro(ModulusLaw);
  vtkShapeOption(Materials, int);
  vtkShapeOption(BoundaryLayers, int);
  vtkShapeOption(SamplingStep, double);
  ///@}

protected:
  vtkShapeImageValues();
  ~vtkShapeImageValues() override = default;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapeImageValues(const vtkShapeImageValues&) = delete;
  void operator=(const vtkShapeImageValues&) = delete;

  struct Run;
  void ReadInputs(Run& run);
  void MakeLaws(Run& run, const shape::Progress& progress);
  void MakeMaterials(Run& run);
  void WriteFacts(const Run& run);

  std::string ImageArray;
  std::string Density;
  std::string ModulusLaw = "6850 * Density^1.49";
  shape::ImageValuesOptions Options;
};

#endif
