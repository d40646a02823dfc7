!> What a check found, as tables and as text.
module asperity_program_commands_check_tables
   use asperity_base_number_text, only: to_text
   use asperity_check_finding, only: finding_list, n_rules, rule_names, &
      severity_error, severity_names, severity_note, severity_warning
   use asperity_program_report_report, only: report_type
   use asperity_program_report_table, only: new_table, table_type
   use asperity_program_system_strings, only: string_type
   implicit none
   private
   public :: report_findings, count_severity

   !> Where the text of a finding begins on its lines
   integer, parameter, public :: text_column = 24

contains

   !> Put the findings into a report, the worst first.
   subroutine report_findings(report, findings, is_tried)
      !> The report
      type(report_type), intent(inout) :: report
      !> What was found
      type(finding_list), intent(in) :: findings
      !> Rules that were tried
      logical, intent(in) :: is_tried(n_rules)
      integer :: order(findings%n)
      integer :: i, n, severity

      n = 0
      do severity = severity_error, severity_note
         do i = 1, findings%n
            if (findings%items(i)%severity /= severity) cycle
            n = n + 1
            order(n) = i
         end do
      end do
      report%table = finding_table(findings, order)
      report%shows_table = .false.
      report%first_rows = [1, findings%n + 1]
      allocate (report%more(1))
      report%more(1)%name = 'rules'
      report%more(1)%title = ''
      report%more(1)%table = rule_table(findings, is_tried)
      call finding_lines(findings, order, report%paragraphs)
      report%paragraph_indent = text_column
      call sum_up(findings, is_tried, report%verdict)
   end subroutine report_findings

   !> How many findings have a severity.
   pure integer function count_severity(findings, severity) result(n)
      !> The findings
      type(finding_list), intent(in) :: findings
      !> The severity
      integer, intent(in) :: severity

      n = 0
      if (findings%n > 0) n = count(findings%items(:findings%n)%severity == severity)
   end function count_severity

   !> One row a finding.
   pure function finding_table(findings, order) result(table)
      type(finding_list), intent(in) :: findings
      integer, intent(in) :: order(:)
      type(table_type) :: table
      type(string_type) :: texts(size(order), 6)
      integer :: i

      do i = 1, size(order)
         associate (f => findings%items(order(i)))
            texts(i, 1)%text = trim(rule_names(f%rule))
            texts(i, 2)%text = trim(severity_names(f%severity))
            texts(i, 3)%text = f%place
            texts(i, 4)%text = f%expected
            texts(i, 5)%text = f%found
            texts(i, 6)%text = f%effect
         end associate
      end do
      table = new_table(columns=6, rows=size(order))
      call add_column(table, 'rule', texts(:, 1))
      call add_column(table, 'severity', texts(:, 2))
      call add_column(table, 'place', texts(:, 3))
      call add_column(table, 'expected', texts(:, 4))
      call add_column(table, 'found', texts(:, 5))
      call add_column(table, 'effect', texts(:, 6))
   end function finding_table

   !> Append a column of texts of any length.
   pure subroutine add_column(table, name, texts)
      type(table_type), intent(inout) :: table
      character(len=*), intent(in) :: name
      type(string_type), intent(in) :: texts(:)
      integer :: i, longest

      longest = 1
      do i = 1, size(texts)
         longest = max(longest, len(texts(i)%text))
      end do
      call add_texts(table, name, texts, longest)
   end subroutine add_column

   !> Add them in a length that all have room in.
   pure subroutine add_texts(table, name, texts, length)
      type(table_type), intent(inout) :: table
      character(len=*), intent(in) :: name
      type(string_type), intent(in) :: texts(:)
      integer, intent(in) :: length
      character(len=length) :: rows(size(texts))
      integer :: i

      do i = 1, size(texts)
         rows(i) = texts(i)%text
      end do
      call table%add_texts(name, rows)
   end subroutine add_texts

   !> One row a rule: what came of it.
   pure function rule_table(findings, is_tried) result(table)
      type(finding_list), intent(in) :: findings
      logical, intent(in) :: is_tried(n_rules)
      type(table_type) :: table
      character(len=10) :: results(n_rules)
      integer :: i

      results = 'not tried'
      where (is_tried) results = 'passed'
      do i = findings%n, 1, -1
         results(findings%items(i)%rule) = 'failed'
      end do
      table = new_table(columns=2, rows=n_rules)
      call table%add_texts('rule', rule_names)
      call table%add_texts('result', results)
   end function rule_table

   !> Findings as lines for the terminal.
   pure subroutine finding_lines(findings, order, lines)
      type(finding_list), intent(in) :: findings
      integer, intent(in) :: order(:)
      type(string_type), allocatable, intent(out) :: lines(:)
      character(len=text_column) :: head
      integer :: i

      allocate (lines(3*size(order)))
      do i = 1, size(order)
         associate (f => findings%items(order(i)))
            head = severity_names(f%severity)//'  '//rule_names(f%rule)
            lines(3*i - 2)%text = head//f%place
            lines(3*i - 1)%text = repeat(' ', text_column)//'expected '//f%expected//'; found '// &
               f%found
            lines(3*i)%text = repeat(' ', text_column)//f%effect
         end associate
      end do
   end subroutine finding_lines

   !> What it comes to: numbers of findings, rules that passed, rules that were not tried.
   subroutine sum_up(findings, is_tried, lines)
      type(finding_list), intent(in) :: findings
      logical, intent(in) :: is_tried(n_rules)
      type(string_type), allocatable, intent(out) :: lines(:)
      logical :: has_passed(n_rules), is_left(n_rules)
      integer :: i

      has_passed = is_tried
      is_left = .not. is_tried
      do i = 1, findings%n
         has_passed(findings%items(i)%rule) = .false.
         is_left(findings%items(i)%rule) = .false.
      end do
      allocate (lines(merge(3, 2, any(is_left))))
      lines(1)%text = counted(count_severity(findings, severity_error), 'error')//', '// &
         counted(count_severity(findings, severity_warning), 'warning')//', '// &
         counted(count_severity(findings, severity_note), 'note')//'.'
      lines(2)%text = counted(count(has_passed), 'rule')//' passed'//named(has_passed)
      if (any(is_left)) lines(3)%text = 'Not tried'//named(is_left)
   end subroutine sum_up

   !> `3 errors`.
   pure function counted(n, what) result(text)
      integer, intent(in) :: n
      character(len=*), intent(in) :: what
      character(len=:), allocatable :: text

      text = to_text(n)//' '//what
      if (n /= 1) text = text//'s'
   end function counted

   !> `: guard, repeat.`
   pure function named(is_meant) result(text)
      logical, intent(in) :: is_meant(n_rules)
      character(len=:), allocatable :: text
      integer :: i

      text = ''
      do i = 1, n_rules
         if (is_meant(i) .and. text /= '') text = text//', '
         if (is_meant(i)) text = text//trim(rule_names(i))
      end do
      if (text /= '') text = ': '//text
      text = text//'.'
   end function named

end module asperity_program_commands_check_tables
