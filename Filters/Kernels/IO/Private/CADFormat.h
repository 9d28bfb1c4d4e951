#pragma once

namespace shape
{

enum class CADFormat
{
  STEP,
  IGES,
  BREP
};

} // namespace shape
