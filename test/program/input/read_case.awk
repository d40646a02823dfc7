# Writes, from the help of the commands that take a case file, a Fortran program that reads case
# files by Fortran's own namelist READ and prints every key that was set, with all figures, one per
# line: the independent reading that the program's scanner is compared with. Its status is 1 when
# READ refuses a file.
/^[^ ]/ { is_key = /also keys of a case file/ }
is_key && match($0, /^  --(\[no-\])?[a-z-]+/) {
   name = substr($1, 3)
   kind = $2
   if (sub(/^\[no-\]/, "", name)) kind = "LOGICAL"
   gsub("-", "_", name)
   if (!(name in kinds)) names[++n] = name
   kinds[name] = kind
}
# text for each key, NAME being its name
function each(kind, text, i, line) {
   for (i = 1; i <= n; i++) {
      if (kinds[names[i]] != kind) continue
      line = text
      gsub("NAME", names[i], line)
      print line
   }
}
END {
   print "program read_case"
   print "use, intrinsic :: iso_fortran_env, only: error_unit, wp => real64"
   print "implicit none"
   print "real(wp), parameter :: unset = -huge(1.0_wp)"
   each("NUMBER", "real(wp) :: NAME")
   each("LIST", "real(wp), dimension(1000) :: NAME")
   each("COUNT", "integer :: NAME")
   each("LOGICAL", "logical :: NAME")
   each("NAME", "character(len=80) :: NAME")
   print "character(len=1000) :: path, message"
   print "integer :: unit, status, pass"
   for (i = 1; i <= n; i++) print "namelist /asperity/ " names[i]
   print "call get_command_argument(1, path)"
   # A logical has no value that means "unset": it is set if two defaults give the same
   print "do pass = 1, 2"
   each("NUMBER", "NAME = unset")
   each("LIST", "NAME = unset")
   each("COUNT", "NAME = -huge(1)")
   each("LOGICAL", "NAME = pass == 1")
   each("NAME", "NAME = ''")
   print "open (newunit=unit, file=trim(path), status='old', action='read')"
   print "read (unit, nml=asperity, iostat=status, iomsg=message)"
   print "close (unit)"
   print "if (status /= 0) then"
   print "write (error_unit, '(4a)') trim(path), ': ', trim(message)"
   print "error stop 1"
   print "end if"
   each("LOGICAL", "if (pass == 2 .and. NAME) print '(a)', 'NAME true'")
   each("LOGICAL", "if (pass == 1 .and. .not. NAME) print '(a)', 'NAME false'")
   print "end do"
   each("NUMBER", "if (NAME > unset) print '(a, 1x, es24.16e3)', &\n'NAME', NAME")
   each("LIST", "if (NAME(1) > unset) print '(a, *(1x, es24.16e3))', &\n'NAME', NAME(:count(NAME > unset))")
   each("COUNT", "if (NAME /= -huge(1)) print '(a, 1x, i0)', 'NAME', NAME")
   each("NAME", "if (NAME /= '') print '(2a)', 'NAME ', trim(NAME)")
   print "end program read_case"
}
