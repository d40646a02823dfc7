!> Keys bound to variables: defaults, options, what follows, what is refused.
module test_program_input_key_list
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_program_input_key, only: assign_words, given_as_option, given_in_case
   use asperity_program_input_key_list, only: key_list
   use asperity_program_input_values, only: word_type
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   implicit none
   private
   public :: suite_key_list

   !> Variables of some keys.
   type :: variables
      real(wp) :: height = 300.0_wp, gap = 0.0_wp, load = none
      integer :: rule = 2, points = 12
      logical :: fills = .false., shoulders = .false.
      integer, allocatable :: cycles(:)
      real(wp), allocatable :: depth
   end type variables

contains

   function suite_key_list() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('key_list')
      call suite%addTest(TestMethod('defaults', test_defaults))
      call suite%addTest(TestMethod('given values', test_given))
      call suite%addTest(TestMethod('a value that follows', test_follows))
      call suite%addTest(TestMethod('whole numbers alone', test_counts))
      call suite%addTest(TestMethod('a key that needs another', test_needs))
      call suite%addTest(TestMethod('options over a case', test_forget))
      call suite%addTest(TestMethod('the place of a value', test_place))
   end function suite_key_list

   subroutine declare(v, keys)
      type(variables), intent(inout) :: v
      type(key_list), intent(inout) :: keys
      integer :: height

      call keys%real('height', v%height, 'mm', 'a height')
      height = keys%last
      v%gap = 0.01_wp*v%height
      call keys%real('gap', v%gap, 'mm', 'a gap')
      call keys%follows(height, 'a hundredth of height')
      call keys%means('gap_x gap_y')
      call keys%real('load', v%load, 'N', 'a load')
      call keys%choice('rule', v%rule, 'free fixed force', 'a rule')
      call keys%choice('missing', v%fills, 'mask fill', 'missing points')
      call keys%whole('points', v%points, 'points')
      call keys%switch('shoulders', v%shoulders, 'shoulders')
      call keys%list('cycles', v%cycles, '', 'cycles')
      call keys%optional_real('depth', v%depth, 'mm', 'a depth of shoulders')
      call keys%needs(v%shoulders, 'needs shoulders')
   end subroutine declare

   !> Give a key a value.
   subroutine give(keys, name, value, where)
      type(key_list), intent(inout) :: keys
      character(len=*), intent(in) :: name, value
      integer, intent(in) :: where
      type(error_type), allocatable :: error
      type(word_type) :: word(1)

      word(1)%text = value
      word(1)%in_quotes = verify(value, '+-.0123456789') > 0 .and. value /= 'true'
      word(1)%source = 'case.nml:7'
      if (where == given_as_option) word(1)%source = '--'//name
      call assign_words(keys%rows(keys%find(name)), word, where, error)
      call assertFalse(allocated(error))
   end subroutine give

   subroutine test_defaults()
      type(variables) :: v
      type(key_list) :: keys

      call declare(v, keys)
      call declare(v, keys)
      call assertEqual(9, keys%n)
      call assertEqual(300.0_wp, v%height, 0.0_wp)
      call assertEqual('300', trim(keys%rows(keys%find('height'))%default))
      call assertEqual('default', keys%rows(keys%find('height'))%source)
      call assertEqual('fixed', trim(keys%rows(keys%find('rule'))%default))
      call assertEqual('', trim(keys%rows(keys%find('gap'))%default))
      call assertFalse(keys%rows(keys%find('load'))%has_value)
      call assertFalse(keys%rows(keys%find('cycles'))%has_value)
      call assertFalse(keys%rows(keys%find('depth'))%has_value)
      call assertEqual(0, keys%find('nothing'))
   end subroutine test_defaults

   subroutine test_given()
      type(variables) :: v
      type(key_list) :: keys

      call declare(v, keys)
      call give(keys, 'height', '250', given_as_option)
      call give(keys, 'rule', 'Force', given_as_option)
      call give(keys, 'missing', 'fill', given_in_case)
      call give(keys, 'points', '7', given_in_case)
      call give(keys, 'load', '-3', given_in_case)
      call declare(v, keys)
      call assertEqual(250.0_wp, v%height, 0.0_wp)
      call assertEqual(3, v%rule)
      call assertTrue(v%fills)
      call assertEqual(7, v%points)
      call assertEqual(-3.0_wp, v%load, 0.0_wp)
      call assertEqual('--height', keys%rows(keys%find('height'))%source)
      ! the default in help stays
      call assertEqual('300', trim(keys%rows(keys%find('height'))%default))
   end subroutine test_given

   subroutine test_follows()
      type(variables) :: v
      type(key_list) :: keys

      call declare(v, keys)
      call give(keys, 'height', '200', given_as_option)
      call declare(v, keys)
      associate (gap => keys%rows(keys%find('gap')))
         call assertEqual(2.0_wp, v%gap, 0.0_wp)
         call assertTrue(gap%follows)
         call assertEqual(keys%find('height'), gap%leader)
         call assertEqual('a hundredth of height', gap%source)
      end associate
      call give(keys, 'gap', '5', given_in_case)
      call declare(v, keys)
      associate (gap => keys%rows(keys%find('gap')))
         call assertEqual(5.0_wp, v%gap, 0.0_wp)
         call assertFalse(gap%follows)
         call assertEqual('case.nml:7', gap%source)
      end associate
   end subroutine test_follows

   subroutine test_counts()
      type(variables) :: v
      type(key_list) :: keys

      call declare(v, keys)
      call give(keys, 'cycles', '3', given_as_option)
      call declare(v, keys)
      call assertEqual(3, v%cycles(1))
      call give(keys, 'cycles', '1.5', given_as_option)
      call declare(v, keys)
      call assertTrue(allocated(keys%error))
      call assertEqual('cycles', keys%error%subject)
   end subroutine test_counts

   subroutine test_needs()
      type(variables) :: v
      type(key_list) :: keys

      call declare(v, keys)
      call give(keys, 'depth', '5', given_as_option)
      call declare(v, keys)
      call assertTrue(allocated(keys%error))
      call assertEqual('--depth: needs shoulders', keys%error%message)
      deallocate (keys%error)
      call give(keys, 'shoulders', 'true', given_as_option)
      call declare(v, keys)
      call assertFalse(allocated(keys%error))
      call assertEqual(5.0_wp, v%depth, 0.0_wp)
   end subroutine test_needs

   !> What an option gives anew is forgotten of a case, but not of options.
   subroutine test_forget()
      type(variables) :: v
      type(key_list) :: keys
      integer :: height, load, rule

      call declare(v, keys)
      height = keys%find('height')
      load = keys%find('load')
      rule = keys%find('rule')
      call give(keys, 'height', '200', given_in_case)
      call give(keys, 'load', '5', given_as_option)
      call keys%forget_case(rule, [height, load])
      call assertTrue(keys%given(height))
      call give(keys, 'rule', 'free', given_as_option)
      call keys%forget_case(rule, [height, load])
      call assertFalse(keys%given(height))
      call assertTrue(keys%given(load))
   end subroutine test_forget

   !> The first value of the subject that was given, or that follows one that was.
   subroutine test_place()
      type(variables) :: v
      type(key_list) :: keys

      call declare(v, keys)
      call give(keys, 'height', '200', given_as_option)
      call declare(v, keys)
      call assertEqual('--height: wrong', placed('height'))
      call assertEqual('--height: wrong', placed('gap_y'))
      call assertEqual('--height: wrong', placed('load height'))
      call assertEqual('wrong', placed('load'))
      call assertEqual('wrong', placed('nothing'))
      call assertEqual('wrong', placed(''))

   contains

      function placed(subject) result(message)
         character(len=*), intent(in) :: subject
         character(len=:), allocatable :: message
         type(error_type), allocatable :: error

         call fatal_error(error, 'wrong', subject=subject)
         call keys%with_place(error)
         message = error%message
      end function placed

   end subroutine test_place

end module test_program_input_key_list
