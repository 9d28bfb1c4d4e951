#pragma once

namespace shape
{

/// The largest genus of surfaces for which a common base domain is traced.
constexpr int MaximumBaseGenus = 4;

} // namespace shape
