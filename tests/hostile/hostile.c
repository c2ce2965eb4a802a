/* A vehicle FMU that misbehaves at 0.05 s, as BEHAVIOUR says: a point that keeps its speed. One
 * file, no header of the standard needed. */
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum {
    WELL,
    STEP_ERROR,
    DISCARD,       /* without progress */
    DISCARD_LONG,  /* steps longer than 0.6 ms */
    ABORT,
    SEGFAULT,
    NULL_CATEGORY, /* a warning with a null category and arguments to format */
    WARN_SILENTLY,
    FATAL,
    PENDING,       /* three times, then done */
    SET_ERROR,
    TELL_PARAMETERS, /* once, as a warning */
    OTHER_VERSION  /* says that it is of FMI 1.0 */
};

/* Misbehaviour of seam.c. */
enum {
    NAN_SPEED = 100,
    INFINITE_SPEED,
    HUGE_SPEED,
    REVERSING,          /* the speed, from step to step */
    ROUNDING,           /* upward, from then on */
    FLUSHING,           /* of denormal numbers */
    TRAPPING,           /* of invalid operations, divisions by zero and overflows */
    ROUNDING_AT_LOAD,
    ONE_THREAD,         /* only the one that has made the instance may call */
    MESSAGE_AFTER_FREE, /* from a thread, with the environment of the instance */
    THREAD_OUTLIVES,    /* and logs all the time */
    DOUBLE_FREE,        /* in a step */
    WRITES_BEYOND,      /* the array of fmi2GetReal */
    WRITES_BEFORE,
    CHANGES_REFERENCES, /* of fmi2GetReal */
    CHANGES_INPUTS,     /* of fmi2SetReal */
    NULL_ENVIRONMENT,   /* is handed to the logger */
    OWN_ENVIRONMENT,
    FOREIGN_THREAD,     /* logs, without an environment */
    CONTROL_CHARACTERS, /* in a message */
    MANY_MESSAGES       /* one in each step */
};

enum { OK, WARNING, DISCARDED, ERROR, FATALLY, IS_PENDING };
enum { POSITION0, VELOCITY0, FRONT, REAR, SYNC, POSITION, VELOCITY, REALS };
enum { INTEGERS = 1, BOOLEANS = 1 };

#define WHEN 0.05
#define GUID "{a hostile vehicle}"
#define EXPORT __attribute__((visibility("default")))

/* Ends of the process, and calls that do not return: ENDS(how, where). */
enum {
    BY_EXIT,
    BY_EXIT_AT_ONCE,
    BY_CRASH,
    BY_CRASH_OF_THREAD,
    BY_LOOP,
    BY_BUSY_LOOP,
    BY_DOUBLE_FREE,
    BY_TAKING_MEMORY /* until there is no more */
};
enum { AT_LOAD, AT_INSTANTIATE, AT_INIT, AT_STEP, AT_TERMINATE, AT_FREE, AT_UNLOAD };
#define ENDS(how, where) (1000 + 10 * (how) + (where))
/* Two that end nothing: a step that takes a millisecond, and one that reads the standard input. */
#define SLOW 900
#define READS_STDIN 901

static void *crash(void *nothing) {
    *(volatile int *)nothing = 1;
    return NULL;
}
static void free_twice(void) {
    void *memory = malloc(40);
    free(memory);
    free(memory);
}
static void take_memory(void) {
    for (void *memory; (memory = malloc(1 << 20)) != NULL;) memset(memory, 1, 1 << 20);
    abort();
}
static void end_at(int where) {
    pthread_t thread;
    if (BEHAVIOUR < 1000 || BEHAVIOUR % 10 != where) return;
    switch ((BEHAVIOUR - 1000) / 10) {
    case BY_EXIT: exit(0);
    case BY_EXIT_AT_ONCE: _exit(3);
    case BY_CRASH: crash(NULL);
    case BY_CRASH_OF_THREAD:
        pthread_create(&thread, NULL, crash, NULL);
        pthread_join(thread, NULL);
    case BY_LOOP: for (;;) sleep(1);
    case BY_BUSY_LOOP: for (volatile int i = 0;;) i = i;
    case BY_DOUBLE_FREE: free_twice(); return;
    case BY_TAKING_MEMORY: take_memory();
    }
}
__attribute__((constructor)) static void at_load(void) { end_at(AT_LOAD); }
__attribute__((destructor)) static void at_unload(void) { end_at(AT_UNLOAD); }

typedef void (*Logger)(void *, const char *, int, const char *, const char *, ...);
typedef struct {
    Logger logger;
    void *(*allocate)(size_t, size_t);
    void (*release)(void *);
    void (*step_finished)(void *, int);
    void *environment;
} Callbacks;

