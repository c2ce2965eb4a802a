/* A vehicle of another maker: a point mass in C that counts in kN, km/h and m, with just what
 * FMI 2.0 asks of a co-simulation FMU. Its names are its own. */

#include <stddef.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    void (*logger)(void *, const char *, int, const char *, const char *, ...);
    void *(*allocate)(size_t, size_t);
    void (*free)(void *);
    void (*step_finished)(void *, int);
    void *environment;
} Callbacks;

enum { OK = 0, ERROR = 3 };

/* Value references, as in modelDescription.xml. */
enum { START_KM_POST, START_SPEED, FRONT, REAR, CONTROL, DRAG, KM_POST, SPEED, COUNT };

static const double MASS = 134e3; /* kg */
static const char GUID[] = "{6d0c1e7a-point-mass-in-c}";

typedef struct {
    double values[COUNT];
} Vehicle;

const char *fmi2GetTypesPlatform(void) { return "default"; }
const char *fmi2GetVersion(void) { return "2.0"; }
int fmi2SetDebugLogging(void *c, int on, size_t n, const char *const names[]) {
    (void)c, (void)on, (void)n, (void)names;
    return OK;
}

void *fmi2Instantiate(const char *name, int type, const char *guid, const char *resources,
                      const Callbacks *callbacks, int visible, int logging) {
    (void)name, (void)type, (void)resources, (void)callbacks, (void)visible, (void)logging;
    return strcmp(guid, GUID) == 0 ? calloc(1, sizeof(Vehicle)) : NULL;
}

void fmi2FreeInstance(void *c) { free(c); }
int fmi2SetupExperiment(void *c, int d, double tolerance, double start, int s, double stop) {
    (void)c, (void)d, (void)tolerance, (void)start, (void)s, (void)stop;
    return OK;
}
int fmi2EnterInitializationMode(void *c) { return (void)c, OK; }

int fmi2ExitInitializationMode(void *c) {
    Vehicle *vehicle = c;
    vehicle->values[KM_POST] = vehicle->values[START_KM_POST];
    vehicle->values[SPEED] = vehicle->values[START_SPEED];
    return OK;
}

int fmi2Terminate(void *c) { return (void)c, OK; }
int fmi2Reset(void *c) { return memset(c, 0, sizeof(Vehicle)), OK; }

int fmi2GetReal(void *c, const unsigned vr[], size_t n, double values[]) {
    for (size_t i = 0; i < n; i++) {
        if (vr[i] >= COUNT) return ERROR;
        values[i] = ((Vehicle *)c)->values[vr[i]];
    }
    return OK;
}

int fmi2SetReal(void *c, const unsigned vr[], size_t n, const double values[]) {
    for (size_t i = 0; i < n; i++) {
        if (vr[i] >= KM_POST) return ERROR;
        ((Vehicle *)c)->values[vr[i]] = values[i];
    }
    return OK;
}

int fmi2DoStep(void *c, double time, double length, int no_return) {
    (void)time, (void)no_return;
    double *values = ((Vehicle *)c)->values;
    double force = (values[FRONT] - values[REAR] + values[CONTROL] + values[DRAG]) * 1e3;
    double before = values[SPEED] / 3.6;
    double after = before + force / MASS * length;
    values[KM_POST] += (before + after) / 2 * length / 1e3;
    values[SPEED] = after * 3.6;
    return OK;
}

/* It has variables of no other type, saves no states and knows no derivatives. */
#define NOT_OFFERED(name) \
    int name(void *c) { return (void)c, ERROR; }
NOT_OFFERED(fmi2GetInteger)
NOT_OFFERED(fmi2SetInteger)
NOT_OFFERED(fmi2GetBoolean)
NOT_OFFERED(fmi2SetBoolean)
NOT_OFFERED(fmi2GetString)
NOT_OFFERED(fmi2SetString)
NOT_OFFERED(fmi2GetFMUstate)
NOT_OFFERED(fmi2SetFMUstate)
NOT_OFFERED(fmi2FreeFMUstate)
NOT_OFFERED(fmi2SerializedFMUstateSize)
NOT_OFFERED(fmi2SerializeFMUstate)
NOT_OFFERED(fmi2DeSerializeFMUstate)
NOT_OFFERED(fmi2GetDirectionalDerivative)
NOT_OFFERED(fmi2SetRealInputDerivatives)
NOT_OFFERED(fmi2GetRealOutputDerivatives)
NOT_OFFERED(fmi2CancelStep)
NOT_OFFERED(fmi2GetStatus)
NOT_OFFERED(fmi2GetRealStatus)
NOT_OFFERED(fmi2GetIntegerStatus)
NOT_OFFERED(fmi2GetBooleanStatus)
NOT_OFFERED(fmi2GetStringStatus)
