#pragma once

#include <string>

/// Compressed archives (.tar.gz), read without unpacking them to disk.
namespace vtkShapeArchive
{

/// Returns the bytes of one file of an archive. `member` is the path in the archive. Throws
/// shape::InvalidInput if the archive cannot be read or has no such file.
std::string Read(const std::string& archive, const std::string& member);

} // namespace vtkShapeArchive
