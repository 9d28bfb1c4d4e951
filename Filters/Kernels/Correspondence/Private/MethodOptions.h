#pragma once

#include "Correspondence/CorrespondenceOptions.h"

namespace shape
{

/// Throws InvalidInput if a number of `options` is out of its range, whether the method uses it or
/// not. The message has the name of the filter's property.
void RequireMethodOptions(const CorrespondenceOptions& options);

} // namespace shape
