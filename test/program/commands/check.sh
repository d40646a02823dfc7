# asperity check: routines with one fault each, right ones, asperity's own, and what is no routine

routines=$root/test/check/routines
own=$root/interface/abaqus/ready
export TMPDIR=$PWD/tmp
mkdir tmp results
saved_compiler=${FC:-}
if ! command -v gfortran >/dev/null; then
   skip check 'there is no gfortran'
   return 0
fi
export FC=gfortran

# head_of FILE WORD: what a comment `! WORD: ...` at the head of a routine says
head_of() { sed -n "1,5s/^[!C] $2: *//p" "$1"; }

# check_file NAME FILE OPTION...: check a file, with all that comes of it in results/NAME.*
check_file() {
   local name=$1
   shift
   limited "$program" check "$@" --csv "results/$name.csv" --json "results/$name.json" \
      >"results/$name.out" 2>"results/$name.err" </dev/null
   echo $? >"results/$name.status"
}

# Several at a time: most of it is compiling
jobs_at_once=$(nproc)
start() {
   while [ "$(jobs -rp | wc -l)" -ge "$jobs_at_once" ]; do wait -n; done
   check_file "$@" &
}
for file in "$routines"/wrong/* "$routines"/right/*; do
   # shellcheck disable=SC2046  # several options
   start "$(basename "$(dirname "$file")")-$(basename "$file")" "$file" $(head_of "$file" check)
done
# asperity's own, as users have them, with PROPS of the paper's pair
for file in asperity_uinter.f90 asperity_uinter.f asperity_vuinter.f90 asperity_vuinter_single.f90; do
   precision=double
   [ "$file" = asperity_vuinter_single.f90 ] && precision=single
   start "own-$file" "$own/$file" --precision $precision --nstatv 11 \
      --properties 0.5,0.31,206,297,3.14159265,0.1477,24.53,0.4,0.0593,0.2372,1,1
done
wait

# of these runs, whose own is in results
status=-

# finds NAME FILE: the findings are all of the rule that the file names, the worst of its severity
finds() {
   local rule severity found
   read -r rule severity <<<"$(head_of "$2" finds)"
   found=$(python3 - "results/$1.csv" <<'PYTHON'
import csv, sys
rows = list(csv.DictReader(open(sys.argv[1])))
print(*sorted({row['rule'] for row in rows}), next((s for s in ('error', 'warning', 'note') for row in rows if row['severity'] == s), ''))
PYTHON
   )
   echo "$found, not $rule $severity"
   [ "$found" = "$rule $severity" ] && [ "$(cat "results/$1.status")" -eq "$([ "$severity" = error ] && echo 1 || echo 0)" ]
}
# clean NAME: no finding
clean() {
   cat "results/$1.err" "results/$1.csv"
   [ "$(cat "results/$1.status")" -eq 0 ] && [ ! -s "results/$1.err" ] && [ "$(wc -l <"results/$1.csv")" -eq 1 ]
}
for file in "$routines"/wrong/*; do
   name=$(basename "$file")
   check "check: $name is found by its rule alone" finds "wrong-$name" "$file"
done
for file in "$routines"/right/*; do
   name=$(basename "$file")
   check "check: $name is clean" clean "right-$name"
done
for file in asperity_uinter.f90 asperity_uinter.f asperity_vuinter.f90 asperity_vuinter_single.f90; do
   check "check: $file is clean" clean "own-$file"
done
# every rule has a routine with its fault
cat "$routines"/wrong/* | sed -n 's/^[!C] finds: *//p' >faults
for rule in $(of_json results/wrong-prints.f.json rules rule); do
   check "check: rule $rule has a wrong routine" grep -q "^$rule " faults
done

