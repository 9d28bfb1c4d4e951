#pragma once

#include "Base/Progress.h"
#include "IO/Deck.h"

#include <Eigen/Core>

#include <cstdint>
#include <ostream>
#include <vector>

namespace shape
{

/// Points that carry the numbers of nodes of a deck.
struct NumberedPoints
{
  Eigen::MatrixXd Points;            ///< p x 3
  std::vector<std::int64_t> Numbers; ///< p: number of each node
  std::vector<int> Parts;            ///< p, or empty if no node has a part
};

/**
 * Returns the new position of each node of the deck (n x 3). Each node must be among the points, in
 * any order; points at the same position may have the same node.
 *
 * Throws InvalidInput, with the number of nodes and the first, if nodes are missing, two points at
 * different positions have the same node, a point has a node that the deck does not have, a
 * position is not finite, or a coordinate would change that the deck leaves out.
 */
Eigen::MatrixXd FindMovedNodes(const Deck& deck, const NumberedPoints& moved);

/// True if the file has nodes, so that WriteMovedFile can change it.
bool HasNodes(const Deck& deck, int file);

/**
 * Writes a file of the deck with other positions of its nodes (n x 3). All other bytes are those of
 * the file, and also a coordinate that does not change.
 *
 * A coordinate is written as the shortest text that represents it exactly. If that has more columns
 * than the format reads (20 in Abaqus and CalculiX, 16 or 20 in LS-DYNA), it is the nearest number
 * that fits: with 16 columns, its error is less than 1e-8 of the coordinate, and with 20 less than
 * 1e-12.
 *
 * Throws Aborted. The caller checks `file` for write errors.
 */
void WriteMovedFile(std::ostream& file, const Deck& deck, int index,
  const Eigen::MatrixXd& positions, const Progress& progress = {});

} // namespace shape
