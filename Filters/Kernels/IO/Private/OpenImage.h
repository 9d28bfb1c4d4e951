#pragma once

#include "IO/ImageHeader.h"

#include <string>

namespace shape
{

/// What libshape_image.so does, which links ITK. Both throw InvalidInput as ReadImageHeader does.
struct ImageLibrary
{
  ImageHeader (*ReadHeader)(const std::string& path);
  void (*ReadValues)(const std::string& path, void* values);
};

/// Loads ITK, unless an earlier call did. Throws InvalidInput if ShapeMap was built without it, and
/// SolveFailure if its libraries are missing.
ImageLibrary LoadImageLibrary();

} // namespace shape

/// The ImageLibrary of libshape_image.so, which LoadImageLibrary looks up by this name.
extern "C" [[gnu::visibility("default")]] void ShapeMapImageLibrary(shape::ImageLibrary& own);
