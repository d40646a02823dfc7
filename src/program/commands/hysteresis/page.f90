!> The page that `asperity hysteresis --report` writes: result, tables, pictures, input, remarks, in
!> one file that needs no other and prints well.
module asperity_program_commands_hysteresis_page
   use asperity_base_number_text, only: to_text
   use asperity_base_text_builder, only: growing_text
   use asperity_program_report_html, only: add_html_table
   use asperity_program_report_page, only: add_case, add_head, add_list, add_pictures, &
      add_remarks, end_page, origin_type
   use asperity_program_report_report, only: report_type
   use asperity_program_system_strings, only: string_type
   implicit none
   private
   public :: record_page

   !> Rows of a table that a page has
   integer, parameter :: most_rows = 500

   character(len=*), parameter :: definitions(*) = [character(len=260) :: &
      'Skeleton: the envelope of the first cycles; the mean takes both sides together, cycle '// &
      'by cycle (ASTM E2126).', &
      'Yield force: of the elastic and perfectly plastic curve of equal energy, through 0.4 of '// &
      'the peak; ultimate point: 0.8 of the peak past it, or the last point (ASTM E2126).', &
      'EN 12512: yield where two clear straight parts meet (two_lines), else where the line '// &
      'through 0.1 and 0.4 of the peak meets the tangent with a sixth of its slope (tangent); '// &
      'ultimate at 0.8 of the peak, at 30 mm or at the end.', &
      'Ductility class: medium from 4, high from 6 (EN 1998-1); three-cycle ductility: the '// &
      'largest amplitude up to the ultimate point whose third cycle has 0.8 of the force of '// &
      'the first, over the yield displacement.', &
      'Impairment: loss of force from the first to the third cycle, over the first. Damping: '// &
      'energy of the loop, or of its half, over 2 pi times the elastic energy of its peaks.', &
      'EN 26891: modified initial slip 4/3 (v04 - v01), slip modulus 0.4 of the estimated '// &
      'force over it; largest force up to 15 mm.']

contains

   !> Text of the page before each picture and after the last.
   function record_page(report) result(parts)
      !> The report, with its tables, pictures and remarks
      type(report_type), intent(in) :: report
      type(string_type), allocatable :: parts(:)
      type(growing_text) :: b
      type(origin_type) :: no_origins(0)
      integer :: i

      allocate (parts(size(report%pictures) + 1))
      call add_head(b, report, 'Record of displacement and force')
      call add_html_table(b, report%summary, 'Yield and ultimate point by equal energy '// &
         '(ASTM E2126), stiffness')
      do i = 1, size(report%more)
         if (report%more(i)%title /= '') &
            call add_html_table(b, report%more(i)%table, report%more(i)%title)
      end do
      call add_remarks(b, report)
      call add_pictures(b, report, parts)
      call b%line('<h2>Cycles</h2>')
      if (report%table%rows <= most_rows) then
         call add_html_table(b, report%table, 'Every cycle')
      else
         call b%line('<p>'//to_text(report%table%rows)//' cycles: --csv writes them.</p>')
      end if
      call b%line('<h2>Input</h2>')
      call add_case(b, report, report%keys, no_origins)
      call b%line('<h2>Definitions</h2>')
      call add_list(b, definitions)
      call end_page(b, 'The standards were not at hand: their definitions are used as they are '// &
         'commonly cited.')
      parts(size(parts))%text = b%text()
   end function record_page

end module asperity_program_commands_hysteresis_page
