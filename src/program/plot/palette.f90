!> Colours of all pictures, which colour-blind people can tell apart (Okabe and Ito).
module asperity_program_plot_palette
   use asperity_base_kinds, only: wp
   implicit none
   private

   !> The colours; lines of a family take them in this order
   character(len=7), parameter, public :: palette(7) = ['#0072B2', '#D55E00', '#009E73', &
      '#CC79A7', '#E69F00', '#56B4E9', '#000000']
   integer, parameter, public :: blue = 1, red = 2, green = 3, pink = 4, sky = 6, black = 7
   !> From low to high, for maps, and where the steps lie in between
   character(len=7), parameter, public :: map_palette(5) = ['#08306b', '#4292c6', '#f7f7f7', &
      '#ef8a62', '#7f0000']
   real(wp), parameter, public :: map_places(5) = [0.0_wp, 0.35_wp, 0.5_wp, 0.65_wp, 1.0_wp]
   !> Of grids, of axes through zero, of what has no value
   character(len=7), parameter, public :: grid_colour = '#d4d4d4', zero_colour = '#808080', &
      missing_colour = '#909090'

end module asperity_program_plot_palette
