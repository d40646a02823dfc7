/**
 * @file asperity.h
 * @brief Elasto-plastic contact of rough timber faces: the C interface of asperity.
 *
 * Units are N, mm and MPa, as in the library. Every function returns an #asperity_code, 0 when it
 * did what it says. The last argument of every function is the caller's own #asperity_error, which
 * receives the code and a message; it may be NULL.
 *
 * Threads: the library keeps nothing of its own between calls. A law never changes once it is
 * built, so any number of threads may use one law at the same time. A set of states belongs to one
 * thread at a time: give each thread its own. Freeing must not overlap with any other use.
 *
 * Arrays over the points come first-index-last: an array written [2][n] here holds all n first
 * components, then all n second ones, so that component c of point i is a[c*n + i]. Arrays are
 * contiguous and aligned as C aligns them. One that a function writes to may share no memory with
 * another argument of the same call.
 *
 * NULL, wrong lengths, numbers that are not finite or absurdly large, and handles of another kind
 * give a code and a message; after any error nothing that was passed has been changed, save for the
 * error struct and, where a function says so, a handle or a text buffer. What no library can find
 * out is undefined as everywhere in C: an array shorter than its n, a pointer to nowhere, and the
 * copy of a handle that was freed (the handle itself is set to NULL).
 */
#ifndef ASPERITY_H
#define ASPERITY_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/** What functions return. */
enum asperity_code {
   ASPERITY_OK = 0,
   /** A computation failed. */
   ASPERITY_COMPUTATION_ERROR = 1,
   /** A value that is not allowed. */
   ASPERITY_BAD_INPUT = 2,
   /** A pointer is NULL that must not be. */
   ASPERITY_NULL_ARGUMENT = 4,
   /** A length, number of points, number of a point or size of a struct does not fit. */
   ASPERITY_WRONG_LENGTH = 5,
   /** There is not enough memory. */
   ASPERITY_NO_MEMORY = 6,
   /** A handle is not of the kind asked for. */
   ASPERITY_WRONG_HANDLE = 7
};

/** What happens to the elastic slip when the pressure changes. */
enum asperity_friction_rule {
   /** The elastic slip stays: the shear stress follows the pressure, as in ABAQUS' own friction. */
   ASPERITY_RULE_ABAQUS = 1,
   /** Pressure rising keeps the shear stress, falling the elastic slip: creates no energy. */
   ASPERITY_RULE_DISSIPATIVE = 2
};

/** How the slip of an increment is integrated. */
enum asperity_slip_integration {
   /** Exactly, on a straight path: two half increments equal one. */
   ASPERITY_SLIP_EXACT = 1,
   /** Backward Euler (radial return), as in ABAQUS' own friction. */
   ASPERITY_SLIP_BACKWARD_EULER = 2
};

/** What summits do that part again. */
enum asperity_unloading {
   /** Unloading follows loading: the paper's law. */
   ASPERITY_UNLOADING_REVERSIBLE = 0,
   /** Every yielded summit recovers as an elastic one of the radius that its largest deformation
    * left; not below a yield factor of 2/sqrt(plastic_ratio). */
   ASPERITY_UNLOADING_ELASTIC = 1
};

/** A section of wood, by the direction of its normal. */
enum asperity_section {
   /** Normal along the grain. */
   ASPERITY_SECTION_TRANSVERSE = 1,
   /** Normal radial. */
   ASPERITY_SECTION_TANGENTIAL = 2,
   /** Normal tangential. */
   ASPERITY_SECTION_RADIAL = 3
};

/** Whose hardness a pair of two faces takes. */
enum asperity_hardness_rule {
   /** That of the softer face, as the text of the paper has it. */
   ASPERITY_HARDNESS_SOFTER = 1,
   /** That of the harder face, as its Table 4 has it. */
   ASPERITY_HARDNESS_HARDER = 2
};

