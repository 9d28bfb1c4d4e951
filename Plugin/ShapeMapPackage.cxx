#include "ShapeMapPackage.h"

#include "vtkPythonInterpreter.h"
#include "vtksys/SystemTools.hxx"

#include <dlfcn.h>

void AddShapeMapPackage()
{
  Dl_info plugin;
  if (dladdr(reinterpret_cast<const void*>(&AddShapeMapPackage), &plugin))
  {
    const std::string folder =
      vtksys::SystemTools::GetFilenamePath(vtksys::SystemTools::GetRealPath(plugin.dli_fname));
    const std::string packages =
      vtksys::SystemTools::CollapseFullPath(SHAPEMAP_PLUGIN_TO_PYTHON, folder);
    vtkPythonInterpreter::PrependPythonPath(packages.c_str());
  }
}
