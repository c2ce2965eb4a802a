/* Misbehaviour at the seam, included by hostile.c: values that cannot be, settings of the processor,
 * threads, memory, and messages. */
#include <math.h>
#include <pthread.h>
#include <unistd.h>

static Callbacks kept;
static pthread_t maker;

/* Changes bits of MXCSR, the control word of SSE. */
static void change_mxcsr(unsigned clear, unsigned set) {
    unsigned mxcsr;
    __asm__ volatile("stmxcsr %0" : "=m"(mxcsr));
    mxcsr = (mxcsr & ~clear) | set;
    __asm__ volatile("ldmxcsr %0" : : "m"(mxcsr));
}

__attribute__((constructor)) static void seam_at_load(void) {
    if (BEHAVIOUR == ROUNDING_AT_LOAD) change_mxcsr(0, 0x4000);
}

static void *log_for_ever(void *environment) {
    for (;;) {
        kept.logger(environment, "hostile", WARNING, "logStatusWarning", "still here");
        usleep(500);
    }
    return NULL;
}

static void *log_once(void *environment) {
    kept.logger(environment, "hostile", WARNING, "logStatusWarning", "the bearing is warm");
    return NULL;
}

static void log_on_a_thread(void *environment) {
    pthread_t thread;
    pthread_create(&thread, NULL, log_once, environment);
    pthread_join(thread, NULL);
}

static void seam_instantiate(Instance *i) {
    pthread_t thread;
    kept = i->callbacks;
    maker = pthread_self();
    if (BEHAVIOUR == THREAD_OUTLIVES) {
        pthread_create(&thread, NULL, log_for_ever, kept.environment);
    }
}

/* Whether a call comes from a thread that may call. */
static int seam_refuses(void) {
    if (BEHAVIOUR != ONE_THREAD || pthread_equal(maker, pthread_self())) return 0;
    kept.logger(kept.environment, "hostile", ERROR, "logStatusError", "another thread calls");
    return 1;
}

static void seam_free(Instance *i) {
    if (seam_refuses()) abort();
    free(i);
    if (BEHAVIOUR == MESSAGE_AFTER_FREE) log_on_a_thread(kept.environment);
}

static void seam_get(Instance *i, unsigned *vr, size_t n, double *v) {
    if (i->time < WHEN + 1e-9) return;
    if (BEHAVIOUR == WRITES_BEYOND) v[n] = 1;
    if (BEHAVIOUR == WRITES_BEFORE) v[-1] = 1;
    for (size_t k = 0; k < n; k++) {
        if (vr[k] != VELOCITY) continue;
        if (BEHAVIOUR == NAN_SPEED) v[k] = NAN;
        if (BEHAVIOUR == INFINITE_SPEED) v[k] = INFINITY;
        if (BEHAVIOUR == HUGE_SPEED) v[k] = 1e9;
    }
    if (BEHAVIOUR == CHANGES_REFERENCES) vr[0] = 0;
}

static void seam_set(Instance *i, double *v) {
    if (BEHAVIOUR == CHANGES_INPUTS && i->time >= WHEN - 1e-9) v[0] += 1;
}

static int seam_step(Instance *i) {
    Callbacks *c = &i->callbacks;
    volatile unsigned short x87 = 0x0372;
    switch (BEHAVIOUR) {
    case REVERSING:
        i->reals[VELOCITY] = -i->reals[VELOCITY];
        return OK;
    case ROUNDING:
        change_mxcsr(0, 0x4000);
        return OK;
    case FLUSHING:
        change_mxcsr(0, 0x8040);
        return OK;
    case TRAPPING:
        change_mxcsr(0x0680, 0);
        __asm__ volatile("fldcw %0" : : "m"(x87));
        return OK;
    case DOUBLE_FREE:
        free_twice();
        return OK;
    case NULL_ENVIRONMENT:
    case OWN_ENVIRONMENT:
        c->logger(BEHAVIOUR == OWN_ENVIRONMENT ? (void *)1 : NULL, "hostile", WARNING,
                  "logStatusWarning", "the bearing is warm: %g K", 300.5);
        return WARNING;
    case FOREIGN_THREAD:
        log_on_a_thread(NULL);
        return OK;
    case CONTROL_CHARACTERS:
        tell(i, WARNING, "logStatusWarning", "\033[2J\033]0;all is well\007 at %g s\n", i->time);
        return WARNING;
    case MANY_MESSAGES:
        tell(i, WARNING, "logStatusWarning", "low oil at %g s", i->time);
        return WARNING;
    default:
        return OK;
    }
}
