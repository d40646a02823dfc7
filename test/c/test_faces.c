/* Two faces as one pair: values, rules, and what is refused. */
#include "check.h"

#include <math.h>
#include <string.h>

static asperity_error error;

static asperity_face paper(const char *surface, int section)
{
   asperity_face face;
   CHECK_CODE(asperity_face_from_paper(&face, surface, section, &error), ASPERITY_OK);
   return face;
}

static void values(void)
{
   const asperity_face cross = paper("unpolished-cross", ASPERITY_SECTION_TRANSVERSE);
   const asperity_face tangential = paper("unpolished-tangential", ASPERITY_SECTION_TANGENTIAL);
   asperity_properties p, pair;
   asperity_law *law;

   CHECK(cross.sigma == 0.0593 && cross.radius == 0.1477 && cross.eta == 206.0);
   CHECK(cross.young_modulus == 3727.12 && cross.poisson_ratio == 0.42);
   CHECK(cross.hardness == 24.53 && tangential.hardness == 12.14);
   CHECK(tangential.young_modulus == 351.01 && tangential.poisson_ratio == 0.35);

   CHECK_CODE(asperity_properties_from_faces(&p, sizeof p, &cross, &tangential,
                                             ASPERITY_HARDNESS_SOFTER, ASPERITY_ROUGHNESS_MOMENTS,
                                             &error),
              ASPERITY_OK);
   /* Eq. 4, and the sum of moments as formulas have it */
   CHECK(fabs(p.modulus * (0.8236 / 3727.12 + 0.8775 / 351.01) - 1.0) < 1e-14);
   CHECK(fabs(p.radius * sqrt(1.0 / (0.1477 * 0.1477) + 1.0 / (0.1142 * 0.1142)) - 1.0) < 1e-14);
   CHECK(fabs(p.eta - 154.16) < 0.005 && fabs(p.sigma - 0.07244) < 5e-6);
   CHECK(p.hardness == 12.14 && p.yield_factor == 0.4);
   CHECK(p.friction_coefficient == 0.5 && p.critical_slip == 0.31);
   CHECK(p.initial_separation == ASPERITY_FOUR_SIGMA && p.size == sizeof p);
   CHECK_CODE(asperity_law_new(&law, &p, &error), ASPERITY_OK);
   asperity_law_free(&law, NULL);

   /* one face and the harder one: the paper's pair but for E* */
   CHECK_CODE(asperity_properties_from_faces(&p, sizeof p, &cross, &tangential,
                                             ASPERITY_HARDNESS_HARDER, ASPERITY_ROUGHNESS_FACE_1,
                                             &error),
              ASPERITY_OK);
   pair = wood(0);
   CHECK(p.modulus > 367.5 && p.modulus < 367.6);
   p.modulus = pair.modulus;
   CHECK(p.eta == pair.eta && p.radius == pair.radius && p.sigma == pair.sigma);
   CHECK(p.hardness == pair.hardness);
}

static void refused(void)
{
   const asperity_face good = paper("mesh-400-cross", ASPERITY_SECTION_TRANSVERSE);
   asperity_face bad = good, face = good;
   asperity_properties p;

   p.eta = -1.0;
   CHECK_CODE(asperity_face_from_paper(NULL, "unpolished-cross", 1, &error),
              ASPERITY_NULL_ARGUMENT);
   CHECK_CODE(asperity_face_from_paper(&face, NULL, 1, &error), ASPERITY_NULL_ARGUMENT);
   CHECK_CODE(asperity_face_from_paper(&face, "cross", 1, &error), ASPERITY_BAD_INPUT);
   CHECK_MESSAGE("surface = 'cross' is unknown");
   CHECK_CODE(asperity_face_from_paper(&face, "unpolished-cross", 0, &error), ASPERITY_BAD_INPUT);
   CHECK_MESSAGE("section = 0 is unknown");
   CHECK_CODE(asperity_face_from_paper(&face, "unpolished-radial", ASPERITY_SECTION_RADIAL,
                                       &error),
              ASPERITY_BAD_INPUT);
   CHECK_MESSAGE("hardness_radial is not given");
   CHECK(memcmp(&face, &good, sizeof face) == 0);

   CHECK_CODE(asperity_properties_from_faces(NULL, sizeof p, &good, &good, 1, 1, &error),
              ASPERITY_NULL_ARGUMENT);
   CHECK_CODE(asperity_properties_from_faces(&p, 8, &good, &good, 1, 1, &error),
              ASPERITY_WRONG_LENGTH);
   CHECK_CODE(asperity_properties_from_faces(&p, sizeof p, NULL, &good, 1, 1, &error),
              ASPERITY_NULL_ARGUMENT);
   CHECK_CODE(asperity_properties_from_faces(&p, sizeof p, &good, NULL, 1, 1, &error),
              ASPERITY_NULL_ARGUMENT);
   CHECK_CODE(asperity_properties_from_faces(&p, sizeof p, &good, &good, 0, 1, &error),
              ASPERITY_BAD_INPUT);
   CHECK_MESSAGE("hardness_rule = 0 is unknown");
   CHECK_CODE(asperity_properties_from_faces(&p, sizeof p, &good, &good, 1, 4, &error),
              ASPERITY_BAD_INPUT);
   CHECK_MESSAGE("roughness_rule = 4 is unknown");
   bad.hardness = (double)NAN;
   CHECK_CODE(asperity_properties_from_faces(&p, sizeof p, &good, &bad, 1, 1, &error),
              ASPERITY_BAD_INPUT);
   CHECK_MESSAGE("hardness_2 = NaN");
   bad.hardness = good.hardness;
   bad.poisson_ratio = 1.5;
   CHECK_CODE(asperity_properties_from_faces(&p, sizeof p, &bad, &good, 1, 1, &error),
              ASPERITY_BAD_INPUT);
   CHECK_MESSAGE("poisson_ratio_1 = 1.5");
   CHECK(p.eta == -1.0);
}

void test_faces(void)
{
   values();
   refused();
}
