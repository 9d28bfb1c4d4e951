#pragma once

#include <string>

namespace shape
{

/**
 * Loads a library that lies beside this one, unless it is loaded, and returns the address of a
 * function in it. The library stays loaded. What links a large product is such a library of its
 * own, because linking its symbols takes longer than all else when ParaView loads the plugin.
 *
 * product: what the library links, for the message. Throws SolveFailure if the library or one that
 * it needs is missing.
 */
void* LoadFunction(
  const std::string& library, const std::string& function, const std::string& product);

} // namespace shape
