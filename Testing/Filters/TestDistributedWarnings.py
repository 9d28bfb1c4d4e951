"""In parallel the first process shows the warnings of all processes: the OpenCL device of the last process fails,
and its processor computes the sums.

Run by CTest under pvpython on one process, which is the last one, too, and under pvbatch --sym on two."""
import contextlib
import ctypes
import os
import resource

from vtkmodules.vtkCommonDataModel import vtkPolyData
import shapemap

import shapetesting
from shapetesting import fact, facts, points, read

processes, rank = shapetesting.parallel()
surface = read('DentedSphere600.vtp')
charges = read('DentedSphereCharges.vtp') if rank == 0 else vtkPolyData()


def moved(device):
    return shapetesting.outputs(
        shapetesting.new(shapemap.vtkShapeApplyVolumeMap, surface, charges, Device=device))[0]


def load_driver():
    opencl, platform, devices = ctypes.CDLL('libOpenCL.so.1'), ctypes.c_void_p(), ctypes.c_uint()
    assert opencl.clGetPlatformIDs(1, ctypes.byref(platform), None) == 0
    every_type = ctypes.c_ulong(0xFFFFFFFF)
    assert opencl.clGetDeviceIDs(platform, every_type, 0, None, ctypes.byref(devices)) == 0


@contextlib.contextmanager
def no_more_files():
    """Nothing can be opened."""
    soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    resource.setrlimit(resource.RLIMIT_NOFILE, (max(map(int, os.listdir('/proc/self/fd'))) + 1, hard))
    held = []
    with contextlib.suppress(OSError):
        while True:
            held.append(os.open(os.devnull, os.O_RDONLY))
    yield
    for each in held:
        os.close(each)
    resource.setrlimit(resource.RLIMIT_NOFILE, (soft, hard))


by_processor = moved(1)
load_driver()
# Without files, it cannot compile.
with no_more_files() if rank == processes - 1 else contextlib.nullcontext():
    by_device = moved(2)

warning = fact(by_device, 'ApplyVolumeMap.Warning')
assert warning.count('the OpenCL device failed') == 1, warning
assert facts(by_processor).GetAbstractArray('ApplyVolumeMap.Warning') is None
difference = abs(points(by_device) - points(by_processor)).max()
assert (difference == 0.0) == (rank == processes - 1) and difference < 1e-13, difference
