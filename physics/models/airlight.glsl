// Airlight's own sky: single scattering marched along the ray, higher orders from a small table of their source.
// What it is and leaves out: src/models/airlight.cpp. Theory: docs/theory.md, section 10.1.
//
// A ray is cut where its integrand has an edge: at its perigee, where it enters and leaves the planet's shadow, where a density
// jumps. On each piece the nodes of Gauss's rule crowd, in altitude, quadratically towards the lower end. Columns of air up to a
// node are integrals of the polynomial through the densities at all nodes of its piece.

const int airlight_parts = 8;      // constituents, at most
const int airlight_segments = 8;   // of an altitude axis, at most
const int airlight_nodes = 16;     // on a piece, at most
const int airlight_cuts = 24;      // of a ray, at most

// The altitudes of a table's texels: segments between jumps of density, between which nothing is interpolated.
struct AirlightAxis {
    int segments;
    int texels;
    Number from[airlight_segments];           // altitude_coordinate of a segment's first texel
    Number inverse_range[airlight_segments];  // of the coordinate over the segment
    Number first[airlight_segments];          // texel
    Number last[airlight_segments];
    Number crowds[airlight_segments];         // 1 where texels crowd towards the segment's upper end, else 0
};

// Air at N wavelengths.
struct AirlightAir {
    Length bottom;
    Length top;
    int parts;
    ScatteringSpectrum scattering[airlight_parts];  // where the density is 1
    ScatteringSpectrum extinction[airlight_parts];
    InverseLength opacity[airlight_parts];          // the greatest extinction at any wavelength that the ray is shared by
    Spectrum ground_albedo;
    IrradianceSpectrum solar_irradiance;
    Number sun_radius;  // angular; 0 is a point
    AirlightAxis density_axis;
    AirlightAxis transmittance_axis;
    AirlightAxis source_axis;
    // Tables hold values of 0 to 1: optical depth over deepest_depth, and the logarithm of the source over the sun's irradiance
    // from log_low to log_low + log_range.
    Number deepest_depth;
    Number log_low;
    Number log_range;
    int sun_texels;
    int azimuth_texels;
    int view_texels;
    int cosine_texels;
};

// Densities relative to their references.
struct AirlightDensities {
    Number of[airlight_parts];
};

// Where a ray is cut: signed distances from its perigee, increasing, the first and the last its ends.
struct AirlightCuts {
    int count;
    Length at[airlight_cuts];
};

// Gauss's rule on [0, 1], and the integrals from 0 to each node of the polynomial through all nodes: up_to[node * count + sample].
struct AirlightRule {
    int count;
    Number node[airlight_nodes];
    Number weight[airlight_nodes];
    Number up_to[airlight_nodes * airlight_nodes];
};

// Columns of each constituent's air: integrals of its relative density along a ray.
struct AirlightColumns {
    Length of[airlight_parts];
};

// A ray within the air, from its start.
struct AirlightRay {
    Length h;
    Number mu;
    Number mu_s;
    Number nu;
    Length limit;  // where it ends, if it has not met the ground or left the air before
};

// Light that reaches the start of a ray, apart from the sun's disk itself.
struct AirlightLight {
    RadianceSpectrum multiple;                // of two and more scatterings, and from the ground
    IrradianceSpectrum single[airlight_parts];  // one scattering in each constituent; times its phase function it is radiance
    Spectrum transmittance;                   // to the end of the ray
};

// The texel, as a real number, that an altitude falls on.
FN Number airlight_texel(IN(AirlightAxis) axis, Length h, Length top) {
    Number u = altitude_coordinate(h, top);
    int s = 0;
    while (s + 1 < axis.segments && u >= axis.from[s + 1]) s = s + 1;
    Number t = clamp((u - axis.from[s]) * axis.inverse_range[s], Number(0.0), Number(1.0));
    Number v = axis.crowds[s] > 0.5 ? 1.0 - sqrt(1.0 - t) : t;
    return axis.first[s] + v * (axis.last[s] - axis.first[s]);
}

