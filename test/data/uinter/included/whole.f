C     Own: a UINTER that stands in another file, whose name is written as Windows allows
      INCLUDE 'BODY.INC'
      SUBROUTINE OTHER(A)
      INCLUDE 'ABA_PARAM.INC'
      COMMON /KEEP/ B
      END
