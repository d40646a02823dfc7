/* The structs of asperity.h are the library's, member by member, and calls write no byte beyond. */
#include "check.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

/* A value at each end that no call may touch */
typedef struct guarded_state {
   double before;
   asperity_state state;
   double after;
} guarded_state;

typedef struct guarded_properties {
   double before;
   asperity_properties p;
   double after;
} guarded_properties;

/* What stands for the law of before. */
static void defaults(const asperity_properties *p)
{
   int i;

   CHECK(p->plastic_ratio == 110.0 && p->height_distribution == ASPERITY_HEIGHTS_GAUSSIAN);
   CHECK(p->skewness == 0.0 && p->kurtosis == 3.0);
   CHECK(p->static_friction_coefficient == 0.0 && p->decay_slip == 0.0);
   CHECK(p->decay_slip_rate == 0.0 && p->friction_coefficient_across == 0.0);
   CHECK(p->grain_angle == 0.0 && p->slip_direction == ASPERITY_SLIP_ASSOCIATED);
   CHECK(p->pressure_exponent == 0.0 && p->reference_pressure == 0.0 && p->shear_limit == 0.0);
   CHECK(p->stick == ASPERITY_STICK_CRITICAL_SLIP && p->stick_elements == 0);
   CHECK(p->shear_modulus == 0.0 && p->friction_points == 0);
   for (i = 0; i < ASPERITY_MOST_FRICTION_POINTS; i++)
      CHECK(p->friction_pressures[i] == 0.0 && p->friction_factors[i] == 0.0);
}

static void properties(void)
{
   guarded_properties g;
   asperity_properties p;
   asperity_law *law;
   asperity_error error;

   memset(&g, 0, sizeof g);
   g.before = 1.25;
   g.after = 2.5;
   CHECK_CODE(asperity_properties_init(&g.p, sizeof g.p, &error), ASPERITY_OK);
   CHECK(g.before == 1.25 && g.after == 2.5);
   CHECK(g.p.size == sizeof(asperity_properties));
   CHECK(isnan(g.p.eta) && isnan(g.p.modulus) && isnan(g.p.radius) && isnan(g.p.hardness));
   CHECK(isnan(g.p.yield_factor) && isnan(g.p.sigma) && isnan(g.p.friction_coefficient));
   CHECK(isnan(g.p.critical_slip));
   CHECK(g.p.initial_separation == ASPERITY_FOUR_SIGMA);
   CHECK(g.p.friction_rule == ASPERITY_RULE_ABAQUS);
   CHECK(g.p.slip_integration == ASPERITY_SLIP_EXACT);
   CHECK(g.p.accept_unphysical == 0 && g.p.compiled == 0);
   CHECK(g.p.unloading == ASPERITY_UNLOADING_REVERSIBLE);
   defaults(&g.p);

   /* distinct values go to the library and come back each from its own member */
   p = wood(1);
   p.initial_separation = -0.125;
   p.friction_rule = ASPERITY_RULE_DISSIPATIVE;
   p.slip_integration = ASPERITY_SLIP_BACKWARD_EULER;
   p.unloading = ASPERITY_UNLOADING_ELASTIC;
   CHECK_CODE(asperity_law_new(&law, &p, &error), ASPERITY_OK);
   CHECK_CODE(asperity_law_properties(law, &g.p, sizeof g.p, &error), ASPERITY_OK);
   CHECK(g.before == 1.25 && g.after == 2.5);
   CHECK(g.p.size == sizeof p);
   CHECK(g.p.eta == 206.0 && g.p.modulus == 297.0 && g.p.radius == 0.1477);
   CHECK(g.p.hardness == 24.53 && g.p.yield_factor == 0.4 && g.p.sigma == 0.0593);
   CHECK(g.p.friction_coefficient == 0.5 && g.p.critical_slip == 0.31);
   CHECK(g.p.initial_separation == -0.125);
   CHECK(g.p.friction_rule == ASPERITY_RULE_DISSIPATIVE);
   CHECK(g.p.slip_integration == ASPERITY_SLIP_BACKWARD_EULER);
   CHECK(g.p.accept_unphysical == 1 && g.p.compiled == 1);
   CHECK(g.p.unloading == ASPERITY_UNLOADING_ELASTIC);
   CHECK_CODE(asperity_law_free(&law, &error), ASPERITY_OK);

   /* a pair of the paper, each value in its own member, and the defaults */
   CHECK_CODE(asperity_properties_from_pair(&g.p, sizeof g.p, "transverse-tangential", &error),
              ASPERITY_OK);
   CHECK(g.before == 1.25 && g.after == 2.5);
   p = wood(0);
   /* the last member and what may pad the struct behind it */
   CHECK(memcmp(&g.p, &p, offsetof(asperity_properties, unloading)) == 0);
   CHECK(g.p.unloading == ASPERITY_UNLOADING_REVERSIBLE);
   defaults(&g.p);
   CHECK_CODE(asperity_properties_from_pair(&p, sizeof p, "tangential-tangential", &error),
              ASPERITY_OK);
   CHECK(p.eta == 134.0 && p.modulus == 263.0 && p.radius == 0.1142 && p.hardness == 12.14);
   CHECK(p.yield_factor == 0.4 && p.sigma == 0.0416 && p.friction_coefficient == 0.5);
   CHECK(p.critical_slip == 0.31 && p.initial_separation == ASPERITY_FOUR_SIGMA);

   law = wood_law(0);
   CHECK_CODE(asperity_law_properties(law, &p, sizeof p, &error), ASPERITY_OK);
   CHECK(p.initial_separation == 4.0 * 0.0593 && p.compiled == 0);
   CHECK(p.friction_rule == ASPERITY_RULE_ABAQUS && p.slip_integration == ASPERITY_SLIP_EXACT);
   CHECK_CODE(asperity_law_free(&law, &error), ASPERITY_OK);
   law = wood_law(1);
   CHECK_CODE(asperity_law_properties(law, &p, sizeof p, &error), ASPERITY_OK);
   CHECK(p.initial_separation == 4.0 * 0.0593 && p.compiled == 1);
   CHECK_CODE(asperity_law_free(&law, &error), ASPERITY_OK);
}

