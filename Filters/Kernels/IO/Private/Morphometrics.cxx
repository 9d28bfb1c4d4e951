#include "IO/Private/Morphometrics.h"

#include "Base/Errors.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <sstream>

namespace shape
{
namespace
{

using Words = std::vector<std::string>;

Words SplitWords(const std::string& line)
{
  std::istringstream stream(line);
  Words words;
  for (std::string word; stream >> word;)
  {
    words.push_back(word);
  }
  return words;
}

std::string ToUpper(std::string word)
{
  std::transform(word.begin(), word.end(), word.begin(),
    [](unsigned char letter) { return static_cast<char>(std::toupper(letter)); });
  return word;
}

/// The lines of a file that are not blank.
class LineText
{
public:
  explicit LineText(std::string_view content)
    : Stream(std::string(content))
  {
  }

  /// Goes to the next line. Returns false at the end of the file.
  bool Next()
  {
    do
    {
      ++this->Number;
      if (!std::getline(this->Stream, this->Line))
      {
        return false;
      }
      this->Line = Trim(this->Line);
    } while (this->Line.empty());
    return true;
  }

  /// Goes to the next line, which must exist.
  const std::string& Require(const char* what)
  {
    if (!this->Next())
    {
      this->Refuse(std::string("the file ends before ") + what + "; save it again");
    }
    return this->Line;
  }

  std::string Where() const { return "line " + std::to_string(this->Number); }

  [[noreturn]] void Refuse(const std::string& why) const
  {
    throw InvalidInput(this->Where() + ": " + why);
  }

  int ToCount(const std::string& word) const
  {
    const double count = ToCoordinate(word, this->Where());
    if (!(count >= 0.0 && count < 1e9) || count != static_cast<int>(count))
    {
      this->Refuse("`" + word + "` is no number of points");
    }
    return static_cast<int>(count);
  }

  /// Converts the words from `first`, of which there are two or three.
  Eigen::RowVector3d ToPosition(const Words& words, std::size_t first) const
  {
    const std::size_t count = words.size() - std::min(first, words.size());
    if (count < 2 || count > 3)
    {
      this->Refuse("there are " + std::to_string(count) + " coordinates instead of 2 or 3");
    }
    Eigen::RowVector3d position = Eigen::RowVector3d::Zero();
    for (std::size_t k = 0; k < count; ++k)
    {
      position(static_cast<Eigen::Index>(k)) = ToCoordinate(words[first + k], this->Where());
    }
    return position;
  }

