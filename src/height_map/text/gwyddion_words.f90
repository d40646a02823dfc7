!> The keys of Gwyddion's text exports, which stand there in the language of the desktop.
module asperity_height_map_text_gwyddion_words
   implicit none
   private
   public :: to_english

   !> The nine languages of its 2.62 besides English, as `plain_key` leaves their words
   character(len=*), parameter :: channel(*) = [character(len=16) :: &
      'kanál', 'kanal', 'canal', 'canale', 'チャネル', '채널', 'Канал']
   character(len=*), parameter :: width(*) = [character(len=16) :: &
      'Šířka', 'breite', 'anchura', 'largeur', 'larghezza', '幅', '폭', 'largura', &
      'Ширина']
   character(len=*), parameter :: height(*) = [character(len=16) :: &
      'výška', 'höhe', 'altura', 'hauteur', 'altezza', '高さ', '높이', 'Высота']
   character(len=*), parameter :: value_units(*) = [character(len=34) :: &
      'jednotkyhodnot', 'einheiten', 'unités', 'unitàvalore', '値の単位', '값단위', &
      'unidadesdevalor', 'Единицыизмерения']
   character(len=*), parameter :: lateral_units(*) = [character(len=60) :: &
      'jednotkyrozměrů', 'unitéslatérales', 'unitàlaterali', '水平単位', &
      'unidadesdelaterais', 'Единицыгоризонтальныхразмеров']

contains

   !> The English key for one of another language; others stay.
   pure subroutine to_english(key)
      !> The key
      character(len=:), allocatable, intent(inout) :: key

      if (any(channel == key)) then
         key = 'channel'
      else if (any(width == key)) then
         key = 'width'
      else if (any(height == key)) then
         key = 'height'
      else if (any(value_units == key)) then
         key = 'valueunits'
      else if (any(lateral_units == key)) then
         key = 'lateralunits'
      end if
   end subroutine to_english

end module asperity_height_map_text_gwyddion_words
