!> Brings a report to where the user wants it: terminal, CSV, JSON, picture.
module asperity_program_outputs
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type, fatal_error, file_error
   use asperity_base_memory, only: check_work
   use asperity_program_input_key, only: given_nowhere, kind_file, kind_picture, option_name
   use asperity_program_input_key_list, only: key_list
   use asperity_program_plot_gnuplot, only: check_picture, draw, format_of
   use asperity_program_plot_script, only: page_script, sheet_script
   use asperity_program_report_csv, only: write_csv
   use asperity_program_report_html, only: joined_page
   use asperity_program_report_json, only: write_json
   use asperity_program_report_report, only: report_type
   use asperity_program_report_terminal, only: terminal_text, warning_text
   use asperity_program_system_atomic_files, only: open_target, output_file, write_files, &
      write_standard_output
   use asperity_program_system_environment, only: output_width
   use asperity_program_system_files, only: standard_error, write_text
   use asperity_program_system_path, only: resolved_path
   use asperity_program_system_strings, only: split_lines, string_type
   use asperity_program_system_utf8, only: make_utf8, utf8_text
   implicit none
   private
   public :: delivery_type, prepare_delivery, deliver

   !> Outputs asked for.
   type :: delivery_type
      private
      !> Files to write
      type(output_file), allocatable :: files(:)
      !> How many of them, the first ones, are pictures
      integer :: pictures = 0
      !> Option whose text goes to standard output; empty for the table
      character(len=:), allocatable :: standard
   end type delivery_type

   !> Bytes that choosing the rows shown takes for each row of the table
   integer(int64), parameter :: bytes_of_row = 16
   !> How often the script of pictures is in memory on its way to gnuplot: it grows, becomes UTF-8,
   !> and follows its terminal
   integer(int64), parameter :: copies_of_script = 6
   !> Path that stands for standard output
   character(len=*), parameter :: dash = '-'

