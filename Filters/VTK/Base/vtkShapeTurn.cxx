#include "vtkShapeTurn.h"

#include "vtkAlgorithm.h"
#include "vtkMultiProcessController.h"

#include "Base/Errors.h"
#include "Base/Progress.h"

#include <chrono>
#include <dlfcn.h>
#include <mutex>

namespace
{

std::recursive_timed_mutex& Turns()
{
  static std::recursive_timed_mutex turns;
  return turns;
}

/// Releases Python's lock while it exists, if this thread holds it. The filters do not link to
/// Python: its functions are there only if the process has loaded it.
class WithoutPython
{
public:
  WithoutPython()
  {
    const auto isHeld = reinterpret_cast<int (*)()>(dlsym(RTLD_DEFAULT, "PyGILState_Check"));
    const auto isReady = reinterpret_cast<int (*)()>(dlsym(RTLD_DEFAULT, "Py_IsInitialized"));
    const auto release = reinterpret_cast<void* (*)()>(dlsym(RTLD_DEFAULT, "PyEval_SaveThread"));
    if (isHeld && isReady && release && isReady() && isHeld())
    {
      this->Thread = release();
    }
  }
  ~WithoutPython()
  {
    if (this->Thread)
    {
      reinterpret_cast<void (*)(void*)>(dlsym(RTLD_DEFAULT, "PyEval_RestoreThread"))(this->Thread);
    }
  }
  WithoutPython(const WithoutPython&) = delete;
  WithoutPython& operator=(const WithoutPython&) = delete;

private:
  void* Thread = nullptr;
};

} // namespace

vtkShapeTurn::vtkShapeTurn(vtkAlgorithm* filter, vtkMultiProcessController* controller)
{
  if (controller && controller->GetNumberOfProcesses() > 1)
  {
    return;
  }
  this->IsMine = Turns().try_lock();
  if (this->IsMine)
  {
    return;
  }
  const WithoutPython released;
  while (!Turns().try_lock_for(std::chrono::milliseconds(50)))
  {
    if (filter->GetAbortExecute())
    {
      throw shape::Aborted();
    }
  }
  this->IsMine = true;
}

vtkShapeTurn::~vtkShapeTurn()
{
  if (this->IsMine)
  {
    Turns().unlock();
  }
}
