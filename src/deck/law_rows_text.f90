!> A table of the law as keywords of ABAQUS and CalculiX: an interaction that a contact pair can
!> name. Its comments say what it holds, how good it is, and what the program makes of it.
module asperity_deck_law_rows_text
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_base_version, only: version
   use asperity_contact_properties, only: contact_properties
   use asperity_deck_law_rows, only: law_table, reach, stick_slope
   use asperity_deck_solver_friction, only: check_solver_friction, friction_parameters, &
      friction_rows
   use asperity_law_normal_law, only: evaluate_normal_law, normal_response
   use asperity_law_validity, only: validity_remark
   implicit none
   private
   public :: table_interaction

   !> Programs that read a table
   enum, bind(c)
      enumerator :: host_abaqus = 1, host_calculix
   end enum
   public :: host_abaqus, host_calculix

   !> CalculiX takes no more rows: it would put others of its own in their place
   integer, parameter, public :: calculix_rows = 200
   !> It has a spring where the clearance is below this times the root of the area of a slave node
   real(wp), parameter :: calculix_clearance = 1.0e-3_wp
   !> Both read twenty characters of a number
   integer, parameter :: figures = 12
   character(len=*), parameter :: newline = achar(10)

contains

   !> `*SURFACE INTERACTION` with the table and its friction, as lines. `error` is set when the
   !> program cannot take it.
   pure subroutine table_interaction(text, table, properties, host, name, stick_pressure, error)
      !> The lines, each with its end
      character(len=:), allocatable, intent(out) :: text
      !> The table, and the properties that it was made from
      type(law_table), intent(in) :: table
      type(contact_properties), intent(in) :: properties
      !> `host_abaqus` or `host_calculix`
      integer, intent(in) :: host
      !> Name of the interaction
      character(len=*), intent(in) :: name
      !> Pressure at which sticking faces have the law's stiffness, MPa; of no matter to ABAQUS
      real(wp), intent(in) :: stick_pressure
      !> Set when the program cannot take the table
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: line
      integer :: i, j

      text = ''
      call check_solver_friction(properties, host == host_calculix, error)
      if (allocated(error)) return
      if (host == host_calculix .and. size(table%pressure) > calculix_rows) then
         call fatal_error(error, 'rows = '//to_text(size(table%pressure))//' is too many '// &
            'for CalculiX, which puts '//to_text(calculix_rows)//' equally spaced ones in '// &
            'their place', subject='rows')
         return
      end if
      call describe(text, table, properties)
      if (host == host_calculix) then
         call describe_calculix(text, table, properties, stick_pressure)
      else
         call describe_abaqus(text, properties)
      end if
      call add(text, '*SURFACE INTERACTION, NAME='//name)
      call add(text, '*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=TABULAR')
      do i = 1, size(table%pressure)
         call add(text, to_text(table%pressure(i), figures)//', '// &
            to_text(table%overclosure(i), figures))
      end do
      if (.not. properties%friction_coefficient > 0.0_wp) return
      if (host == host_calculix) then
         call add(text, '*FRICTION')
         call add(text, to_text(properties%friction_coefficient, figures)//', '// &
            to_text(stick_slope(properties, stick_pressure), figures))
      else
         call add(text, '*FRICTION, ELASTIC SLIP='//to_text(properties%critical_slip, figures)// &
            friction_parameters(properties))
         associate (rows => friction_rows(properties))
            do i = 1, size(rows, 1)
               line = to_text(rows(i, 1), figures)
               do j = 2, size(rows, 2)
                  line = line//', '//to_text(rows(i, j), figures)
               end do
               call add(text, line)
            end do
         end associate
      end if
   end subroutine table_interaction

   !> What the table holds.
   pure subroutine describe(text, table, properties)
      character(len=:), allocatable, intent(inout) :: text
      type(law_table), intent(in) :: table
      type(contact_properties), intent(in) :: properties
      integer :: n

      n = size(table%pressure)
      associate (p => properties%normal)
         call comment(text, 'Contact of rough timber faces as a table, by asperity '//version// &
            '; N, mm, MPa')
         call comment(text, 'eta '//short(p%eta)//' /mm^2, E* '//short(p%modulus)//' MPa, R '// &
            short(p%radius)//' mm, H '//short(p%hardness)//' MPa, k '//short(p%yield_factor)// &
            ', sigma '//short(p%sigma)//' mm')
      end associate
      call comment(text, 'Rows: pressure, overclosure. Overclosure is penetration of the mesh '// &
         'faces, a clearance')
      call comment(text, 'is negative; separation of the mean planes = '// &
         short(properties%initial_separation)//' mm - overclosure')
      call comment(text, to_text(n)//' rows: linear interpolation is within '// &
         short(100.0_wp*table%error)//' % of the law (measured)')
      call comment(text, 'where the law is between '//short(table%smallest_pressure)//' and '// &
         short(table%largest_pressure)//' MPa, and within '//short(table%low_error)//' MPa below')
      call comment(text, 'The last row carries the slope at '//short(table%largest_pressure)// &
         ' MPa on for '//short(reach)//' sigma: no law there any more')
      if (table%validity /= 0) &
         call comment(text, 'CAUTION: '//validity_remark(table%validity))
   end subroutine describe

   !> What ABAQUS makes of it.
   pure subroutine describe_abaqus(text, properties)
      character(len=:), allocatable, intent(inout) :: text
      type(contact_properties), intent(in) :: properties

      call comment(text, 'Beyond the last row ABAQUS goes on with the last slope')
      if (.not. properties%friction_coefficient > 0.0_wp) then
         call comment(text, 'No friction')
         return
      end if
      call comment(text, 'ELASTIC SLIP is gcrit in mm, so that the stick slope is mu p/gcrit '// &
         'at any pressure p,')
      call comment(text, 'as in the law. Solve with UNSYMM=YES on *STEP')
   end subroutine describe_abaqus

   !> What CalculiX makes of it, as found in version 2.20.
   pure subroutine describe_calculix(text, table, properties, stick_pressure)
      character(len=:), allocatable, intent(inout) :: text
      type(law_table), intent(in) :: table
      type(contact_properties), intent(in) :: properties
      real(wp), intent(in) :: stick_pressure
      type(normal_response) :: at_rest

      at_rest = evaluate_normal_law(properties%normal, properties%initial_separation)
      call comment(text, 'CalculiX 2.20: TYPE=NODE TO SURFACE on *CONTACT PAIR only: with '// &
         'SURFACE TO SURFACE a table')
      call comment(text, '  gives no pressure at all, without a message, or a crash. The '// &
         'larger face is master')
      call comment(text, '  *CONTACT PRINT: CDIS and CSTR are right, the totals CF, CFN, CFS '// &
         'are zero')
      call comment(text, '  Contact only where the clearance is below '// &
         short(calculix_clearance)//' sqrt(area of the slave node): rows of')
      call comment(text, '  larger clearance have no effect, and faces meet and part with a '// &
         'jump of about '//short(at_rest%pressure)//' MPa,')
      call comment(text, '  the law at zero overclosure')
      call comment(text, '  Penetration at the start stays: the first increment counts its '// &
         'share of it, the others all')
      call comment(text, '  of it. So let the first step be one increment')
      call comment(text, '  Beyond the last row, '//short(table%pressure(size(table%pressure)))// &
         ' MPa, the pressure stays constant')
      if (.not. properties%friction_coefficient > 0.0_wp) then
         call comment(text, '  No friction')
         return
      end if
      call comment(text, '  Friction: mu, stick slope in MPa/mm. The slope is constant, mu '// &
         'p/gcrit at p = '//short(stick_pressure)//' MPa')
      call comment(text, '  with gcrit = '//short(properties%critical_slip)//' mm; in the law '// &
         'it follows the pressure. So faces slip after')
      call comment(text, '  gcrit p/('//short(stick_pressure)//' MPa), where it takes gcrit in '// &
         'the law. Slip made while open counts')
      call comment(text, '  at the next contact')
   end subroutine describe_calculix

   pure subroutine comment(text, line)
      character(len=:), allocatable, intent(inout) :: text
      character(len=*), intent(in) :: line

      call add(text, '** '//line)
   end subroutine comment

   pure subroutine add(text, line)
      character(len=:), allocatable, intent(inout) :: text
      character(len=*), intent(in) :: line

      text = text//line//newline
   end subroutine add

   !> A number for a comment.
   pure function short(value) result(text)
      real(wp), intent(in) :: value
      character(len=:), allocatable :: text

      text = to_text(value, 4)
   end function short

end module asperity_deck_law_rows_text
