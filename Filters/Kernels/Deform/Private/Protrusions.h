#pragma once

#include "Deform/UpwindFront.h"
#include "Mesh/Graph.h"

#include <Eigen/Core>

namespace shape
{

/**
 * Labels the protrusions of a shape: the segments that the hierarchy of section 2.3 of Schmidt and
 * Singh ("Drag-and-drop surface composition", Graphics Interface 2010) deforms one after another.
 *
 * The nodes that the front reaches after a time t have components. As t decreases, a component
 * appears at each tip, and components join at saddles: the join tree of the arrival times (Carr,
 * Snoeyink and Axen, "Computing contour trees in all dimensions", 2003). A component that reaches
 * at least `minimum` beyond the saddle at which it joins others as long is a protrusion. It ends at
 * the distance of the saddle from its tip. What lies between the saddles of protrusions is a
 * segment, too, if it is at least `minimum` long; otherwise it belongs to the segment below it.
 * Shorter components belong to the one that they join.
 *
 * graph, sweep: a graph and the arrival times at its nodes. minimum: >= 0, in the model's units.
 * Returns a label for each node: 0 at the sources and in the segment with the most links to them,
 * and 1, 2, ... in the others, by the time at which the front reaches their last node, the latest
 * first.
 */
Eigen::VectorXi FindProtrusions(const Graph& graph, const FrontSweep& sweep, double minimum);

} // namespace shape
