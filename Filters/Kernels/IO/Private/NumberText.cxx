#include "IO/Private/NumberText.h"

#include "Base/Errors.h"

#include <cctype>
#include <charconv>
#include <cmath>
#include <system_error>

namespace shape
{
namespace
{

bool IsBlank(char letter)
{
  return letter == ' ' || letter == '\t' || letter == '\r' || letter == '\f' || letter == '\v';
}

} // namespace

NumberText::NumberText(std::string_view text)
  : At(text.data())
  , End(text.data() + text.size())
{
}

void NumberText::Refuse(const std::string& problem) const
{
  throw InvalidInput("line " + std::to_string(this->Line) + ": " + problem);
}

void NumberText::SkipBlanks()
{
  while (this->At != this->End && IsBlank(*this->At))
  {
    ++this->At;
  }
}

bool NumberText::IsAtLineEnd()
{
  this->SkipBlanks();
  return this->At == this->End || *this->At == '\n' || *this->At == '#';
}

void NumberText::SkipLine()
{
  while (this->At != this->End && *this->At != '\n')
  {
    ++this->At;
  }
  if (this->At != this->End)
  {
    ++this->At;
    ++this->Line;
  }
}

bool NumberText::IsAtEnd()
{
  while (this->IsAtLineEnd() && this->At != this->End)
  {
    this->SkipLine();
  }
  return this->At == this->End;
}

bool NumberText::IsAtNumber()
{
  return !this->IsAtEnd() &&
    (std::isdigit(static_cast<unsigned char>(*this->At)) || *this->At == '-' || *this->At == '+' ||
      *this->At == '.');
}

void NumberText::SkipToWord(const char* what)
{
  if (this->IsAtEnd())
  {
    this->Refuse(std::string("the file ends before ") + what + "; it is incomplete");
  }
}

std::string_view NumberText::ReadWord(const char* what)
{
  this->SkipToWord(what);
  const char* first = this->At;
  while (this->At != this->End && !IsBlank(*this->At) && *this->At != '\n' && *this->At != '#')
  {
    ++this->At;
  }
  return { first, static_cast<std::size_t>(this->At - first) };
}

template <typename Number>
Number NumberText::Read(const char* what, const char* kind)
{
  this->SkipToWord(what);
  // std::from_chars reads no plus sign.
  const char* first = this->At + (*this->At == '+' ? 1 : 0);
  Number number = 0;
  const auto [next, error] = std::from_chars(first, this->End, number);
  const bool ends = next == this->End || IsBlank(*next) || *next == '\n' || *next == '#';
  if (error != std::errc() || !ends)
  {
    const std::string word(this->ReadWord(what));
    this->Refuse("'" + word + "' is not " + kind + " of " + what);
  }
  this->At = next;
  return number;
}

int NumberText::ReadInteger(const char* what)
{
  return this->Read<int>(what, "an integer");
}

double NumberText::ReadNumber(const char* what)
{
  const double number = this->Read<double>(what, "a number");
  if (!std::isfinite(number))
  {
    this->Refuse(std::string("a number of ") + what + " is not finite");
  }
  return number;
}

} // namespace shape
