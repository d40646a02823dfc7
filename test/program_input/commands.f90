!> The keys of all commands: each is declared soundly, and alike however often.
module test_program_input_commands
   use asperity_base_kinds, only: wp
   use asperity_program_commands_command, only: command_type
   use asperity_program_commands_registry, only: command_entry, find_command, list_commands, &
      n_commands
   use asperity_program_input_key, only: key_type, kind_list, kind_real
   use asperity_program_input_key_list, only: key_list
   use asperity_replay_press, only: default_peak
   use asperity_replay_tenon_settings, only: tenon_settings
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   implicit none
   private
   public :: suite_commands

contains

   function suite_commands() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('commands')
      call suite%addTest(TestMethod('keys declared anew are as they were', test_anew))
      call suite%addTest(TestMethod('a key means the same in every command', test_alike))
      call suite%addTest(TestMethod('defaults are those of the library', test_defaults))
      call suite%addTest(TestMethod('a leader stands above what follows', test_leaders))
   end function suite_commands

   subroutine test_anew()
      type(command_entry) :: list(n_commands)
      type(key_list), allocatable :: keys, once
      character(len=12) :: name
      integer :: i, j

      call list_commands(list)
      do i = 1, size(list)
         name = list(i)%command%name
         allocate (keys)
         call list(i)%command%declare(keys)
         once = keys
         call list(i)%command%declare(keys)
         call assertEqual(once%n, keys%n, name)
         call assertFalse(allocated(keys%error), name)
         do j = 1, keys%n
            call assertTrue(keys%rows(j)%help /= '', name//' '//keys%rows(j)%name)
            call assertEqual(once%rows(j)%source, keys%rows(j)%source, &
               name//' '//keys%rows(j)%name)
            call assertTrue(once%rows(j)%has_value .eqv. keys%rows(j)%has_value, &
               name//' '//keys%rows(j)%name)
         end do
         deallocate (keys, once)
      end do
   end subroutine test_anew

   !> Case files are shared by commands; surface takes none, and has a `pair` of its own.
   subroutine test_alike()
      type(command_entry) :: list(n_commands)
      type(key_list) :: keys, known
      type(key_type) :: own, other
      integer :: i, j, place

      call list_commands(list)
      do i = 1, size(list)
         if (.not. list(i)%command%takes_case) cycle
         call declare_alone(list(i)%command, keys)
         do j = 1, keys%n
            own = keys%rows(j)
            place = known%find(trim(own%name))
            if (place == 0) cycle
            other = known%rows(place)
            call assertEqual(other%kind, own%kind, own%name)
            call assertEqual(other%unit, own%unit, own%name)
            ! of a deck, how the law is written; of the solid joint, which laws are compared
            if (own%name /= 'contact') &
               call assertEqual(other%choices, own%choices, own%name)
            call assertTrue(other%is_property .eqv. own%is_property, own%name)
         end do
         call list(i)%command%declare(known)
      end do
   end subroutine test_alike

   subroutine test_defaults()
      type(tenon_settings) :: joint

      call assertEqual(joint%length, number_of('tenon', 'length'), 0.0_wp)
      call assertEqual(joint%clearance_below, number_of('tenon', 'clearance_below'), 0.0_wp)
      call assertEqual(0.5_wp*joint%height, number_of('tenon', 'bearing_depth'), 0.0_wp)
      call assertEqual(joint%wood%compression_strengths(1), &
         number_of('deck tenon', 'compression_strength_l'), 0.0_wp)
      call assertEqual(default_peak, number_of('press', 'peak'), 0.0_wp)
   end subroutine test_defaults

   subroutine test_leaders()
      type(command_entry) :: list(n_commands)
      type(key_list) :: keys
      integer :: i, j

      call list_commands(list)
      do i = 1, size(list)
         call declare_alone(list(i)%command, keys)
         do j = 1, keys%n
            call assertTrue(keys%rows(j)%leader < j, keys%rows(j)%name)
         end do
      end do
   end subroutine test_leaders

   !> The keys of one command, and of no other.
   subroutine declare_alone(command, keys)
      class(command_type), intent(inout) :: command
      type(key_list), intent(out) :: keys

      call command%declare(keys)
      call command%declare(keys)
   end subroutine declare_alone

   !> Value of a real key of a command that is given nothing.
   real(wp) function number_of(name, key)
      character(len=*), intent(in) :: name, key
      class(command_type), allocatable :: command
      type(key_list) :: keys
      integer :: place

      call find_command(name, command)
      call declare_alone(command, keys)
      place = keys%find(key)
      call assertTrue(any(keys%rows(place)%kind == [kind_real, kind_list]), key)
      number_of = keys%rows(place)%values(1)
   end function number_of

end module test_program_input_commands
