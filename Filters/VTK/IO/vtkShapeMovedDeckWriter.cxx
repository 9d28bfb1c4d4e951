#include "vtkShapeMovedDeckWriter.h"

#include "vtkShapeConvert.h"
#include "vtkShapeFileContent.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkStringArray.h"

#include "Base/Errors.h"
#include "IO/MovedDeckWriter.h"

#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>

vtkStandardNewMacro(vtkShapeMovedDeckWriter);

namespace fs = std::filesystem;

namespace
{

bool AreSame(const fs::path& a, const fs::path& b)
{
  std::error_code error; // a file that is not there is not the same
  return fs::equivalent(a, b, error);
}

/// True if a file of this name beside the copy of the deck stays inside the folder of the copy.
bool IsBelow(const std::string& name)
{
  const fs::path path = fs::path(name).lexically_normal();
  return path.is_relative() && *path.begin() != "..";
}

shape::NumberedPoints ReadPoints(vtkPointSet* input, bool hasParts)
{
  shape::NumberedPoints points;
  points.Points = vtkShapeConvert::ToPoints(input);
  vtkDataArray* numbers = input->GetPointData()->GetArray("NodeId");
  vtkDataArray* parts = hasParts ? input->GetPointData()->GetArray("NodePart") : nullptr;
  if (!numbers || (hasParts && !parts))
  {
    throw shape::InvalidInput(std::string("the Input has no point array ") +
      (numbers ? "NodePart" : "NodeId") +
      "; move the output of Shape Deck Reader by filters that keep its arrays");
  }
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    points.Numbers.push_back(static_cast<std::int64_t>(numbers->GetComponent(i, 0)));
    if (parts)
    {
      points.Parts.push_back(static_cast<int>(parts->GetComponent(i, 0)));
    }
  }
  return points;
}

} // namespace

int vtkShapeMovedDeckWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

std::string vtkShapeMovedDeckWriter::FindDeck() const
{
  if (!this->Deck.empty())
  {
    return this->Deck;
  }
  auto* name = vtkStringArray::SafeDownCast(
    const_cast<vtkShapeMovedDeckWriter*>(this)->GetInput()->GetFieldData()->GetAbstractArray(
      "Deck"));
  if (!name || name->GetNumberOfValues() == 0)
  {
    throw shape::InvalidInput("the Input does not say from which deck it came; choose a Deck");
  }
  return name->GetValue(0);
}

void vtkShapeMovedDeckWriter::AddIncludedFiles(
  const std::string& path, const std::function<Content(int)>& contentOf, const shape::Deck& deck)
{
  for (int file = 1; file < static_cast<int>(deck.Files.size()); ++file)
  {
    const std::string& name = deck.Files[file].Name;
    const fs::path copy = vtkShapeFileContent::FindBeside(this->FileName, name);
    const bool isInPlace = AreSame(copy, vtkShapeFileContent::FindBeside(path, name));
    if (shape::HasNodes(deck, file) && (isInPlace || !IsBelow(name)))
    {
      throw shape::InvalidInput("the deck includes '" + name + "', which has nodes; " +
        (isInPlace ? "save the moved deck in another folder"
                   : "include it by a name inside the folder of the deck"));
    }
    if (!isInPlace && IsBelow(name))
    {
      this->AddFile(copy.string(), contentOf(file));
    }
  }
}

vtkShapeFileWriter::Content vtkShapeMovedDeckWriter::ReadInput(const shape::Progress& progress)
{
  const std::string path = this->FindDeck();
  auto deck = std::make_shared<shape::Deck>(vtkShapeFileContent::ReadDeck(
    path, vtkShapeFileContent::Read(path), progress.Part(0.0, 0.8), shape::DeckContent::Nodes));
  if (fs::path(path).extension() != fs::path(this->FileName).extension())
  {
    throw shape::InvalidInput("the deck is '" + fs::path(path).filename().string() +
      "'; give the moved deck the same extension");
  }
  auto positions = std::make_shared<Eigen::MatrixXd>(shape::FindMovedNodes(
    *deck, ReadPoints(vtkPointSet::SafeDownCast(this->GetInput()), deck->HasParts)));
  const auto contentOf = [deck, positions](int file) -> Content
  {
    return [deck, positions, file](std::ostream& stream, const shape::Progress& part)
    { shape::WriteMovedFile(stream, *deck, file, *positions, part); };
  };
  this->AddIncludedFiles(path, contentOf, *deck);
  return contentOf(0);
}

void vtkShapeMovedDeckWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Deck: " << this->Deck << "\n";
}
