!> The numbers of a press record's model: their names, and where a search for them begins and stays.
module asperity_program_commands_fit_press_numbers
   use asperity_base_kinds, only: wp
   use asperity_fit_parameter, only: fit_parameter
   use asperity_fit_press, only: press_compliance, press_separation
   use asperity_program_commands_faces_properties, only: eta, face_properties, sigma, yield_factor
   use asperity_program_commands_fit_record_input, only: fit_record
   implicit none
   private
   public :: least_yield_factor, press_name, press_names, press_number, press_parameter

   character(len=*), parameter, public :: separation_name = 'initial_separation', &
      compliance_name = 'machine_compliance'
   !> Bounds of what nothing is known of, and the way to them from a value that something gives
   real(wp), parameter :: usual_bounds(2, sigma) = reshape([1.0_wp, 1.0e5_wp, 1.0_wp, 1.0e5_wp, &
      1.0e-3_wp, 1.0e2_wp, 0.1_wp, 1.0e4_wp, 0.05_wp, 1.0_wp, 1.0e-5_wp, 5.0_wp], [2, sigma])
   real(wp), parameter :: usual_ratio = 100.0_wp
   !> Bounds over the range of closures: of sigma; of the separation at closure zero, from the
   !> largest closure on
   real(wp), parameter :: sigma_bounds(2) = [0.02_wp, 50.0_wp]
   real(wp), parameter :: separation_bounds(2) = [-5.0_wp, 25.0_wp]
   !> Where a compliance begins, over that of a record that is all machine
   real(wp), parameter :: first_compliance = 0.1_wp

contains

   !> Place of a number, as asperity_fit_press counts them, zero for none.
   pure integer function press_number(name)
      !> Name of its key
      character(len=*), intent(in) :: name

      press_number = findloc(face_properties(eta:sigma)%name == name, .true., 1)
      if (name == separation_name) press_number = press_separation
      if (name == compliance_name) press_number = press_compliance
   end function press_number

   !> Name of a number's key.
   pure function press_name(which) result(name)
      !> Its place
      integer, intent(in) :: which
      character(len=:), allocatable :: name

      select case (which)
      case (press_separation)
         name = separation_name
      case (press_compliance)
         name = compliance_name
      case default
         name = trim(face_properties(which)%name)
      end select
   end function press_name

   !> All names for a message.
   pure function press_names() result(text)
      character(len=:), allocatable :: text
      integer :: i

      text = ''
      do i = 1, press_compliance - 1
         text = text//press_name(i)//', '
      end do
      text = text//'and '//press_name(press_compliance)
   end function press_names

   !> Unit, start and bounds of a number.
   pure type(fit_parameter) function press_parameter(which, record, value, is_known) result(p)
      !> Its place
      integer, intent(in) :: which
      !> The record
      type(fit_record), intent(in) :: record
      !> A value that something gives, and whether there is one
      real(wp), intent(in) :: value
      logical, intent(in) :: is_known
      real(wp) :: range

      range = maxval(record%x) - minval(record%x)
      p%name = press_name(which)
      select case (which)
      case (press_separation)
         p%unit = 'mm'
         p%scale = range
         p%lower = maxval(record%x) + separation_bounds(1)*range
         p%upper = maxval(record%x) + separation_bounds(2)*range
         p%start = maxval(record%x) + range
      case (press_compliance)
         p%unit = 'mm/MPa'
         p%scale = range/maxval(record%y)
         p%upper = p%scale
         p%start = first_compliance*p%upper
      case default
         p%unit = face_properties(which)%unit
         p%by_ratio = .true.
         p%lower = usual_bounds(1, which)
         p%upper = usual_bounds(2, which)
         if (which == sigma) then
            p%lower = max(p%lower, sigma_bounds(1)*range)
            p%upper = min(p%upper, sigma_bounds(2)*range)
         else if (is_known .and. which /= yield_factor) then
            p%lower = value/usual_ratio
            p%upper = value*usual_ratio
         end if
         p%start = sqrt(p%lower)*sqrt(p%upper)
      end select
      if (is_known) p%start = value
   end function press_parameter

   !> Lower bound of the yield factor with elastic unloading, which the law allows.
   pure real(wp) function least_yield_factor(plastic_ratio)
      !> w2/w1
      real(wp), intent(in) :: plastic_ratio

      least_yield_factor = 2.0001_wp/sqrt(plastic_ratio)
   end function least_yield_factor

end module asperity_program_commands_fit_press_numbers