/** Whose summits a pair of two faces takes. */
enum asperity_roughness_rule {
   /** Those of the sum of both faces, whose spectral moments add. */
   ASPERITY_ROUGHNESS_MOMENTS = 1,
   /** Those of one face, the other being smooth: nothing is asked of its summits. */
   ASPERITY_ROUGHNESS_FACE_1 = 2,
   ASPERITY_ROUGHNESS_FACE_2 = 3
};

/** How summit heights are distributed. */
enum asperity_height_distribution {
   ASPERITY_HEIGHTS_GAUSSIAN = 0,
   /** By Johnson's distribution of a skewness and a kurtosis. */
   ASPERITY_HEIGHTS_JOHNSON = 1
};

/** Where a point slips to whose friction depends on direction. */
enum asperity_slip_direction {
   /** Normal to the ellipse of shear stresses: the most dissipation. */
   ASPERITY_SLIP_ASSOCIATED = 0,
   /** Along the shear stress. */
   ASPERITY_SLIP_OF_STRESS = 1
};

/** What sticks before it slides. */
enum asperity_stick {
   /** The point, up to one critical slip. */
   ASPERITY_STICK_CRITICAL_SLIP = 0,
   /** Its summits, each as Mindlin's theory has it. */
   ASPERITY_STICK_SUMMITS = 1
};

/** Contact status of a point. */
enum asperity_status {
   /** Never updated: nothing is known of the point's past. */
   ASPERITY_UNSET = 0,
   ASPERITY_OPEN = 1,
   /** Closed; only elastic slip at the end of the increment. */
   ASPERITY_STICK = 2,
   /** Closed and slipping at the end of the increment. */
   ASPERITY_SLIP = 3
};

/** Limits past which a result is still computed but no longer means what the law assumes. The
 * validity of a result is a sum of these, 0 where no limit is passed. */
enum asperity_validity {
   ASPERITY_AREA_ABOVE_NOMINAL = 1,
   ASPERITY_PRESSURE_ABOVE_HARDNESS = 2,
   ASPERITY_CLOSURE_ABOVE_HALF_RADIUS = 4,
   ASPERITY_STIFFER_THAN_HERTZ = 8,
   ASPERITY_ROUGHNESS_NUMBER_HIGH = 16,
   ASPERITY_ROUGHNESS_NUMBER_LOW = 32,
   /** Let pass by accept_unphysical: a property as no face or solid has. */
   ASPERITY_IMPLAUSIBLE_PROPERTY = 64,
   /** With memory: summits were flattened further than unloading is known for. */
   ASPERITY_MEMORY_BEYOND_DATA = 128
};

/** Overclosure of a point without opposite surface, mm; below -1e30 means the same. */
#define ASPERITY_NO_OPPOSITE_SURFACE (-1.0e36)

/** asperity_properties::initial_separation that stands for 4 sigma. */
#define ASPERITY_FOUR_SIGMA 1.0e300

/** Most points of friction over pressure. */
#define ASPERITY_MOST_FRICTION_POINTS 8

/** Most elements of #ASPERITY_STICK_SUMMITS. */
#define ASPERITY_MOST_STICK_ELEMENTS 16

/** How a call ended. */
typedef struct asperity_error {
   /** An #asperity_code. */
   int code;
   /** One line of text, empty when the code is #ASPERITY_OK. */
   char message[508];
} asperity_error;

/** A law: the normal law, friction and the datum of the overclosure of one pair of faces. */
typedef struct asperity_law asperity_law;

/** One rough face. */
typedef struct asperity_face {
   /** Standard deviation of summit heights, mm. */
   double sigma;
   /** Summit radius, mm. */
   double radius;
   /** Asperity density, summits per nominal area, 1/mm2. */
   double eta;
   /** Young's modulus along the normal of the face, MPa. */
   double young_modulus;
   /** Poisson's ratio of strain in the face for pressure on it, -0.99 to 0.99. */
   double poisson_ratio;
   /** Hardness, MPa. */
   double hardness;
} asperity_face;

