#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace shape
{

/// The lines of a text, one after the other.
class DeckLines
{
public:
  explicit DeckLines(std::string_view text)
    : Text(text)
  {
  }

  /// Moves to the next line. Returns false at the end.
  bool Next();

  std::string_view Line() const { return this->Current; } ///< without its end
  std::size_t Begin() const { return this->First; }       ///< byte at which the line begins
  std::size_t End() const { return this->After; }         ///< byte at which the next line begins
  long Number() const { return this->Count; }             ///< from 1

private:
  std::string_view Text, Current;
  std::size_t First = 0, After = 0;
  long Count = 0;
};

/// Returns the text without blanks, tabs and line ends around it.
std::string_view Trimmed(std::string_view text);

/// Returns the text in upper case; bytes that are not ASCII stay.
std::string InUpperCase(std::string_view text);

/// Replaces `parts` by the parts of a text between commas; they are not trimmed.
void SplitAtCommas(std::string_view text, std::vector<std::string_view>& parts);

/// Reads the integer that is the trimmed text. Returns false if it is none.
bool ReadDeckInteger(std::string_view text, std::int64_t& value);

/// Reads the finite number that is the trimmed text, also in Fortran's ways: 1.5D3, 1.5+3. An empty
/// text is 0. Returns false if it is none.
bool ReadDeckNumber(std::string_view text, double& value);

} // namespace shape
