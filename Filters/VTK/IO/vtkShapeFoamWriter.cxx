#include "vtkShapeFoamWriter.h"

#include "vtkObjectFactory.h"

#include "Base/Errors.h"
#include "IO/FoamWriter.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <system_error>

vtkStandardNewMacro(vtkShapeFoamWriter);

namespace fs = std::filesystem;

namespace
{

/// Throws if a mesh would be replaced that nobody asked to replace.
void RequireReplaceable(const fs::path& folder, const fs::path& marker)
{
  const std::vector<shape::FoamFile>& files = shape::GetFoamFiles();
  std::error_code error; // a folder that is not there has no files
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
  {
    const fs::path name = entry.path().filename();
    if (std::none_of(files.begin(), files.end(),
          [&](const shape::FoamFile& file) { return name == file.Name; }))
    {
      throw shape::InvalidInput("the folder " + folder.string() + " has '" + name.string() +
        "', which belongs to another mesh; delete the folder, or save in another one");
    }
    if (!fs::exists(marker, error))
    {
      throw shape::InvalidInput("the folder " + folder.string() + " already has a mesh, and " +
        marker.filename().string() + " is not its file; replace the .foam file that is there, or " +
        "save in another folder");
    }
  }
}

} // namespace

void vtkShapeFoamWriter::AddFiles(const shape::MeshSets& sets, const shape::Progress& progress)
{
  const fs::path marker = this->FileName;
  const fs::path folder = marker.parent_path() / "constant" / "polyMesh";
  RequireReplaceable(folder, marker);
  auto mesh = std::make_shared<const shape::PolyMesh>(shape::MakePolyMesh(sets, progress));
  for (const shape::FoamFile& file : shape::GetFoamFiles())
  {
    this->AddFile((folder / file.Name).string(),
      [mesh, write = file.Write](std::ostream& stream, const shape::Progress& part)
      { write(stream, *mesh, part); });
  }
}

void vtkShapeFoamWriter::WriteText(std::ostream&, const shape::MeshSets&, const shape::Progress&)
{
  // The name of the file is all that the reader needs.
}
