/* Where a sample begins on Windows: its arguments come as wide characters, and main gets them in UTF-8, which is what
 * the library takes. SPDX-License-Identifier: Apache-2.0 */
#include <stdio.h>
#include <stdlib.h>
#include <windows.h>

extern int main(int argc, char **argv);
int wmain(int argc, wchar_t **wide);

/* The whole of it lives as long as the program. */
int wmain(int argc, wchar_t **wide) {
  char **argv = calloc((size_t)argc + 1, sizeof *argv);
  int i;
  if (argv == NULL) return 3;
  SetConsoleOutputCP(CP_UTF8);
  for (i = 0; i < argc; ++i) {
    const int size = WideCharToMultiByte(CP_UTF8, 0, wide[i], -1, NULL, 0, NULL, NULL);
    if (size == 0 || (argv[i] = malloc((size_t)size)) == NULL) return 3;
    WideCharToMultiByte(CP_UTF8, 0, wide[i], -1, argv[i], size, NULL, NULL);
  }
  return main(argc, argv);
}
