/* The logger that FMUs call: variadic in FMI 2.0, so it is C. It formats the message and hands
 * it to Rust (`hotfoot_take_message` in callbacks.rs), with the file of the library that calls. */
#ifndef _GNU_SOURCE
#define _GNU_SOURCE
#endif
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>

extern void hotfoot_take_message(void *environment, const char *caller, int status,
                                 const char *message);

#ifdef _WIN32
static const char *library_of(const void *address) {
    (void)address;
    return "";
}
#else
#include <dlfcn.h>
static const char *library_of(const void *address) {
    Dl_info info;
    return dladdr(address, &info) != 0 && info.dli_fname != NULL ? info.dli_fname : "";
}
#endif

void hotfoot_logger(void *environment, const char *instance, int status, const char *category,
                    const char *format, ...) {
    char message[4096] = "";
    (void)instance;
    (void)category;
    if (format != NULL) {
        va_list arguments;
        va_start(arguments, format);
        vsnprintf(message, sizeof message, format, arguments);
        va_end(arguments);
    }
    hotfoot_take_message(environment, library_of(__builtin_return_address(0)), status, message);
}
