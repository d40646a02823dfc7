/* What the tests of the C interface share: checks that count, and the law under test. */
#ifndef CHECK_H
#define CHECK_H

#include <asperity.h>

/* Count one check; say where it failed. */
#define CHECK(condition) check_that((condition), #condition, __FILE__, __LINE__)

/* |value - expected| <= tolerance * max(|expected|, floor); NaN fails. */
#define CHECK_NEAR(value, expected, tolerance, floor) \
   check_near((value), (expected), (tolerance), (floor), #value, __FILE__, __LINE__)

/* The call returns the code, and so does its error struct, with a message unless it is 0. */
#define CHECK_CODE(call, expected) check_code((call), (expected), &error, #call, __FILE__, __LINE__)

/* The message of the last error holds the text. */
#define CHECK_MESSAGE(text) check_message(&error, (text), __FILE__, __LINE__)

void check_that(int condition, const char *text, const char *file, int line);
void check_near(double value, double expected, double tolerance, double floor, const char *text,
                const char *file, int line);
void check_code(int code, int expected, const asperity_error *error, const char *text,
                const char *file, int line);
void check_message(const asperity_error *error, const char *text, const char *file, int line);

/* Properties of the pair transverse-tangential, as the README gives them. */
asperity_properties wood(int compiled);

/* A law of them; ends the program when there is none. */
asperity_law *wood_law(int compiled);

/* Fresh states; ends the program when there are none. */
asperity_states *fresh_states(int n);

/* The normal law by Simpson's rule, written anew in C: see reference.c. */
typedef struct reference {
   double pressure, stiffness, area_fraction, contact_density, energy;
} reference;
reference reference_law(const asperity_properties *p, double separation);

void test_layout(void);
void test_law(void);
void test_update(void);
void test_unloading(void);
void test_restart(void);
void test_friction(void);
void test_arguments(void);
void test_values(void);
void test_faces(void);
void test_memory(int limit);
void test_threads(void);

#endif
