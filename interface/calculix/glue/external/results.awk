# Write the wrapper of CalculiX' results() from its prototype in CalculiX.h:
#    awk -f results.awk CalculiX.h > results.c
# It hands the solver's variables over to host.f90 before the springs are called, and asks for a
# shorter increment afterwards.

/^void results\(/ { inside = 1 }
inside { text = text " " $0 }
inside && /;/ { inside = 0; exit }

END {
   sub(/^ *void results\(/, "", text)
   sub(/\) *; *$/, "", text)
   n = split(text, arguments, ",")
   if (n < 100) {
      print "results.awk: no prototype of results() with 100 arguments and more" > "/dev/stderr"
      exit 1
   }
   for (i = 1; i <= n; i++) {
      name = arguments[i]
      gsub(/[ \t]+/, " ", name)
      gsub(/^ | $/, "", name)
      declared = declared (i > 1 ? ", " : "") name
      sub(/^.*[ *]/, "", name)
      names = names (i > 1 ? ", " : "") name
      known[name] = 1
   }
   before = "vini mi nk time dtime ttime istep iinc iout ielas matname tieset ntie nstate_ ne0 xstateini xstate mortar"
   after = "qa mi nstate_ ne0 ntie xstate"
   m = split(before " " after, wanted, " ")
   for (i = 1; i <= m; i++) if (!(wanted[i] in known)) {
      print "results.awk: results() has no argument " wanted[i] > "/dev/stderr"
      exit 1
   }
   gsub(/ /, ", ", before)
   gsub(/ /, ", ", after)
   print "#include <stdio.h>"
   print "#include <stdlib.h>"
   print "#include \"CalculiX.h\""
   print "void before_results();"
   print "void after_results();"
   print "void begin_attempt();"
   print "void end_job();"
   print "void report_time();"
   print "static int registered = 0;"
   print "void ccx_results(" declared ");"
   print "void results(" declared ")"
   print "{"
   print "   if (!registered) registered = !atexit(report_time) && !atexit(end_job);"
   print "   before_results(" before ");"
   print "   begin_attempt();"
   print "   ccx_results(" names ");"
   print "   after_results(" after ");"
   print "}"
}
