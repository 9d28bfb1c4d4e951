#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

namespace shape
{

/// Collects landmarks.
struct LandmarkRows
{
  std::vector<Eigen::RowVector3d> Points, Targets;
  std::vector<std::string> Names;
  std::string CoordinateSystem;

  void Add(const Eigen::RowVector3d& point, const std::string& name)
  {
    this->Points.push_back(point);
    this->Names.push_back(name.empty() ? std::to_string(this->Points.size()) : name);
  }
};

/// Returns a word without the blanks around it.
std::string Trim(std::string word);

/// Converts a word to a finite number. Throws InvalidInput that begins with `where`.
double ToCoordinate(const std::string& word, const std::string& where);

} // namespace shape
