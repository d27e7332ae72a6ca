// How a reaction's rate f, times scale s, is added to the new value n. A model is one file in kernels/models. Its first line
//   //@ model WORD | SPECIES LOW to HIGH [kept], ... | PARAMETER LOW to HIGH, ...
// is the only place where the host learns of it: the word in the language, the chemicals it takes and the parameters, each
// with values that make sense (verification and random experiments draw from them). For each species that is not kept it has
//   real WORD_SPECIES(real n, real s, real dt, real SPECIES ..., real PARAMETER ...)
// which returns the new value of n, with _ for the - of the word; all species and all parameters are handed over, in order.
// Kept species stand last.

#ifdef PELAGE_PUBLISHED
#define ADD_REACTION(n, s, f, dt) ((n) + (((s) * (f)) * (dt)))
#else
#define ADD_REACTION(n, s, f, dt) fma((s) * (dt), f, n)
#endif