  std::string Line;

private:
  std::istringstream Stream;
  long Number = 0;
};

std::string FirstLine(std::string_view content)
{
  LineText text(content.substr(0, 1024));
  return text.Next() ? ToUpper(text.Line) : std::string();
}

/// Points in braces: "n_points: 2", "{", "x y", "x y", "}".
LandmarkRows ReadBraces(LineText& text)
{
  LandmarkRows rows;
  const Words count = SplitWords(text.Line);
  text.Require("the points");
  if (count.size() != 2 || text.Line != "{")
  {
    text.Refuse("`{` should follow the line with n_points");
  }
  const int points = text.ToCount(count[1]);
  for (int i = 0; i < points; ++i)
  {
    rows.Add(text.ToPosition(SplitWords(text.Require("the last point")), 0), "");
  }
  if (text.Require("`}`") != "}")
  {
    text.Refuse("there are more points than n_points says");
  }
  return rows;
}

/// Landmarks of a specimen; a missing one has no value.
using SpecimenLandmarks = std::vector<std::optional<Eigen::RowVector3d>>;

SpecimenLandmarks ReadSpecimen(LineText& text, std::size_t dimension, int count)
{
  SpecimenLandmarks landmarks;
  for (int i = 0; i < count; ++i)
  {
    const Words words = SplitWords(text.Require("the last landmark"));
    if (words.size() != dimension)
    {
      text.Refuse("there are " + std::to_string(words.size()) + " coordinates instead of " +
        std::to_string(dimension));
    }
    const bool isMissing =
      std::any_of(words.begin(), words.end(), [](const auto& word) { return word == "NA"; });
    landmarks.push_back(isMissing ? std::nullopt : std::optional(text.ToPosition(words, 0)));
  }
  return landmarks;
}

std::vector<SpecimenLandmarks> ReadSpecimens(LineText& text)
{
  std::vector<SpecimenLandmarks> specimens;
  while (text.Next())
  {
    const std::size_t equals = text.Line.find('=');
    const std::string key = ToUpper(Trim(text.Line.substr(0, equals)));
    const std::string value = equals == std::string::npos ? "" : Trim(text.Line.substr(equals + 1));
    if (equals == std::string::npos)
    {
      text.Refuse("`" + text.Line.substr(0, 20) + "` belongs to no entry; save the file again");
    }
    if (key == "LM" || key == "LM3")
    {
      specimens.push_back(ReadSpecimen(text, key == "LM" ? 2 : 3, text.ToCount(value)));
    }
    else if (key == "POINTS")
    {
      const int points = text.ToCount(value); // of a curve
      for (int i = 0; i < points; ++i)
      {
        text.Require("the last point of a curve");
      }
    }
    else if (key == "SCALE" && !specimens.empty())
    {
      const double scale = ToCoordinate(value, text.Where());
      for (auto& landmark : specimens.back())
      {
        landmark = landmark ? std::optional<Eigen::RowVector3d>(*landmark * scale) : landmark;
      }
    }
  }
  return specimens;
}

} // namespace

bool IsPTS(std::string_view content)
{
  return FirstLine(content).rfind("VERSION", 0) == 0;
}

LandmarkRows ReadPTS(std::string_view content)
{
  constexpr double missing = 9999.0;
  LineText text(content);
  text.Require("the version");
  text.Require("the number of points");
  if (ToUpper(text.Line).rfind("N_POINTS", 0) == 0)
  {
    return ReadBraces(text);
  }
  const int count = text.ToCount(text.Line);
  LandmarkRows rows;
  for (int i = 0; i < count; ++i)
  {
    const Words words = SplitWords(text.Require("the last landmark"));
    const Eigen::RowVector3d position = text.ToPosition(words, 1);
    if ((position.array() != missing).all())
    {
      rows.Add(position, words.front());
    }
  }
  if (text.Next())
  {
    text.Refuse("there are more landmarks than the second line says");
  }
  return rows;
}

bool IsTPS(std::string_view content)
{
  const std::string line = FirstLine(content);
  return line.rfind("LM=", 0) == 0 || line.rfind("LM3=", 0) == 0;
}

LandmarkRows ReadTPS(std::string_view content, int specimen, int target)
{
  LineText text(content);
  const std::vector<SpecimenLandmarks> specimens = ReadSpecimens(text);
  const int count = static_cast<int>(specimens.size());
  if (specimen < 1 || specimen > count)
  {
    throw InvalidInput("Specimen is " + std::to_string(specimen) + ", and the file has " +
      std::to_string(count) + "; choose one of them");
  }
  const SpecimenLandmarks& landmarks = specimens[specimen - 1];
  const bool isPaired = target >= 1 && target <= count && target != specimen;
  const SpecimenLandmarks& targets = specimens[isPaired ? target - 1 : specimen - 1];
  if (targets.size() != landmarks.size())
  {
    throw InvalidInput("specimen " + std::to_string(target) + " has " +
      std::to_string(targets.size()) + " landmarks, and specimen " + std::to_string(specimen) +
      " has " + std::to_string(landmarks.size()) + "; set TargetSpecimen to 0, or to another one");
  }
  LandmarkRows rows;
  for (std::size_t i = 0; i < landmarks.size(); ++i)
  {
    if (!landmarks[i] || !targets[i])
    {
      continue;
    }
    rows.Add(*landmarks[i], std::to_string(i + 1));
    if (isPaired)
    {
      rows.Targets.push_back(*targets[i]);
    }
  }
  return rows;
}

} // namespace shape
