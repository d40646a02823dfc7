"""Files that are there whole or not at all."""

import contextlib
import os


@contextlib.contextmanager
def whole_file(path):
    """Path of a temporary file of this process alone, which becomes `path` when all went well."""
    path = os.path.realpath(path)
    part = f"{path}.{os.getpid()}.part"
    os.close(os.open(part, os.O_CREAT | os.O_EXCL | os.O_WRONLY, 0o666))
    try:
        yield part
        os.replace(part, path)
    except BaseException:
        os.remove(part)
        raise