// A row of the table holds four constituents.
FN AirlightDensities airlight_densities(IN(AirlightAir) air, IN(TABLE_2D(Spectrum)) densities, Length h) {
    AirlightDensities at;
    Number u = (airlight_texel(air.density_axis, h, air.top) + 0.5) / Number(air.density_axis.texels);
    Spectrum low = look_up(densities, TexCoord2(u, Number(0.25)));
    for (int p = 0; p < 4; ++p) at.of[p] = low[p];
    Spectrum high = air.parts > 4 ? look_up(densities, TexCoord2(u, Number(0.75))) : Spectrum(Number(0.0));
    for (int p = 4; p < 8; ++p) at.of[p] = high[p - 4];
    return at;
}

FN Spectrum airlight_transmittance(IN(AirlightAir) air, IN(AirlightColumns) columns) {
    Spectrum depth = air.extinction[0] * columns.of[0];
    for (int p = 1; p < air.parts; ++p) depth = depth + air.extinction[p] * columns.of[p];
    return exp(-depth);
}

// The part of a uniform disk that stands above a straight horizon; x is the height of its centre in units of its radius.
FN Number disk_above(Number x) {
    Number c = clamp(x, Number(-1.0), Number(1.0));
    return 0.5 + (c * sqrt(1.0 - c * c) + asin(c)) / pi;
}

// Transmittance from a point to the sun, times the part of its disk above the horizon.
FN Spectrum airlight_sunlight(IN(AirlightAir) air, IN(PACKED_TABLE_2D(Spectrum)) transmittance, Length h, Number mu_s) {
    Number horizon = horizon_cosine(h, air.bottom);
    Number sine = sqrt(max(1.0 - horizon * horizon, Number(1e-6)));
    Number above = (mu_s - horizon) / sine;  // the height of the sun's centre above the horizon, in radians
    Number part = air.sun_radius > 0.0 ? disk_above(above / air.sun_radius) : (above >= 0.0 ? Number(1.0) : Number(0.0));
    if (part <= 0.0) return Spectrum(Number(0.0));
    Number u = transmittance_cosine_coordinate(h, max(mu_s, horizon), air.bottom, air.top);
    Number v = (airlight_texel(air.transmittance_axis, h, air.top) + 0.5) / Number(air.transmittance_axis.texels);
    Spectrum depth = look_up(transmittance, TexCoord2(texture_coordinate(u, air.cosine_texels), v));
    return exp(depth * (-air.deepest_depth)) * part;
}

// Radiance scattered per scattering coefficient, by light of at least one scattering or reflection, towards where a view of
// zenith cosine mu came from; over the sun's irradiance, per steradian.
FN Spectrum airlight_source(IN(AirlightAir) air, IN(PACKED_TABLE_3D(Spectrum)) source, Length h, Number mu, Number mu_s, Number nu) {
    Number x = texture_coordinate(sun_coordinate(mu_s), air.sun_texels);
    Number y = texture_coordinate(view_coordinate(mu), air.view_texels);
    Number azimuth = azimuth_coordinate(relative_azimuth_cosine(mu, mu_s, nu)) * Number(air.azimuth_texels - 1);
    int low = int(min(azimuth, Number(air.azimuth_texels - 2)));
    // Azimuths are slabs of the third dimension, one upon the other.
    Number slab = Number(air.source_axis.texels);
    Number z = (airlight_texel(air.source_axis, h, air.top) + 0.5 + slab * Number(low)) / (slab * Number(air.azimuth_texels));
    Number weight = azimuth - Number(low);
    Spectrum value = look_up(source, TexCoord3(x, y, z)) * (1.0 - weight) +
                     look_up(source, TexCoord3(x, y, z + 1.0 / Number(air.azimuth_texels))) * weight;
    return exp(value * air.log_range + Spectrum(air.log_low));
}

// Diffuse irradiance of the ground, over the sun's.
FN Spectrum airlight_diffuse(IN(AirlightAir) air, IN(PACKED_TABLE_2D(Spectrum)) diffuse, Number mu_s) {
    Number x = texture_coordinate(sun_coordinate(mu_s), air.sun_texels);
    return exp(look_up(diffuse, TexCoord2(x, Number(0.5))) * air.log_range + Spectrum(air.log_low));
}

