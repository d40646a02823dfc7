# How files are written: under temporary names that nobody else has, through links, into pipes; what
# signals, limits and other processes do meanwhile
run curve --csv plain.csv --json plain.json
cp out table
nothing_else() { ! ls ./*.part 2>/dev/null; }

# Files and links of the user's that look like temporary ones
echo mine >precious
echo mine >own.csv.part
ln -s precious other.csv.part
mkdir folder.csv.part
for name in own other folder; do
   run curve --csv $name.csv
   check "$name.csv is written beside $name.csv.part" cmp $name.csv plain.csv
   check "$name.csv is no link" test ! -L $name.csv
done
check 'the file of that name is what it was' test "$(cat own.csv.part)" = mine
check 'the link of that name too' test "$(readlink other.csv.part)$(cat precious)" = preciousmine
rm -r ./*.part
name=$(printf '%0251d.csv' 0)
run curve --csv "$name"
check 'a name of 255 bytes' cmp "$name" plain.csv

# Links
echo before >keep.csv
ln -s keep.csv link.csv
run curve --csv link.csv
check 'a link stays a link' test "$(readlink link.csv)" = keep.csv
check 'what it points to is written' cmp keep.csv plain.csv
mkdir deeper
ln -s ../deeper/new.csv deeper/inner_link.csv
ln -s deeper/inner_link.csv outer_link.csv
run curve --csv outer_link.csv
check 'what a link to nothing points to is written' cmp deeper/new.csv plain.csv
check 'links to nothing stay links' test -L outer_link.csv -a -L deeper/inner_link.csv
ln -s circle.csv circle.csv
refuses 'a link to itself' 3 '--csv: circle.csv cannot be written: its links lead to each other' \
   curve --csv circle.csv
ln -s nowhere/x.csv lost.csv
refuses 'a link into a folder that is not there' 3 '--csv: lost.csv .*: the folder does not exist' \
   curve --csv lost.csv

# Rights: of a file written plainly, and of the file that was there
(umask 027 && limited "$program" curve --csv new.csv >/dev/null)
check 'rights of a new file follow the umask' test "$(stat -c %a new.csv)" = 640
for rights in 600 664 777; do
   : >keep.csv
   chmod $rights keep.csv
   (umask 077 && limited "$program" curve --csv keep.csv >/dev/null)
   check "rights $rights of an older file stay" test "$(stat -c %a keep.csv)" = $rights -a -s keep.csv
done
if [ "$(id -u)" -ne 0 ]; then
   mkdir locked
   chmod a-w locked keep.csv
   refuses 'folder without permission' 3 '--csv: locked/x.csv cannot be written: Permission' \
      curve --csv locked/x.csv
   refuses 'file without permission' 3 '--csv: keep.csv cannot be written: Permission' \
      curve --csv keep.csv
else
   chown 65534:65533 keep.csv
   run curve --csv keep.csv
   check 'the owner of an older file stays' test "$(stat -c %u:%g keep.csv)" = 65534:65533
   skip 'permissions' 'root has all'
fi

# Pipes and descriptors
mkfifo pipe.csv
limited cat pipe.csv >got &
run curve --csv pipe.csv
wait $!
check 'a named pipe gets the file' cmp got plain.csv
check 'and stays a pipe' test -p pipe.csv
ln -s pipe.csv to_pipe.csv
limited cat pipe.csv >got &
run curve --csv to_pipe.csv --json beside.json
wait $!
check 'a named pipe behind a link' cmp got plain.csv
check 'and a file beside it' cmp beside.json plain.json
mkfifo pipe.svg
refuses 'a picture in a pipe' 2 '--plot: pipe.svg: a picture needs a file' curve --plot pipe.svg
limited "$program" curve --csv >(cat >substituted; echo >substituted.done) >/dev/null 2>&1
for i in $(seq 100); do [ -e substituted.done ] && break; sleep 0.02; done
check 'a process of the shell' cmp substituted plain.csv
echo before >log
limited "$program" curve --csv /dev/stdout --json - >>log 2>err
check '/dev/stdout: what is in the file stays' \
   sh -c '{ echo before; cat plain.csv plain.json; } | cmp - log'
echo before >log
limited "$program" curve --csv /dev/fd/7 7>>log >/dev/null
check '/dev/fd/7: likewise' sh -c '{ echo before; cat plain.csv; } | cmp - log'
refuses 'a descriptor that is not open' 3 '--csv: /dev/fd/77 cannot be written: no such file is' \
   curve --csv /dev/fd/77

# Larger than a file may be, 1 MiB here
echo before >keep.csv
(ulimit -f 1024; limited "$program" curve --separation 0.1:0.2:100000 --csv keep.csv >out 2>err)
status=$?
check 'a file larger than allowed' is_refused 3 '--csv: keep.csv cannot be written: File too large$'
check 'an older file is kept then' test "$(cat keep.csv)" = before
(ulimit -f 1024; limited "$program" curve --separation 0.15:0.2:100000 --csv - >large 2>err)
status=$?
: >out
check 'standard output larger than allowed' is_refused 3 \
   'standard output cannot be written: File too large$'

# Two processes and one file: it is whole, and of one of them
one=(curve --separation 0.1:0.2:2000)
other=(curve --sigma 0.06 --separation 0.05:0.2:2000)
limited "$program" "${one[@]}" --csv one.csv >/dev/null
limited "$program" "${other[@]}" --csv other.csv >/dev/null
of_one() { cmp -s "$1" one.csv || cmp -s "$1" other.csv; }
# at_once COMMAND...: before the program, for 24 processes; the number of those that failed
at_once() {
   local i jobs=() failures=0
   for i in $(seq 12); do
      limited "$@" "$program" "${one[@]}" --csv shared.csv >/dev/null 2>>err_shared & jobs+=($!)
      limited "$@" "$program" "${other[@]}" --csv shared.csv >/dev/null 2>>err_shared & jobs+=($!)
   done
   for i in "${jobs[@]}"; do wait "$i" || failures=$((failures + 1)); done
   return $failures
}
: >err_shared
check '24 processes and one file: all succeed' at_once env
check 'the file is whole' of_one shared.csv
check 'nothing else stays' nothing_else
trace=(strace -qq -o /dev/null -e)
if "${trace[@]}" inject=getppid:error=EPERM true 2>/dev/null; then
   rm -f shared.csv
   check '24 slow processes and one file: all succeed' \
      at_once "${trace[@]}" inject=write:delay_exit=20000
   check 'slow: the file is whole' of_one shared.csv
   check 'slow: nothing else stays' nothing_else
   # What a disk does: fails at some call
   for fault in write:error=ENOSPC fsync:error=EIO rename:error=EBUSY; do
      echo before >keep.csv
      limited "${trace[@]}" inject=$fault:when=1 "$program" curve --csv keep.csv --json faulty.json \
         >out 2>err
      status=$?
      check "$fault: told" is_refused 3 '--(csv|json): .* cannot be written: [A-Z]'
      check "$fault: no result, and the older one kept" \
         sh -c 'test "$(cat keep.csv)" = before && test ! -e faulty.json'
   done
   # Signals while the first of two files is written: both are there, or none
   for signal in HUP INT QUIT USR1 TERM XCPU; do
      limited "${trace[@]}" inject=fsync:signal=$signal "$program" curve --csv s.csv --json s.json \
         >out 2>err
      check "SIG$signal while files are written: whole" \
         sh -c 'cmp s.csv plain.csv && cmp s.json plain.json'
      check "SIG$signal: nothing else stays" nothing_else
      rm -f s.csv s.json
   done
else
   skip 'slow processes, faults of the disk, signals while files are written' \
      'no strace, or it may not trace'
fi

# Two sweeps and one file
sweep=(tenon --amplitudes 4 --face-points 20 --side-points 4 --displacement-increment 0.5
   --sweep gap=mean_plane,first_touch)
limited "$program" "${sweep[@]}" --csv sweep_alone.csv >/dev/null 2>&1
if command -v flock >/dev/null; then
   : >sweep_2.csv.partial
   limited flock sweep_2.csv.partial sleep 5 &
   for i in $(seq 100); do flock -n sweep_2.csv.partial true || break; sleep 0.02; done
   refuses 'a partial file that another process writes' 3 \
      'sweep_2.csv.partial: cannot be used: another process is writing it' \
      "${sweep[@]}" --csv sweep_2.csv
   wait $!
   run "${sweep[@]}" --csv sweep_2.csv
   check 'when that is gone, the sweep goes on' cmp sweep_2.csv sweep_alone.csv
else
   skip 'a partial file that another process writes' 'no flock'
fi
jobs=()
for i in $(seq 8); do
   OMP_NUM_THREADS=1 limited "$program" "${sweep[@]}" --csv sweep_3.csv >/dev/null 2>"err_$i" & jobs+=($!)
done
bad=0
done_well=0
for i in $(seq 8); do
   wait "${jobs[$((i - 1))]}"
   status=$?
   if [ $status -eq 0 ]; then done_well=$((done_well + 1));
   elif [ $status -ne 3 ] || ! grep -q 'another process is writing it' "err_$i"; then bad=$((bad + 1)); fi
done
check 'eight sweeps and one file: some succeed, the others say why not' \
   test $done_well -ge 1 -a $bad -eq 0
check 'its rows are those of one sweep' cmp sweep_3.csv sweep_alone.csv
check 'no partial file stays' absent sweep_3.csv.partial
# A head that was not finished, as on a full disk
limited "$program" "${sweep[@]}" --csv sweep_4.csv >/dev/null 2>&1
printf '# --sweep' >sweep_4.csv.partial
run "${sweep[@]}" --csv sweep_4.csv
check 'a partial file that ends in its head' is_quiet
check 'the sweep begins anew' cmp sweep_4.csv sweep_alone.csv
