!> Brings a report to where the user wants it: terminal, CSV, JSON, picture.
module app_delivery
   use asperity, only: error_type
   use asperity_error, only: fatal_error
   use app_cli, only: command_line_type
   use app_csv, only: csv_text
   use app_gnuplot, only: check_picture, draw
   use app_json, only: json_text
   use app_output, only: open_target, output_file, write_files, &
      write_standard_output
   use app_plots, only: plot_script
   use app_system, only: resolved_path, standard_error, write_text
   use app_report, only: report_type
   use app_terminal, only: terminal_text, warning_text
   implicit none
   private
   public :: delivery_type, prepare_delivery, deliver

   !> Outputs asked for.
   type :: delivery_type
      private
      !> Files to write
      type(output_file), allocatable :: files(:)
      !> Option whose text goes to standard output; empty for the table
      character(len=:), allocatable :: standard
   end type delivery_type

   !> Options that name a file; pictures first since they are most likely to fail
   character(len=*), parameter :: options(3) = [character(len=4) :: 'plot', 'csv', 'json']
   !> Path that stands for standard output
   character(len=*), parameter :: dash = '-'

contains

   !> Check the outputs before the work whose results they take.
   subroutine prepare_delivery(delivery, line, error)
      !> Outputs asked for
      type(delivery_type), intent(out) :: delivery
      !> Command line
      type(command_line_type), intent(in) :: line
      !> Set when an output cannot be written
      type(error_type), allocatable, intent(out) :: error
      type(output_file) :: files(size(options))
      character(len=:), allocatable :: option, path
      integer :: i, n

      delivery%standard = ''
      n = 0
      do i = 1, size(options)
         option = '--'//trim(options(i))
         path = line%options%text_of(trim(options(i)))
         if (path == '') cycle
         if (path == dash .and. option /= '--plot') then
            if (delivery%standard /= '') then
               call fatal_error(error, option//': standard output already takes '// &
                  delivery%standard)
               return
            end if
            delivery%standard = option
            cycle
         end if
         n = n + 1
         call open_target(files(n), option, path, error)
         if (.not. allocated(error) .and. option == '--plot') call check_picture(files(n), error)
         if (.not. allocated(error)) call check_collision(files(:n), line%case_path, error)
         if (allocated(error)) return
      end do
      allocate (delivery%files, source=files(:n))
   end subroutine prepare_delivery

   !> Set `error` if the last file is another output or the case file.
   subroutine check_collision(files, case_path, error)
      type(output_file), intent(in) :: files(:)
      character(len=*), intent(in) :: case_path
      type(error_type), allocatable, intent(out) :: error
      integer :: i

      associate (last => files(size(files)))
         if (last%is_device) return
         do i = 1, size(files) - 1
            if (files(i)%target == last%target) call fatal_error(error, last%option//': '// &
               last%path//' is already written by '//files(i)%option)
         end do
         if (case_path == '') return
         if (resolved_path(case_path) == last%target) call fatal_error(error, last%option// &
            ': '//last%path//' is the case file, it would be lost')
      end associate
   end subroutine check_collision

   !> Write all outputs. Files are written completely or not at all, then standard output.
   subroutine deliver(delivery, report, error)
      !> Outputs asked for
      type(delivery_type), intent(inout) :: delivery
      !> What to write
      type(report_type), intent(in) :: report
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: reason
      integer :: i

      do i = 1, size(delivery%files)
         associate (file => delivery%files(i))
            if (file%option == '--plot') then
               call draw(file, plot_script(report), error)
               if (allocated(error)) return
            else
               file%text = text_for(file%option, report)
            end if
         end associate
      end do
      call write_files(delivery%files, error)
      if (allocated(error)) return
      if (delivery%standard == '') then
         call write_standard_output(terminal_text(report), error)
      else
         call write_standard_output(text_for(delivery%standard, report), error)
         call write_text(standard_error, warning_text(report), reason)
      end if
   end subroutine deliver

   !> The report in the form of an option.
   pure function text_for(option, report) result(text)
      character(len=*), intent(in) :: option
      type(report_type), intent(in) :: report
      character(len=:), allocatable :: text

      if (option == '--csv') then
         text = csv_text(report%table)
      else
         text = json_text(report)
      end if
   end function text_for

end module app_delivery
