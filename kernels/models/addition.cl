// How a reaction's rate f, times scale s, is added to the new value n. A model is one file in this folder with
//   real NAME_u(real n, real s, real dt, real u, real v, PARAMETERS ...)   and NAME_v alike,
// which return the new value of n; a model that acts on u alone has only
//   real NAME_u(real n, real s, real dt, real u, PARAMETERS ...).
// NAME is the model's name in the language with _ for -; PARAMETERS are in the order of parameter_names().

#ifdef PELAGE_PUBLISHED
#define ADD_REACTION(n, s, f, dt) ((n) + (((s) * (f)) * (dt)))
#else
#define ADD_REACTION(n, s, f, dt) fma((s) * (dt), f, n)
#endif