contains

   !> Check the outputs before the work whose results they take.
   subroutine prepare_delivery(delivery, keys, error)
      !> Outputs asked for
      type(delivery_type), intent(out) :: delivery
      !> Keys of the command
      type(key_list), intent(in) :: keys
      !> Set when an output cannot be written
      type(error_type), allocatable, intent(out) :: error
      type(output_file) :: files(keys%n)
      character(len=:), allocatable :: option
      integer :: i, n, pass

      delivery%standard = ''
      n = 0
      ! pictures first since they are most likely to fail
      do pass = 1, 2
         do i = 1, keys%n
            associate (key => keys%rows(i))
               if (key%kind /= merge(kind_picture, kind_file, pass == 1)) cycle
               if (key%given == given_nowhere) cycle
               option = option_name(key%name)
               if (key%text == dash .and. key%kind == kind_file) then
                  if (delivery%standard /= '') then
                     call fatal_error(error, option//': standard output already takes '// &
                        delivery%standard)
                     return
                  end if
                  delivery%standard = option
                  cycle
               end if
               n = n + 1
               call open_target(files(n), option, key%text, error)
               if (.not. allocated(error) .and. pass == 1) call check_picture(files(n), error)
               if (.not. allocated(error)) call check_collision(files(:n), keys, error)
               if (allocated(error)) return
            end associate
         end do
         if (pass == 1) delivery%pictures = n
      end do
      allocate (delivery%files, source=files(:n))
   end subroutine prepare_delivery

   !> Set `error` if the last file is another output or one that is read.
   subroutine check_collision(files, keys, error)
      type(output_file), intent(in) :: files(:)
      type(key_list), intent(in) :: keys
      type(error_type), allocatable, intent(out) :: error
      type(string_type), allocatable :: paths(:)
      integer :: i, k

      associate (last => files(size(files)))
         if (last%is_device) return
         do i = 1, size(files) - 1
            if (files(i)%target == last%target) call fatal_error(error, last%option//': '// &
               last%path//' is already written by '//files(i)%option)
         end do
         if (allocated(error)) return
         call check_input(last, keys%case_path, 'case file', error)
         do i = 1, keys%n
            associate (key => keys%rows(i))
               if (key%reads == '') cycle
               call split_lines(key%text, paths)
               do k = 1, size(paths)
                  if (.not. allocated(error)) &
                     call check_input(last, paths(k)%text, trim(key%reads), error)
               end do
            end associate
         end do
      end associate
   end subroutine check_collision

   !> Set `error` if a file to write is one that is read.
   subroutine check_input(file, path, what, error)
      type(output_file), intent(in) :: file
      character(len=*), intent(in) :: path, what
      type(error_type), allocatable, intent(out) :: error

      if (path == '') return
      if (resolved_path(path) == file%target) call fatal_error(error, file%option//': '// &
         file%path//' is the '//what//', it would be lost')
   end subroutine check_input

   !> Write all outputs. Files are written completely or not at all, then standard output.
   subroutine deliver(delivery, report, error)
      !> Outputs asked for
      type(delivery_type), intent(inout) :: delivery
      !> What to write; texts that can be large are moved out of it
      type(report_type), intent(inout) :: report
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: reason, text
      integer :: i

      call check_work('the report', bytes_of_row*report%table%rows, error)
      if (allocated(error)) return
      do i = 1, size(delivery%files)
         associate (file => delivery%files(i))
            if (i <= delivery%pictures) then
               call draw_pictures(file, report, error)
            else
               call take_text(file%option, report, file%text, error)
            end if
         end associate
         if (allocated(error)) return
      end do
      if (delivery%standard /= '') call take_text(delivery%standard, report, text, error)
      if (.not. allocated(error)) call write_files(delivery%files, error, is_ending=.true.)
      if (allocated(error)) return
      if (delivery%standard == '') then
         call write_standard_output(utf8_text(terminal_text(report, output_width())), error)
      else
         call write_standard_output(text, error)
         call write_text(standard_error, utf8_text(warning_text(report)), reason)
      end if
   end subroutine deliver

   !> Draw the pictures of a report on a sheet, or on a page.
   subroutine draw_pictures(file, report, error)
      type(output_file), intent(inout) :: file
      type(report_type), intent(in) :: report
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: pictures, script

      if (file%option == '--report') then
         call page_script(report%pictures, script, error)
      else
         call sheet_script(report%pictures, report%picture_title, format_of(file%path), script, &
            error)
      end if
      if (.not. allocated(error)) &
         call check_work(file%option, copies_of_script*len(script, int64), error)
      if (.not. allocated(error)) call draw(file, script, pictures, error)
      if (allocated(error)) return
      if (file%option == '--report') then
         call joined_page(report%page, pictures, file%text, error)
         if (allocated(error)) call fatal_error(error, file%option//': '//file%path// &
            ' cannot be written: '//error%message, file_error)
      else
         call move_alloc(pictures, file%text)
      end if
   end subroutine draw_pictures

   !> The report in the form of an option.
   pure subroutine take_text(option, report, text, error)
      character(len=*), intent(in) :: option
      type(report_type), intent(inout) :: report
      character(len=:), allocatable, intent(out) :: text
      type(error_type), allocatable, intent(out) :: error
      integer :: i

      if (allocated(report%decks)) then
         i = findloc([('--'//trim(report%decks(i)%option) == option, i=1, size(report%decks))], &
            .true., 1)
         if (i > 0) then
            call move_alloc(report%decks(i)%text, text)
            return
         end if
      end if
      if (option == '--csv') then
         call write_csv(report%table, text, error)
      else if (option == '--points') then
         call write_csv(report%points, text, error)
      else
         call write_json(report, text, error)
      end if
      if (.not. allocated(error)) call make_utf8(text, error)
      if (allocated(error)) error%message = option//': '//error%message
   end subroutine take_text

end module asperity_program_outputs
