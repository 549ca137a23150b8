// obj_reader.cpp: tinyobjloader compiled in, for compilers that have no such library.
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>
