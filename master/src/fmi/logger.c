/* The logger that FMUs call: variadic in FMI 2.0, so it is C. It formats the message and hands
 * it to Rust (`take_message` in callbacks.rs). */
#include <stdarg.h>
#include <stdio.h>

extern void hotfoot_take_message(void *environment, int status, const char *category,
                                 const char *message);

void hotfoot_logger(void *environment, const char *instance, int status, const char *category,
                    const char *format, ...) {
    char message[4096] = "";
    (void)instance;
    if (format != NULL) {
        va_list arguments;
        va_start(arguments, format);
        vsnprintf(message, sizeof message, format, arguments);
        va_end(arguments);
    }
    hotfoot_take_message(environment, status, category != NULL ? category : "", message);
}
