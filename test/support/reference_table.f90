!> Opens tables of test/data, and reads normal_law_reference.csv: inputs, and the law's values in 30
!> digits.
module reference_table
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_law_normal_properties, only: new_normal_properties, normal_properties
   use funit, only: assertEqual
   implicit none
   private
   public :: open_table, reference_row, read_reference

   integer, parameter, public :: n_columns = 8
   !> Names of the values, as the library names them
   character(len=19), parameter, public :: columns(n_columns) = [character(len=19) :: &
      'pressure', 'stiffness', 'area_fraction', 'contact_density', 'energy', 'elastic_share', &
      'elastoplastic_share', 'plastic_share']

   character(len=*), parameter :: header = 'kind,sigma,eta,modulus,radius,hardness,'// &
      'yield_factor,h,separation,pressure,stiffness,area_fraction,contact_density,energy,'// &
      'elastic_share,elastoplastic_share,plastic_share,w1,w2'

   !> One row of the table.
   type :: reference_row
      !> `paper`, `plausible`, `stress`, `sweep` or `edge`
      character(len=16) :: kind
      !> Properties that the library makes of the row's inputs
      type(normal_properties) :: properties
      !> Separation d, mm
      real(wp) :: separation
      !> The exact values, in the order of `columns`
      real(wp) :: values(n_columns)
      !> The exact w1 and w2, mm
      real(wp) :: w1, w2
   end type reference_row

contains

   !> All rows; `message` says what went wrong and is empty when nothing did.
   subroutine read_reference(rows, message)
      !> Rows read
      type(reference_row), allocatable, intent(out) :: rows(:)
      !> What went wrong, or nothing
      character(len=:), allocatable, intent(out) :: message
      character(len=1024) :: line, path
      real(wp) :: input(8)
      type(reference_row) :: row
      type(error_type), allocatable :: error
      integer :: unit, status

      message = ''
      allocate (rows(0))
      call get_environment_variable('ASPERITY_TEST_DATA', path, status=status)
      if (status /= 0) path = 'test/data'
      open (newunit=unit, file=trim(path)//'/normal_law_reference.csv', status='old', &
         action='read', iostat=status)
      if (status /= 0) then
         message = 'no '//trim(path)//'/normal_law_reference.csv (ASPERITY_TEST_DATA is its folder)'
         return
      end if
      read (unit, '(a)') line
      if (line /= header) message = 'normal_law_reference.csv has other columns'
      do while (message == '')
         read (unit, '(a)', iostat=status) line
         if (status /= 0) exit
         read (line, *, iostat=status) row%kind, input, row%values, row%w1, row%w2
         if (status /= 0) then
            message = 'unreadable: '//trim(line)
            exit
         end if
         row%separation = input(8)
         call new_normal_properties(row%properties, input(2), input(3), input(4), input(5), &
            input(6), input(1), error, accept_unphysical=.true.)
         if (allocated(error)) then
            message = 'refused: '//error%message
            exit
         end if
         rows = [rows, row]
      end do
      close (unit)
   end subroutine read_reference

   !> Open a table of test/data, with these columns, before its first row.
   subroutine open_table(name, header, unit)
      !> Its name, and its first line
      character(len=*), intent(in) :: name, header
      !> The unit it is open on
      integer, intent(out) :: unit
      character(len=1024) :: line, path
      integer :: status

      call get_environment_variable('ASPERITY_TEST_DATA', path, status=status)
      if (status /= 0) path = 'test/data'
      open (newunit=unit, file=trim(path)//'/'//name, status='old', action='read', iostat=status)
      if (status /= 0) error stop 'no such table (ASPERITY_TEST_DATA is its folder)'
      read (unit, '(a)') line
      call assertEqual(header, trim(line), 'columns of '//name)
   end subroutine open_table

end module reference_table
