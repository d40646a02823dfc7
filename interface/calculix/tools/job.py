"""One run of ccx: started on a terminal of its own, so that its lines come at once."""

import os
import select
import shutil
import signal
import subprocess
import sys
import time

try:
    import fcntl
    import pty
    import termios
except ImportError:                         # no POSIX system
    pty = None


class Job:
    """A ccx process. lines() yields what it prints."""

    def __init__(self, program, name, folder, variables):
        environment = {"OMP_NUM_THREADS": "1", **os.environ, **variables}
        self.started = time.monotonic()
        # ccx puts its output into the folder it runs in
        command, options = [program, "-i", name], {"cwd": folder, "env": environment,
                                                   "stdin": subprocess.DEVNULL}
        self._reader, writer = _terminal()
        if writer is None:
            self._start_on_pipe(command, environment, options)
            return
        try:
            # the session ends, and ccx with it, when the runner is killed
            self.process = subprocess.Popen(
                command, stdout=writer, stderr=writer, start_new_session=True,
                preexec_fn=_own_terminal(writer), **options)
        except OSError:
            os.close(self._reader)
            raise
        finally:
            os.close(writer)

    def _start_on_pipe(self, command, environment, options):
        """Where there is no terminal. C and Fortran each keep back what they write, unless told
        otherwise: lines would come late, and not in their order."""
        environment["GFORTRAN_UNBUFFERED_PRECONNECTED"] = "y"
        line_by_line = shutil.which("stdbuf")
        if line_by_line:
            command = [line_by_line, "-oL", "-eL", *command]
        self.process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                        **options)
        self._reader = os.dup(self.process.stdout.fileno())
        self.process.stdout.close()

    def lines(self, seconds=1.0):
        """Yield lines, and None when there was none for so many seconds."""
        pending = b""
        while True:
            if not select.select([self._reader], [], [], seconds)[0]:
                yield None
                continue
            try:
                data = os.read(self._reader, 65536)
            except OSError:                 # how a terminal says that its other end is gone
                data = b""
            if not data:
                break
            *whole, pending = (pending + data).split(b"\n")
            for line in whole:
                yield line.decode("utf-8", "replace").rstrip("\r")
        if pending:
            yield pending.decode("utf-8", "replace")

    def wall_seconds(self):
        return time.monotonic() - self.started

    def cpu_seconds(self):
        """Processor time so far, of all threads; nan where the system does not tell."""
        try:
            with open(f"/proc/{self.process.pid}/stat", encoding="ascii", errors="replace") as file:
                fields = file.read().rpartition(")")[2].split()
            return (int(fields[11]) + int(fields[12]))/os.sysconf("SC_CLK_TCK")
        except (OSError, ValueError, IndexError):
            return float("nan")

    def wait(self):
        """Exit status, negative if by a signal."""
        status = self.process.wait()
        os.close(self._reader)
        return status

    def stop(self):
        """End ccx if it still runs."""
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGTERM)
            try:
                self.process.wait(5)
            except subprocess.TimeoutExpired:
                self.process.kill()


def _terminal():
    """Both ends of a new terminal, or (None, None): a minimal container may have none."""
    try:
        return pty.openpty() if pty else (None, None)
    except OSError:
        return None, None


def _own_terminal(descriptor):
    """What makes the new terminal the one that controls the process."""
    if not hasattr(termios, "TIOCSCTTY") or not sys.platform.startswith("linux"):
        return None
    return lambda: fcntl.ioctl(descriptor, termios.TIOCSCTTY, 0) and None