static void state(void)
{
   asperity_state given = {ASPERITY_SLIP, 37, -0.25, 1.5, 2.5, {3.5, -4.5}, 5.5, 6.5, -7.5, 0.75,
                           -8.5, {{0.0, 0.0}}};
   guarded_state g;
   asperity_states *states = fresh_states(3);
   asperity_error error;
   int i;

   for (i = 0; i < ASPERITY_MOST_STICK_ELEMENTS; i++) {
      given.summit_slip[i][0] = 0.5 + i;
      given.summit_slip[i][1] = -0.25 - i;
   }
   CHECK_CODE(asperity_states_set(states, 1, 1, &given, &error), ASPERITY_OK);
   memset(&g, 0x5a, sizeof g);
   g.before = 1.25;
   g.after = 2.5;
   CHECK_CODE(asperity_states_get(states, 1, 1, &g.state, &error), ASPERITY_OK);
   CHECK(g.before == 1.25 && g.after == 2.5);
   CHECK(g.state.status == ASPERITY_SLIP && g.state.validity == 37);
   CHECK(g.state.overclosure == -0.25 && g.state.pressure == 1.5);
   CHECK(g.state.normal_energy == 2.5);
   CHECK(g.state.elastic_slip[0] == 3.5 && g.state.elastic_slip[1] == -4.5);
   CHECK(g.state.largest_closure == 5.5);
   CHECK(g.state.dissipation == 6.5 && g.state.pressure_coupling == -7.5);
   CHECK(g.state.motion_share == 0.75 && g.state.grain_turn == -8.5);
   CHECK(memcmp(g.state.summit_slip, given.summit_slip, sizeof given.summit_slip) == 0);
   asperity_states_free(&states, NULL);
}

/* A message ends within its member, and nothing is written after it. */
static void error_struct(void)
{
   struct {
      asperity_error error;
      int after;
   } g;
   int length;

   memset(&g, 0x5a, sizeof g);
   CHECK(asperity_law_new(NULL, NULL, &g.error) == ASPERITY_NULL_ARGUMENT);
   CHECK(g.error.code == ASPERITY_NULL_ARGUMENT);
   CHECK(strstr(g.error.message, "law is NULL") != NULL);
   CHECK(memchr(g.error.message, '\0', sizeof g.error.message) != NULL);
   /* nothing is written after the NUL */
   CHECK(g.error.message[strlen(g.error.message) + 1] == 0x5a);
   CHECK(g.after == 0x5a5a5a5a);
   /* success wipes it */
   CHECK(asperity_law_free(NULL, &g.error) == ASPERITY_OK);
   CHECK(g.error.code == ASPERITY_OK && g.error.message[0] == '\0');
   CHECK(sizeof g.error == 512);
   CHECK(offsetof(asperity_error, message) == sizeof(int));
   length = (int)sizeof g.error.message;
   CHECK(length == 508);
}

void test_layout(void)
{
   properties();
   state();
   error_struct();
}
