// The body of stb_image: decoding, and nothing else. The only file of the project that holds it.
#include <stdlib.h>

// Memory starts as zeros: where a damaged file leaves pixels unwritten, they are black every time instead of left-overs.
#define STBI_MALLOC(size) calloc(1, size)
#define STBI_REALLOC realloc
#define STBI_FREE free

#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#define STBI_MAX_DIMENSIONS 16384
#define STB_IMAGE_IMPLEMENTATION
#include <stb_image.h>
