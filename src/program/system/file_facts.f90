!> What the operating system knows of a file: whether it is there, its kind, its rights.
module asperity_program_system_file_facts
   use, intrinsic :: iso_c_binding, only: c_int, c_int32_t, c_int64_t, c_null_char
   use asperity_program_system_posix, only: c_statx, statx_type
   implicit none
   private
   public :: file_facts, facts_of, facts_of_descriptor, facts_of_link

   !> Facts of one file; those of no file are as set here.
   type :: file_facts
      !> There is such a file
      logical :: exists = .false.
      !> It is neither a device, a pipe, a socket nor a folder
      logical :: is_regular = .false.
      !> Rights, and who has them
      integer(c_int) :: rights = 0_c_int, owner = 0_c_int, group = 0_c_int
      !> Device and number, which two files never share
      integer(c_int64_t) :: identity(3) = 0_c_int64_t
   end type file_facts

   !> Arguments of statx: no folder of its own, the file of the descriptor, no link followed, all
   !> that stat tells
   integer(c_int), parameter :: here = -100_c_int, of_descriptor = int(z'1000', c_int), &
      no_follow = int(z'100', c_int), basic = int(z'7ff', c_int)
   !> Parts of a file's mode
   integer(c_int), parameter :: kind_bits = int(o'170000', c_int), &
      regular = int(o'100000', c_int), right_bits = int(o'777', c_int)

contains

   !> Facts of the file that a path leads to.
   type(file_facts) function facts_of(path) result(facts)
      !> The path
      character(len=*), intent(in) :: path

      facts = facts_by(here, path, 0_c_int)
   end function facts_of

   !> Facts of a path itself, which may be a link.
   type(file_facts) function facts_of_link(path) result(facts)
      !> The path
      character(len=*), intent(in) :: path

      facts = facts_by(here, path, no_follow)
   end function facts_of_link

   !> Facts of an open file.
   type(file_facts) function facts_of_descriptor(file) result(facts)
      !> Its descriptor
      integer(c_int), intent(in) :: file

      facts = facts_by(file, '', of_descriptor)
   end function facts_of_descriptor

   type(file_facts) function facts_by(file, path, flags) result(facts)
      integer(c_int), intent(in) :: file, flags
      character(len=*), intent(in) :: path
      type(statx_type) :: status
      integer(c_int) :: mode

      if (c_statx(file, path//c_null_char, flags, basic, status) /= 0) return
      mode = int(status%mode, c_int)
      facts%exists = .true.
      facts%is_regular = iand(mode, kind_bits) == regular
      facts%rights = iand(mode, right_bits)
      facts%owner = status%owner
      facts%group = status%group
      facts%identity = [int([status%device_major, status%device_minor], c_int64_t), status%inode]
   end function facts_by

end module asperity_program_system_file_facts
