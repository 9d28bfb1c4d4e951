#pragma once

#include "Distance/SignedDistance.h"
#include "Skeleton/CurveSkeleton.h"
#include "Skeleton/Private/CurveGraph.h"

namespace shape
{

/**
 * Makes a skeleton from a graph of curves: links shorter than half of `length` are merged, branches
 * that end within the ball around their junction or are shorter than three edges are removed, and
 * branches get equal edges of about `length`, at least three in a closed branch and two in branches
 * between the same junctions. Components and cycles stay.
 */
CurveSkeleton MakeBranches(const CurveGraph& graph, const SignedDistance& surface, double length);

} // namespace shape
