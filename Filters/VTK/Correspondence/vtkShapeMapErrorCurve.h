/**
 * @class   vtkShapeMapErrorCurve
 * @brief   measure how far a map between surfaces is from the true one, as a cumulative curve
 *
 * Inputs
 * - Input: a surface with the map array (double, 3).
 * - Target: the surface onto which the map takes Input. If Target has the map array, too, that
 *   array is the map back to Input.
 * - Truth: any data set with points on Input. The map array of Truth gives the true images of these
 *   points on Target. The optional array SymmetryArray of Truth gives the mirror images of the true
 *   images under a symmetry of the shape. Errors are then measured from both, and the errors with
 *   the smaller mean are reported.
 * Blocks and distributed pieces of each input are joined first.
 *
 * Outputs, on one process
 * - Curve: a table with the columns
 *   `Error`: the exact geodesic distance on Target between the image of a point and its true image,
 *   divided by .Unit. The rows are in ascending order of this error;
 *   `Share`: the share of points with at most this error.
 * - Errors: Truth with the point array `Error`, -1 where the image is on another component than the
 *   true image.
 *
 * Facts, with the prefix MapErrorCurve
 * - .Mean, .Median, .Percentile95, .Maximum, .AreaUnderCurve (the mean share for errors up to
 *   LargestError).
 * - .Unit: the length by which errors were divided.
 * - .Mirrored: 1 if the reported errors are measured from the mirror images.
 * - .UnreachedPlaces: number of points whose image is on another component than the true image.
 *   These points have no row, but are counted in the total to which Share refers.
 * - .LargestGap: maximum distance of a point of Truth from Input, or of its true image from Target,
 *   in the units of the model.
 * - .Coverage: share of the area of Target that the image of Input covers, within a hundredth of
 *   the root of the area.
 * - .RoundTripMean, .RoundTripMaximum: only if Target has the map array. Distance of the points of
 *   Input from their original positions after the map to Target and back, divided by the root of
 *   the area.
 *
 * vtkShapeMapQuality measures the cells of a map, for example their conformal distortion.
 *
 * The mathematics: shape::ComputeMapErrorCurve, shape::ComputeRoundTripErrors,
 * shape::ComputeCoverage.
 */
#ifndef vtkShapeMapErrorCurve_h
#define vtkShapeMapErrorCurve_h

#include "vtkShapeAlgorithm.h"

#include "Correspondence/Evaluate/MapErrorCurve.h" // for the options

class VTKSHAPEFILTERS_EXPORT vtkShapeMapErrorCurve : public vtkShapeAlgorithm
{
public:
  static vtkShapeMapErrorCurve* New();
  vtkTypeMacro(vtkShapeMapErrorCurve, vtkShapeAlgorithm);

  ///@{
  /// The properties. Effects and ranges: vtkShapeMapErrorCurve.xml. Enumerations and defaults:
  /// shape::MapErrorCurveOptions.
  vtkSetStdStringFromCharMacro(MapArray);
  vtkGetCharFromStdStringMacro(MapArray);
  vtkSetStdStringFromCharMacro(SymmetryArray);
  vtkGetCharFromStdStringMacro(SymmetryArray);
  vtkShapeEnumOption(Normalisation, shape::MapErrorCurveOptions::NormalisationType,
    shape::MapErrorCurveOptions::NormalisationType::None,
    shape::MapErrorCurveOptions::NormalisationType::GeodesicDiameter);
  vtkShapeOption(LargestError, double);
  ///@}

protected:
  vtkShapeMapErrorCurve();
  ~vtkShapeMapErrorCurve() override = default;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapeMapErrorCurve(const vtkShapeMapErrorCurve&) = delete;
  void operator=(const vtkShapeMapErrorCurve&) = delete;

  std::string MapArray = "TargetPosition";
  std::string SymmetryArray = "SymmetricTargetPosition";
  shape::MapErrorCurveOptions Options;
};

#endif
