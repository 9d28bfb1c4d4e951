#include "IO/DeckReader.h"

#include "Base/Errors.h"
#include "IO/Private/DeckBuilder.h"
#include "IO/Private/DeckText.h"

#include <algorithm>
#include <utility>

namespace shape
{

Deck ReadDeck(const std::string& name, std::string content, const ReadNamedFile& read,
  const Progress& progress, DeckContent wanted)
{
  const std::string extension = InUpperCase(name.substr(std::min(name.rfind('.'), name.size())));
  const auto parse = extension == ".INP"                              ? ParseAbaqusDeck
    : extension == ".K" || extension == ".KEY" || extension == ".DYN" ? ParseDynaDeck
    : extension == ".FEB"                                             ? ParseFebioDeck
                                                                      : nullptr;
  if (!parse)
  {
    throw InvalidInput("the extension '" + extension +
      "' is no format of a deck; it must be .inp, .k, .key, .dyn or .feb");
  }
  DeckBuilder builder(
    name, std::move(content), read, progress, wanted == DeckContent::NodesAndElements);
  parse(builder);
  return builder.Finish();
}

} // namespace shape