/** What a number of contact points remember between increments. */
typedef struct asperity_states asperity_states;

/** Properties of a pair of faces. Fill it by asperity_properties_init() or
 * asperity_properties_from_pair() first: members may join at the end in later versions. */
typedef struct asperity_properties {
   /** Size of this struct; set by asperity_properties_init(). */
   size_t size;
   /** Asperity density, summits per nominal area, 1/mm2. */
   double eta;
   /** Equivalent modulus E*, MPa. */
   double modulus;
   /** Summit radius R, mm. */
   double radius;
   /** Hardness H of the softer face, MPa. */
   double hardness;
   /** Mean contact pressure factor k, 0.05 to 1. */
   double yield_factor;
   /** Standard deviation of summit heights, mm. */
   double sigma;
   /** Coulomb friction coefficient mu, 0 to 1000. */
   double friction_coefficient;
   /** Critical elastic slip gcrit, mm. */
   double critical_slip;
   /** Separation at zero overclosure d0, mm: separation = d0 - overclosure. Taken literally, zero
    * and negative too; #ASPERITY_FOUR_SIGMA unless set. */
   double initial_separation;
   /** An #asperity_friction_rule; #ASPERITY_RULE_ABAQUS unless set. */
   int friction_rule;
   /** An #asperity_slip_integration; #ASPERITY_SLIP_EXACT unless set. */
   int slip_integration;
   /** 1 lets properties that no face or solid has pass, and flags results; 0 unless set. Such are
    * an eta*radius*sigma below 0.0158, and most slips of units. */
   int accept_unphysical;
   /** 1 compiles the normal law to polynomials, for many evaluations; 0, direct evaluation, unless
    * set. */
   int compiled;
   /** An #asperity_unloading; #ASPERITY_UNLOADING_REVERSIBLE unless set. */
   int unloading;
   /** Plastic ratio w2/w1, 10 to 1000; 110, that of metals and of the paper, unless set. */
   double plastic_ratio;
   /** An #asperity_height_distribution; #ASPERITY_HEIGHTS_GAUSSIAN unless set. */
   int height_distribution;
   /** Skewness and kurtosis of Johnson's heights; 0 and 3 unless set. */
   double skewness, kurtosis;
   /** Friction coefficient at rest; 0, unless set, stands for friction_coefficient, that in
    * motion. Needs decay_slip or decay_slip_rate. */
   double static_friction_coefficient;
   /** Slip over which the excess at rest falls to 1/e, mm; 0, not by slip, unless set. */
   double decay_slip;
   /** Slip rate at which it is down to 1/e, mm/s; 0, not by rate, unless set. */
   double decay_slip_rate;
   /** Friction coefficient across the grain; 0, unless set, stands for friction_coefficient, that
    * along it. */
   double friction_coefficient_across;
   /** Angle from the first slip direction to the grain at the start, degrees; 0 unless set. */
   double grain_angle;
   /** An #asperity_slip_direction; #ASPERITY_SLIP_ASSOCIATED unless set. */
   int slip_direction;
   /** All coefficients times (p/reference_pressure)^pressure_exponent; 0 unless set. */
   double pressure_exponent;
   /** Pressure at which the coefficients hold, MPa; needed with an exponent. */
   double reference_pressure;
   /** Largest shear stress at rest along the grain, MPa; 0, none, unless set. */
   double shear_limit;
   /** An #asperity_stick; #ASPERITY_STICK_CRITICAL_SLIP unless set. */
   int stick;
   /** Elements of #ASPERITY_STICK_SUMMITS, 4 to 16; 0, unless set, stands for 8. */
   int stick_elements;
   /** Equivalent shear modulus G*, 1/G* = (2 - nu1)/G1 + (2 - nu2)/G2, MPa; needed for
    * #ASPERITY_STICK_SUMMITS. */
   double shear_modulus;
   /** How many of the points after it count; 0 unless set. */
   int friction_points;
   /** Pressures, MPa, rising, and factors on all coefficients there; straight in between, constant
    * outside. */
   double friction_pressures[ASPERITY_MOST_FRICTION_POINTS];
   double friction_factors[ASPERITY_MOST_FRICTION_POINTS];
} asperity_properties;

