// The only file of the programs that compiles stb_image: JPEG and inflate, nothing else.
#include <stdlib.h>

// Memory starts as zeros: pixels that a damaged file leaves out are always black, never left-overs.
#define STBI_MALLOC(size) calloc(1, size)
#define STBI_REALLOC realloc
#define STBI_FREE free

#define STBI_ONLY_JPEG
#define STBI_SUPPORT_ZLIB  // inflates the rows of PNG files
#define STBI_NO_STDIO
#define STBI_MAX_DIMENSIONS 16384
#define STB_IMAGE_IMPLEMENTATION
#include <stb_image.h>
