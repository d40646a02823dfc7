!> How the keys of a sweep are shown: as columns, in legends, and not as input of the run.
module asperity_program_commands_sweep_columns
   use asperity_base_kinds, only: wp
   use asperity_program_commands_sweep_cases, only: axis_type, places_of
   use asperity_program_input_key, only: key_type, kind_integer, kind_logical, kind_real
   use asperity_program_input_key_list, only: key_list
   use asperity_program_report_table, only: column_counts, table_type
   use asperity_program_report_terminal, only: input_text
   implicit none
   private
   public :: add_axes, case_words, hide_swept

contains

   !> Columns of the keys that are swept.
   subroutine add_axes(table, keys, axes, which)
      !> The table
      type(table_type), intent(inout) :: table
      !> The keys
      type(key_list), intent(in) :: keys
      !> The axes
      type(axis_type), intent(in) :: axes(:)
      !> Combination of each row
      integer, intent(in) :: which(:)
      type(key_type) :: key
      integer :: chosen(size(axes), size(which)), whole(size(which)), i, j
      real(wp) :: numbers(size(which))
      character(len=80) :: texts(size(which))

      do j = 1, size(which)
         chosen(:, j) = places_of(axes, which(j))
      end do
      do i = 1, size(axes)
         key = keys%rows(axes(i)%key)
         do j = 1, size(which)
            associate (value => axes(i)%values(chosen(i, j)))
               select case (key%kind)
               case (kind_real)
                  numbers(j) = value%values(1)
               case (kind_integer)
                  whole(j) = value%whole
               case (kind_logical)
                  texts(j) = merge('true ', 'false', value%switch)
               case default
                  texts(j) = value%text
               end select
            end associate
         end do
         select case (key%kind)
         case (kind_real)
            call table%add_numbers(trim(key%name), unit_of(key%unit), numbers)
         case (kind_integer)
            call table%add_codes(trim(key%name), column_counts, whole)
         case default
            call table%add_texts(trim(key%name), texts)
         end select
      end do
   end subroutine add_axes

   !> A unit, `-` for none.
   pure function unit_of(unit) result(text)
      character(len=*), intent(in) :: unit
      character(len=:), allocatable :: text

      text = trim(unit)
      if (text == '') text = '-'
   end function unit_of

   !> One combination in words, such as `sigma = 0.05 mm, pair = tangential-tangential`.
   pure function case_words(axes, which) result(text)
      !> The axes
      type(axis_type), intent(in) :: axes(:)
      !> The combination
      integer, intent(in) :: which
      character(len=:), allocatable :: text
      integer :: chosen(size(axes)), i

      chosen = places_of(axes, which)
      text = ''
      do i = 1, size(axes)
         if (i > 1) text = text//', '
         associate (key => axes(i)%values(chosen(i)))
            text = text//trim(key%name)//' = '//input_text(key)
            if (key%unit /= '') text = text//' '//trim(key%unit)
         end associate
      end do
   end function case_words

   !> Keys that are swept, and what follows from them, have no value of their own to show, nor have
   !> notes on the faces where these are swept.
   pure subroutine hide_swept(keys, axes)
      !> The keys
      type(key_list), intent(inout) :: keys
      !> The axes
      type(axis_type), intent(in) :: axes(:)
      integer :: i

      keys%rows(axes%key)%unused = .true.
      ! notes are on the values of one case
      if (allocated(keys%note) .and. any(keys%rows(axes%key)%is_property)) deallocate (keys%note)
      ! a leader stands above what follows it
      do i = 1, keys%n
         associate (leader => keys%rows(i)%leader)
            if (leader == 0) cycle
            if (keys%rows(leader)%unused) keys%rows(i)%unused = .true.
         end associate
      end do
   end subroutine hide_swept

end module asperity_program_commands_sweep_columns