/** State of one contact point, for a restart. All zero is a fresh point. */
typedef struct asperity_state {
   /** An #asperity_status. */
   int status;
   /** Sum of all #asperity_validity flags reached so far. */
   int validity;
   /** Overclosure, mm. */
   double overclosure;
   /** Pressure, MPa. */
   double pressure;
   /** Stored (recoverable) normal energy per area, N/mm. */
   double normal_energy;
   /** Elastic slip in the two slip directions, mm; zero while open. */
   double elastic_slip[2];
   /** Largest overclosure reached, mm: all that elastic unloading remembers. */
   double largest_closure;
   /** Frictional dissipation per area since the start, N/mm. */
   double dissipation;
   /** Pressure coupling per area since the start, N/mm. */
   double pressure_coupling;
   /** How far friction has gone from rest, 0, to motion, 1; by slip alone. */
   double motion_share;
   /** Angle by which slip directions have turned over the grain since the start, radians. */
   double grain_turn;
   /** Elastic slips of the elements of #ASPERITY_STICK_SUMMITS in the two slip directions, mm. */
   double summit_slip[ASPERITY_MOST_STICK_ELEMENTS][2];
} asperity_state;

/**
 * @brief Version of the library, such as 0.1.0.
 * @param buffer where the text goes; one that is too short holds what fits
 * @param length characters in buffer, with the NUL at the end; 16 are plenty
 * @param error  may be NULL
 */
int asperity_library_version(char *buffer, int length, asperity_error *error);

/**
 * @brief What the validity flags of a result mean, as text; empty where none is set.
 * @param validity sum of #asperity_validity flags, 0 to 255
 * @param buffer   where the text goes; one that is too short holds what fits
 * @param length   characters in buffer, with the NUL at the end; 1024 hold any text
 * @param error    may be NULL
 */
int asperity_validity_remark(int validity, char *buffer, int length, asperity_error *error);

/**
 * @brief Fill the struct with defaults. eta to critical_slip have none: they become NaN, which
 *        asperity_law_new() refuses by name.
 * @param properties struct to fill
 * @param size       sizeof(asperity_properties)
 * @param error      may be NULL
 */
int asperity_properties_init(asperity_properties *properties, size_t size, asperity_error *error);

/**
 * @brief Fill the struct with defaults and the properties of a pair of faces of the paper.
 * @param properties struct to fill; unchanged after an error
 * @param size       sizeof(asperity_properties)
 * @param pair       name: "transverse-tangential" or "tangential-tangential"
 * @param error      may be NULL
 */
int asperity_properties_from_pair(asperity_properties *properties, size_t size, const char *pair,
                                  asperity_error *error);

/**
 * @brief Fill a face with a surface of Table 2 of the paper on a section of its wood.
 * @param face    struct to fill; unchanged after an error
 * @param surface name, such as "unpolished-cross"
 * @param section an #asperity_section; the wood has no hardness of the radial one, which is refused
 * @param error   may be NULL
 */
int asperity_face_from_paper(asperity_face *face, const char *surface, int section,
                             asperity_error *error);

/**
 * @brief Fill the struct with defaults and the pair that two faces make: E* by Eq. 4, hardness and
 *        summits by rules. Yield factor, friction and critical slip are those of the paper's pairs.
 * @param properties     struct to fill; unchanged after an error
 * @param size           sizeof(asperity_properties)
 * @param face_1         one face
 * @param face_2         the other
 * @param hardness_rule  an #asperity_hardness_rule
 * @param roughness_rule an #asperity_roughness_rule
 * @param error          may be NULL
 */
