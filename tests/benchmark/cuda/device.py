# SPDX-License-Identifier: MIT
"""A card of NVIDIA by its driver alone (libcuda): memory, modules, launches, events. Every call's answer is checked.

    card = device.Card()
    kernel = card.module("robot.cubin").kernel("ns_jacobian_batch")
    q = card.array(host)                     # freed with the object
    kernel(n, [n, q, result])                # the arguments behind one another: integers, floats, bytes, arrays
"""
import ctypes
import statistics

import numpy as np

BLOCK = 128


class NoCard(Exception):
    """Says why there is no card to run on."""


class Array:
    """Memory of the card: `size` bytes."""

    def __init__(self, card, size):
        self.card, self.size, self.place = card, size, ctypes.c_uint64()
        card.call("cuMemAlloc_v2", ctypes.byref(self.place), ctypes.c_size_t(max(1, size)))

    def __del__(self):
        self.card.cuda.cuMemFree_v2(self.place)

    def fill(self, byte):
        self.card.call("cuMemsetD8_v2", self.place, ctypes.c_ubyte(byte), ctypes.c_size_t(self.size))

    def put(self, host, at=0):
        self.card.call("cuMemcpyHtoD_v2", ctypes.c_uint64(self.place.value + at), ctypes.c_void_p(host.ctypes.data),
                       ctypes.c_size_t(host.nbytes))

    def get(self, shape, kind, at=0):
        host = np.empty(shape, kind)
        self.card.call("cuMemcpyDtoH_v2", ctypes.c_void_p(host.ctypes.data), ctypes.c_uint64(self.place.value + at),
                       ctypes.c_size_t(host.nbytes))
        return host


class Kernel:
    """A kernel; its registers, and bytes of the stack with spills."""

    def __init__(self, card, handle):
        self.card, self.handle = card, handle
        self.registers, self.stack = self._attribute(4), self._attribute(3)

    def _attribute(self, which):
        value = ctypes.c_int()
        self.card.call("cuFuncGetAttribute", ctypes.byref(value), ctypes.c_int(which), self.handle)
        return value.value

    def __call__(self, n, arguments, block=BLOCK):
        kept = [self._cell(each) for each in arguments]
        pointers = (ctypes.c_void_p * len(kept))(*(ctypes.addressof(each) for each in kept))
        self.card.call("cuLaunchKernel", self.handle, max(1, -(-n // block)), 1, 1, block, 1, 1, 0, None, pointers, None)

    @staticmethod
    def _cell(value):
        if isinstance(value, Array):
            return value.place
        if isinstance(value, bytes):
            return ctypes.create_string_buffer(value, len(value))
        return {int: ctypes.c_size_t, np.float64: ctypes.c_double, np.float32: ctypes.c_float}[type(value)](value)


class Module:
    def __init__(self, card, path):
        self.card, self.handle = card, ctypes.c_void_p()
        card.call("cuModuleLoad", ctypes.byref(self.handle), str(path).encode())

    def kernel(self, name):
        handle = ctypes.c_void_p()
        self.card.call("cuModuleGetFunction", ctypes.byref(handle), self.handle, name.encode())
        return Kernel(self.card, handle)


class Card:
    def __init__(self):
        try:
            self.cuda = ctypes.CDLL("libcuda.so.1")
        except OSError as error:
            raise NoCard(f"the driver of NVIDIA is not there: {error}") from None
        self.cuda.cuMemFree_v2.restype = ctypes.c_int
        if answer := self.cuda.cuInit(0):
            raise NoCard(f"the driver finds no card: cuInit gives {answer}")
        number, context = ctypes.c_int(), ctypes.c_void_p()
        self.call("cuDeviceGet", ctypes.byref(number), 0)
        self.call("cuDevicePrimaryCtxRetain", ctypes.byref(context), number)
        self.call("cuCtxSetCurrent", context)
        name, values = ctypes.create_string_buffer(100), [ctypes.c_int(), ctypes.c_int()]
        self.call("cuDeviceGetName", name, 100, number)
        for value, which in zip(values, (75, 76)):
            self.call("cuDeviceGetAttribute", ctypes.byref(value), which, number)
        self.name, self.architecture = name.value.decode(), f"sm_{values[0].value}{values[1].value}"

    def call(self, function, *arguments):
        if answer := getattr(self.cuda, function)(*arguments):
            text = ctypes.c_char_p()
            self.cuda.cuGetErrorString(answer, ctypes.byref(text))
            raise RuntimeError(f"{function}: {(text.value or b'unknown').decode()} ({answer})")

    def module(self, path):
        return Module(self, path)

    def array(self, host):
        array = Array(self, host.nbytes)
        array.put(host)
        return array

    def empty(self, size):
        return Array(self, size)

    def free_bytes(self):
        free, total = ctypes.c_size_t(), ctypes.c_size_t()
        self.call("cuMemGetInfo_v2", ctypes.byref(free), ctypes.byref(total))
        return free.value

    def finish(self):
        self.call("cuCtxSynchronize")

    def pinned(self, size):
        """Returns bytes of the host that the card reads and writes directly."""
        place = ctypes.c_void_p()
        self.call("cuMemHostAlloc", ctypes.byref(place), ctypes.c_size_t(size), ctypes.c_uint(0))
        return np.ctypeslib.as_array((ctypes.c_ubyte * size).from_address(place.value))

    def seconds(self, work, repeats=15):
        """Returns the median time of `work`, by events, after two runs that do not count."""
        events = [ctypes.c_void_p(), ctypes.c_void_p()]
        for event in events:
            self.call("cuEventCreate", ctypes.byref(event), ctypes.c_uint(0))
        times = []
        for _ in range(repeats + 2):
            self.call("cuEventRecord", events[0], None)
            work()
            self.call("cuEventRecord", events[1], None)
            self.call("cuEventSynchronize", events[1])
            passed = ctypes.c_float()
            self.call("cuEventElapsedTime", ctypes.byref(passed), *events)
            times.append(passed.value / 1000)
        for event in events:
            self.call("cuEventDestroy_v2", event)
        return statistics.median(times[2:])
