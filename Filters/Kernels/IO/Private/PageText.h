#pragma once

namespace shape
{

/// The page that shows a mesh (IO/Page/viewer.html), with @MESH@ where the mesh belongs.
extern const char* const PageText;

} // namespace shape
