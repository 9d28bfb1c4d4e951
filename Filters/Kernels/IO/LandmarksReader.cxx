#include "IO/LandmarksReader.h"

#include "Base/Errors.h"
#include "IO/Private/LandmarkRows.h"
#include "IO/Private/Morphometrics.h"

#define BOOST_BIND_GLOBAL_PLACEHOLDERS // without it, the header prints a message
#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <sstream>

namespace shape
{
namespace
{

using Tree = boost::property_tree::ptree;
using Row = std::vector<std::string>;

/// Splits a line of comma-separated values. A value in quotes may have commas, and a doubled quote
/// stands for one.
Row SplitValues(const std::string& line)
{
  Row values(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i)
  {
    if (line[i] == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"')
    {
      values.back() += line[++i];
    }
    else if (line[i] == '"')
    {
      quoted = !quoted;
    }
    else if (line[i] == ',' && !quoted)
    {
      values.emplace_back();
    }
    else
    {
      values.back() += line[i];
    }
  }
  std::transform(values.begin(), values.end(), values.begin(), Trim);
  return values;
}

/// The index of each named column.
class NamedColumns
{
public:
  NamedColumns(const Row& names, long line)
  {
    for (std::size_t i = 0; i < names.size(); ++i)
    {
      this->Indices.insert({ names[i], i });
    }
    const bool hasTarget = this->Has("tx") || this->Has("ty") || this->Has("tz");
    for (const char* name : { "x", "y", "z", "tx", "ty", "tz" })
    {
      if (!this->Has(name) && (hasTarget || name[0] != 't'))
      {
        throw InvalidInput("line " + std::to_string(line) + ": there is no column " + name +
          "; name the columns x,y,z,name or x,y,z,tx,ty,tz,name");
      }
    }
  }

  bool Has(const std::string& name) const { return this->Indices.count(name) > 0; }

  std::string Find(const Row& row, const std::string& name) const
  {
    const auto found = this->Indices.find(name);
    return found == this->Indices.end() || found->second >= row.size() ? std::string()
                                                                       : row[found->second];
  }

  /// names: of three columns.
  Eigen::RowVector3d ReadPosition(
    const Row& row, const std::array<const char*, 3>& names, long line) const
  {
    Eigen::RowVector3d position;
    for (std::size_t k = 0; k < 3; ++k)
    {
      position(static_cast<Eigen::Index>(k)) = ToCoordinate(
        this->Find(row, names[k]), "line " + std::to_string(line) + ", column " + names[k]);
    }
    return position;
  }

private:
  std::map<std::string, std::size_t> Indices;
};

/// Returns "LPS" or "RAS". Files of Slicer before version 4.11 have numbers.
std::string ToCoordinateSystem(const std::string& word, const std::string& where)
{
  if (word == "LPS" || word == "1")
  {
    return "LPS";
  }
  if (word == "RAS" || word == "0")
  {
    return "RAS";
  }
  throw InvalidInput(where + ": the coordinate system is `" + word + "`; save as LPS or RAS");
}

/// Reads a comment of an .fcsv file: "# name = value".
void ReadComment(const std::string& line, long number, LandmarkRows& rows, Row& names)
{
  const std::size_t equals = line.find('=');
  const std::string name = Trim(line.substr(1, equals == std::string::npos ? equals : equals - 1));
  const std::string value =
    equals == std::string::npos ? std::string() : Trim(line.substr(equals + 1));
  if (name == "CoordinateSystem")
  {
    rows.CoordinateSystem = ToCoordinateSystem(value, "line " + std::to_string(number));
  }
  else if (name == "columns")
  {
    names = SplitValues(value);
  }
}

LandmarkRows ReadTable(std::string_view content)
{
  std::istringstream stream{ std::string(content) };
  LandmarkRows rows;
  Row names;
  const bool isSlicers = !content.empty() && content.front() == '#';
  rows.CoordinateSystem = isSlicers ? "RAS" : "";
  std::string line;
  for (long number = 1; std::getline(stream, line); ++number)
  {
    if (Trim(line).empty())
    {
      continue;
    }
    if (line.front() == '#')
    {
      ReadComment(line, number, rows, names);
      continue;
    }
    const Row row = SplitValues(line);
    if (names.empty())
    {
      names = row;
      NamedColumns(names, number); // refuses at this line
      continue;
    }
    const NamedColumns columns(names, number);
    const Eigen::RowVector3d point = columns.ReadPosition(row, { "x", "y", "z" }, number);
    const std::string name = columns.Find(row, columns.Has("name") ? "name" : "label");
    if (columns.Has("tx"))
    {
      rows.Targets.push_back(columns.ReadPosition(row, { "tx", "ty", "tz" }, number));
    }
    rows.Add(point, name);
  }
  return rows;
}

/// Returns a child, or an empty tree.
Tree GetChild(const Tree& tree, const char* name)
{
  const auto child = tree.get_child_optional(name);
  return child ? *child : Tree();
}

LandmarkRows ReadMarkups(const Tree& tree)
{
  LandmarkRows rows;
  for (const auto& [key, list] : GetChild(tree, "markups"))
  {
    const std::string system =
      ToCoordinateSystem(list.get("coordinateSystem", "LPS"), "`coordinateSystem`");
    if (!rows.CoordinateSystem.empty() && rows.CoordinateSystem != system)
    {
      throw InvalidInput("the lists have different coordinate systems; save them as LPS");
    }
    rows.CoordinateSystem = system;
    for (const auto& [number, point] : GetChild(list, "controlPoints"))
    {
      const std::string status = point.get("positionStatus", "defined");
      if (status != "defined")
      {
        continue;
      }
      const std::string where = "control point " + std::to_string(rows.Points.size() + 1);
      const Tree coordinates = GetChild(point, "position");
      if (coordinates.size() != 3)
      {
        throw InvalidInput(where + ": `position` has " + std::to_string(coordinates.size()) +
          " numbers instead of 3");
      }
      Eigen::RowVector3d position;
      Eigen::Index k = 0;
      for (const auto& [unused, coordinate] : coordinates)
      {
        position(k++) = ToCoordinate(coordinate.data(), where);
      }
      rows.Add(position, point.get("label", ""));
    }
  }
  return rows;
}

LandmarkRows ReadPickedPoints(const Tree& tree)
{
  LandmarkRows rows;
  for (const auto& [tag, point] : GetChild(tree, "PickedPoints"))
  {
    if (tag != "point" || point.get("<xmlattr>.active", "1") == "0")
    {
      continue;
    }
    Eigen::RowVector3d position;
    for (const int k : { 0, 1, 2 })
    {
      const std::string axis(1, "xyz"[k]);
      position(k) = ToCoordinate(point.get("<xmlattr>." + axis, ""),
        "point " + std::to_string(rows.Points.size() + 1) + ", attribute " + axis);
    }
    rows.Add(position, point.get("<xmlattr>.name", ""));
  }
  return rows;
}

/// parse: reads a tree of Boost from a stream.
template <class Parse>
Tree ParseTree(std::string_view content, const Parse& parse)
{
  std::istringstream stream{ std::string(content) };
  Tree tree;
  try
  {
    parse(stream, tree);
  }
  catch (const boost::property_tree::file_parser_error& error)
  {
    throw InvalidInput("line " + std::to_string(error.line()) + ": " + error.message());
  }
  return tree;
}

LandmarkRows ReadAnyFormat(std::string_view content, const LandmarksReaderOptions& options)
{
  const std::size_t first = content.find_first_not_of(" \t\r\n");
  const char sign = first == std::string_view::npos ? '\0' : content[first];
  if (sign == '{')
  {
    return ReadMarkups(ParseTree(content,
      [](std::istream& stream, Tree& tree) { boost::property_tree::read_json(stream, tree); }));
  }
  if (sign == '<')
  {
    return ReadPickedPoints(ParseTree(content,
      [](std::istream& stream, Tree& tree) { boost::property_tree::read_xml(stream, tree); }));
  }
  if (IsPTS(content))
  {
    return ReadPTS(content);
  }
  return IsTPS(content) ? ReadTPS(content, options.Specimen, options.TargetSpecimen)
                        : ReadTable(content);
}

Eigen::MatrixXd Stack(const std::vector<Eigen::RowVector3d>& rows)
{
  Eigen::MatrixXd matrix(static_cast<Eigen::Index>(rows.size()), 3);
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    matrix.row(static_cast<Eigen::Index>(i)) = rows[i];
  }
  return matrix;
}

} // namespace

LandmarkFile ReadLandmarks(std::string_view content, const LandmarksReaderOptions& options)
{
  using SystemType = LandmarksReaderOptions::CoordinateSystemType;
  const LandmarkRows rows = ReadAnyFormat(content, options);
  if (rows.Points.empty())
  {
    throw InvalidInput(
      "there are no landmarks; expected .csv, .fcsv, .mrk.json, .pp, .pts or .tps");
  }
  LandmarkFile file{ Stack(rows.Points), Stack(rows.Targets), rows.Names, rows.CoordinateSystem };
  const std::string wanted = options.CoordinateSystem == SystemType::LPS ? "LPS" : "RAS";
  if (options.CoordinateSystem != SystemType::AsInFile && !file.CoordinateSystem.empty() &&
    file.CoordinateSystem != wanted)
  {
    file.Points.leftCols(2) *= -1.0;
    file.Targets.leftCols(2) *= -1.0;
    file.CoordinateSystem = wanted;
  }
  return file;
}

} // namespace shape
