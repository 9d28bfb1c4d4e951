#pragma once

/// Makes the Python package shapemap, which is built and installed beside the plugin, importable in
/// the process that loads the plugin: in the window, pvpython, pvbatch and pvserver.
void AddShapeMapPackage();
