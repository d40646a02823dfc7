!> What must be known beside the figures of a solid, of one joint or a frame.
module asperity_program_commands_joint_remarks
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_hysteresis_analysis, only: negative_side, positive_side
   use asperity_program_commands_hysteresis_remarks, only: excess_words
   use asperity_program_commands_joint_loops, only: legends
   use asperity_program_commands_solid_outcome, only: solid_outcome
   use asperity_program_system_strings, only: string_type
   implicit none
   private
   public :: analysis_remarks

   !> Work that is not accounted for, over all work, that is worth a word
   real(wp), parameter :: unbalanced = 0.01_wp
   !> Plastic strain that is no small one
   real(wp), parameter :: large_strain = 0.2_wp

contains

   !> Remarks on the analyses of all models, a line each.
   pure function analysis_remarks(outcomes) result(lines)
      !> The models
      type(solid_outcome), intent(in) :: outcomes(:)
      type(string_type), allocatable :: lines(:)
      character(len=:), allocatable :: text, name
      integer :: i, side

      allocate (lines(0))
      do i = 1, size(outcomes)
         name = trim(legends(outcomes(i)%model))
         associate (last => outcomes(i)%records(size(outcomes(i)%records)))
            if (.not. outcomes(i)%has_moment) then
               text = name//': there is no moment in any increment'
               call add_line(lines, text)
            end if
            if (last%plastic_strain > large_strain .and. .not. outcomes(i)%is_logarithmic) then
               text = name//': the wood''s plastic strain reaches '// &
                  to_text(last%plastic_strain, 2)//', which is past small strains: '// &
                  'strain = logarithmic bears it; a smaller mesh_size raises it'
               call add_line(lines, text)
            end if
            if (abs(last%balance) > unbalanced*abs(last%work)) then
               text = name//': '//to_text(last%balance, 3)//' of '//to_text(last%work, 4)// &
                  ' J of work are not accounted for; larger stroke_increments leave less'
               call add_line(lines, text)
            end if
            if (outcomes(i)%multigrid_failures > 0) then
               text = name//': multigrid did not converge ('// &
                  to_text(outcomes(i)%multigrid_failures)//'); factors took its place until '// &
                  'contact met other faces, with the memory of preconditioner = lu'
               call add_line(lines, text)
            end if
            do side = positive_side, negative_side
               text = excess_words(outcomes(i)%loops%skeleton(side), 'kN m')
               if (text == '') cycle
               text = name//': the analysis has '//text// &
                  ' than its skeleton through the tips of first cycles'
               call add_line(lines, text)
            end do
         end associate
      end do
   end function analysis_remarks

   !> One line more.
   pure subroutine add_line(lines, text)
      type(string_type), allocatable, intent(inout) :: lines(:)
      character(len=*), intent(in) :: text
      type(string_type) :: line

      line%text = text
      lines = [lines, line]
   end subroutine add_line

end module asperity_program_commands_joint_remarks