typedef struct {
    double reals[REALS];
    int integers[INTEGERS];
    int booleans[BOOLEANS];
    char text[64];
    double time;
    int asked;
    int told;
    Callbacks callbacks;
} Instance;

static void tell(Instance *i, int status, const char *category, const char *format, double value) {
    i->callbacks.logger(i->callbacks.environment, "hostile", status, category, format, value);
}

#include "seam.c"

EXPORT const char *fmi2GetVersion(void) { return BEHAVIOUR == OTHER_VERSION ? "1.0" : "2.0"; }
EXPORT const char *fmi2GetTypesPlatform(void) { return "default"; }
EXPORT int fmi2SetDebugLogging(void *c, int on, size_t n, const char *const *categories) {
    (void)c, (void)on, (void)n, (void)categories;
    return OK;
}

EXPORT void *fmi2Instantiate(const char *name, int type, const char *guid, const char *resources,
                             const Callbacks *callbacks, int visible, int logging) {
    (void)name, (void)resources, (void)visible, (void)logging;
    if (type != 1 || strcmp(guid, GUID) != 0) {
        callbacks->logger(callbacks->environment, name, ERROR, "logStatusError",
                          "the GUID %s is not mine", guid);
        return NULL;
    }
    end_at(AT_INSTANTIATE);
    Instance *i = calloc(1, sizeof *i);
    i->callbacks = *callbacks;
    seam_instantiate(i);
    return i;
}

EXPORT void fmi2FreeInstance(void *c) {
    end_at(AT_FREE);
    seam_free(c);
}
EXPORT int fmi2SetupExperiment(void *c, int td, double t, double start, int sd, double stop) {
    (void)td, (void)t, (void)sd, (void)stop;
    ((Instance *)c)->time = start;
    return OK;
}
EXPORT int fmi2EnterInitializationMode(void *c) {
    (void)c;
    end_at(AT_INIT);
    return seam_refuses() ? ERROR : OK;
}
EXPORT int fmi2ExitInitializationMode(void *c) {
    Instance *i = c;
    if (seam_refuses()) return ERROR;
    i->reals[POSITION] = i->reals[POSITION0];
    i->reals[VELOCITY] = i->reals[VELOCITY0];
    return OK;
}
EXPORT int fmi2Terminate(void *c) {
    (void)c;
    end_at(AT_TERMINATE);
    return seam_refuses() ? ERROR : OK;
}
EXPORT int fmi2Reset(void *c) { (void)c; return OK; }

EXPORT int fmi2GetReal(void *c, const unsigned *vr, size_t n, double *v) {
    if (seam_refuses()) return ERROR;
    for (size_t k = 0; k < n; k++) v[k] = ((Instance *)c)->reals[vr[k]];
    seam_get(c, (unsigned *)vr, n, v);
    return OK;
}
EXPORT int fmi2SetReal(void *c, const unsigned *vr, size_t n, const double *v) {
    Instance *i = c;
    if (BEHAVIOUR == SET_ERROR && i->time >= WHEN) {
        tell(i, ERROR, "logStatusError", "I take no more forces after %g s", i->time);
        return ERROR;
    }
    if (seam_refuses()) return ERROR;
    for (size_t k = 0; k < n; k++) i->reals[vr[k]] = v[k];
    seam_set(i, (double *)v);
    return OK;
}
EXPORT int fmi2GetInteger(void *c, const unsigned *vr, size_t n, int *v) {
    for (size_t k = 0; k < n; k++) v[k] = ((Instance *)c)->integers[vr[k]];
    return OK;
}
EXPORT int fmi2SetInteger(void *c, const unsigned *vr, size_t n, const int *v) {
    for (size_t k = 0; k < n; k++) ((Instance *)c)->integers[vr[k]] = v[k];
    return OK;
}
EXPORT int fmi2GetBoolean(void *c, const unsigned *vr, size_t n, int *v) {
    for (size_t k = 0; k < n; k++) v[k] = ((Instance *)c)->booleans[vr[k]];
    return OK;
}
EXPORT int fmi2SetBoolean(void *c, const unsigned *vr, size_t n, const int *v) {
    for (size_t k = 0; k < n; k++) ((Instance *)c)->booleans[vr[k]] = v[k];
    return OK;
}
EXPORT int fmi2GetString(void *c, const unsigned *vr, size_t n, const char **v) {
    (void)vr;
    for (size_t k = 0; k < n; k++) v[k] = ((Instance *)c)->text;
    return OK;
}
EXPORT int fmi2SetString(void *c, const unsigned *vr, size_t n, const char *const *v) {
    (void)vr;
    for (size_t k = 0; k < n; k++) {
        strncpy(((Instance *)c)->text, v[k], sizeof ((Instance *)c)->text - 1);
    }
    return OK;
}

