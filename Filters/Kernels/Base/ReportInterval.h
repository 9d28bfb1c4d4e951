#pragma once

namespace shape
{

/// Loops report progress after this many short iterations: seldom enough to cost nothing.
constexpr int ReportInterval = 4096;

} // namespace shape
