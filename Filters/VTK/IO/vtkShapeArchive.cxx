#include "vtkShapeArchive.h"

#include "Base/Errors.h"

#include <zlib.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <memory>

namespace
{

/// A header of a tar archive is one block; the content of its file fills whole blocks.
constexpr int BlockSize = 512;
constexpr int NameSize = 100, SizeField = 124, SizeLength = 12;

} // namespace

std::string vtkShapeArchive::Read(const std::string& archive, const std::string& member)
{
  const auto refuse = [&](const std::string& problem)
  { throw shape::InvalidInput("the archive '" + archive + "' " + problem); };
  const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(gzopen(archive.c_str(), "rb"), &gzclose);
  if (!file)
  {
    refuse("cannot be opened; install its package again");
  }
  gzbuffer(file.get(), 1U << 18U);
  std::array<char, BlockSize + 1> header{};
  while (gzread(file.get(), header.data(), BlockSize) == BlockSize && header[0] != '\0')
  {
    const std::string name(header.data(), strnlen(header.data(), NameSize));
    const std::string octal(header.data() + SizeField, SizeLength);
    const long size = std::strtol(octal.c_str(), nullptr, 8);
    if (name == member)
    {
      std::string content(static_cast<std::size_t>(size), '\0');
      if (gzread(file.get(), content.data(), static_cast<unsigned>(size)) != size)
      {
        break;
      }
      return content;
    }
    const long blocks = (size + BlockSize - 1) / BlockSize;
    if (gzseek(file.get(), blocks * BlockSize, SEEK_CUR) < 0)
    {
      break;
    }
  }
  refuse("has no complete file " + member + "; install its package again");
  return {};
}