static int misbehave(Instance *i, double length) {
    switch (BEHAVIOUR) {
    case TELL_PARAMETERS:
        if (i->told) return OK;
        i->told = 1;
        i->callbacks.logger(i->callbacks.environment, "hostile", WARNING, "logStatusWarning",
                            "count %d, worn %d, file %s", i->integers[0], i->booleans[0], i->text);
        return WARNING;
    case STEP_ERROR:
        tell(i, ERROR, "logStatusError", "the axle box is too hot at %g s", i->time);
        return ERROR;
    case DISCARD:
        tell(i, DISCARDED, "logStatusDiscard", "no progress at %g s", i->time);
        return DISCARDED;
    case DISCARD_LONG:
        return length > 6e-4 ? DISCARDED : OK;
    case ABORT:
        abort();
    case SEGFAULT:
        *(volatile int *)0 = 1;
        return OK;
    case NULL_CATEGORY:
        tell(i, WARNING, NULL, "50 %% worn at %g s", i->time);
        return WARNING;
    case WARN_SILENTLY:
        return WARNING;
    case FATAL:
        tell(i, FATALLY, "logStatusFatal", "all is lost at %g s", i->time);
        return FATALLY;
    case PENDING:
        i->asked = 0;
        return IS_PENDING;
    default:
        return seam_step(i);
    }
}

EXPORT int fmi2DoStep(void *c, double time, double length, int no_set_state) {
    (void)no_set_state;
    Instance *i = c;
    if (seam_refuses()) return ERROR;
    i->time = time;
    if (BEHAVIOUR == SLOW) usleep(1000);
    if (BEHAVIOUR == READS_STDIN) getchar();
    if (time + length / 2 >= WHEN) end_at(AT_STEP);
    int status = time + length / 2 >= WHEN ? misbehave(i, length) : OK;
    if (status == ERROR || status == DISCARDED || status == FATALLY) {
        return status;
    }
    i->reals[POSITION] += i->reals[VELOCITY] * length;
    i->time = time + length;
    return status;
}
EXPORT int fmi2CancelStep(void *c) { (void)c; return ERROR; }
EXPORT int fmi2GetStatus(void *c, int kind, int *status) {
    (void)kind;
    *status = ((Instance *)c)->asked++ < 3 ? IS_PENDING : OK;
    return OK;
}
EXPORT int fmi2GetRealStatus(void *c, int kind, double *value) {
    *value = ((Instance *)c)->time;
    return kind == 2 ? OK : DISCARDED;
}
EXPORT int fmi2GetIntegerStatus(void *c, int kind, int *value) {
    (void)c, (void)kind, (void)value;
    return DISCARDED;
}
EXPORT int fmi2GetBooleanStatus(void *c, int kind, int *value) {
    (void)c;
    *value = 0;
    return kind == 3 ? OK : DISCARDED;
}
EXPORT int fmi2GetStringStatus(void *c, int kind, const char **value) {
    (void)c, (void)kind, (void)value;
    return DISCARDED;
}

EXPORT int fmi2GetFMUstate(void *c, void **state) {
    if (*state == NULL) *state = malloc(sizeof(Instance));
    memcpy(*state, c, sizeof(Instance));
    return OK;
}
EXPORT int fmi2SetFMUstate(void *c, void *state) {
    memcpy(c, state, sizeof(Instance));
    return OK;
}
EXPORT int fmi2FreeFMUstate(void *c, void **state) {
    (void)c;
    free(*state);
    *state = NULL;
    return OK;
}
#define REFUSE(name, ...) \
    EXPORT int name(__VA_ARGS__) { return ERROR; }
REFUSE(fmi2SerializedFMUstateSize, void *c, void *s, size_t *n)
REFUSE(fmi2SerializeFMUstate, void *c, void *s, char *b, size_t n)
REFUSE(fmi2DeSerializeFMUstate, void *c, const char *b, size_t n, void **s)
REFUSE(fmi2GetDirectionalDerivative, void *c, const unsigned *u, size_t nu, const unsigned *k,
       size_t nk, const double *dk, double *du)
REFUSE(fmi2SetRealInputDerivatives, void *c, const unsigned *vr, size_t n, const int *o,
       const double *v)
REFUSE(fmi2GetRealOutputDerivatives, void *c, const unsigned *vr, size_t n, const int *o,
       double *v)
