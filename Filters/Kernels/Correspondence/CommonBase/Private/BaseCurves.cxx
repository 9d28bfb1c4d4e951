#include "Correspondence/CommonBase/Private/BaseCurves.h"

#include "Base/Errors.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace shape
{
namespace
{

const std::array<std::string, 2> Names{ "SurfaceA", "SurfaceB" };

std::string NameOf(std::size_t curve)
{
  return "curve " + std::to_string(curve);
}

class CurveDivision
{
public:
  CurveDivision(
    const std::array<PathSurface*, 2>& surfaces, const std::array<std::vector<int>*, 2>& nodes)
    : Surfaces(surfaces)
    , Nodes(nodes)
  {
    for (int k = 0; k < 2; ++k)
    {
      for (std::size_t node = 0; node < nodes[k]->size(); ++node)
      {
        this->NodeOf[k][(*nodes[k])[node]] = static_cast<int>(node);
      }
    }
  }

  /// Makes the ends of a curve nodes.
  void AddEnds(const CurvePair& curve, std::size_t number)
  {
    this->AddEnd({ curve.OnA.front(), curve.OnB.front() }, number);
    this->AddEnd({ curve.OnA.back(), curve.OnB.back() }, number);
  }

  void RequireEdges(const CurvePair& curve, std::size_t number) const
  {
    for (int k = 0; k < 2; ++k)
    {
      const std::vector<int>& points = k == 0 ? curve.OnA : curve.OnB;
      bool isPath = points.size() > 1;
      for (std::size_t i = 1; isPath && i < points.size(); ++i)
      {
        isPath = this->Surfaces[k]->Find(points[i - 1], points[i]) >= 0;
      }
      if (!isPath)
      {
        throw InvalidInput(NameOf(number) + " does not follow edges of " + Names[k]);
      }
    }
    if ((curve.OnA.front() == curve.OnA.back()) != (curve.OnB.front() == curve.OnB.back()))
    {
      throw InvalidInput(
        NameOf(number) + " is closed on one surface only; close it on both, or on none");
    }
  }

  /// Divides a curve at its nodes.
  void Divide(const CurvePair& curve, std::size_t number)
  {
    std::array<std::vector<int>, 2> passed; // nodes
    std::array<std::vector<std::vector<int>>, 2> pieces;
    for (int k = 0; k < 2; ++k)
    {
      const std::vector<int>& points = k == 0 ? curve.OnA : curve.OnB;
      for (std::size_t i = 0; i < points.size(); ++i)
      {
        const int point = points[i];
        if (i > 0 && !this->Edges[k].insert(std::minmax(points[i - 1], point)).second)
        {
          throw InvalidInput(NameOf(number) + " runs along the edge from point " +
            std::to_string(points[i - 1]) + " to point " + std::to_string(point) + " of " +
            Names[k] + ", which a curve has passed; give it once");
        }
        const auto node = this->NodeOf[k].find(point);
        if (node == this->NodeOf[k].end())
        {
          const auto [first, isNew] = this->CurveOf[k].emplace(point, number);
          if (!isNew)
          {
            throw InvalidInput(first->second == number ? NameOf(number) + " passes point " +
                  std::to_string(point) + " of " + Names[k] + " twice; leave out the loop between"
                                                       : NameOf(first->second) + " and " +
                  NameOf(number) + " meet at point " + std::to_string(point) + " of " + Names[k] +
                  ", so both cannot be kept; move one, or divide both there");
          }
        }
        if (!pieces[k].empty())
        {
          pieces[k].back().push_back(point);
        }
        if (node != this->NodeOf[k].end())
        {
          passed[k].push_back(node->second);
          pieces[k].push_back({ point });
        }
      }
      pieces[k].pop_back();
    }
    if (passed[0] != passed[1])
    {
      throw InvalidInput(NameOf(number) + " passes landmarks" + Listed(passed[0]) +
        " on SurfaceA, but" + Listed(passed[1]) + " on SurfaceB; put its landmarks on both curves");
    }
    for (std::size_t i = 0; i < pieces[0].size(); ++i)
    {
      this->AddPiece(passed[0][i], passed[0][i + 1], { pieces[0][i], pieces[1][i] });
    }
  }

  std::vector<CurvePiece> Pieces;

private:
  static std::string Listed(const std::vector<int>& nodes)
  {
    std::string text;
    for (const int node : nodes)
    {
      text += " " + std::to_string(node);
    }
    return text;
  }

  void AddEnd(const std::array<int, 2>& points, std::size_t number)
  {
    std::array<int, 2> nodes{ -1, -1 };
    for (int k = 0; k < 2; ++k)
    {
      const auto found = this->NodeOf[k].find(points[k]);
      nodes[k] = found == this->NodeOf[k].end() ? -1 : found->second;
    }
    if (nodes[0] != nodes[1])
    {
      throw InvalidInput("an end of " + NameOf(number) + " is at a landmark on " +
        Names[nodes[0] < 0 ? 1 : 0] + ", but not at its partner; let it end at both");
    }
    if (nodes[0] < 0)
    {
      this->AddNode(points);
    }
  }

  int AddNode(const std::array<int, 2>& points)
  {
    const auto node = static_cast<int>(this->Nodes[0]->size());
    for (int k = 0; k < 2; ++k)
    {
      this->Nodes[k]->push_back(points[k]);
      this->NodeOf[k][points[k]] = node;
    }
    return node;
  }

  void AddPiece(int from, int to, std::array<std::vector<int>, 2> points)
  {
    const bool isNew = this->Ends.insert(std::minmax(from, to)).second;
    for (int parts = from == to ? 3 : isNew ? 1 : 2; parts > 1; --parts)
    {
      std::array<std::vector<int>, 2> first;
      std::array<int, 2> ends;
      for (int k = 0; k < 2; ++k)
      {
        first[k] = this->CutOff(k, points[k], 1.0 / parts);
        ends[k] = first[k].back();
      }
      const int node = this->AddNode(ends);
      this->Ends.insert(std::minmax(from, node));
      this->Pieces.push_back({ { from, node }, first });
      from = node;
    }
    this->Ends.insert(std::minmax(from, to));
    this->Pieces.push_back({ { from, to }, std::move(points) });
  }

  /// Cuts off the beginning of a piece, of a given share of its length. It ends inside.
  std::vector<int> CutOff(int k, std::vector<int>& points, double share)
  {
    PathSurface& surface = *this->Surfaces[k];
    std::vector<double> lengths{ 0.0 };
    for (std::size_t i = 1; i < points.size(); ++i)
    {
      lengths.push_back(lengths.back() +
        (surface.PositionOf(points[i]) - surface.PositionOf(points[i - 1])).norm());
    }
    const double length = share * lengths.back();
    std::size_t next = 1;
    while (next + 1 < points.size() && lengths[next] < length)
    {
      ++next;
    }
    // A node very near a point would make slivers: it is at the point then.
    constexpr double margin = 0.2;
    const double along = (length - lengths[next - 1]) / (lengths[next] - lengths[next - 1]);
    const bool atBegin = along < margin && next > 1,
               atEnd = along > 1.0 - margin && next + 1 < points.size();
    if (!atBegin && !atEnd)
    {
      const int point = surface.Split(surface.Find(points[next - 1], points[next]), along);
      points.insert(points.begin() + static_cast<std::ptrdiff_t>(next), point);
    }
    const std::size_t cut = atBegin ? next - 1 : next;
    std::vector<int> first(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(cut) + 1);
    points.erase(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(cut));
    return first;
  }

  std::array<PathSurface*, 2> Surfaces;
  std::array<std::vector<int>*, 2> Nodes;
  std::array<std::map<int, int>, 2> NodeOf;           ///< the node at a point
  std::array<std::map<int, std::size_t>, 2> CurveOf;  ///< the curve that passes a point
  std::array<std::set<std::pair<int, int>>, 2> Edges; ///< passed by curves
  std::set<std::pair<int, int>> Ends;                 ///< of the pieces
};

} // namespace

std::vector<CurvePiece> DivideCurves(const std::vector<CurvePair>& curves,
  const std::array<PathSurface*, 2>& surfaces, const std::array<std::vector<int>*, 2>& nodes)
{
  CurveDivision division(surfaces, nodes);
  for (std::size_t i = 0; i < curves.size(); ++i)
  {
    division.RequireEdges(curves[i], i);
    division.AddEnds(curves[i], i);
  }
  for (std::size_t i = 0; i < curves.size(); ++i)
  {
    division.Divide(curves[i], i);
  }
  return std::move(division.Pieces);
}

} // namespace shape
