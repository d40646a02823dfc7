!> Feeds damaged files to every reader of height maps, in memory: each must give a sound map or an
!> error with a message. Built with checks of addresses and undefined behaviour, which stop it.
!>
!>     asperity_fuzz [files for each reader [seed]]
program fuzz_main
   use, intrinsic :: iso_fortran_env, only: int64, output_unit
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_height_map_read, only: map_hints, read_height_map_bytes
   use asperity_height_map_type, only: check_heights, height_map
   use binary_cases, only: plux_members
   use fuzz_mutate, only: dice, mutate
   use fuzz_seeds, only: add_file, add_written, seed_type
   use x3p_cases, only: x3p_members
   use zip_writer, only: zip_member_text, zip_of
   implicit none
   !> Most seconds for one file, with all the checks; points for a byte
   real(wp), parameter :: longest = 2.0_wp
   integer(int64), parameter :: most_points = 1100_int64
   type(seed_type), allocatable :: seeds(:)
   integer :: count, passed, failed
   type(dice) :: chance

   count = argument(1, 1000)
   chance%state = argument(2, 20240611)
   write (*, '(a, i0, a, i0)') 'seed ', chance%state, ', files for each reader: ', count
   passed = 0
   failed = 0

   allocate (seeds(0))
   call add_written(seeds, 'sdf')
   call add_file(seeds, 'maps/surfalize.sdf')
   call add_file(seeds, 'maps/sdfio_iso_2_0_binary_int16.sdf')
   call add_file(seeds, 'maps/sdfio_bcr_1_0_binary_uint16.sdf')
   call run('SDF binary', .false.)
   call add_file(seeds, 'maps/surfalize_text.sdf')
   call add_file(seeds, 'maps/sdfio_bcr_1_0_ascii_int32.sdf')
   call add_file(seeds, 'maps/sdfio_iso_2_0_ascii_binary32.sdf')
   call add_file(seeds, 'gwyddion/small.sdf')
   call run('SDF text', .false.)
   call add_file(seeds, 'maps/surfalize.sur')
   call add_file(seeds, 'gwyddion/small.sur')
   call add_file(seeds, 'scans/bytes_behind.sur')
   call add_file(seeds, 'scans/two_objects.sur')
   call run('SUR', .false.)
   call add_file(seeds, 'maps/surfalize_packed.sur')
   call run('SUR, compressed', .false.)
   call add_file(seeds, 'maps/surfalize.x3p')
   call add_file(seeds, 'maps/surface_topography_D.x3p')
   call add_file(seeds, 'maps/surface_topography_I.x3p')
   call add_file(seeds, 'scans/folder.x3p')
   call run('X3P', .false.)
   call run('X3P within zip', .true.)
   call run('PLUX within zip', .true.)
   call add_written(seeds, 'plu')
   call run('PLU', .false.)
   call add_written(seeds, 'gwy')
   call run('GWY', .false.)
   call add_written(seeds, 'gsf')
   call run('GSF', .false.)
   call add_written(seeds, 'xyz')
   call add_written(seeds, 'names')
   call add_written(seeds, 'quoted')
   call add_file(seeds, 'scans/end_mark.xyz')
   call add_file(seeds, 'scans/colours.xyz')
   call add_file(seeds, 'scans/gwyddion_5_figures.xyz')
   call add_file(seeds, 'gwyddion/it.xyz')
   call run('text of x, y, z', .false.)
   call add_file(seeds, 'scans/profile.txt')
   call add_written(seeds, 'column')
   call run('text of a profile', .false.)
   call add_written(seeds, 'csv')
   call add_written(seeds, 'esri')
   call add_written(seeds, 'gwyddion')
   call add_written(seeds, 'semicolons')
   call add_written(seeds, 'axes')
   call add_written(seeds, 'factor')
   call add_file(seeds, 'scans/esri_broken_lines.asc')
   call add_file(seeds, 'gwyddion/it.txt')
   call add_file(seeds, 'gwyddion/ja.txt')
   call run('text of a matrix', .false.)
   call add_file(seeds, 'scans/keyence_vk.csv')
   call add_file(seeds, 'scans/zygo_header.xyz')
   call add_file(seeds, 'scans/wyko.asc')
   call add_file(seeds, 'scans/spip.asc')
   call add_file(seeds, 'scans/surfer.grd')
   call add_written(seeds, 'keyence')
   call add_written(seeds, 'wyko')
   call add_written(seeds, 'spip')
   call add_written(seeds, 'surfer')
   call run('exports', .false.)
   deallocate (seeds)
   write (*, '(i0, a, i0, a)') passed, ' passed, ', failed, ' failed'
   if (failed > 0) stop 1, quiet=.true.

