// The few words of the shared text that C++ and GLSL spell differently, as C++ spells them.
// physics/readings/glsl.glsl is the other spelling. docs/decisions/0002-one-text.md has the rules.
#pragma once

#define FN inline
#define IN(T) const T&
#define OUT(T) T&
#define INOUT(T) T&

// A table argument, of spectra: FN RadianceSpectrum sky(IN(TABLE_2D(RadianceSpectrum)) table, ...), read by
// look_up(table, TexCoord2(u, v)).
#define TABLE_2D(T) Table2D<T>
#define TABLE_3D(T) Table3D<T>
// The same with texels of 16 bits that stand for 0 to 1.
#define PACKED_TABLE_2D(T) PackedTable2D<T>
#define PACKED_TABLE_3D(T) PackedTable3D<T>
