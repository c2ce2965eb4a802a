/* Writes who ends the program: the thread that crashes or calls exit(), for the parent, which tells it.
 * A signal handler may hardly call anything, so this is C: each thread has its number and its counter
 * of calls, which is odd while it calls an FMU. */
#define _GNU_SOURCE
#include <stdint.h>

struct record {
    uint32_t event;
    uint32_t thread;
    char library[512];
};

#ifdef _WIN32

void hotfoot_watch_crashes(struct record *into) { (void)into; }
void hotfoot_watch_thread(uint32_t number, const uint64_t *calls) {
    (void)number;
    (void)calls;
}
void hotfoot_expect_exit(void) {}

#else

#include <dlfcn.h>
#include <signal.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include <ucontext.h>
#include <unistd.h>

#define EXIT (1u << 16)
#define OUTSIDE (1u << 17)
#define UNKNOWN_THREAD UINT32_MAX

/* Seconds for looking up a library, which may wait for ever if the loader has crashed. */
#define LOOK_UP 2

static struct record *record;
static __thread uint32_t own_number;
static __thread const uint64_t *own_counter;

/* The number of this thread if it is in a call, or 0. */
static uint32_t caller(void) {
    if (own_counter == NULL) {
        return UNKNOWN_THREAD;
    }
    return __atomic_load_n(own_counter, __ATOMIC_RELAXED) % 2 == 1 ? own_number : 0;
}

/* Only the first event counts. */
static int note(uint32_t event) {
    uint32_t none = 0;
    if (record == NULL || !__atomic_compare_exchange_n(&record->event, &none, event, 0,
                                                       __ATOMIC_ACQ_REL, __ATOMIC_RELAXED)) {
        return 0;
    }
    __atomic_store_n(&record->thread, caller(), __ATOMIC_RELAXED);
    return 1;
}

/* Where the code was that crashed. */
static const void *place(const void *context) {
#if defined(__linux__) && defined(__x86_64__)
    return (const void *)((const ucontext_t *)context)->uc_mcontext.gregs[REG_RIP];
#elif defined(__linux__) && defined(__aarch64__)
    return (const void *)((const ucontext_t *)context)->uc_mcontext.pc;
#else
    (void)context;
    return NULL;
#endif
}

static void handle(int number, siginfo_t *info, void *context) {
    /* What a process sends to itself is abort(); what another sends is no crash. */
    int sent = info->si_code == SI_USER || info->si_code == SI_QUEUE;
    uint32_t outside = sent && info->si_pid != getpid() ? OUTSIDE : 0;
    if (note((uint32_t)number | outside)) {
        Dl_info library;
        signal(SIGALRM, SIG_DFL);
        alarm(LOOK_UP);
        if (dladdr(place(context), &library) != 0 && library.dli_fname != NULL) {
            strncpy(record->library, library.dli_fname, sizeof record->library - 1);
        }
    }
    /* SA_RESETHAND has put the default action back, which ends the program. */
    raise(number);
}

/* Whether the program itself is about to end. */
static int exit_is_expected;

void hotfoot_expect_exit(void) { exit_is_expected = 1; }

/* exit() calls this in the thread that has called exit(). */
static void at_exit(void) {
    if (!exit_is_expected && caller() != 0) {
        note(EXIT);
    }
}

void hotfoot_watch_crashes(struct record *into) {
    static const int numbers[] = {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL};
    struct sigaction action;
    record = into;
    memset(&action, 0, sizeof action);
    action.sa_sigaction = handle;
    /* On a stack of its own, where the thread has one, since the thread's may be full. */
    action.sa_flags = SA_SIGINFO | (int)SA_RESETHAND | SA_ONSTACK | SA_NODEFER;
    sigemptyset(&action.sa_mask);
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        sigaction(numbers[i], &action, NULL);
    }
    atexit(at_exit);
}

void hotfoot_watch_thread(uint32_t number, const uint64_t *calls) {
    own_number = number;
    own_counter = calls;
}

#endif
