#pragma once

#include <Eigen/Core>

#include <utility>
#include <vector>

class vtkRenderer;
class vtkSMSourceProxy;

/**
 * The output Handle of a filter, on the client: the handle where it is now, with its frames.
 *
 * The filter moves the handle; nothing is moved here.
 */
class pqShapeHandleCurves
{
public:
  /// Fetches an output of a filter that is up to date. Without data, there are no samples.
  void Fetch(vtkSMSourceProxy* filter, int port, double time);
  bool IsThere() const { return !this->Samples.empty(); }

  struct Sample
  {
    Eigen::Vector3d Position, Normal; ///< the normal is 0 if there is none
    Eigen::Vector3d Rest;             ///< the position before the handle moved
    Eigen::Vector3d Turn;             ///< rotation that the frames add, in degrees
    int Part;
  };
  const std::vector<Sample>& GetSamples() const { return this->Samples; }
  /// Pairs of samples.
  const std::vector<std::pair<int, int>>& GetSegments() const { return this->Segments; }

  /// A part of the handle. Centre is the point about which the filter rotates and scales it. Axes
  /// are the direction of a sample, the one at right angles, and the normal of the part.
  struct Part
  {
    Eigen::Vector3d Centre;
    Eigen::Matrix3d Axes;
    double Radius; ///< mean distance of the samples from the centre
  };
  const std::vector<Part>& GetParts() const { return this->Parts; }

  /// Returns the sample that was closest to a position at rest.
  int FindAtRest(const Eigen::Vector3d& position) const;
  /// Returns the sample closest to a pixel, at most `reach` pixels of a standard screen away, or
  /// -1. Of samples that are equally close, it is the one nearest to the viewer.
  int FindUnder(vtkRenderer* renderer, const Eigen::Vector2d& pixel, double reach) const;

private:
  Part MakePart(int number) const;

  std::vector<Sample> Samples;
  std::vector<std::pair<int, int>> Segments;
  std::vector<Part> Parts;
};
