#pragma once

#include "Driver/Arguments.h"
#include "Driver/Figures.h"

#include <map>
#include <string>

// The program `benchmark` and its cases.
namespace benchmark
{

/// One measurement, in a process of its own.
struct Case
{
  /// The first line names the arguments; the others say what they and the figures mean.
  std::string Usage;
  /// Throws shape::InvalidInput if the case does not apply to the model, UsageError if the
  /// arguments are wrong, and any other exception if the computation fails.
  void (*Run)(Arguments& arguments, Figures& figures);
};

/// The table of the cases that the program was linked with, by name.
std::map<std::string, Case>& Cases();

/// Enters a case in the table. Each file of Cases/ has one of these at its end, and no list
/// elsewhere names the file.
struct Entry
{
  Entry(const std::string& name, const Case& benchmark) { Cases().emplace(name, benchmark); }
};

} // namespace benchmark