contains

   !> Damage the seeds of one reader and forget them.
   subroutine run(name, is_within)
      character(len=*), intent(in) :: name
      !> Whether the members of an archive are damaged, and not the archive
      logical, intent(in) :: is_within
      character(len=:), allocatable :: file, other
      type(zip_member_text) :: members(3)
      integer :: i, maps, errors, bad, k
      real(wp) :: seconds, worst

      other = ''
      maps = 0
      errors = 0
      bad = 0
      worst = 0.0_wp
      do i = 1, count
         if (is_within) then
            if (index(name, 'PLUX') == 1) then
               call plux_members(members)
            else
               call x3p_members(members, chance%below(5))
            end if
            other = members(1)%bytes
            if (i > 1) then
               k = 1
               if (chance%below(3) == 0) k = 2 + chance%below(2)
               call mutate(chance, members(k)%bytes, other)
            end if
            call zip_of(members, file)
         else
            k = 1 + mod(i - 1, size(seeds))
            file = seeds(k)%bytes
            other = seeds(1 + chance%below(size(seeds)))%bytes
            ! the first ones as they are
            if (i > size(seeds)) call mutate(chance, file, other)
         end if
         call check(name, file, i <= max(size(seeds), 1), maps, errors, bad, seconds)
         worst = max(worst, seconds)
      end do
      if (bad > 0 .or. maps == 0) then
         failed = failed + 1
      else
         passed = passed + 1
      end if
      write (*, '(2x, a, t24, 4(i0, a), f6.1, a)') name, count, ' files, ', maps, ' maps, ', &
         errors, &
         ' errors, ', bad, ' faults; longest ', 1.0e3_wp*worst, ' ms'
      flush (output_unit)
      seeds = seeds(:0)
   end subroutine run

   !> Read one file.
   subroutine check(name, file, must_be_sound, maps, errors, bad, seconds)
      character(len=*), intent(in) :: name, file
      logical, intent(in) :: must_be_sound
      integer, intent(inout) :: maps, errors, bad
      real(wp), intent(out) :: seconds
      type(height_map) :: map
      type(map_hints) :: hints
      type(error_type), allocatable :: error, unsound
      integer(int64) :: began, ended, rate
      logical :: is_fault, is_told

      is_told = chance%below(3) > 0
      if (index(name, 'text of') == 1 .and. (must_be_sound .or. is_told)) then
         if (index(file, '[') == 0) then
            if (index(file, 'unit') + index(file, '単位') + index(file, '/nm') == 0) &
               hints%height_unit = 'um'
            if (index(file, '# ') + index(file, '_um') == 0) hints%lateral_unit = 'mm'
         end if
         if (index(file, '1.25;') == 1 .or. index(file, '7'//achar(10)) == 1) then
            hints%step_x = 0.001_wp
            hints%step_y = 0.002_wp
         end if
      end if
      if (index(file, 'DSAA') == 1 .and. (must_be_sound .or. is_told)) then
         hints%height_unit = 'um'
         hints%lateral_unit = 'mm'
      end if
      hints%has_missing_value = chance%below(8) == 0 .and. .not. must_be_sound
      hints%missing_value = real(chance%below(10), wp)
      call system_clock(began, rate)
      call read_height_map_bytes('file', file, hints, map, error, 16 + chance%below(300))
      call system_clock(ended)
      seconds = real(ended - began, wp)/real(rate, wp)
      is_fault = seconds > longest
      if (allocated(error)) then
         errors = errors + 1
         is_fault = is_fault .or. len(error%message) < 10 .or. allocated(map%heights)
         is_fault = is_fault .or. must_be_sound
         if (must_be_sound) write (*, '(a)') error%message
      else
         maps = maps + 1
         if (.not. allocated(map%heights)) then
            is_fault = .true.
         else
            call check_heights(map, unsound)
            is_fault = is_fault .or. allocated(unsound) .or. &
               size(map%heights, kind=int64) > most_points*len(file)
         end if
      end if
      if (.not. is_fault) return
      bad = bad + 1
      if (bad == 1) call keep(file)
   end subroutine check

   !> Keep a file that shows a fault.
   subroutine keep(file)
      character(len=*), intent(in) :: file
      integer :: unit

      open (newunit=unit, file='fuzz_fault', access='stream', form='unformatted', &
         status='replace', &
         action='write')
      write (unit) file
      close (unit)
      write (*, '(a)') '  a fault: the file is kept as fuzz_fault'
   end subroutine keep

   !> A whole number from the command line.
   integer function argument(number, usual)
      integer, intent(in) :: number, usual
      character(len=20) :: text
      integer :: status

      argument = usual
      if (command_argument_count() < number) return
      call get_command_argument(number, text)
      read (text, *, iostat=status) argument
      if (status /= 0 .or. argument < 1) error stop 'the arguments must be whole numbers above 0'
   end function argument

end program fuzz_main
