# Help, version, citation, and what the command line refuses

version=$(sed -n "s/.*version = '\(.*\)'.*/\1/p" "$root/src/base/version.f90")
run --version
check 'version is that of the library' test "$(head -n 1 out)" = "asperity $version"
check 'version says which libraries are under the GPL' has out 'linked with FFTW and GSL, under the GNU GPL'
cp out first
run version
check 'version and --version agree' cmp first out
check 'version is quiet' is_quiet

run help
check 'help' is_quiet
check 'help names every command' \
   sh -c 'for c in curve press shear tenon table "deck shear" "deck tenon" hysteresis fit pairs version help; do grep -q "^  $c " out || exit 1; done'
cp out first
run --help
check '--help is help' cmp first out
run -V
check '-V is version' test "$(head -n 1 out)" = "asperity $version"
for command in curve press shear tenon table hysteresis fit surface pairs; do
   run help $command
   cp out first
   run $command --help
   check "$command --help is help $command" cmp first out
   check "$command --help describes its options" has out '--csv FILE'
   run $command help
   check "$command help is help $command" cmp first out
   COLUMNS=80 run help $command
   check "help $command fits 80 columns" sh -c '! grep -E ".{81}" out'
done
COLUMNS=80 run help
check 'help fits 80 columns' sh -c '! grep -E ".{81}" out'
COLUMNS=120 run help shear
check 'help takes the width of the terminal' grep -q -E '.{100}' out
run help deck
check 'help deck names both models' sh -c 'grep -q "deck shear" out && grep -q "deck tenon" out'
cp out first
run deck --help
check 'deck --help is help deck' cmp first out

# Man page and completion, made of the same keys
run help --man
check 'man page' is_quiet
cp out asperity.1
if command -v groff >/dev/null; then
   check 'man page: groff has nothing to say' \
      sh -c 'groff -man -ww -Tutf8 asperity.1 2>&1 >/dev/null | cmp - /dev/null'
else
   skip 'man page in groff' 'no groff'
fi
run help --completion bash
check 'completion' is_quiet
cp out asperity.bash
check 'completion: bash takes it' bash -n asperity.bash
run help tenon
sed -n 's/^  --\(\[no-\]\)\{0,1\}\([a-z0-9-]*\).*/  --\2/p' out | sort >options
bash -c '. ./asperity.bash; COMP_WORDS=(asperity tenon --); COMP_CWORD=2; _asperity
   printf "  %s\n" "${COMPREPLY[@]}"' | sort >offered
check 'completion offers every option of a command' \
   sh -c 'test -s options && test "$(comm -23 options offered)" = ""'
check 'completion of the first word' test "$(bash -c '. ./asperity.bash; COMP_WORDS=(asperity hy)
   COMP_CWORD=1; _asperity; echo "${COMPREPLY[@]}"')" = hysteresis
check 'completion of a choice' test "$(bash -c '. ./asperity.bash
   COMP_WORDS=(asperity tenon --gap fi); COMP_CWORD=3; _asperity; echo "${COMPREPLY[@]}"')" = first_touch
check 'completion of the second word of deck' test "$(bash -c '. ./asperity.bash
   COMP_WORDS=(asperity deck s); COMP_CWORD=2; _asperity; echo "${COMPREPLY[@]}"')" = shear

# A case on standard input
printf '&asperity\n sigma = 0.01\n/\n' >case.nml
run curve case.nml --csv -
cp out first
check 'case on standard input' sh -c 'cat case.nml | "$1" curve - --csv - | cmp first -' - "$program"
run shear --displacement 3 --help
check '--help among options' has out 'usage: asperity shear'

run --citation
check 'citation has the DOI' has out '10.1186/s10086-021-01963-x'
check 'citation has the paper' has out 'Normal contact performance of mortise and tenon joint'
check 'citation has the version' has out "$version"

run
check 'no arguments: usage and status 2' test "$status" -eq 2
check 'no arguments: usage on standard error' has err 'usage: asperity'
check 'no arguments: nothing on standard output' test ! -s out

run pairs
check 'pairs' is_quiet
check 'pairs lists both pairs' \
   sh -c 'grep -q transverse-tangential out && grep -q tangential-tangential out'
check 'pairs says what the paper printed' has out 'Spd 0.000206 (1/um^2)'
run pairs --csv pairs.csv
check 'pairs: two pairs and nine surfaces' test "$(rows pairs.csv)" -eq 11
run pairs --json -
check 'pairs: no value is null' has out 'null'

refuses 'unknown command' 2 "unknown command 'foo'" foo
refuses 'mistyped command' 2 'unknown command .*did you mean shear' shera
refuses 'help on an unknown command' 2 "unknown command 'foo'" help foo
refuses 'help on two commands' 2 "'press': help takes one command" help curve press
refuses 'unknown option' 2 '--foo: unknown option of curve' curve --foo 3
refuses 'mistyped option' 2 '--sgima: .*did you mean --sigma' curve --sgima 3
refuses 'option of another command' 2 '--rate: is an option of shear' curve --rate 3
refuses 'friction has no effect on press' 2 '--critical-slip: is an option of shear' \
   press --critical-slip 3
refuses 'option without value' 2 '--sigma: needs a value' curve --sigma
refuses 'option without value before another' 2 '--sigma: needs a value' curve --sigma --eta 3
refuses 'option twice' 2 '--sigma: is given twice' curve --sigma 1 --sigma=1
refuses 'value for what takes none' 2 '--print-case: takes no value' curve --print-case=1
refuses 'logical with a wrong value' 2 '--shrinking-overlap: .*neither true nor false' \
   shear --shrinking-overlap=maybe
refuses 'two case files' 2 "'b.nml': there is already" curve a.nml b.nml
refuses 'pairs takes no case file' 2 "'a.nml': pairs takes no case file" pairs a.nml
refuses 'help on no shell' 2 "--completion: 'fish' is unknown; known: bash" help --completion fish
refuses 'version takes nothing' 2 '--csv: is an option of' --version --csv x

# A BLAS with threads takes memory and time at every start; GSL's own has none
if command -v ldd >/dev/null; then
   loads_no_blas() { ldd "$program" >libraries && ! grep -v gslcblas libraries | grep -i -E 'lapack|blas'; }
   check 'no command loads LAPACK or a BLAS' loads_no_blas
fi
