#include "vtkShapeProgress.h"

#include "vtkAlgorithm.h"
#include "vtkVersionMacros.h"

#include <algorithm>
#include <utility>

namespace
{

std::function<bool()>& StopRequest()
{
  static std::function<bool()> request;
  return request;
}

} // namespace

namespace vtkShapeProgress
{

shape::Progress Make(vtkAlgorithm* algorithm, const std::string& label)
{
  const char* none = nullptr;
  return shape::Progress(
    [algorithm, label, shown = none](double fraction, const char* stage) mutable
    {
      // Stages are literals: another pointer is another stage.
      if (stage != shown)
      {
        shown = stage;
        algorithm->SetProgressText((label + (*stage ? ": " : "") + stage).c_str());
      }
      // Progress never decreases, even if a part was estimated wrongly.
      algorithm->UpdateProgress(std::clamp(fraction, algorithm->GetProgress(), 1.0));
      if (StopRequest() && StopRequest()())
      {
        return false;
      }
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20230111)
      return !algorithm->CheckAbort();
#else
      return !algorithm->GetAbortExecute();
#endif
    });
}

void SetStopRequest(std::function<bool()> isWanted)
{
  StopRequest() = std::move(isWanted);
}

} // namespace vtkShapeProgress
