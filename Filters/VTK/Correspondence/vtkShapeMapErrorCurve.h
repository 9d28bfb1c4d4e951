/**
 * @class   vtkShapeMapErrorCurve
 * @brief   measure how far a map between surfaces is from the true one, as a cumulative curve
 *
 * Inputs
 * - Input: a surface with the map array (double, 3).
 * - Target: the surface that the map leads to. It may have the map array of the map back to Input.
 * - Truth: any data set whose points are positions on Input and whose map array gives their true
 *   images on Target. An array with the name SymmetryArray gives the images under a symmetry of
 *   the shape. Errors are then measured to each of the two truths, and those with the smaller mean
 *   are reported.
 * Blocks and distributed pieces of each are joined first.
 *
 * Output: a table, on one process
 * - `Error`: ascending, the exact geodesic distance on the triangles of Target, divided by the
 *   Normalisation.
 * - `Share`: the share of points with at most this error.
 *
 * Field data, with the prefix MapErrorCurve
 * - .Mean, .Median, .Percentile95, .Maximum, .AreaUnderCurve (the mean share for errors up to
 *   LargestError).
 * - .Unit: the length by which errors were divided.
 * - .Mirrored: 1 if errors are measured to the symmetric truth.
 * - .UnreachedPlaces: points mapped to another component than their truth. They have no row, but
 *   are included in the total of Share.
 * - .LargestGap: maximum distance of a point of Truth from its surface, in their units.
 * - .Coverage: share of the area of Target that is nearer to the image than a hundredth of the
 *   root of the area.
 * - .RoundTripMean, .RoundTripMaximum: if Target has the map array. Distance of points of Input
 *   from themselves after the round trip, divided by the root of the area.
 *
 * Measures of the cells of a map, such as conformal distortion, are those of vtkShapeMapQuality.
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
