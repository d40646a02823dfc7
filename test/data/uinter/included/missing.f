      INCLUDE 'nowhere.inc'