int asperity_properties_from_faces(asperity_properties *properties, size_t size,
                                   const asperity_face *face_1, const asperity_face *face_2,
                                   int hardness_rule, int roughness_rule, asperity_error *error);

/**
 * @brief Build a law. Free it by asperity_law_free().
 * @param law        receives the handle, NULL after an error
 * @param properties what the law is built from; not needed afterwards
 * @param error      may be NULL
 */
int asperity_law_new(asperity_law **law, const asperity_properties *properties,
                     asperity_error *error);

/**
 * @brief Free a law and set the handle to NULL. A NULL handle, or NULL for law, is fine.
 * @param law   the handle
 * @param error may be NULL
 */
int asperity_law_free(asperity_law **law, asperity_error *error);

/**
 * @brief The properties of a law, its initial separation as a number.
 * @param law        the law
 * @param properties struct to fill
 * @param size       sizeof(asperity_properties)
 * @param error      may be NULL
 */
int asperity_law_properties(const asperity_law *law, asperity_properties *properties, size_t size,
                            asperity_error *error);

/**
 * @brief The normal law at n separations, each as if the face had never been closer: first loading,
 *        the same for every #asperity_unloading.
 * @param law             the law
 * @param n               number of points; with 0 the arrays may be NULL
 * @param separation      [n] separations, mm, up to 1e36 in size
 * @param pressure        [n] receives pressures, MPa
 * @param stiffness       [n] receives stiffnesses -dp/dd, MPa/mm
 * @param area_fraction   [n] receives real area over nominal area; may be NULL
 * @param contact_density [n] receives summits in contact per area, 1/mm2; may be NULL
 * @param energy          [n] receives works per area since first touch, N/mm, stored unless with
 *                        memory; may be NULL
 * @param validity        [n] receives sums of #asperity_validity flags; may be NULL
 * @param error           may be NULL
 */
int asperity_law_evaluate(const asperity_law *law, int n, const double *separation,
                          double *pressure, double *stiffness, double *area_fraction,
                          double *contact_density, double *energy, int *validity,
                          asperity_error *error);

/**
 * @brief The law with memory at n closest separations and retractions from them, by direct
 *        evaluation. The law must be one of #ASPERITY_UNLOADING_ELASTIC.
 * @param law                 the law
 * @param n                   number of points; with 0 the arrays may be NULL
 * @param closest_separation  [n] closest separations so far, mm, up to 1e36 in size
 * @param retraction          [n] separations less the closest ones, mm; with zero or less the face
 *                            is as close as never before
 * @param pressure            [n] receives pressures, MPa
 * @param stiffness           [n] receives stiffnesses -dp/dd at fixed memory, MPa/mm
 * @param area_fraction       [n] receives real area over nominal area; may be NULL
 * @param contact_density     [n] receives summits in contact per area, 1/mm2; may be NULL
 * @param energy              [n] receives recoverable energies per area, N/mm; may be NULL
 * @param plastic_dissipation [n] receives plastic dissipation per area since first touch, N/mm; may
 *                            be NULL
 * @param validity            [n] receives sums of #asperity_validity flags; may be NULL
 * @param error               may be NULL
 */
int asperity_law_evaluate_unloading(const asperity_law *law, int n,
                                    const double *closest_separation, const double *retraction,
                                    double *pressure, double *stiffness, double *area_fraction,
                                    double *contact_density, double *energy,
                                    double *plastic_dissipation, int *validity,
                                    asperity_error *error);

/**
 * @brief Separation at which the law gives a pressure, when the face was never closer.
 * @param law        the law
 * @param pressure   pressure, MPa, above zero
 * @param separation receives the separation, mm
 * @param error      may be NULL
 */
int asperity_law_separation(const asperity_law *law, double pressure, double *separation,
                            asperity_error *error);

/**
 * @brief States of n fresh points. Free them by asperity_states_free().
 * @param states receives the handle, NULL after an error
 * @param n      number of points, zero or more
 * @param error  may be NULL
 */