// Light that the ground sends up where the sun's zenith cosine is mu_s.
FN RadianceSpectrum airlight_ground(IN(AirlightAir) air, IN(PACKED_TABLE_2D(Spectrum)) transmittance, IN(PACKED_TABLE_2D(Spectrum)) diffuse,
                                    Number mu_s) {
    Spectrum light = airlight_diffuse(air, diffuse, mu_s);
    // Near the horizon, the part of the disk that is above the plane faces it at about half its height.
    Number facing = mu_s >= air.sun_radius ? mu_s : max(0.5 * (mu_s + air.sun_radius), Number(0.0));
    if (facing > 0.0) light = light + airlight_sunlight(air, transmittance, 0.0 * m, mu_s) * facing;
    return light * air.ground_albedo * air.solar_irradiance * (1.0 / pi * per_sr);
}

// Adds a cut within the ends; one that would leave less than a millionth of the ray is left out.
FN void airlight_cut(INOUT(AirlightCuts) cuts, Length x) {
    Length least = 1e-6 * (cuts.at[cuts.count - 1] - cuts.at[0]);
    if (cuts.count == airlight_cuts || x < cuts.at[0] + least || x > cuts.at[cuts.count - 1] - least) return;
    int i = cuts.count;
    while (cuts.at[i - 1] > x) {
        cuts.at[i] = cuts.at[i - 1];
        i = i - 1;
    }
    cuts.at[i] = x;
    cuts.count = cuts.count + 1;
}

// Cuts some mean free paths after x, where the altitude is h: what lies beyond is seen less and less.
FN void airlight_cut_free_paths(IN(AirlightAir) air, IN(TABLE_2D(Spectrum)) densities, INOUT(AirlightCuts) cuts, Length x, Length h) {
    AirlightDensities beside = airlight_densities(air, densities, x >= 0.0 * m ? h * 1.00001 : h * 0.99999);
    InverseLength extinction = air.opacity[0] * beside.of[0];
    for (int p = 1; p < air.parts; ++p) extinction = extinction + air.opacity[p] * beside.of[p];
    Length left = cuts.at[cuts.count - 1] - x;
    // With less extinction no cut is within the ray.
    if (x < cuts.at[0] || 0.25 * left * extinction < 2.0) return;
    airlight_cut(cuts, x + 2.0 / extinction);
    if (0.25 * left * extinction > 12.0) airlight_cut(cuts, x + 12.0 / extinction);
}

// Where a ray of a length is cut by what does not depend on the sun: its perigee, jumps of density, mean free paths.
FN AirlightCuts airlight_air_cuts(IN(AirlightAir) air, IN(TABLE_2D(Spectrum)) densities, Length h, Number mu, Length length) {
    Length start = (air.bottom + h) * mu;
    AirlightCuts cuts;
    cuts.count = 2;
    cuts.at[0] = start;
    cuts.at[1] = start + length;
    airlight_cut(cuts, 0.0 * m);
    for (int s = 1; s < air.density_axis.segments; ++s) {
        Length jump = altitude_of_coordinate(air.density_axis.from[s], air.top);
        Area squared = start * start + (jump - h) * (2.0 * air.bottom + jump + h);
        if (squared > 0.0 * m * m) {
            Length x = sqrt(squared);
            airlight_cut(cuts, -x);
            airlight_cut(cuts, x);
            airlight_cut_free_paths(air, densities, cuts, -x, jump);
            airlight_cut_free_paths(air, densities, cuts, x, jump);
        }
    }
    airlight_cut_free_paths(air, densities, cuts, start, h);
    return cuts;
}

