/* An FMI 2.0 co-simulation FMU to try masters with: y = k u, and what goes in of each other type comes
   out. It counts its steps. `mode` chooses what it does besides:
   1: the step that ends behind 0.05 s is done by half and discarded, as the simulation shall end;
   2: refuses a step beyond the stop time of fmi2SetupExperiment, to the last bit. */
#include <stdlib.h>
#include <string.h>

typedef void *Component;
typedef unsigned Reference;
typedef int Status;
enum { OK = 0, DISCARD = 2, ERROR = 3 };
enum { LAST_SUCCESSFUL_TIME = 2, TERMINATED = 3 };

typedef struct {
    double reals[4];    /* u, y, k, tolerance */
    int integers[4];    /* mode, count, choice_in, choice */
    int booleans[2];    /* flag_in, flag */
    char text[64];
    double time, stop;
} Probe;

const char *fmi2GetTypesPlatform(void) { return "default"; }
const char *fmi2GetVersion(void) { return "2.0"; }

Component fmi2Instantiate(const char *name, int type, const char *guid, const char *resources,
                          const void *callbacks, int visible, int logging) {
    Probe *probe = calloc(1, sizeof(Probe));
    probe->reals[2] = 1;
    probe->integers[2] = probe->integers[3] = 1;
    return probe;
}
void fmi2FreeInstance(Component c) { free(c); }

Status fmi2SetupExperiment(Component c, int has_tolerance, double tolerance, double start, int has_stop,
                           double stop) {
    Probe *probe = c;
    probe->reals[3] = has_tolerance ? tolerance : -1;
    probe->time = start;
    probe->stop = has_stop ? stop : 1e300;
    return OK;
}
Status fmi2EnterInitializationMode(Component c) { return OK; }
Status fmi2ExitInitializationMode(Component c) { return OK; }
Status fmi2Terminate(Component c) { return OK; }

static void compute(Probe *probe) {
    probe->reals[1] = probe->reals[2] * probe->reals[0];
    probe->integers[3] = probe->integers[2];
    probe->booleans[1] = probe->booleans[0];
}

#define ACCESS(Name, type, values)                                                                    \
    Status fmi2Get##Name(Component c, const Reference *r, size_t n, type *v) {                        \
        Probe *probe = c;                                                                             \
        compute(probe);                                                                               \
        for (size_t i = 0; i < n; i++) v[i] = probe->values[r[i]];                                    \
        return OK;                                                                                    \
    }                                                                                                 \
    Status fmi2Set##Name(Component c, const Reference *r, size_t n, const type *v) {                  \
        Probe *probe = c;                                                                             \
        for (size_t i = 0; i < n; i++) probe->values[r[i]] = v[i];                                    \
        return OK;                                                                                    \
    }
ACCESS(Real, double, reals)
ACCESS(Integer, int, integers)
ACCESS(Boolean, int, booleans)

Status fmi2GetString(Component c, const Reference *r, size_t n, const char **v) {
    for (size_t i = 0; i < n; i++) v[i] = ((Probe *)c)->text;
    return OK;
}
Status fmi2SetString(Component c, const Reference *r, size_t n, const char *const *v) {
    for (size_t i = 0; i < n; i++) strncpy(((Probe *)c)->text, v[i], 63);
    return OK;
}

Status fmi2DoStep(Component c, double time, double length, int keep) {
    Probe *probe = c;
    if (probe->integers[0] == 1 && time + length > 0.05) {
        probe->time = time + length / 2;
        return DISCARD;
    }
    if (probe->integers[0] == 2 && time + length > probe->stop) return ERROR;
    probe->integers[1]++;
    probe->time = time + length;
    return OK;
}
Status fmi2GetRealStatus(Component c, int kind, double *value) {
    *value = ((Probe *)c)->time;
    return kind == LAST_SUCCESSFUL_TIME ? OK : DISCARD;
}
Status fmi2GetBooleanStatus(Component c, int kind, int *value) {
    *value = 1;
    return kind == TERMINATED ? OK : DISCARD;
}

#define UNUSED(name) Status name(void) { return ERROR; }
UNUSED(fmi2SetDebugLogging) UNUSED(fmi2Reset) UNUSED(fmi2CancelStep) UNUSED(fmi2GetStatus)
UNUSED(fmi2GetIntegerStatus) UNUSED(fmi2GetStringStatus) UNUSED(fmi2GetFMUstate) UNUSED(fmi2SetFMUstate)
UNUSED(fmi2FreeFMUstate) UNUSED(fmi2SerializedFMUstateSize) UNUSED(fmi2SerializeFMUstate)
UNUSED(fmi2DeSerializeFMUstate) UNUSED(fmi2GetDirectionalDerivative)
UNUSED(fmi2SetRealInputDerivatives) UNUSED(fmi2GetRealOutputDerivatives)
