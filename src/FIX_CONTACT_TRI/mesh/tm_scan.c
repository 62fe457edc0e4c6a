/* SPH-TM: words and numbers from a buffer that no 0 ends; see tm_scan.h. */
#include "tm_scan.h"

#include <locale.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int is_space(unsigned char c)
{
  return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\v';
}

int tm_scan_fail(tm_scan *s, int status, const char *format, ...)
{
  va_list args;
  va_start(args, format);
  if (s->nmsg > 0) vsnprintf(s->msg, s->nmsg, format, args);
  va_end(args);
  return status;
}

size_t tm_scan_left(const tm_scan *s) { return (size_t) (s->end - s->p); }

static void raw_word(tm_scan *s, char word[TM_WORD])
{
  while (s->p < s->end && is_space(*s->p)) s->p++;
  int n = 0;
  for (; s->p < s->end && !is_space(*s->p); s->p++)
    if (n < TM_WORD - 1) word[n++] = (char) *s->p;
  word[n] = '\0';
}

void tm_scan_word(tm_scan *s, char word[TM_WORD])
{
  raw_word(s, word);
  for (char *c = word; *c; c++)
    if (*c >= 'A' && *c <= 'Z') *c = (char) (*c - 'A' + 'a');
}

void tm_scan_peek(const tm_scan *s, char word[TM_WORD])
{
  tm_scan ahead = *s;
  tm_scan_word(&ahead, word);
}

int tm_scan_accept(tm_scan *s, const char *word)
{
  char next[TM_WORD];
  tm_scan ahead = *s;
  tm_scan_word(&ahead, next);
  if (strcmp(next, word) != 0) return 0;
  s->p = ahead.p;
  return 1;
}

int tm_scan_real(tm_scan *s, double *value)
{
  char word[TM_WORD], *stop;
  raw_word(s, word);
  if (!word[0] || strlen(word) == TM_WORD - 1) return 0;
  const char point = localeconv()->decimal_point[0];
  if (point != '.')
    for (char *c = word; *c; c++)
      if (*c == '.') *c = point;
  *value = strtod(word, &stop);
  return *stop == '\0';
}

int tm_scan_count(tm_scan *s, uint64_t limit, uint64_t *value)
{
  char word[TM_WORD];
  raw_word(s, word);
  if (!word[0]) return 0;
  *value = 0;
  for (const char *c = word; *c; c++) {
    if (*c < '0' || *c > '9') return 0;
    if (*value <= limit) *value = 10 * *value + (uint64_t) (*c - '0');
  }
  return *value <= limit;
}

void tm_scan_line_end(tm_scan *s)
{
  while (s->p < s->end && *s->p != '\n' && *s->p != '\r') s->p++;
  if (s->p + 1 < s->end && s->p[0] == '\r' && s->p[1] == '\n') s->p++;
  if (s->p < s->end) s->p++;
}

int tm_scan_line(const tm_scan *s)
{
  int line = 1;
  for (const unsigned char *c = s->begin; c < s->p; c++) line += *c == '\n';
  return line;
}
