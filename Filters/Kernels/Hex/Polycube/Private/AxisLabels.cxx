#include "Hex/Polycube/Private/AxisLabels.h"

#include "Hex/Polycube/Private/AxisAlignment.h"
#include "Mesh/HalfEdges.h"

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/boykov_kolmogorov_max_flow.hpp>

#include <algorithm>
#include <cmath>

namespace shape
{
namespace
{

/// The cost of opposite labels on neighbours. It exceeds the sum of all other costs.
constexpr double Forbidden = 1e6;
/// A bound only: the loop ends when no label lowers the energy.
constexpr int MaximumRounds = 20;

/// Returns the cost of two labels on neighbours, relative to the weight of their edge.
double PairCost(int first, int second, double weight)
{
  if (first == second)
  {
    return 0.0;
  }
  return first / 2 == second / 2 ? Forbidden : weight;
}

double Energy(
  const Eigen::MatrixXd& costs, const std::vector<LabelEdge>& edges, const Eigen::VectorXi& labels)
{
  double sum = 0.0;
  for (int i = 0; i < labels.size(); ++i)
  {
    sum += costs(i, labels(i));
  }
  for (const LabelEdge& edge : edges)
  {
    sum += PairCost(labels(edge.First), labels(edge.Second), edge.Weight);
  }
  return sum;
}

using Traits = boost::adjacency_list_traits<boost::vecS, boost::vecS, boost::directedS>;

struct Node
{
  boost::default_color_type Color = boost::white_color;
  long Distance = 0;
  Traits::edge_descriptor Predecessor;
};

struct Arc
{
  double Capacity = 0.0, Residual = 0.0;
  Traits::edge_descriptor Reverse;
};

using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS, Node, Arc>;

/// A minimum cut; sites on the source's side keep their label.
class Cut
{
public:
  explicit Cut(int sites)
    : Network(sites + 2)
    , Keep(Eigen::VectorXd::Zero(sites))
    , Change(Eigen::VectorXd::Zero(sites))
  {
  }

  void AddCosts(int site, double keep, double change)
  {
    this->Keep(site) += keep;
    this->Change(site) += change;
  }

  /// Adds the cost for the case that `first` keeps its label and `second` changes.
  void AddPair(int first, int second, double cost, double reverse)
  {
    this->AddArcs(first, second, cost, reverse);
  }

  /// Returns whether each site changes.
  std::vector<char> Solve()
  {
    const int sites = static_cast<int>(this->Keep.size());
    const int source = sites, sink = sites + 1;
    for (int i = 0; i < sites; ++i)
    {
      const double minimum = std::min(this->Keep(i), this->Change(i));
      this->AddArcs(source, i, this->Change(i) - minimum, 0.0);
      this->AddArcs(i, sink, this->Keep(i) - minimum, 0.0);
    }
    boost::boykov_kolmogorov_max_flow(this->Network, get(&Arc::Capacity, this->Network),
      get(&Arc::Residual, this->Network), get(&Arc::Reverse, this->Network),
      get(&Node::Predecessor, this->Network), get(&Node::Color, this->Network),
      get(&Node::Distance, this->Network), get(boost::vertex_index, this->Network), source, sink);
    std::vector<char> changes(sites);
    const auto ofSource = this->Network[source].Color;
    for (int i = 0; i < sites; ++i)
    {
      changes[i] = this->Network[i].Color != ofSource;
    }
    return changes;
  }

private:
  void AddArcs(int from, int to, double capacity, double reverse)
  {
    const auto there = add_edge(from, to, this->Network).first;
    const auto back = add_edge(to, from, this->Network).first;
    this->Network[there].Capacity = capacity;
    this->Network[back].Capacity = reverse;
    this->Network[there].Reverse = back;
    this->Network[back].Reverse = there;
  }

