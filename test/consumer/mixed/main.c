/* The same modulus by the library in Fortran, whose own procedures are not seen through that in C */
#include <asperity.h>
#include <stdio.h>

double modulus_of_two(double modulus, double poisson);

int main(void)
{
   asperity_error error;
   asperity_properties pair;

   asperity_properties_init(&pair, sizeof pair, &error);
   if (error.code != ASPERITY_OK)
      return 1;
   if (modulus_of_two(8.0, 0.0) != 4.0)
      return 2;
   puts("consumer: C and Fortran answer");
   return 0;
}
