#pragma once

#include <functional>
#include <string>
#include <vector>

namespace vtkShapeExpression
{

/**
 * Returns the function of one number that an expression denotes, as in ParaView's Calculator
 * (vtkExprTkFunctionParser).
 *
 * variables: all names of the number; those that are no words of letters, digits and underscores
 * are left out. property: the name of the expression in errors. Where the function has no value, it
 * is NaN. It may be called by one thread at a time.
 *
 * Throws shape::InvalidInput if the expression has an error or other variables, or if its value is
 * a vector.
 */
std::function<double(double)> Parse(const std::string& expression,
  const std::vector<std::string>& variables, const std::string& property);

} // namespace vtkShapeExpression
