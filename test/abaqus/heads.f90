!> What the heads of the files for ABAQUS say, against the sources: the tables of PROPS and STATEV,
!> and DEPVAR.
module test_abaqus_heads
   use asperity_abaqus_prop_slots, only: n_props, prop_names
   use asperity_abaqus_statev, only: n_statev, state_grain_turn
   use asperity_base_number_text, only: to_text
   use asperity_base_version, only: version
   use funit, only: assertEqual, assertTrue, TestMethod, TestSuite
   implicit none
   private
   public :: suite_heads

   character(len=*), parameter :: names(3) = [character(len=23) :: 'asperity_uinter', &
      'asperity_vuinter', 'asperity_vuinter_single']

contains

   function suite_heads() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('heads of the files for ABAQUS')
      call suite%addTest(TestMethod('version, licence, tables', test_tables))
   end function suite_heads

   subroutine test_tables()
      integer :: i

      do i = 1, size(names)
         call check('interface/abaqus/ready/'//trim(names(i))//'.f90')
      end do
   end subroutine test_tables

   !> One file.
   subroutine check(path)
      character(len=*), intent(in) :: path
      character(len=:), allocatable :: head, name
      integer :: props, statev, slot, bracket

      call read_head(path, head)
      call assertEqual(1, index(head, '! asperity '//version//': '), path//': version')
      call assertTrue(index(head, '! MIT License') > 0, path//': licence')
      props = index(head, '!   slot        property')
      statev = index(head, '!   slot        state')
      call assertTrue(props > 0 .and. statev > props, path//': tables')
      do slot = 1, n_props
         name = trim(prop_names(slot))
         bracket = index(name, ' (')
         if (bracket > 0) name = name(:bracket - 1)
         call assertTrue(index(row(head(props:statev), slot), ' '//name) > 0, path//': '//name)
         if (bracket > 0) call assertTrue(index(row(head(props:statev), slot), ' ['// &
            unit(prop_names(slot))//']') > 0, path//': unit of '//name)
      end do
      call assertEqual('', row(head(props:statev), n_props + 1), path//': no more PROPS')
      do slot = 1, state_grain_turn
         ! 5 and 6 are in one row
         if (slot /= 6) call assertTrue(len(row(head(statev:), slot)) > 0, path//': STATEV')
      end do
      call assertTrue(index(head, 'DEPVAR='//to_text(n_statev)//' while') > 0, path//': DEPVAR')
      call assertTrue(index(head, 'zero, '//to_text(state_grain_turn)//' when') > 0, &
         path//': DEPVAR')
   end subroutine check

   !> Unit of a property's name.
   pure function unit(name)
      character(len=*), intent(in) :: name
      character(len=:), allocatable :: unit

      unit = name(index(name, '(') + 1:index(name, ')') - 1)
   end function unit

   !> Row of a slot in a table, with the lines that it goes on in; empty when there is none.
   pure function row(table, slot)
      character(len=*), intent(in) :: table
      integer, intent(in) :: slot
      character(len=:), allocatable :: row
      character(len=1), parameter :: nl = new_line('a')
      integer :: first, last

      row = ''
      first = index(table, nl//'!   '//to_text(slot)//' ')
      if (first == 0) first = index(table, nl//'!   '//to_text(slot)//',')
      if (first == 0) return
      last = first + index(table(first + 1:), nl)
      do while (index(table(last + 1:), '!          ') == 1)
         last = last + index(table(last + 1:), nl)
      end do
      row = table(first + 1:last)
   end function row

   !> The comments that a file begins with.
   subroutine read_head(path, head)
      character(len=*), intent(in) :: path
      character(len=:), allocatable, intent(out) :: head
      character(len=132) :: line
      integer :: unit, status

      head = ''
      open (newunit=unit, file=path, status='old', action='read', iostat=status)
      call assertEqual(0, status, path//' opens')
      if (status /= 0) return
      do
         read (unit, '(a)', iostat=status) line
         if (status /= 0 .or. line(1:1) /= '!') exit
         head = head//trim(line)//new_line('a')
      end do
      close (unit)
   end subroutine read_head

end module test_abaqus_heads
