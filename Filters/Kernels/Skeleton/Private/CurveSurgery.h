#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"
#include "Skeleton/Private/CurveGraph.h"

namespace shape
{

/**
 * Collapses a contracted surface to a graph of curves, the shortest edges first.
 *
 * An edge that no link condition forbids is collapsed to a point. If an edge is in a cycle of three
 * edges that bounds no triangle, the surface is cut along the cycle: both sides get a triangle as a
 * cap, and a link of the graph joins them. A surface of four triangles becomes the shortest tree
 * over its points. No step changes the number of components. A cut that separates a surface makes
 * one link more and one surface more; another makes one link more and lowers the genus by one, so
 * that the graph of a surface of genus g has exactly g independent cycles.
 *
 * Whether a cycle winds around the solid or around its hole is a question of lengths: the surface
 * is contracted, so that its parts are long compared with their girths.
 *
 * surface: closed and oriented, of any number of components. Throws Aborted.
 */
CurveGraph CollapseToCurves(const Mesh& surface, const Progress& progress = {});

} // namespace shape