// Cuts a ray where it enters and leaves the planet's shadow, a cylinder whose axis points from the sun and whose radius is the
// ground's.
FN void airlight_cut_shadow(IN(AirlightAir) air, IN(AirlightRay) ray, INOUT(AirlightCuts) cuts) {
    Length r = air.bottom + ray.h;
    Length start = r * ray.mu;
    Number a = 1.0 - ray.nu * ray.nu;
    Length b = r * (ray.mu - ray.mu_s * ray.nu);
    Area c = ray.h * (2.0 * air.bottom + ray.h) - r * ray.mu_s * (r * ray.mu_s);
    Area discriminant = b * b - a * c;
    if (a > 1e-6 && discriminant > 0.0 * m * m) {
        Length root = sqrt(discriminant);
        Length enters = (-b - root) / a;
        Length leaves = (-b + root) / a;
        if (r * ray.mu_s + ray.nu * enters < 0.0 * m) airlight_cut(cuts, start + enters);
        if (r * ray.mu_s + ray.nu * leaves < 0.0 * m) airlight_cut(cuts, start + leaves);
    }
}

// A place on a ray where its light is gathered.
struct AirlightNode {
    Length h;
    Number mu;                  // of the ray, there
    Length distance;            // from the ray's start
    AirlightDensities density;
    LengthSpectrum seen;        // transmittance from the ray's start, times the length that the node stands for
};

// The nodes of a piece, as many as the rule's.
struct AirlightPiece {
    AirlightNode node[airlight_nodes];
};

// The piece [from, to] of a ray that starts at h, mu, on one side of the perigee. `columns` holds those before it, and receives
// those after it.
FN void airlight_piece(IN(AirlightAir) air, IN(AirlightRule) rule, IN(TABLE_2D(Spectrum)) densities, Length h, Number mu, Length from,
                       Length to, INOUT(AirlightColumns) columns, INOUT(AirlightPiece) piece) {
    Length r = air.bottom + h;
    Length start = r * mu;
    bool rises = from + to > 0.0 * m;
    Length x_low = rises ? max(from, 0.0 * m) : min(to, 0.0 * m);
    Length x_high = rises ? to : from;
    Area low_gain = (x_low - start) * (x_low + start);
    Length h_low = max(h + low_gain / (sqrt(max(r * r + low_gain, 0.0 * m * m)) + r), 0.0 * m);
    Area gain = (x_high - x_low) * (x_high + x_low);
    Length r_low = air.bottom + h_low;
    Length rise = gain / (sqrt(max(r_low * r_low + gain, 0.0 * m * m)) + r_low);
    Length slope[airlight_nodes];  // of the distance by the rule's variable
    for (int k = 0; k < rule.count; ++k) {
        Number u = rises ? rule.node[k] : 1.0 - rule.node[k];
        Length h_k = h_low + rise * (u * u);
        Length x = sqrt(x_low * x_low + rise * (u * u) * (2.0 * air.bottom + h_k + h_low));
        slope[k] = 2.0 * rise * u * ((air.bottom + h_k) / x);
        piece.node[k].h = h_k;
        piece.node[k].mu = clamp((rises ? x : -x) / (air.bottom + h_k), Number(-1.0), Number(1.0));
        piece.node[k].distance = (rises ? x : -x) - start;
        piece.node[k].density = airlight_densities(air, densities, h_k);
    }
    for (int k = 0; k < rule.count; ++k) {
        AirlightColumns up_to = columns;
        for (int j = 0; j < rule.count; ++j) {
            Length part = rule.up_to[k * rule.count + j] * slope[j];
            for (int p = 0; p < airlight_parts; ++p) up_to.of[p] = up_to.of[p] + piece.node[j].density.of[p] * part;
        }
        for (int p = 0; p < airlight_parts; ++p) up_to.of[p] = max(up_to.of[p], 0.0 * m);
        piece.node[k].seen = airlight_transmittance(air, up_to) * (rule.weight[k] * slope[k]);
    }
    for (int k = 0; k < rule.count; ++k)
        for (int p = 0; p < airlight_parts; ++p)
            columns.of[p] = columns.of[p] + piece.node[k].density.of[p] * (rule.weight[k] * slope[k]);
}

// Integrals along a ray, relative to the sun's irradiance.
struct AirlightSums {
    Spectrum multiple;
    LengthSpectrum lit[airlight_parts];  // of each constituent's air, as if of density one
};

