!> What a fit comes to in words: what the record cannot tell, parameters at bounds, residuals that
!> are not random.
module asperity_program_commands_fit_words
   use asperity_base_error, only: computation_error, error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_fit_parameter, only: fit_parameter
   use asperity_fit_types, only: fit_result, is_unsettled
   use asperity_program_system_strings, only: add_line, string_type
   implicit none
   private
   public :: check_explained, check_settled, combination, durbin_watson, pronoun, residual_remarks

   !> Parts of a direction that count when it is written out
   real(wp), parameter :: written_part = 0.1_wp
   !> Residuals are not random if Durbin and Watson's number is so many standard errors below 2
   real(wp), parameter :: least_deviation = 3.0_wp
   !> Residuals smaller than this, over the scale, are rounding
   real(wp), parameter :: rounding = 1.0e-8_wp
   !> Standard error up to which intervals were found to hold the truth as often as they say
   real(wp), parameter :: largest_sure = 0.2_wp
   !> A model that misses more than this share of the readings is none of the record
   real(wp), parameter :: largest_miss = 0.5_wp
   !> Correlation from which a pair of parameters is named
   real(wp), parameter :: high_correlation = 0.98_wp

contains

   !> Set `error` when the record cannot settle what is free, or a parameter is at its bound.
   pure subroutine check_settled(parameters, result, error)
      !> The parameters
      type(fit_parameter), intent(in) :: parameters(:)
      !> What was found
      type(fit_result), intent(in) :: result
      !> Set then
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: text
      integer :: i

      text = ''
      if (.not. all(result%settled)) text = unsettled_words(parameters, result)
      if (text == '') then
         do i = 1, size(parameters)
            if (.not. result%at_bound(i)) cycle
            if (text /= '') text = text//'; '
            text = text//trim(parameters(i)%name)//' came to its bound '// &
               to_text(result%values(i), 4)//trim(' '//parameters(i)%unit)// &
               ': widen it by --bounds, or fix it'
         end do
      end if
      if (text /= '') call fatal_error(error, text, computation_error)
   end subroutine check_settled

   !> Set `error` when the model with the values found is no model of the record.
   pure subroutine check_explained(readings, model, error)
      !> What was read, and the model there
      real(wp), intent(in) :: readings(:), model(:)
      !> Set then
      type(error_type), allocatable, intent(out) :: error

      if (norm2(model - readings) <= largest_miss*norm2(readings)) return
      call fatal_error(error, 'the model misses '//to_text(100.0_wp*norm2(model - readings) &
         /norm2(readings), 2)//' % of the readings with the best values (root mean square): '// &
         'this is a record of something else, or what is fixed is wrong', computation_error)
   end subroutine check_explained

   !> Which parameters the directions that are not settled are of.
   pure function unsettled_words(parameters, result) result(text)
      type(fit_parameter), intent(in) :: parameters(:)
      type(fit_result), intent(in) :: result
      character(len=:), allocatable :: text
      integer, allocatable :: members(:)
      integer :: i, n

      n = count(.not. result%settled)
      members = pack([(i, i=1, size(parameters))], [(is_unsettled(result, i), &
         i=1, size(parameters))])
      text = ''
      do i = 1, size(members)
         if (i > 1 .and. i == size(members)) then
            text = text//' and '
         else if (i > 1) then
            text = text//', '
         end if
         text = text//trim(parameters(members(i))%name)
      end do
      if (size(members) == n) then
         text = text//' cannot be told by this record: fix '//trim(merge('it  ', 'them', n == 1))
      else
         text = text//' cannot be told apart by this record: fix '//to_text(n)//' of them'
      end if
      text = text//', or give a record with less noise'
   end function unsettled_words

   !> `it` or `them`.
   pure function pronoun(names)
      !> One name, or several between blanks
      character(len=*), intent(in) :: names
      character(len=:), allocatable :: pronoun

      pronoun = 'it'
      if (scan(names, ' ') > 0) pronoun = 'them'
   end function pronoun

   !> A direction written out, such as `0.71 ln eta - 0.70 ln radius`.
   pure function combination(parameters, direction) result(text)
      !> The parameters
      type(fit_parameter), intent(in) :: parameters(:)
      !> Parts of them
      real(wp), intent(in) :: direction(:)
      character(len=:), allocatable :: text
      real(wp) :: part
      integer :: i

      text = ''
      do i = 1, size(direction)
         part = direction(i)*sign(1.0_wp, direction(maxloc(abs(direction), 1)))
         if (abs(part) < written_part) cycle
         if (text == '') then
            if (part < 0.0_wp) text = '-'
         else
            text = text//trim(merge(' +', ' -', part > 0.0_wp))//' '
         end if
         text = text//to_text(abs(part), 2)//' '
         if (parameters(i)%by_ratio) then
            text = text//'ln '//trim(parameters(i)%name)
         else
            text = text//trim(parameters(i)%name)//'/('//to_text(parameters(i)%scale, 2)// &
               trim(' '//parameters(i)%unit)//')'
         end if
      end do
   end function combination

   !> Durbin and Watson's number: 2 for residuals without order, near 0 for those that go on.
   pure real(wp) function durbin_watson(residuals)
      !> The residuals, in the order of the record
      real(wp), intent(in) :: residuals(:)
      integer :: n

      n = size(residuals)
      durbin_watson = 2.0_wp
      if (norm2(residuals) > 0.0_wp) durbin_watson = &
         sum((residuals(2:)/norm2(residuals) - residuals(:n - 1)/norm2(residuals))**2)
   end function durbin_watson

   !> What is to be said of residuals and correlations.
   pure function residual_remarks(parameters, result) result(lines)
      !> The parameters
      type(fit_parameter), intent(in) :: parameters(:)
      !> What was found
      type(fit_result), intent(in) :: result
      type(string_type), allocatable :: lines(:)
      real(wp) :: number
      integer :: i, j

      allocate (lines(0))
      if (result%agreeing < result%searches) call add_line(lines, to_text(result%agreeing)// &
         ' of '//to_text(result%searches)//' searches came to this '// &
         'minimum, the others to worse ends.')
      number = durbin_watson(result%residuals)
      if ((1.0_wp - 0.5_wp*number)*sqrt(real(size(result%residuals), wp)) > least_deviation &
         .and. norm2(result%residuals) > rounding*sqrt(real(size(result%residuals), wp))) &
         call add_line(lines, 'The residuals go on from one sample to the next '// &
         '(Durbin-Watson '//to_text(number, 2)//', 2 for noise): the model misses the shape of '// &
         'the record, or the record drifts. The intervals count noise alone and are too narrow.')
      do i = 1, size(parameters)
         if (result%standard_errors(i) > largest_sure) call add_line(lines, &
            trim(parameters(i)%name)//' is known so little that its interval may hold the '// &
            'truth less often than 95 times in 100 (docs/fit.md).')
         do j = 1, i - 1
            if (abs(result%correlations(i, j)) < high_correlation) cycle
            call add_line(lines, trim(parameters(j)%name)//' and '// &
               trim(parameters(i)%name)//' are known together much better than each: '// &
               'correlation '//to_text(result%correlations(i, j), 3)//'.')
         end do
      end do
   end function residual_remarks

end module asperity_program_commands_fit_words
