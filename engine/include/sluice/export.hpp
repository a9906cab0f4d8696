// What a program may call in the shared library; everything else stays inside.
#pragma once

#define SLUICE_API __attribute__((visibility("default")))