FN AirlightSums airlight_nothing() {
    AirlightSums sums;
    sums.multiple = Spectrum(Number(0.0));
    for (int p = 0; p < airlight_parts; ++p) sums.lit[p] = LengthSpectrum(0.0 * m);
    return sums;
}

// Adds the light of a node of a ray.
FN void airlight_gather(IN(AirlightAir) air, IN(PACKED_TABLE_2D(Spectrum)) transmittance, IN(PACKED_TABLE_3D(Spectrum)) source,
                        IN(AirlightRay) ray, IN(AirlightNode) node, INOUT(AirlightSums) sums) {
    Length r = air.bottom + node.h;
    Number mu_s = clamp(((air.bottom + ray.h) * ray.mu_s + ray.nu * node.distance) / r, Number(-1.0), Number(1.0));
    LengthSpectrum lit = node.seen * airlight_sunlight(air, transmittance, node.h, mu_s);
    ScatteringSpectrum scattering = air.scattering[0] * node.density.of[0];
    sums.lit[0] = sums.lit[0] + lit * node.density.of[0];
    for (int p = 1; p < air.parts; ++p) {
        scattering = scattering + air.scattering[p] * node.density.of[p];
        sums.lit[p] = sums.lit[p] + lit * node.density.of[p];
    }
    sums.multiple = sums.multiple + airlight_source(air, source, node.h, node.mu, mu_s, ray.nu) * (scattering * node.seen);
}

// How far a ray runs in the air.
FN Length airlight_length(IN(AirlightAir) air, Length h, Number mu, bool grounded) {
    return grounded ? distance_to_ground(h, mu, air.bottom) : distance_to_top(h, mu, air.bottom, air.top);
}

// The light that sums along a whole ray stand for, that of the ground at its end left out.
FN AirlightLight airlight_summed(IN(AirlightAir) air, IN(AirlightSums) sums, IN(AirlightColumns) columns) {
    AirlightLight light;
    light.transmittance = airlight_transmittance(air, columns);
    light.multiple = sums.multiple * air.solar_irradiance * per_sr;
    for (int p = 0; p < airlight_parts; ++p) light.single[p] = sums.lit[p] * air.scattering[p] * air.solar_irradiance;
    return light;
}

// The sun's zenith cosine where a ray meets the ground after a length.
FN Number airlight_ground_sun(IN(AirlightAir) air, IN(AirlightRay) ray, Length length) {
    return clamp(((air.bottom + ray.h) * ray.mu_s + ray.nu * length) / air.bottom, Number(-1.0), Number(1.0));
}

// The light along a ray.
FN AirlightLight airlight_light(IN(AirlightAir) air, IN(AirlightRule) rule, IN(TABLE_2D(Spectrum)) densities,
                                IN(PACKED_TABLE_2D(Spectrum)) transmittance, IN(PACKED_TABLE_3D(Spectrum)) source,
                                IN(PACKED_TABLE_2D(Spectrum)) diffuse, IN(AirlightRay) ray) {
    AirlightColumns columns;
    for (int p = 0; p < airlight_parts; ++p) columns.of[p] = 0.0 * m;
    AirlightSums sums = airlight_nothing();
    bool grounded = meets_ground(ray.h, ray.mu, air.bottom);
    Length length = airlight_length(air, ray.h, ray.mu, grounded);
    if (ray.limit < length) {
        grounded = false;
        length = ray.limit;
    }
    if (length > 0.0 * m) {
        AirlightCuts cuts = airlight_air_cuts(air, densities, ray.h, ray.mu, length);
        airlight_cut_shadow(air, ray, cuts);
        AirlightPiece piece;
        for (int i = 0; i + 1 < cuts.count; ++i) {
            airlight_piece(air, rule, densities, ray.h, ray.mu, cuts.at[i], cuts.at[i + 1], columns, piece);
            for (int k = 0; k < rule.count; ++k) airlight_gather(air, transmittance, source, ray, piece.node[k], sums);
        }
    }
    AirlightLight light = airlight_summed(air, sums, columns);
    if (grounded)
        light.multiple = light.multiple +
                         airlight_ground(air, transmittance, diffuse, airlight_ground_sun(air, ray, length)) * light.transmittance;
    return light;
}
