#include "vtkShapeExpression.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkExprTkFunctionParser.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include "Base/Errors.h"

namespace
{

void Remember(vtkObject*, unsigned long, void* target, void* text)
{
  std::string& first = *static_cast<std::string*>(target);
  if (first.empty() && text)
  {
    first = static_cast<const char*>(text);
  }
}

/// Returns what the parser says, in one line and without the place in VTK's own source.
std::string Shorten(std::string text)
{
  if (const auto start = text.find("): "); start != std::string::npos)
  {
    text.erase(0, start + 3);
  }
  for (char& letter : text)
  {
    letter = letter == '\n' || letter == '\t' ? ' ' : letter;
  }
  while (!text.empty() && (text.back() == ' ' || text.back() == '.'))
  {
    text.pop_back();
  }
  return text;
}

} // namespace

std::function<double(double)> vtkShapeExpression::Parse(const std::string& expression,
  const std::vector<std::string>& variables, const std::string& property)
{
  const auto parser = vtkSmartPointer<vtkExprTkFunctionParser>::New();
  std::vector<std::string> names;
  std::string known;
  for (const std::string& variable : variables)
  {
    if (!variable.empty() && vtkExprTkFunctionParser::SanitizeName(variable.c_str()) == variable)
    {
      parser->SetScalarVariableValue(variable, 1.0);
      known += (names.empty() ? "" : " or ") + variable;
      names.push_back(variable);
    }
  }
  std::string error;
  vtkNew<vtkCallbackCommand> listener;
  listener->SetCallback(Remember);
  listener->SetClientData(&error);
  const unsigned long tag = parser->AddObserver(vtkCommand::ErrorEvent, listener);
  parser->SetFunction(expression.c_str());
  const bool isScalar = parser->IsScalarResult() != 0;
  parser->RemoveObserver(tag);
  if (!isScalar)
  {
    throw shape::InvalidInput("the expression of " + property + ", '" + expression +
      "', is not a number computed from " + known +
      (error.empty() ? "" : " (" + Shorten(error) + ")") + "; correct it");
  }
  return [parser, names](double value)
  {
    for (const std::string& name : names)
    {
      parser->SetScalarVariableValue(name, value);
    }
    return parser->GetScalarResult();
  };
}
