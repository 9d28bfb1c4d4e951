#pragma once

#include <string>

namespace shape
{

/// Returns the shortest text that represents the number exactly, or, if that has more columns, the
/// text of the nearest number that fits. columns: at least 9. Redundant zeros are left out (.5,
/// 1e-5), and an integer has a decimal point (2.).
std::string ToColumnText(double value, std::size_t columns);

} // namespace shape