  Graph Network;
  Eigen::VectorXd Keep, Change;
};

/// One alpha-expansion (Boykov et al. 2001): the best labelling in which each site either keeps its
/// label or takes `label`. It is the minimum cut of a network with an arc for each edge.
Eigen::VectorXi Expanded(const Eigen::MatrixXd& costs, const std::vector<LabelEdge>& edges,
  const Eigen::VectorXi& labels, int label)
{
  Cut cut(static_cast<int>(labels.size()));
  for (int i = 0; i < labels.size(); ++i)
  {
    cut.AddCosts(i, costs(i, labels(i)), costs(i, label));
  }
  for (const auto& [p, q, weight] : edges)
  {
    // The cost of an edge as a function of p and q, which are 1 for a site that changes:
    // both + (first - both) p - first q + (second + first - both) (1 - p) q.
    // The last factor is not negative, because current labels of neighbours are never opposite; a
    // cut represents such a function exactly. The constant `both` changes nothing.
    const double both = PairCost(labels(p), labels(q), weight);
    const double second = PairCost(labels(p), label, weight);
    const double first = PairCost(label, labels(q), weight);
    cut.AddCosts(p, 0.0, first - both);
    cut.AddCosts(q, 0.0, -first);
    cut.AddPair(p, q, std::max(0.0, second + first - both), 0.0);
  }
  const std::vector<char> changes = cut.Solve();
  Eigen::VectorXi expanded = labels;
  for (int i = 0; i < labels.size(); ++i)
  {
    expanded(i) = changes[i] ? label : labels(i);
  }
  return expanded;
}

} // namespace

Eigen::VectorXi SolveGraphCutLabelling(
  const Eigen::MatrixXd& costs, const std::vector<LabelEdge>& edges)
{
  Eigen::VectorXi labels = Eigen::VectorXi::Zero(costs.rows());
  double energy = Energy(costs, edges, labels);
  // Expansions of the six labels in turn, until a whole cycle lowers nothing. A gain below the
  // rounding of the sums does not count.
  for (int round = 0, unchanged = 0; round < MaximumRounds && unchanged < 6; ++round)
  {
    for (int label = 0; label < 6 && unchanged < 6; ++label)
    {
      const Eigen::VectorXi expanded = Expanded(costs, edges, labels, label);
      const double now = Energy(costs, edges, expanded);
      ++unchanged;
      if (now < energy - 1e-9 * (1.0 + std::abs(energy)))
      {
        labels = expanded;
        energy = now;
        unchanged = 0;
      }
    }
  }
  return labels;
}

namespace
{

/// The widths of the two bells of the energy of PolyCut (Livesu et al. 2013, section 3): of the
/// data term and of the border term.
constexpr double Fidelity = 0.2, Sharpness = 0.25;
/// The cost of a border edge at a sharp crease, where it is lowest: a border must not be free.
constexpr double MinimumBoundaryCost = 1e-3;

/// Close to 1 within the width of 0, close to 0 beyond.
double Bell(double x, double width)
{
  return std::exp(-0.5 * (x / width) * (x / width));
}

} // namespace

Eigen::VectorXi FindAxisLabels(const WorkingSolid& solid, const Eigen::MatrixXd& positions,
  double compactness, const Eigen::MatrixXd& further)
{
  const Mesh rest = solid.Surface();
  const Eigen::MatrixXd vectors = ComputeAreaVectors(rest);
  const Eigen::VectorXd areas = 0.5 * vectors.rowwise().norm();
  const Eigen::MatrixXd atRest = vectors.rowwise().normalized();
  const Eigen::MatrixXd normals =
    ComputeAreaVectors(solid.Surface(positions)).rowwise().normalized();
  const double area = areas.mean();
  Eigen::MatrixXd costs = further.size() > 0 ? further : Eigen::MatrixXd::Zero(areas.size(), 6);
  for (Eigen::Index f = 0; f < areas.size(); ++f)
  {
    for (int label = 0; label < 6 && normals.row(f).allFinite(); ++label)
    {
      // The data term: the deviation of the deformed normal from the label's axis.
      costs(f, label) +=
        areas(f) / area * (1.0 - Bell(normals.row(f).dot(GetLabelAxis(label)) - 1.0, Fidelity));
    }
  }
  // The border term takes normals of the undeformed solid: its creases stay where they are.
  const std::vector<HalfEdge> sides = SortHalfEdges(solid.Triangles, solid.SurfacePointCount);
  std::vector<LabelEdge> edges;
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < sides.size(); i += 2)
  {
    const int t = sides[i].Triangle, s = sides[i + 1].Triangle;
    const double own = (rest.Points.row(sides[i].Begin) - rest.Points.row(sides[i].End)).norm();
    length += own;
    edges.push_back({ t, s,
      own *
        (compactness * Bell(atRest.row(t).dot(atRest.row(s)) - 1.0, Sharpness) +
          MinimumBoundaryCost) });
  }
  length /= static_cast<double>(edges.size());
  std::for_each(edges.begin(), edges.end(), [&](LabelEdge& edge) { edge.Weight /= length; });
  return SolveGraphCutLabelling(costs, edges);
}

} // namespace shape
