#pragma once

#include "Base/Progress.h"
#include "IO/Deck.h"

#include <string>

namespace shape
{

/// What is read of a deck.
enum class DeckContent
{
  NodesAndElements,
  Nodes ///< elements are not even checked
};

/**
 * Reads the nodes and elements of an input deck. name: of the deck; its extension is the format:
 * .inp; .k, .key or .dyn; .feb. content: of that file. read: the files that it includes.
 *
 * The time is linear in the size of the files. Bytes outside of nodes and elements are not
 * interpreted, in any encoding; lines may end with CR LF.
 *
 * - Abaqus and CalculiX: *NODE, *ELEMENT, both also with INPUT=, and *INCLUDE. Parts that have one
 *   instance without translation or rotation are read; each has its own numbers.
 *   Elements: solid, surface and truss elements of 2 to 20 nodes, by their names (C3D8R, S4, ...).
 * - LS-DYNA: *NODE, *ELEMENT_SOLID (also _ORTHO), _TSHELL and _SHELL (also _THICKNESS, _BETA,
 *   _MCID), *INCLUDE; columns or commas; the standard, I10 and long formats.
 * - FEBio: <Nodes> and <Elements>, of version 1 to 4.
 *
 * Throws InvalidInput, with the file and line, if
 * - the extension, a number or an element is wrong, or a file includes itself,
 * - nodes are not where their coordinates say, or are generated from others: *SYSTEM, *NODE with
 *   SYSTEM=, *NGEN, *NFILL, *NCOPY, *NMAP, instances with a translation or of a part that has
 *   another one; *NODE_TRANSFORM, *NODE_RIGID_SURFACE, *INCLUDE_TRANSFORM and other *INCLUDE_...;
 *   <Instance>, and meshes from another file,
 * - there is no node, two nodes have the same number, or an element has a node that is not there.
 * Throws Aborted.
 */
Deck ReadDeck(const std::string& name, std::string content, const ReadNamedFile& read,
  const Progress& progress = {}, DeckContent wanted = DeckContent::NodesAndElements);

} // namespace shape