int asperity_states_new(asperity_states **states, int n, asperity_error *error);

/**
 * @brief Free states and set the handle to NULL. A NULL handle, or NULL for states, is fine.
 * @param states the handle
 * @param error  may be NULL
 */
int asperity_states_free(asperity_states **states, asperity_error *error);

/**
 * @brief Copy the states of all points. A host that iterates keeps the states of the start of an
 *        increment in a second set, and copies them back before each trial.
 * @param from  states to read
 * @param to    states of the same number of points to overwrite
 * @param error may be NULL
 */
int asperity_states_copy(const asperity_states *from, asperity_states *to, asperity_error *error);

/**
 * @brief Number of points.
 * @param states the states
 * @param n      receives the number
 * @param error  may be NULL
 */
int asperity_states_count(const asperity_states *states, int *n, asperity_error *error);

/**
 * @brief States of points, one after the other.
 * @param states the states
 * @param first  number of the first point, from 0
 * @param n      how many; with 0 the array may be NULL
 * @param state  [n] structs to fill
 * @param error  may be NULL
 */
int asperity_states_get(const asperity_states *states, int first, int n, asperity_state *state,
                        asperity_error *error);

/**
 * @brief Set the states of points, one after the other. What no update can have left behind is
 *        refused: an unknown status or flag, a negative pressure, numbers that are not finite.
 * @param states the states
 * @param first  number of the first point, from 0
 * @param n      how many; with 0 the array may be NULL
 * @param state  [n] their new states
 * @param error  may be NULL
 */
int asperity_states_set(asperity_states *states, int first, int n, const asperity_state *state,
                        asperity_error *error);

/**
 * @brief Advance all points over one increment, in place.
 *
 * Pressure is positive in compression; shear stress has the sign of the elastic slip. Energies are
 * per area and obey, on any path, work = change of (normal + tangential energy) + dissipation
 * + plastic dissipation - pressure coupling.
 *
 * @param law            the law
 * @param states         states at the start; at the end on return
 * @param n              number of points of the states; with 0 the arrays may be NULL
 * @param overclosure    [n] overclosure at the end, mm, up to 1e36 in size
 * @param slip_increment [2][n] relative tangential motion of the increment, mm, up to 1e30
 * @param rotation       [2][2][n] rotation of the slip directions in the increment, which makes
 *                       w = R v of a vector v: R(row, column) of point i is
 *                       rotation[column][row][i], as Fortran has it; NULL for none
 * @param time_increment time of the increment, s, for friction with a decay_slip_rate; 0 where
 *                       there is no time: nothing decays by rate then
 * @param traction       [3][n] receives the pressure and two shear stresses at the end, MPa
 * @param tangent        [3][3][n] receives derivatives, MPa/mm: tangent[column][row][i] is that of
 *                       traction[row][i] by the overclosure (column 0) or a slip (1, 2);
 *                       unsymmetric; may be NULL
 * @param tangential_energy [n] receives stored tangential energies at the end, N/mm; may be NULL
 * @param dissipation       [n] receives frictional dissipation of this increment, N/mm; may be NULL
 * @param plastic_dissipation [n] receives plastic dissipation of summits in this increment, N/mm,
 *                          zero without memory; may be NULL
 * @param pressure_coupling [n] receives the energy that a change of pressure put into elastic slip
 *                          in this increment, N/mm; may be NULL
 * @param validity          [n] receives sums of #asperity_validity flags of this increment; may be
 *                          NULL
 * @param error             may be NULL
 */
int asperity_states_update(const asperity_law *law, asperity_states *states, int n,
                           const double *overclosure, const double *slip_increment,
                           const double *rotation, double time_increment, double *traction,
                           double *tangent, double *tangential_energy, double *dissipation,
                           double *plastic_dissipation, double *pressure_coupling, int *validity,
                           asperity_error *error);

#ifdef __cplusplus
}
#endif

#endif
