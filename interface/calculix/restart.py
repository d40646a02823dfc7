"""Restart files of ccx: which steps do they hold?

A restart file is a sequence of Fortran records; each finished step begins with a record of the
version and ends with a record of two integers."""

import os
import struct


def records(path):
    """Yield (first bytes, length) of every complete Fortran record."""
    with open(path, "rb") as file:
        whole = os.fstat(file.fileno()).st_size
        while True:
            head, length = b"", 0
            while True:                     # records beyond 2 GB come in several pieces
                mark = file.read(4)
                if len(mark) < 4:
                    return
                size = struct.unpack("=i", mark)[0]
                start = file.tell()
                if start + abs(size) + 4 > whole:
                    return
                if not head:
                    head = file.read(min(abs(size), 16))
                file.seek(start + abs(size) + 4)
                length += abs(size)
                if size >= 0:
                    break
            yield head, length


def last_step(path):
    """Number of the last step that is complete in a restart file, 0 if there is none."""
    complete = step = 0
    fresh, length = False, 0
    try:
        for head, length in records(path):
            if head.startswith(b"Version"):
                complete = step             # the block before has come to its end
                fresh = True
            elif fresh:
                step = struct.unpack("=i", head[:4])[0] if length == 4 else 0
                fresh = False
    except (OSError, struct.error):
        return 0
    # the last block is complete if the file ends with irstrt(1:2), and nothing hangs over
    if step and not fresh and length == 8 and ends_with_record(path, 8):
        return step
    return complete


def ends_with_record(path, length):
    """Does a file end with a record of this length?"""
    with open(path, "rb") as file:
        size = os.fstat(file.fileno()).st_size
        if size < length + 8:
            return False
        file.seek(size - length - 8)
        data = file.read()
    mark = struct.pack("=i", length)
    return data[:4] == mark and data[-4:] == mark
