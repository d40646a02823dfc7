!> The reader of decimal numbers against Fortran's own, bit by bit.
module test_height_map_numbers
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_kinds, only: wp
   use asperity_height_map_text_numbers, only: count_figures, number_absent, number_found, &
      number_too_large, read_number
   use funit, only: assertEqual, assertTrue, TestMethod, TestSuite
   use random_inputs, only: random_stream
   implicit none
   private
   public :: suite_map_numbers

contains

   function suite_map_numbers() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('map numbers')
      call suite%addTest(TestMethod('written numbers, bit by bit', test_written))
      call suite%addTest(TestMethod('random figures, bit by bit', test_figures))
      call suite%addTest(TestMethod('in the middle of two doubles', test_middle))
      call suite%addTest(TestMethod('forms', test_forms))
      call suite%addTest(TestMethod('what is no number', test_none))
      call suite%addTest(TestMethod('figures and decimals', test_count))
   end function suite_map_numbers

   subroutine read_one(text, value, status, length)
      character(len=*), intent(in) :: text
      real(wp), intent(out) :: value
      integer, intent(out) :: status, length
      character(len=1) :: letters(len(text))
      integer :: at, i

      do i = 1, len(text)
         letters(i) = text(i:i)
      end do
      at = 1
      call read_number(letters, at, len(text), value, status)
      length = at - 1
   end subroutine read_one

   !> Whether a text reads as the bits that Fortran reads.
   logical function is_same(text)
      character(len=*), intent(in) :: text
      real(wp) :: expected, value
      integer :: length, status

      read (text, *) expected
      call read_one(text, value, status, length)
      is_same = status == number_found .and. length == len(text) .and. &
         transfer(value, 0_int64) == transfer(expected, 0_int64)
      if (.not. is_same) write (*, '(5x, 2a, es26.17)') text, ' read as ', value
   end function is_same

   !> Doubles of all sizes with 5 to 19 figures.
   subroutine test_written()
      type(random_stream) :: stream
      character(len=16) :: edit
      character(len=40) :: text
      real(wp) :: value
      integer :: i, wrong

      stream%state = 12345
      wrong = 0
      do i = 1, 60000
         value = stream%log_uniform(1.0e-8_wp, 1.0e8_wp)
         if (mod(i, 5) == 0) value = stream%log_uniform(1.0e-150_wp, 1.0e150_wp)
         if (mod(i, 2) == 0) value = -value
         write (edit, '(a, i0, a)') '(es40.', 4 + mod(i, 15), 'e3)'
         write (text, edit) value
         if (.not. is_same(trim(adjustl(text)))) wrong = wrong + 1
      end do
      call assertEqual(0, wrong)
   end subroutine test_written

   !> Up to 25 random figures with a point anywhere and an exponent.
   subroutine test_figures()
      type(random_stream) :: stream
      character(len=40) :: text
      integer :: i, k, figures, wrong

      stream%state = 54321
      wrong = 0
      do i = 1, 40000
         figures = 1 + int(stream%uniform(0.0_wp, 25.0_wp))
         text = ''
         do k = 1, figures
            text(k:k) = achar(48 + int(stream%uniform(0.0_wp, 10.0_wp)))
         end do
         k = 1 + int(stream%uniform(0.0_wp, real(figures, wp)))
         text = text(:k)//'.'//text(k + 1:)
         write (text(len_trim(text) + 1:), '(a, i0)') 'e', int(stream%uniform(-60.0_wp, 60.0_wp))
         if (.not. is_same(trim(text))) wrong = wrong + 1
      end do
      call assertEqual(0, wrong)
   end subroutine test_figures

   !> Exactly between two doubles, and so little beside that only the last figure tells.
   subroutine test_middle()
      character(len=*), parameter :: texts(12) = [character(len=64) :: '9007199254740993', &
         '9007199254740993.0000000000000000000000000000000000001', &
         '9007199254740992.9999999999999999999999999999999999999', '9007199254740995', &
         '1.00000000000000011102230246251565404236316680908203125', &
         '1.00000000000000011102230246251565404236316680908203126', &
         '1.00000000000000011102230246251565404236316680908203124', &
         '0.99999999999999994448884876874217297881841659545898437', &
         '0.99999999999999994448884876874217297881841659545898438', &
         '36028797018963967', '72057594037927943e-1', '2.2250738585072014e-308']
      integer :: i

      do i = 1, size(texts)
         call assertTrue(is_same(trim(texts(i))), trim(texts(i)))
      end do
   end subroutine test_middle

   subroutine test_forms()
      character(len=*), parameter :: texts(15) = [character(len=32) :: '0', '5.', '.5', '+1.5', &
         '1e5', '1E+05', '1d-5', '-2.5D3', '007', '0.000000000000000000000000000001', &
         '100000000000000000000000000000', '1e-320', '0e400', '9223372036854775807', &
         '0.00000000000000000000e-7']
      real(wp) :: value
      integer :: i, length, status

      do i = 1, size(texts)
         call assertTrue(is_same(trim(texts(i))), trim(texts(i)))
      end do
      call read_one('1.5e', value, status, length)
      call assertEqual(3, length, 'an exponent without figures is none')
      call read_one('2 3', value, status, length)
      call assertEqual(1, length, 'ends at a blank')
      call read_one('1e-400', value, status, length)
      call assertEqual(number_found, status, 'too small for a double')
      call assertEqual(0.0_wp, value, 'too small for a double')
   end subroutine test_forms

   subroutine test_none()
      character(len=*), parameter :: texts(8) = [character(len=8) :: '-', '+', '.', '', 'e5', &
         'abc', &
         '--1', '*']
      real(wp) :: value
      integer :: i, length, status

      do i = 1, size(texts)
         call read_one(trim(texts(i)), value, status, length)
         call assertEqual(number_absent, status, texts(i))
      end do
      do i = 308, 400, 23
         call read_one(repeat('9', i + 1), value, status, length)
         call assertEqual(number_too_large, status, 'many figures')
      end do
      call read_one('1e309', value, status, length)
      call assertEqual(number_too_large, status, '1e309')
      call read_one('-1e99999999999999', value, status, length)
      call assertEqual(number_too_large, status, 'an exponent that is no integer of ours')
   end subroutine test_none

   subroutine test_count()
      call check('1.5', 2, 1)
      call check('-0.0500 ', 3, 4)
      call check(' "+120.0"', 4, 1)
      call check('1.5e-7', 2, 8)
      call check('12345,6', 5, 0)
      call check('2.5E+03;1', 2, -2)
      call check('0.000', 0, 3)
      call check('7e', 1, 0)
      call check('', 0, 0)

   contains

      subroutine check(text, figures, decimals)
         character(len=*), intent(in) :: text
         integer, intent(in) :: figures, decimals
         character(len=1) :: letters(len(text))
         integer :: found(2), i

         do i = 1, len(text)
            letters(i) = text(i:i)
         end do
         call count_figures(letters, 1, len(text), found(1), found(2))
         call assertEqual([figures, decimals], found, text)
      end subroutine check

   end subroutine test_count

end module test_height_map_numbers
