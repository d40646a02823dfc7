"""Restart files of ccx: which steps do they hold?

A restart file is a sequence of Fortran records; each finished step begins with a record of the
version and ends with four of known length."""

import os
import struct

# Bytes of the last records of a step: two reals, four characters, the time, two integers
LAST_RECORDS = [16, 4, 8, 8]


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
    fresh, lengths = False, []
    try:
        for head, length in records(path):
            if head.startswith(b"Version"):
                complete = step             # the block before has come to its end
                fresh, lengths = True, []
            elif fresh:
                step = struct.unpack("=i", head[:4])[0] if length == 4 else 0
                fresh = False
            lengths = lengths[-3:] + [length]
    except (OSError, struct.error):
        return 0
    return step if lengths == LAST_RECORDS and not fresh else complete
