/* Says which FMU was at work when the program crashes. A signal handler may hardly call anything,
 * so this is C: each thread notes what it calls, and the handler writes that and lets the program
 * die as it would have. */
#ifdef _WIN32

void hotfoot_watch_crashes(void) {}
void hotfoot_now_calling(const char *instance, const char *function) {
    (void)instance;
    (void)function;
}

#else

#include <signal.h>
#include <stddef.h>
#include <string.h>
#include <unistd.h>

static __thread const char *volatile current_instance;
static __thread const char *volatile current_function;

static void say(const char *text) {
    size_t length = strlen(text);
    while (length > 0) {
        ssize_t written = write(STDERR_FILENO, text, length);
        if (written <= 0) {
            return;
        }
        text += written;
        length -= (size_t)written;
    }
}

static const char *name_of(int number) {
    switch (number) {
    case SIGABRT: return "abort (SIGABRT)";
    case SIGSEGV: return "a memory error (SIGSEGV)";
    case SIGBUS: return "a memory error (SIGBUS)";
    case SIGFPE: return "an arithmetic error (SIGFPE)";
    default: return "an illegal instruction (SIGILL)";
    }
}

static void handle(int number) {
    if (current_instance != NULL) {
        say("\n");
        say(current_instance);
        say(": ");
        say(current_function);
        say(" crashed with ");
        say(name_of(number));
        say("\n");
    }
    /* SA_RESETHAND has put the default action back, which ends the program. */
    raise(number);
}

void hotfoot_watch_crashes(void) {
    static const int numbers[] = {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL};
    struct sigaction action;
    memset(&action, 0, sizeof action);
    action.sa_handler = handle;
    /* On a stack of its own, where the thread has one, since the thread's may be full. */
    action.sa_flags = SA_RESETHAND | SA_ONSTACK | SA_NODEFER;
    sigemptyset(&action.sa_mask);
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        sigaction(numbers[i], &action, NULL);
    }
}

void hotfoot_now_calling(const char *instance, const char *function) {
    current_function = function;
    current_instance = instance;
}

#endif
