/* SPH-TM: a cursor over a file in memory, for the mesh readers. Host only. */
#ifndef TM_SCAN_H
#define TM_SCAN_H

#include <stddef.h>
#include <stdint.h>

#include "tm_mesh.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
  const unsigned char *begin, *p, *end;
  char *msg; /* room for the reason of a failure */
  size_t nmsg;
} tm_scan;

#define TM_WORD 64 /* longest word, with its 0 */

#if defined(__GNUC__)
#define TM_PRINTF(f, a) __attribute__((format(printf, f, a)))
#else
#define TM_PRINTF(f, a)
#endif

/* Write the reason and return the status. */
int tm_scan_fail(tm_scan *s, int status, const char *format, ...) TM_PRINTF(3, 4);
/* The next word in lower case, "" at the end; words that are too long are cut. */
void tm_scan_word(tm_scan *s, char word[TM_WORD]);
/* The next word without moving on. */
void tm_scan_peek(const tm_scan *s, char word[TM_WORD]);
/* Nonzero, and moved past it, when the next word is this one (lower case). */
int tm_scan_accept(tm_scan *s, const char *word);
/* A number; 0 when the next word is none. NaN and infinity are numbers here. */
int tm_scan_real(tm_scan *s, double *value);
/* A count of at most `limit`; 0 when the next word is none. */
int tm_scan_count(tm_scan *s, uint64_t limit, uint64_t *value);
/* To the beginning of the next line; lines end with LF, CR LF or CR. */
void tm_scan_line_end(tm_scan *s);
/* Line of the cursor, counted from 1. */
int tm_scan_line(const tm_scan *s);
/* What is left, in bytes. */
size_t tm_scan_left(const tm_scan *s);

/* the readers of one format each */
int tm_read_stl_ascii(tm_scan *s, tm_soup *soup);
int tm_read_vtk(tm_scan *s, tm_soup *soup);

#ifdef __cplusplus
}
#endif

#endif
