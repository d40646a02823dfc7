!> The machine that a benchmark ran on, as Linux tells it; blank or zero where it does not.
module bench_machine
   use, intrinsic :: iso_fortran_env, only: compiler_version
   !$ use omp_lib, only: omp_get_num_procs
   use asperity, only: wp
   implicit none
   private
   public :: machine_type, this_machine, available_memory, has_openmp

   !> What the figures depend on.
   type :: machine_type
      character(len=80) :: processor = 'unknown processor', system = 'unknown system', &
         compiler = ''
      character(len=10) :: date = ''
      integer :: cores = 1
      !> GB
      real(wp) :: memory = 0.0_wp
   end type machine_type

contains

   !> The machine this runs on, now.
   function this_machine() result(machine)
      type(machine_type) :: machine
      character(len=80) :: text
      character(len=8) :: date
      integer :: cut

      call find_value('/proc/cpuinfo', 'model name', text)
      if (text /= '') machine%processor = text
      call find_value('/etc/os-release', 'PRETTY_NAME', text)
      if (text /= '') machine%system = text
      call find_value('/proc/sys/kernel/osrelease', '', text)
      if (text /= '') machine%system = trim(machine%system)//', Linux '//text
      machine%compiler = compiler_version()
      ! flang adds the address of its source
      cut = index(machine%compiler, ' (')
      if (cut > 0) machine%compiler(cut:) = ''
      machine%cores = count_processors()
      !$ machine%cores = omp_get_num_procs()
      machine%memory = memory_value('MemTotal')
      call date_and_time(date)
      machine%date = date(:4)//'-'//date(5:6)//'-'//date(7:)
   end function this_machine

   !> Memory that may be used, GB; zero when unknown.
   function available_memory() result(memory)
      real(wp) :: memory

      memory = memory_value('MemAvailable')
   end function available_memory

   !> Is OpenMP compiled in?
   function has_openmp() result(has)
      logical :: has

      has = .false.
      !$ has = .true.
   end function has_openmp

   !> A number of /proc/meminfo, GB.
   function memory_value(key) result(memory)
      character(len=*), intent(in) :: key
      real(wp) :: memory, kilobytes
      character(len=80) :: text
      integer :: status

      memory = 0.0_wp
      call find_value('/proc/meminfo', key, text)
      read (text, *, iostat=status) kilobytes
      if (status == 0) memory = kilobytes*1024.0e-9_wp
   end function memory_value

   !> First value of a key in a file of lines `key: value` or `key="value"`; the first line for a
   !> blank key. Blank when there is none.
   subroutine find_value(path, key, value)
      character(len=*), intent(in) :: path, key
      character(len=80), intent(out) :: value
      character(len=256) :: line
      integer :: unit, status, place

      value = ''
      open (newunit=unit, file=path, status='old', action='read', iostat=status)
      if (status /= 0) return
      do
         read (unit, '(a)', iostat=status) line
         if (status /= 0) exit
         if (index(line, key) /= 1) cycle
         place = 0
         if (key /= '') place = scan(line, ':=')
         value = adjustl(line(place + 1:))
         if (value(1:1) == '"') value = value(2:index(value, '"', back=.true.) - 1)
         exit
      end do
      close (unit)
   end subroutine find_value

   !> Lines of /proc/cpuinfo that begin a processor; one at least.
   function count_processors() result(n)
      integer :: n
      character(len=64) :: line
      integer :: unit, status

      n = 0
      open (newunit=unit, file='/proc/cpuinfo', status='old', action='read', iostat=status)
      if (status == 0) then
         do
            read (unit, '(a)', iostat=status) line
            if (status /= 0) exit
            if (index(line, 'processor') == 1) n = n + 1
         end do
         close (unit)
      end if
      n = max(n, 1)
   end function count_processors

end module bench_machine
