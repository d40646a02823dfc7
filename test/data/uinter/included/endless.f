      INCLUDE 'endless.f'
