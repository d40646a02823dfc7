"""Whole processes, timed in turn, and their figures as tables."""

import os
import statistics
import subprocess
import sys
import time


def run(command, log, environment=None):
    """Run a command; its seconds, its processor seconds, and the memory of its largest process, MB."""
    began = time.monotonic()
    with open(log, "w", encoding="utf-8") as file, \
            subprocess.Popen(command, stdout=file, stderr=file,
                             env={**os.environ, **(environment or {})}) as child:
        _, status, used = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode != 0:
        sys.exit(f"{os.path.basename(sys.argv[0])}: error: {' '.join(command)} failed: {log}")
    return time.monotonic() - began, used.ru_utime + used.ru_stime, used.ru_maxrss/1024


def short(x):
    """Three significant digits, whole from 100 on."""
    return f"{x:.0f}" if abs(x) >= 100 else f"{x:.3g}"


def spread_text(middle, low, high):
    """`middle (low-high)`, or the one number."""
    return f"{middle:.4g}" if low == high else f"{short(middle)} ({short(low)}-{short(high)})"


def spread(values):
    """Median, and in brackets the least and the largest."""
    return spread_text(statistics.median(values), min(values), max(values))


def heading(repetitions):
    """How often, when, and how busy the machine is."""
    return (f"{repetitions} repetitions on {time.strftime('%Y-%m-%d')}; load of the machine at the end "
            f"{os.getloadavg()[0]:.1f}.\n\n")


def show(path, text):
    """Write a table and print it."""
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    print(text + f"written: {path}")
