#pragma once

#include <string>
#include <string_view>

namespace shape
{

/// Reads numbers and words from a text, in order. A comment goes from # to the end of its line.
/// Every function that reads throws InvalidInput with the number of the line.
class NumberText
{
public:
  explicit NumberText(std::string_view text);

  ///@{
  /// Returns the next number or word, on this line or a later one. `what` names it in errors: "a
  /// vertex".
  int ReadInteger(const char* what);
  double ReadNumber(const char* what);
  std::string_view ReadWord(const char* what);
  ///@}

  /// Returns how many of the lines' bytes are left. A count of things that take more is wrong.
  std::size_t CountBytesLeft() const { return static_cast<std::size_t>(this->End - this->At); }

  bool IsAtEnd();     ///< only blanks and comments are left
  bool IsAtLineEnd(); ///< only blanks and comments are left on this line
  bool IsAtNumber();  ///< the next word begins as a number does
  /// Moves to the first byte of the next line.
  void SkipLine();

  /// Throws InvalidInput: "line 12: `problem`".
  [[noreturn]] void Refuse(const std::string& problem) const;

private:
  void SkipBlanks();
  void SkipToWord(const char* what);
  template <typename Number>
  Number Read(const char* what, const char* kind);

  const char* At;
  const char* End;
  long Line = 1; ///< of At
};

} // namespace shape
