// The names of the shared text as GLSL spells them: read before physics/*.glsl, after the #version line.
// physics/readings/names.inc and macros.h are the other spelling. docs/decisions/0002-one-text.md has the rules.
#ifdef GL_ES
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp sampler3D;
#endif

#define FN
#define IN(T) in T
#define OUT(T) out T
#define INOUT(T) inout T
#define TABLE_2D(T) sampler2D
#define TABLE_3D(T) sampler3D
#define PACKED_TABLE_2D(T) sampler2D
#define PACKED_TABLE_3D(T) sampler3D
#define TexCoord2 vec2
#define TexCoord3 vec3

#define Number float
#define Length float
#define Area float
#define InverseLength float
#define InverseSolidAngle float

// A spectrum is four wavelengths, never three: a vec3 in a block shifts what follows it (std140, std430).
#define Spectrum vec4
#define LengthSpectrum vec4
#define ScatteringSpectrum vec4
#define PhaseSpectrum vec4
#define PhasedScatteringSpectrum vec4
#define IrradianceSpectrum vec4
#define RadianceSpectrum vec4
#define RadianceDensitySpectrum vec4
const int N = 4;

const Length m = 1.0;
const InverseSolidAngle per_sr = 1.0;
const Number pi = 3.14159265358979323846;

// Textures of tables are filtered linearly and clamped at their edges.
vec4 look_up(in sampler2D table, vec2 place) { return textureLod(table, place, 0.0); }
vec4 look_up(in sampler3D table, vec3 place) { return textureLod(table, place, 0.0); }
