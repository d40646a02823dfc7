!> How the text that a program of an instrument exports differs from a plain matrix or plain points.
module asperity_height_map_layout
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: export_layout

   !> What its reader knows besides what a header of plain text says.
   type :: export_layout
      !> Name of the format, for reports; empty for plain text
      character(len=32) :: format = ''
      !> Whether a line is one of constant x, and not of constant y
      logical :: has_lines_of_x = .false.
      !> Whether rows may be broken into lines anywhere
      logical :: has_broken_rows = .false.
      !> Whether numbers have decimal commas, as no comma separates them
      logical :: has_decimal_commas = .false.
      !> Whether something stands behind the heights; whether that is a matrix that is 1 where a
      !> point is missing
      logical :: has_more = .false., has_voids = .false.
      !> Whether a line with a mark must end the heights
      logical :: has_end_mark = .false.
      !> mm of a coordinate, 0 if it is not known; below 0 where they have a unit
      real(wp) :: coordinate = -1.0_wp
      !> Numbers from this on mark missing points
      real(wp) :: missing_from = huge(1.0_wp)
   end type export_layout

end module asperity_height_map_layout
