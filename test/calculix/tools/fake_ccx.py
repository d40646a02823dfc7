#!/usr/bin/env python3
"""What the runner's tests start in place of ccx: it computes nothing and says what ccx would say.

The environment variable FAKE is a list of `what=step:increment` separated by blanks:
   vanish   no contact springs from there on        return   they are back from there on
   few      a tenth of the springs from there on    small    the increment shrinks to the minimum
   killed   ends itself by SIGKILL                  hang     waits there for a minute
   cutback  the increment needs a second attempt    slow     a pause in every increment
   error    fails while it reads the deck           silent   ends there without a word
   stock    knows nothing of UINTER
   late     an *ERROR at the end, with status 0     none     there are never any springs
"""

import os
import re
import signal
import struct
import sys
import time

INCREMENTS = 4


def record(data):
    mark = struct.pack("=i", len(data))
    return mark + data + mark


def restart_file(step):
    """As ccx' begins and ends, with something in between."""
    return (record(b"Version 2.20".ljust(80)) + record(struct.pack("=i", step))
            + record(bytes(800)) + record(bytes(16)) + record(b"asc ")
            + record(struct.pack("=d", step)) + record(struct.pack("=2i", 1, 1)))


def name_of_job():
    """ccx cuts it at a blank."""
    return sys.argv[sys.argv.index("-i") + 1].split()[0]


def main():
    job = name_of_job()
    with open(job + ".inp", encoding="utf-8") as file:
        deck = file.read()
    fake = dict((word.split("=") + ["1:1"])[:2] for word in os.environ.get("FAKE", "").split())
    places = {name: tuple(map(int, place.split(":"))) for name, place in fake.items()}
    print("\nCalculiX Version 2.20, a fake\n")
    if "error" in places:
        for element in range(1, 40):
            print(f" *ERROR in calinput: no material was assigned\n        to element {element}")
        print(" *ERROR reading *BOUNDARY: node set NONE\n        has not yet been defined. \n")
        print(" *ERROR reading *BOUNDARY. Card image:\n        NONE,1,3\n")
        return 201
    resumed = re.match(r"\*RESTART,READ,STEP=(\d+)", deck)
    first = 1
    if resumed:
        first = int(resumed[1]) + 1
        with open(job + ".rin", "rb") as file:
            if file.read() != restart_file(first - 1):
                print(" *ERROR reading *RESTART,READ: requested step\n        is not in the file")
                return 201
    steps = len(re.findall(r"^\*STEP", deck, re.M))
    print(" *WARNING reading *NOTHING: parameter not recognized\n")
    with open(job + ".dat", "w", encoding="ascii") as table:
        for step in range(first, first + steps):
            status = run_step(step, places, table)
            if status is not None:
                return status
            with open("temporaryrestartfile", "wb") as file:
                file.write(restart_file(step))
            os.replace("temporaryrestartfile", job + ".rout")
    if "late" in places:
        print(" *ERROR in something\n")
    if "ASPERITY_CALCULIX_POISON" in os.environ and "stock" not in places:
        print(" asperity: UINTER leaves unset, as it may: SPD SVD\n")
    print("\n Job finished\n\n asperity: 1200 calls of UINTER took .002 s\n")
    return 0


def springs_at(place, places):
    count = 0 if "none" in places else 50
    if place >= places.get("few", (99, 0)):
        count = 5
    if places.get("vanish", (99, 0)) <= place < places.get("return", (99, 0)):
        count = 0
    return count


def run_step(step, places, table):
    print(f"\n STEP{step:13d}\n\n Static analysis was selected\n")
    for increment in range(1, INCREMENTS + 1):
        place = (step, increment)
        if place == places.get("hang"):
            sys.stdout.flush()
            time.sleep(60)
        if place == places.get("killed"):
            sys.stdout.flush()
            os.kill(os.getpid(), signal.SIGKILL)
        if place == places.get("silent"):
            return 0
        if "slow" in places:
            time.sleep(0.15)
        attempts = 2 if place == places.get("cutback") else 1
        for attempt in range(1, attempts + 1):
            iterate(place, attempt, springs_at(place, places))
            if attempt < attempts:
                print(" no convergence\n\n divergence; the increment size is decreased to 0.1\n"
                      " the increment is reattempted\n")
        if place == places.get("small"):
            print(" no convergence\n\n\n *ERROR: increment size smaller than minimum\n"
                  " best solution and residuals are in the frd file\n")
            return 201
        print(" convergence; the increment size is increased to 3.75e-01\n")
        total = step - 1 + increment/INCREMENTS
        side = 1.0 if step % 2 else -1.0
        table.write(f"\n total force (fx,fy,fz) for set TIP and time  {total:.7E}\n\n"
                    f"        0.000000E+00  1.000000-104 {50.0*side*increment:13.6E}\n"
                    f"\n displacements (vx,vy,vz) for set TIP and time  {total:.7E}\n\n"
                    f"      1001  0.000000E+00  0.000000E+00 {side*increment*0.5:13.6E}\n"
                    f"      1002  0.000000E+00  0.000000E+00 {side*increment*1.5:13.6E}\n")
        table.flush()
        if "ASPERITY_CALCULIX_STATES" in os.environ and "stock" not in places:
            write_states(*place, total)
        if place > places.get("vanish", (99, 0)):
            with open("went_on", "w", encoding="ascii"):
                pass
    return None


def write_states(step, increment, total):
    path = name_of_job() + ".states.csv"
    first = not os.path.exists(path)
    with open(path, "a", encoding="ascii") as table:
        if first:
            table.write("step,increment,time,pair,node,statev_1,statev_2\n")
        table.write(f"{step},{increment},{total},TOP,1001,{10*step + increment},.5\n")


def iterate(place, attempt, springs):
    step, increment = place
    print(f" increment {increment} attempt {attempt} \n increment size= 2.500000e-01\n"
          f" sum of previous increments={(increment - 1)/INCREMENTS:e}\n"
          f" actual step time={increment/INCREMENTS:e}\n"
          f" actual total time={step - 1 + increment/INCREMENTS:e}\n")
    for iteration in (1, 2):
        print(f" iteration {iteration}\n\n Number of contact spring elements={springs}\n\n"
              " average force= 0.448436\n time avg. forc= 0.448436\n"
              " largest residual force= 0.003939 in node 1007 and dof 3\n"
              " largest increment of disp= 3.398250e-02\n"
              " largest correction to disp= 3.398250e-02 in node 1006 and dof 3\n")
        if iteration == 1:
            print(" no convergence\n")
    sys.stdout.flush()


if __name__ == "__main__":
    sys.exit(main())