# A shared library has no list of arguments, and is taken as it is
base=$routines/wrong/statics.f
mkdir user
sed '/NCALLS/d' "$base" >user/right.f
printf '      implicit real*8(a-h,o-z)\n' >ABA_PARAM.INC
gfortran -shared -fPIC user/right.f -I. -o user/right.so
rm ABA_PARAM.INC
before=$(cksum user/*; ls -A user)
run check user/right.f --properties 100 --nstatv 1 --json source.json
check 'check: a source of the user' is_quiet
run check user/right.so --properties 100 --nstatv 1 --json library.json
check 'check: its shared library' is_quiet
check 'check: of a library two rules are not tried' test "$(of_json library.json rules result | grep -c 'nottried')" -eq 2
check 'check: and this is said' has out 'argument_list and uninitialised are not tried'
check 'check: nothing of the user is changed' test "$before" = "$(cksum user/*; ls -A user)"

# A folder for what is temporary that is relative, and whose name is of the linker's signs
mkdir 'tmp/a b,c'
TMPDIR='tmp/a b,c' run check user/right.f --properties 100 --nstatv 1
check 'check: any folder in TMPDIR' is_quiet
rmdir 'tmp/a b,c'

# It ends as XIT does, and says nothing
sed "s/NCALLS = NCALLS + 1/CALL EXIT(201)/" "$base" >exit.f
run check exit.f --properties 100 --nstatv 1 --csv exit.csv
check 'check: a silent end' test "$status" -eq 1 -a "$(csv_column exit.csv rule | head -1)" = crash

# Memory
sed 's/STIFF = PROPS(1)/CALL KBIG(STIFF,PROPS(1))/' user/right.f >memory.f
cat >>memory.f <<'TEXT'
      SUBROUTINE KBIG(X,Y)
      INCLUDE 'ABA_PARAM.INC'
      ALLOCATABLE A(:)
      ALLOCATE (A(200000000))
      A(1) = Y
      X = A(1)
      END
TEXT
run check memory.f --properties 100 --nstatv 1 --memory-limit 1000
check 'check: more memory than it may take' test "$status" -eq 1 -a -n "$(grep -o 'Error allocating 1600000000 bytes' out)"

# UEXTERNALDB of the same file is called: without it the stiffness is zero
sed '/STIFF = PROPS/d' "$routines/wrong/common.f" >uexternaldb.f
run check uexternaldb.f --properties 100 --nstatv 1 --csv without.csv
check 'check: without UEXTERNALDB no traction' has without.csv no_traction
cat >>uexternaldb.f <<'TEXT'
      SUBROUTINE UEXTERNALDB(LOP,LRESTART,TIME,DTIME,KSTEP,KINC)
      INCLUDE 'ABA_PARAM.INC'
      DIMENSION TIME(2)
      COMMON /KPENALTY/ STIFF
      IF (LOP .EQ. 0) STIFF = 100.D0
      END
TEXT
run check uexternaldb.f --properties 100 --nstatv 1 --csv with.csv
check 'check: UEXTERNALDB is called' test "$status" -eq 0 -a "$(csv_column with.csv rule)" = common
check 'check: and this is said' has out 'UEXTERNALDB of the same file is called'

# Utilities of ABAQUS are there; a warning is no fault
sed -e 's/(-2,/(-1,/; /CALL XIT/d' "$routines/wrong/crash_xit.f" >warning.f
run check warning.f --properties 100 --nstatv 1
check 'check: a routine that warns through ABAQUS' is_quiet
check 'check: the message of an error is shown' has "results/wrong-crash_xit.f.out" 'THE FACES TOUCH AT NODE 1'

# What is found is said with its place
# gfortran's library tells where a program of its own was
place='trial drive'
grep -aq _gfortran_set_options "$program" && place='line 44'
check 'check: the place of a crash' has results/wrong-crash.f90.out "crash          $place"
check 'check: the variable that is not set' has results/wrong-uninitialised.f90.out "'damage' is used uninitialized"
check 'check: JSON has the findings of the CSV' python3 -c '
import csv, json
rows = list(csv.DictReader(open("results/wrong-prints.f.csv")))
data = json.load(open("results/wrong-prints.f.json"))["data"]
assert rows and all([row[name] for row in rows] == data[name] for name in rows[0]), data'
run check "$routines/wrong/crash_stop.f" --properties 100 --nstatv 1
check 'check: errors have status 1' test "$status" -eq 1 -a "$(cat err)" = \
   "asperity: error: $routines/wrong/crash_stop.f: 1 error found"
check 'check: after the first crash the rest is not run' has out 'Not tried: unset_output'
printf 'time (s),overclosure (mm),slip_1 (mm)\n1,-0.01,0\n2,0.02,0\n3,0.05,0.01\n4,0.03,0.02\n5,-0.01,0.02\n' >path.csv
run check user/right.f --properties 100 --nstatv 1 --path path.csv
check 'check: along a path of the user' is_quiet

# What is no routine
cat >empty.f <<'TEXT'
      subroutine other
      end
TEXT
refuses 'check: no routine is given' 2 'no routine is given: asperity check ROUTINE' check
refuses 'check: no such file' 3 'none.f: there is no such file' check none.f
refuses 'check: no UINTER' 2 'empty.f has no subroutine UINTER' check empty.f
cat "$base" "$base" >two.f
refuses 'check: two UINTERs' 2 'two.f has 2 subroutines UINTER, at line 4 and at line' check two.f
sed 's/UINTER/VUINTER/' "$base" | cat "$base" - >both.f
refuses 'check: UINTER and VUINTER' 2 'both.f has both UINTER and VUINTER: name one by --routine' \
   check both.f
sed 's/NCALLS = NCALLS + 1/NCALLS = = 1/' "$base" >faulty.f
refuses 'check: does not compile' 2 'faulty.f: does not compile: line 19: ' check faulty.f
FC=$PWD/none refuses 'check: no compiler' 2 'the compiler .*/none does not run; install gfortran' check "$base"
FC=cat refuses 'check: another compiler' 2 'FC = cat is not gfortran' check "$base"
cp empty.f text.so
refuses 'check: no shared library' 2 'text.so: nm of the GNU binutils finds no symbols' check text.so
gfortran -shared -fPIC empty.f -o other.so
refuses 'check: a library without UINTER' 2 'other.so has no subroutine UINTER' check other.so
cp empty.f empty.txt
refuses 'check: no Fortran by its ending' 2 'empty.txt is no Fortran by its ending' check empty.txt
refuses 'check: ndir' 2 '--ndir: ndir = 4 is not allowed: 2, 3, or 0' check "$base" --ndir 4
refuses 'check: nstatv' 2 '--nstatv: nstatv = -1 is not allowed' check "$base" --nstatv -1
refuses 'check: sizes' 2 '--largest-slip: largest_slip = 0.0 is not allowed: it must be a number above zero' check "$base" --largest-slip 0
refuses 'check: little memory' 2 '--memory-limit: memory_limit = 199 is not allowed: at least 200' \
   check "$base" --memory-limit 199
refuses 'check: no time' 2 '--time-limit: time_limit = 0 is not allowed: at least 1' check "$base" --time-limit 0
refuses 'check: no path' 3 'none.csv' check "$base" --path none.csv
sed 's/CALL XIT/CALL GETVRM/' "$routines/wrong/crash_xit.f" >getvrm.f
refuses 'check: a routine of ABAQUS that needs a model' 2 'getvrm.f calls GETVRM' check getvrm.f \
   --properties 100 --nstatv 1
mkfifo pipe.f
refuses 'check: a pipe' 3 'pipe.f is a folder, pipe or device, and no file' check pipe.f
printf '#!/bin/sh\ncase $* in *auto-var*) echo "unrecognized option -ftrivial-auto-var-init=zero"; exit 1;; esac\nexec gfortran "$@"\n' >old
chmod +x old
FC=$PWD/old refuses 'check: an old gfortran' 2 '.*/old does not know .*: gfortran 12 or a later one' check "$base"
printf '#!/bin/sh\n[ "$1" = --version ] && exec gfortran "$1"\nexit 1\n' >mute
printf '#!/bin/sh\n[ "$1" = --version ] && exec gfortran "$1"\nkill -KILL 0\n' >killed
chmod +x mute killed
FC=$PWD/mute refuses 'check: a compiler that says nothing' 3 '.*: the compiler fails and says nothing; it needs space in' check "$base"
FC=$PWD/killed refuses 'check: a compiler that is ended' 3 '.*/killed was not run to its end: it needs space in' check "$base"
TMPDIR=$PWD/none refuses 'check: no temporary folder' 3 '.*/none: no temporary folder can be created there' \
   check "$base"

# An interrupt ends the child and removes the folder
"$program" check "$routines/wrong/timeout.f" --properties 2 --nstatv 1 --time-limit 100 >/dev/null 2>&1 &
interrupted=$!
for _ in $(seq 100); do [ -e "$(echo tmp/asperity-*/output)" ] && break; sleep 0.1; done
sleep 1
kill -TERM "$interrupted"
wait "$interrupted"
status=$?
check 'check: an interrupt ends it' test "$status" -eq 143
check 'check: and its children' test -z "$(ps -eo args | grep '[t]imeout.f --properties 2 --nstatv 1 --time-limit 100')"
check 'check: nothing is left in TMPDIR' test -z "$(ls -A tmp)"
# at any time, by Ctrl-C as well, which all processes of the terminal get
cat >interrupts.py <<'PYTHON'
import os, signal, subprocess, sys, time
for number in (signal.SIGINT, signal.SIGHUP):
    for delay in (0.02, 0.06, 0.12, 0.25, 0.4):
        process = subprocess.Popen(sys.argv[1:], start_new_session=True, stdout=subprocess.DEVNULL,
                                   preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))
        time.sleep(delay)
        os.killpg(process.pid, number)
        assert process.wait() == -number, (number, delay, process.returncode)
        assert not os.listdir('tmp'), (number, delay, os.listdir('tmp'))
PYTHON
check 'check: an interrupt at any time' python3 interrupts.py "$program" check \
   "$routines/wrong/timeout.f" --properties 2 --nstatv 1 --time-limit 101
# Killed, it takes its child with it
"$program" check "$routines/wrong/timeout.f" --properties 2 --nstatv 1 --time-limit 102 >/dev/null 2>&1 &
killed=$!
for _ in $(seq 100); do [ "$(ps -eo args | grep -c '[t]imeout.f .*--time-limit 102')" -eq 2 ] && [ -e "$(echo tmp/asperity-*/routine_1.so)" ] && break; sleep 0.1; done
sleep 1
kill -KILL "$killed"
wait "$killed" 2>/dev/null
sleep 0.3
check 'check: killed, it leaves no child' test -z "$(ps -eo args | grep '[t]imeout.f .*--time-limit 102')"
rm -r tmp/asperity-*
unset TMPDIR
export FC=$saved_compiler
